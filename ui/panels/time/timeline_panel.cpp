#include <algorithm>
#include <cmath>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/moments.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "ui/panels/context/key_bar.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/panels/rows/shown_holds.h"
#include "ui/panels/rows/timeline_model.h"
#include "ui/panels/time/transport.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void applyRange(app::Session& session, const TimelineOutcome& outcome) {
  if (outcome.rangeChanged) {
    app::setRangeByHand(session, {outcome.range.start, outcome.range.end});
  }
  if (outcome.playheadMoved) {
    session.view().frame = outcome.playhead;
  }
}

/// Control spheres keep their place in the range's time when the whole range moves.
void moveRange(rig::TrailSettings& settings, const Span& span) {
  const double shift = span.start - settings.startFrame;
  const bool whole = std::abs((span.end - settings.endFrame) - shift) < 1e-9;
  if (whole) {
    for (rig::SphereOffset& sphere : settings.spheres) {
      sphere.frame += shift;
    }
  }
  settings.startFrame = span.start;
  settings.endFrame = span.end;
}

/// What the bar that is dragged says of a trail.
Result<app::Document> withBar(const app::Document& document, int id, const TimelineOutcome& outcome) {
  const rig::Trail* const trail = app::findTrail(document, id);
  if (trail == nullptr) {
    return app::missingTrail(id);
  }
  rig::TrailSettings settings = trail->settings;
  if (outcome.barChanged) {
    moveRange(settings, outcome.barSpan);
  } else {
    const double frames = settings.pivot == rig::Pivot::start ? outcome.releaseEdge - settings.endFrame
                                                              : settings.startFrame - outcome.releaseEdge;
    settings.releaseFrames = std::max(0.0, frames);
  }
  return app::setTrailSettings(document, id, settings);
}

/// The trail of the bar that is dragged; with it those of its group that are selected too and have its range.
std::vector<int> editedWith(const app::Session& session, int id) {
  std::vector<int> edited{id};
  const rig::Trail* const dragged = app::findTrail(session.atBegin(), id);
  for (const int member : app::groupMembers(session.atBegin(), id)) {
    const rig::Trail& other = *app::findTrail(session.atBegin(), member);
    if (member != id && app::isSelected(session, other.limb) && app::isSelected(session, dragged->limb) &&
        other.settings.startFrame == dragged->settings.startFrame &&
        other.settings.endFrame == dragged->settings.endFrame) {
      edited.push_back(member);
    }
  }
  return edited;
}

/// The hand or foot that a hold is about is selected, so that its keys act on it.
void selectHeld(app::Session& session, const app::HoldPlace& place) {
  for (const ShownHold& hold : shownHolds(session.document(), session.view().clip)) {
    if (hold.place == place) {
      app::selectLimb(session, hold.limb, false);
    }
  }
}

void selectBar(app::Session& session, int bar) {
  if (const std::optional<app::HoldPlace> hold = holdOfBar(bar)) {
    selectHeld(session, *hold);
  } else if (bar != 0) {
    app::selectTrail(session, bar);
  }
}

void dragHold(PanelContext& context, const app::HoldPlace& place, const TimelineOutcome& outcome) {
  const Vec2 range(outcome.barSpan.start, outcome.barSpan.end);
  editHold(context, {outcome.barChanged, outcome.gestureEnded}, "Change the range of a hold", place,
           [&](rig::HoldTime& time, double&) { time.rangeFrames = range; });
}

void applyBars(PanelContext& context, const TimelineOutcome& outcome) {
  app::Session& session = context.character();
  selectBar(session, outcome.clickedBar);
  if (const std::optional<app::HoldPlace> hold = holdOfBar(outcome.editedBar)) {
    dragHold(context, *hold, outcome);
    return;
  }
  const EditPhase phase{outcome.barChanged || outcome.releaseChanged, outcome.gestureEnded};
  const std::vector<int> edited = editedWith(session, outcome.editedBar);
  editThrough(context, phase, outcome.releaseChanged ? "Change the release" : "Change the range",
              [&](const app::Document& start) -> Result<app::Document> {
                Result<app::Document> changed = start;
                for (const int id : edited) {
                  changed = changed ? withBar(*changed, id, outcome) : changed;
                }
                return changed;
              });
}

void applyView(PanelContext& context, const TimelineOutcome& outcome) {
  if (outcome.viewChanged) {
    context.ui.time.timeline.viewStart = outcome.view.start;
    context.ui.time.timeline.viewEnd = outcome.view.end;
  }
}

/// The keys of the dope sheet that a box is around.
app::KeySelection keysIn(PanelContext& context, const KeyBox& box) {
  const app::Session& session = context.character();
  app::KeySelection selection;
  const auto& keyed = context.ui.time.rows.keyed;
  for (std::size_t row = box.firstRow; row <= box.lastRow && row < keyed.size(); ++row) {
    selection = app::joined(selection, app::keysBetween(session.document(), session.view().clip, keyed[row],
                                                        box.frames.start, box.frames.end));
  }
  return selection;
}

/// Picks the keys that a menu is about, where they can be edited and are not among the picked ones.
void pickForMenu(PanelContext& context, const KeyBox& box) {
  app::Session& session = context.character();
  const app::KeySelection under = keysIn(context, box);
  if (context.ui.time.tab == BottomTab::dopeSheet &&
      app::joined(app::pickedKeys(session), under) != app::pickedKeys(session)) {
    app::pickKeys(session, under, false);
  }
}

/// A right click: the trail or the key that lies there is selected; the playhead stays until an entry is
/// chosen.
void applyMenu(PanelContext& context, const TimelineOutcome& outcome) {
  app::Session& session = context.character();
  const bool mayAsk = !session.isDragging(); // else a running tool has the keys
  if (mayAsk && outcome.menu.bar != 0) {
    selectBar(session, outcome.menu.bar);
    context.ui.menu.hold = outcome.menu.bar;
    askForMenu(context.ui, outcome.menu.bar < 0 ? MenuTarget::hold : MenuTarget::trail,
               MenuPlace{ImGui::GetIO().MousePos.x, outcome.menu.row.min.y, outcome.menu.row.max.y});
  } else if (mayAsk && outcome.menu.asked) {
    context.ui.menu.frame = outcome.menu.frame;
    if (outcome.menu.onKey && !outcome.menu.onRange) {
      pickForMenu(context, outcome.menu.keys);
    }
    askForMenu(context.ui, outcome.menu.onRange ? MenuTarget::range
                           : outcome.menu.onKey ? MenuTarget::key
                                                : MenuTarget::time);
  }
  if (outcome.doubleClickedBar > 0) {
    app::selectTrail(session, outcome.doubleClickedBar);
    request(context, command::trailRename);
  }
}

/// What is seen of time belongs to the clip that is shown and the rate that it is counted in.
void followClip(PanelContext& context) {
  const app::Session& session = context.character();
  TimelineState& time = context.ui.time.timeline;
  const int clip = session.view().clip;
  const double rate = app::clipOf(session.document(), clip).framesPerSecond;
  if (time.seenClip == clip && time.seenRate != rate && time.viewEnd > time.viewStart) {
    time.viewStart *= rate / time.seenRate;
    time.viewEnd *= rate / time.seenRate;
  } else if (time.seenClip != clip) {
    time.viewStart = 0.0;
    time.viewEnd = -1.0;
  }
  context.ui.time.graph.fitPending =
      context.ui.time.graph.fitPending || time.seenClip != clip || time.seenRate != rate;
  time.seenClip = clip;
  time.seenRate = rate;
}

/// Picking and dragging keys in the dope sheet.
void applyKeys(PanelContext& context, const TimelineOutcome& outcome) {
  app::Session& session = context.character();
  if (outcome.keysPicked) {
    app::pickKeys(session, keysIn(context, *outcome.keysPicked), outcome.keysPicked->add);
  } else if (outcome.clickedBesideKeys) {
    app::pickKeys(session, {}, false);
  }
  editPicked(context, {outcome.keyFrames.has_value(), outcome.gestureEnded}, "Move",
             [&](const app::Document& start, const app::KeySelection& held) {
               return app::moveKeys(start, session.view().clip, held, {outcome.keyFrames.value_or(0.0), 0.0});
             });
}

/// The dope sheet owns the keys of the keyboard while the mouse is over it.
void ownKeys(PanelContext& context, const TimelineOutcome& outcome) {
  app::Session& session = context.character();
  session.view().keyRows = app::keyedRows(session.document(), session.view().clip);
  session.view().keyComponents.clear();
  KeyPane& pane = context.ui.time.keys;
  pane = {outcome.hovered, false, outcome.mouseFrame, 0.0, 1.0, pane.pressTaken && !outcome.gestureEnded};
}

/// A press goes to the moment; under the mouse its path is shown.
void applyMoments(PanelContext& context, const TimelineOutcome& outcome) {
  if (!outcome.moment) {
    return;
  }
  app::Session& session = context.character();
  context.ui.time.hoveredMoment = app::shownMoments(session)[*outcome.moment];
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    app::goToMoment(session, *context.ui.time.hoveredMoment);
  }
}

void timeRows(PanelContext& context, const char* id, RowDetail detail) {
  const TimelineModel model = timelineModel(context, detail);
  ImGui::BeginChild(id, ImGui::GetContentRegionAvail(), false,
                    ImGuiWindowFlags_NoScrollWithMouse); // the wheel zooms
  const float height = std::max(timelineHeight(context.theme, model), ImGui::GetContentRegionAvail().y);
  const TimelineOutcome outcome = timeline(widgetsOf(context), id, model, context.ui.time.gesture,
                                           timelineLabelWidth(context.theme, model), height);
  ImGui::EndChild();
  applyRange(context.character(), outcome);
  applyMoments(context, outcome);
  const bool pressTaken = context.ui.time.keys.pressTaken;
  if (model.keysEditable) {
    ownKeys(context, outcome);
  }
  if (model.keysEditable && !pressTaken) {
    applyKeys(context, outcome);
  }
  applyBars(context, outcome);
  applyView(context, outcome);
  applyMenu(context, outcome);
}

void tabs(PanelContext& context) {
  ImGui::BeginChild("bottom/tabs", {context.theme.px(288.0F), context.theme.rowHeight()});
  const std::vector<Choice> choices{
      {"Timeline",
       {"Timeline", "Keys of the selection and trails over time.", keyOf(context, command::showTimeline)}},
      {"Graph",
       {"Graph", "Curves of the selection, whose keys are edited here.", keyOf(context, command::showGraph)}},
      {"Dope sheet",
       {"Dope sheet", "Keys of every limb and controller: pick, move, scale, copy.",
        keyOf(context, command::showDopeSheet)}}};
  const int chosen =
      segmented(widgetsOf(context), "bottom/tab", choices, static_cast<int>(context.ui.time.tab));
  ImGui::EndChild();
  context.ui.time.tab = chosen >= 0 ? static_cast<BottomTab>(chosen) : context.ui.time.tab;
}

/// A character without a clip is offered one.
void noClip(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  if (!hasCharacter(context)) {
    emptyState(widgets, icon::clock, "No clip",
               "Open a character with an animation to see its time and curves here.");
    return;
  }
  const app::Document& document = context.character().document();
  if (!document.body.isBiped && document.scene->skins.empty()) {
    emptyState(widgets, icon::clock, "No clip",
               "This mesh has no joints yet. Fit locators and bind it; then import a clip of another file.");
    return;
  }
  emptyState(
      widgets, icon::clock, "No clip",
      "This character has no animation. Import a clip of another file: time and curves are then here.");
  const float width = context.theme.px(160.0F);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * (ImGui::GetContentRegionAvail().x - width));
  commandButton(
      context,
      {.command = command::clipImport, .icon = icon::film, .emphasis = Emphasis::primary, .width = width});
}

} // namespace

void drawBottomPanel(PanelContext& context) {
  if (!hasViewedClip(context)) {
    noClip(context);
    return;
  }
  followClip(context);
  tabs(context);
  ImGui::SameLine(0.0F, context.theme.px(16.0F));
  if (context.ui.time.tab == BottomTab::timeline) {
    drawTimelinePanel(context);
  } else {
    drawTransport(context);
    drawGraphPanel(context);
  }
}

void drawTimelinePanel(PanelContext& context) {
  if (hasViewedClip(context)) {
    drawTransport(context);
    timeRows(context, "timeline", RowDetail::selection);
  }
}

void drawDopeSheet(PanelContext& context) {
  if (hasViewedClip(context)) {
    timeRows(context, "dope-sheet", RowDetail::everyLimb);
  }
}

} // namespace stretch::ui
