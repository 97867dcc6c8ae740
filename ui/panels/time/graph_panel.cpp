#include <algorithm>
#include <cmath>
#include <utility>

#include "app/commands/keys/keys.h"
#include "app/commands/table/frames.h"
#include "ui/panels/context/key_bar.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/panels/rows/graph_model.h"
#include "ui/panels/rows/timeline_model.h"
#include "ui/widgets/curve_view.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

const GraphSubject& chosenSubject(PanelContext& context, const std::vector<GraphSubject>& subjects) {
  GraphState& graph = context.ui.time.graph;
  graph.joint = std::clamp(graph.joint, 0, static_cast<int>(subjects.size()) - 1);
  return subjects[static_cast<std::size_t>(graph.joint)];
}

/// How much room the toolbar has. Where it is little, the channels are a list; where it is very little, what
/// the menu Keys and keys of the keyboard have too is left out while keys are picked.
bool isNarrow(const PanelContext& context) {
  return ImGui::GetWindowContentRegionMax().x < context.theme.px(1100.0F);
}
bool isVeryNarrow(const PanelContext& context) {
  return ImGui::GetWindowContentRegionMax().x < context.theme.px(820.0F);
}

void subjectChooser(PanelContext& context, const std::vector<GraphSubject>& subjects) {
  GraphState& graph = context.ui.time.graph;
  std::vector<Choice> choices;
  choices.reserve(subjects.size());
  for (const GraphSubject& subject : subjects) {
    choices.push_back({subject.title});
  }
  const int chosen = dropdown(widgetsOf(context), "graph/joint", choices, graph.joint,
                              {"Joint or controller", "What of the selection the curves are drawn of.", {}},
                              context.theme.px(isNarrow(context) ? 108.0F : 150.0F));
  if (chosen >= 0) {
    graph.joint = chosen;
    graph.fitPending = true;
  }
}

void channelChooser(PanelContext& context, const GraphSubject& subject) {
  GraphState& graph = context.ui.time.graph;
  const bool isJoint = subject.controller.empty();
  const std::vector<Choice> choices{
      {isJoint ? "Translation" : "Move",
       {"Translation", "Local translation of the joint, or what the controller is moved by.", {}}},
      {isJoint ? "Rotation" : "Turn",
       {"Rotation",
        "Local rotation of the joint as angles, or what the controller is turned by, in degrees.",
        {}}},
      {"Scale", {"Scale", "Local scale of the joint.", {}}, isJoint},
      {"Length", {"Length", "Length of the limb, straight from its base to its end.", {}}, isJoint}};
  const int channels = static_cast<int>(graphChannels(context, subject));
  const Help help{"Channel", "What of the joint or the controller is drawn.", {}};
  int chosen = -1;
  if (isNarrow(context)) {
    chosen = dropdown(widgetsOf(context), "graph/channel", choices, channels, help, context.theme.px(104.0F));
  } else {
    ImGui::BeginChild("graph/channels", {context.theme.px(320.0F), context.theme.rowHeight()});
    chosen = segmented(widgetsOf(context), "graph/channel", choices, channels);
    ImGui::EndChild();
  }
  if (chosen >= 0) {
    (isJoint ? graph.channels : graph.offsetChannels) = static_cast<GraphChannels>(chosen);
    graph.fitPending = true;
  }
}

void toolbar(PanelContext& context, const std::vector<GraphSubject>& subjects, const GraphSubject& subject) {
  const WidgetContext widgets = widgetsOf(context);
  GraphState& graph = context.ui.time.graph;
  subjectChooser(context, subjects);
  ImGui::SameLine();
  const bool isValue = subject.controller.find('.') != std::string::npos;
  if (!isValue) {
    channelChooser(context, subject);
    ImGui::SameLine();
  }
  ButtonSpec fit{.id = "graph/fit", .icon = icon::fit, .text = "Fit", .emphasis = Emphasis::quiet};
  fit.help = {"Fit the curves",
              "Shows every value in the visible frames. A double click in the graph does the same.",
              keyOf(context, command::viewFrameAll)};
  const bool leftOut = isVeryNarrow(context) && app::hasPickedKeys(context.character());
  if (!leftOut) {
    graph.fitPending = button(widgets, fit) || graph.fitPending;
    ImGui::SameLine();
  }
  const std::size_t legend = isValue || graph.curves.size() < 3 ? 1 : 3;
  if (const int clicked = curveLegend(widgets, "graph/curve", graph.curves, legend); clicked >= 0) {
    const auto index = static_cast<std::size_t>(clicked);
    graph.hidden[index] = !graph.hidden[index];
  }
  ImGui::SameLine();
  drawKeyBar(context, leftOut);
}

void applyView(PanelContext& context, const CurveViewOutcome& outcome) {
  GraphState& graph = context.ui.time.graph;
  if (outcome.framesChanged) {
    context.ui.time.timeline.viewStart = outcome.frames.start;
    context.ui.time.timeline.viewEnd = outcome.frames.end;
  }
  if (outcome.valuesChanged) {
    graph.valueMin = outcome.values.start;
    graph.valueMax = outcome.values.end;
    std::for_each(graph.curves.begin(), graph.curves.end(), [](Curve& curve) { curve.seen = false; });
  }
  if (outcome.playheadMoved) {
    const double last = app::lastFrame(context.character().document(), context.character().view().clip);
    context.character().view().frame = std::clamp(outcome.playhead, 0.0, last);
  }
  graph.fitPending = graph.fitPending || outcome.fitAsked;
}

unsigned componentBit(const Curve& curve) {
  return 1U << curve.component;
}

app::KeySelection keyOf(const GraphState& graph, const CurveKeyHit& hit) {
  const Curve& curve = graph.curves[hit.curve];
  return {{graph.rows[curve.row], {{hit.key, componentBit(curve)}}}};
}

/// The keys in a box, of the curves that are seen.
app::KeySelection keysInBox(const GraphState& graph, const Span& frames, const Span& values) {
  app::KeySelection selection;
  for (const Curve& curve : graph.curves) {
    app::PickedRow row{curve.row < graph.rows.size() ? graph.rows[curve.row] : app::KeyRow{}, {}};
    for (const CurveKey& key : curve.hidden ? std::vector<CurveKey>{} : curve.keys) {
      const bool inside = key.at.x >= frames.start && key.at.x <= frames.end && key.at.y >= values.start &&
                          key.at.y <= values.end;
      if (inside) {
        row.keys.push_back({key.key, componentBit(curve)});
      }
    }
    if (!row.keys.empty()) {
      selection = app::joined(selection, {row});
    }
  }
  return selection;
}

void applyPicks(PanelContext& context, const CurveViewOutcome& outcome) {
  app::Session& session = context.character();
  const GraphState& graph = context.ui.time.graph;
  if (outcome.pickedKey) {
    app::pickKeys(session, keyOf(graph, *outcome.pickedKey), outcome.addToPicks);
  } else if (outcome.boxDrawn) {
    app::pickKeys(session, keysInBox(graph, outcome.boxFrames, outcome.boxValues), outcome.addToPicks);
  } else if (outcome.clickedBeside && !outcome.addToPicks) {
    app::pickKeys(session, {}, false);
  }
  if (outcome.insertAt) {
    const double frame =
        context.ui.time.timeline.snapToFrames ? std::round(*outcome.insertAt) : *outcome.insertAt;
    tellProblem(context, app::editKeys(session,
                                       app::insertKeys(session.document(), session.view().clip,
                                                       session.view().keyRows, std::max(0.0, frame)),
                                       "Insert"));
  }
}

/// A right click: a key that lies there is picked, and its menu opens; beside the keys that of the frame.
void applyMenu(PanelContext& context, const CurveViewOutcome& outcome) {
  if (!outcome.menu || context.character().isDragging()) {
    return; // a running tool has the keys
  }
  const std::optional<CurveKeyHit>& hit = outcome.menu->key;
  app::Session& session = context.character();
  const GraphState& graph = context.ui.time.graph;
  const double last = app::lastFrame(session.document(), session.view().clip);
  double frame = std::clamp(std::round(outcome.mouse.x), 0.0, last);
  if (hit) {
    const std::vector<CurveKey>& keys = graph.curves[hit->curve].keys;
    const auto key = std::ranges::find(keys, hit->key, &CurveKey::key);
    frame = key == keys.end() ? frame : key->at.x;
    if (!outcome.menu->onPick) {
      app::pickKeys(session, keyOf(graph, *hit), false);
    }
  }
  context.ui.menu.frame = frame;
  askForMenu(context.ui, hit ? MenuTarget::key : MenuTarget::time);
}

/// One frame of a drag of keys or of a tangent.
void applyDrags(PanelContext& context, const CurveViewOutcome& outcome) {
  app::Session& session = context.character();
  GraphState& graph = context.ui.time.graph;
  const int clip = session.view().clip;
  if (!outcome.keysDragged && !outcome.tangent && !outcome.gestureEnded) {
    return;
  }
  if (!session.isDragging()) {
    graph.heldKeys = app::pickedKeys(session);
  }
  const bool moves = outcome.keysDragged && !graph.heldKeys.empty();
  const EditPhase phase{moves || outcome.tangent, outcome.gestureEnded};
  const std::string label =
      (outcome.tangent ? "Bend " : "Move ") + app::selectionTitle(session.document(), graph.heldKeys);
  app::KeySelection picked = app::pickedKeys(session);
  editThrough(context, phase, label, [&](const app::Document& start) -> Result<app::Document> {
    Result<app::EditedKeys> edited = app::EditedKeys{start, picked};
    if (outcome.tangent) {
      const Curve& curve = graph.curves[outcome.tangent->curve];
      const app::TangentSide side = !outcome.tangentAlone  ? app::TangentSide::both
                                    : outcome.tangentAfter ? app::TangentSide::out
                                                           : app::TangentSide::in;
      edited = app::setKeySlope(start, clip, graph.rows[curve.row],
                                {outcome.tangent->key, componentBit(curve)}, side, outcome.slope);
    } else if (moves) {
      edited = app::moveKeys(start, clip, graph.heldKeys, {outcome.drag.x, outcome.drag.y});
    }
    if (!edited) {
      return edited.error();
    }
    picked = edited->picked;
    return std::move(edited->document);
  });
  if (phase.changed) {
    app::pickKeys(session, outcome.tangent ? graph.heldKeys : picked, false);
  }
}

void fit(PanelContext& context) {
  GraphState& graph = context.ui.time.graph;
  const std::optional<CurveFit> picks = graph.fitPicked ? fittedPicks(graph.curves) : std::nullopt;
  const Span values = picks ? picks->values : fittedValues(graph.curves);
  if (picks) {
    context.ui.time.timeline.viewStart = picks->frames.start;
    context.ui.time.timeline.viewEnd = picks->frames.end;
  }
  graph.valueMin = values.start;
  graph.valueMax = values.end;
  graph.fitPending = !graph.complete; // Until all curves are known.
  graph.fitPicked = graph.fitPicked && graph.fitPending;
}

/// The rows that have a curve which is seen, for commands that act on what shows.
void showRows(app::ViewState& view, const GraphState& graph) {
  view.keyRows.clear();
  view.keyComponents.clear();
  for (const Curve& curve : graph.curves) {
    if (curve.hidden || curve.row >= graph.rows.size()) {
      continue;
    }
    const app::KeyRow& row = graph.rows[curve.row];
    if (view.keyRows.empty() || view.keyRows.back() != row) {
      view.keyRows.push_back(row);
    }
    view.keyComponents[row] |= componentBit(curve);
  }
}

void curves(PanelContext& context, const std::vector<GraphSubject>& subjects) {
  GraphState& graph = context.ui.time.graph;
  app::Session& session = context.character();
  const GraphSubject& subject = chosenSubject(context, subjects);
  CurveViewModel model;
  model.frames = visibleFrames(context);
  static_cast<void>(graphCurves(context, subject, model.frames));
  showRows(session.view(), graph);
  if (!session.isDragging() && lostFromSight(graph.curves, {graph.valueMin, graph.valueMax})) {
    graph.fitPending = true;
  }
  if (graph.fitPending) {
    fit(context);
  }
  toolbar(context, subjects, subject);
  model.curves = graph.curves;
  model.values = {graph.valueMin, graph.valueMax};
  model.playhead = session.view().frame;
  model.range = shownSpan(session);
  model.unit = graphUnit(context, subject);
  model.editable = !graph.rows.empty();
  model.snap = context.ui.time.timeline.snapToFrames;
  const float height = std::max(context.theme.px(60.0F), ImGui::GetContentRegionAvail().y);
  const CurveViewOutcome outcome = curveView(widgetsOf(context), "graph", model, graph.gesture, height);
  context.ui.time.keys = {outcome.hovered && model.editable,
                          true,
                          outcome.mouse.x,
                          outcome.mouse.y,
                          (graph.valueMax - graph.valueMin) / 100.0,
                          context.ui.time.keys.pressTaken};
  applyView(context, outcome);
  if (std::exchange(context.ui.time.keys.pressTaken,
                    context.ui.time.keys.pressTaken && !outcome.gestureEnded)) {
    return;
  }
  applyPicks(context, outcome);
  applyMenu(context, outcome);
  applyDrags(context, outcome);
}

} // namespace

void drawGraphPanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  if (!hasViewedClip(context)) {
    emptyState(widgets, icon::graph, "No curves",
               "Open a character with an animation, or import a clip, to see its curves here.");
    return;
  }
  if (context.ui.time.tab == BottomTab::dopeSheet) {
    drawDopeSheet(context);
    return;
  }
  const std::vector<GraphSubject> subjects = graphSubjects(context);
  if (subjects.empty()) {
    emptyState(widgets, icon::graph, "No limb selected",
               "Click a limb in the body picture, or select a controller, to see its curves.");
    return;
  }
  curves(context, subjects);
}

} // namespace stretch::ui
