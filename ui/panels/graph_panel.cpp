#include <algorithm>

#include "app/commands/frames.h"
#include "ui/panels/graph_model.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/panels/timeline_model.h"
#include "ui/widgets/curve_view.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void jointChooser(PanelContext& context, const rig::Limb& limb) {
  GraphState& graph = context.ui.graph;
  const Scene& scene = *context.character().document().scene;
  std::vector<Choice> choices;
  for (const NodeIndex node : graphNodes(limb)) {
    choices.push_back({nodeName(scene, node)});
  }
  graph.joint = std::clamp(graph.joint, 0, static_cast<int>(choices.size()) - 1);
  const int chosen = dropdown(widgetsOf(context), "graph/joint", choices, graph.joint,
                              {"Joint", "The joint of the selected limb whose curves are drawn.", {}},
                              context.theme.px(150.0F));
  if (chosen >= 0) {
    graph.joint = chosen;
    graph.fitPending = true;
  }
}

void channelChooser(PanelContext& context) {
  GraphState& graph = context.ui.graph;
  const WidgetContext widgets = widgetsOf(context);
  const std::vector<Choice> choices{
      {"Translation", {"Translation", "Local translation of the joint.", {}}},
      {"Rotation", {"Rotation", "Local rotation of the joint as angles, in degrees.", {}}},
      {"Scale", {"Scale", "Local scale of the joint.", {}}},
      {"Length", {"Length", "Length of the limb, straight from its base to its end.", {}}}};
  ImGui::BeginChild("graph/channels", {context.theme.px(344.0F), context.theme.rowHeight()});
  const int chosen = segmented(widgets, "graph/channel", choices, static_cast<int>(graph.channels));
  ImGui::EndChild();
  if (chosen >= 0) {
    graph.channels = static_cast<GraphChannels>(chosen);
    graph.fitPending = true;
  }
}

void toolbar(PanelContext& context, const rig::Limb& limb) {
  const WidgetContext widgets = widgetsOf(context);
  GraphState& graph = context.ui.graph;
  jointChooser(context, limb);
  ImGui::SameLine();
  channelChooser(context);
  ImGui::SameLine();
  ButtonSpec fit{.id = "graph/fit", .icon = icon::fit, .text = "Fit", .emphasis = Emphasis::quiet};
  fit.help = {"Fit the curves",
              "Shows every value in the visible frames. A double click in the graph does the same.",
              {}};
  if (button(widgets, fit)) {
    graph.fitPending = true;
  }
  ImGui::SameLine();
  if (const int clicked = curveLegend(widgets, "graph/curve", graph.curves); clicked >= 0) {
    const auto index = static_cast<std::size_t>(clicked);
    graph.hidden[index] = !graph.hidden[index];
  }
}

void applyOutcome(PanelContext& context, const CurveViewOutcome& outcome) {
  GraphState& graph = context.ui.graph;
  if (outcome.framesChanged) {
    context.ui.timeline.viewStart = outcome.frames.start;
    context.ui.timeline.viewEnd = outcome.frames.end;
  }
  if (outcome.valuesChanged) {
    graph.valueMin = outcome.values.start;
    graph.valueMax = outcome.values.end;
  }
  if (outcome.playheadMoved) {
    const double last = app::lastFrame(context.character().document(), context.character().view().clip);
    context.character().view().frame = std::clamp(outcome.playhead, 0.0, last);
  }
  graph.fitPending = graph.fitPending || outcome.fitAsked;
}

void curves(PanelContext& context, const rig::Limb& limb) {
  GraphState& graph = context.ui.graph;
  CurveViewModel model;
  model.frames = visibleFrames(context);
  model.curves = graphCurves(context, limb, model.frames);
  if (graph.fitPending) {
    const Span fitted = fittedValues(model.curves);
    graph.valueMin = fitted.start;
    graph.valueMax = fitted.end;
    graph.fitPending = false;
  }
  toolbar(context, limb);
  model.values = {graph.valueMin, graph.valueMax};
  model.playhead = context.character().view().frame;
  model.range = shownRange(context.character());
  model.unit = graphUnit(graph.channels);
  const float height = std::max(context.theme.px(80.0F), ImGui::GetContentRegionAvail().y);
  applyOutcome(context, curveView(widgetsOf(context), "graph", model, height));
}

} // namespace

void drawGraphPanel(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  if (!hasViewedClip(context)) {
    emptyState(widgets, icon::graph, "No curves",
               "Open a character with an animation to see its curves here.");
    return;
  }
  if (context.ui.bottomTab == BottomTab::dopeSheet) {
    drawDopeSheet(context);
    return;
  }
  const std::vector<std::string>& limbs = context.character().view().selectedLimbs;
  const rig::Limb* selected =
      limbs.empty() ? nullptr : app::findLimb(context.character().document(), limbs.front());
  if (selected == nullptr || graphNodes(*selected).empty()) {
    emptyState(widgets, icon::graph, "No limb selected",
               "Click a limb in the body picture to see the curves of its joints.");
    return;
  }
  curves(context, rig::Limb(*selected));
}

} // namespace stretch::ui
