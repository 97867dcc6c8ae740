#include <algorithm>

#include <fmt/format.h>

#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/scatter_plot.h"

namespace stretch::ui {

namespace {

constexpr ImU32 lineColour = trailPalette[0];
constexpr ImU32 monotoneColour = trailPalette[1];

void facts(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const MeshSequence& mesh = *context.sequence().document().mesh;
  valueRow(widgets, "Name", mesh.name);
  valueRow(widgets, "Frames",
           fmt::format("{}, {} fps", mesh.frameCount(), shortNumber(mesh.framesPerSecond)));
  valueRow(widgets, "Vertices", std::to_string(mesh.vertexCount));
  valueRow(widgets, "Triangles", std::to_string(mesh.triangles.size()));
  for (const std::string& warning : mesh.warnings) {
    notice(widgets, NoticeKind::warning, capitalised(warning) + ".");
  }
  if (!context.sequence().document().analysis->problem.empty()) {
    notice(widgets, NoticeKind::info,
           capitalised(context.sequence().document().analysis->problem) +
               ": its bones are parts that move alike; elastic stretch goes limb by limb.");
  }
}

PlotLine straight(const skinning::LineFit& line, const Span& span) {
  const auto at = [&](double x) { return Vec2(x, line.slope * x + line.intercept); };
  return {lineColour, {at(span.start), at(span.end)}};
}

PlotLine stepped(const skinning::MonotoneFit& fit) {
  PlotLine line{monotoneColour, {}};
  for (std::size_t i = 0; i < fit.curvatures.size(); ++i) {
    line.points.emplace_back(fit.curvatures[i], fit.lengths[i]);
  }
  return line;
}

ScatterPlotModel modelOf(const PanelContext& context, const skinning::LengthFunction& fit) {
  const app::SequenceSession& session = context.sequence();
  const std::vector<skinning::CurvatureLength>& frames = app::measuredFrames(session.document());
  const std::size_t first = session.document().settings.body.firstFittedFrame;
  ScatterPlotModel model;
  model.xLabel = "curvature \xCE\xBA [rad]";
  model.yLabel = "length [units of the mesh]";
  model.pointColour = context.theme.colours.accent;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    model.points.push_back({{frames[i].curvatureRadians, frames[i].length}, i < first});
  }
  model.current = app::shownFrame(session);
  Span span{1e300, -1e300};
  for (std::size_t i = std::min(first, frames.size() - 1); i < frames.size(); ++i) {
    span.start = std::min(span.start, frames[i].curvatureRadians);
    span.end = std::max(span.end, frames[i].curvatureRadians);
  }
  model.lines = {stepped(fit.monotone), straight(fit.line, span)};
  model.describe = [&frames](std::size_t i) {
    return fmt::format("Frame {}: {:.3f} rad, {:.4g} long", i, frames[i].curvatureRadians, frames[i].length);
  };
  return model;
}

/// A line of text behind a piece of the curve that it speaks of.
void fitRow(PanelContext& context, const char* id, ImU32 colour, const std::string& text, const Help& help) {
  const WidgetContext widgets = widgetsOf(context);
  const Theme& theme = context.theme;
  const Control row = takePlace(widgets, id, {ImGui::GetContentRegionAvail().x, theme.px(20.0F)}, false);
  const float y = row.box.centre().y;
  ImGui::GetWindowDrawList()->AddLine({row.box.min.x, y}, {row.box.min.x + theme.px(14.0F), y}, colour,
                                      theme.px(2.0F));
  drawText(widgets, theme.fonts.label, {{row.box.min.x + theme.px(20.0F), row.box.min.y}, row.box.max},
           theme.colours.text, text);
  tooltip(widgets, help);
}

void lengthSection(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  app::SequenceSession& session = context.sequence();
  const skinning::LengthFunction fit = app::fittedLength(session.document());
  const ScatterPlotModel model = modelOf(context, fit);
  if (const auto clicked = scatterPlot(widgets, "sequence/plot", model, context.theme.px(196.0F))) {
    session.view().frame = static_cast<double>(*clicked);
  }
  fitRow(context, "sequence/fit-line", lineColour,
         fmt::format("{:.4g} \xCE\xBA {} {:.4g}   R\xC2\xB2 {:.3f}", fit.line.slope,
                     fit.line.intercept < 0.0 ? "\xE2\x88\x92" : "+", std::abs(fit.line.intercept),
                     fit.line.rSquared),
         {"The paper's line",
          "Slope and intercept of length over curvature, and the share of the variance "
          "that the line explains.",
          {}});
  fitRow(context, "sequence/fit-monotone", monotoneColour,
         fmt::format("monotone curve   R\xC2\xB2 {:.3f}", fit.monotone.rSquared),
         {"The monotone curve", "Never rises with curvature; follows a length that saturates.", {}});
  note(widgets, fmt::format("Fits use frames {} to {}, {} of {}.", model.points.size() - fit.frameCount,
                            model.points.size() - 1, fit.frameCount, model.points.size()));
  if (!fit.remark.empty()) {
    notice(widgets, NoticeKind::warning, capitalised(fit.remark) + ".");
  }
}

} // namespace

void drawSequenceFacts(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  panelTitle(widgets, icon::film, "Sequence");
  facts(context);
  if (app::measuredFrames(context.sequence().document()).empty()) {
    return;
  }
  if (section(widgets, "sequence/length", "Length and curvature", context.ui.closedSections)) {
    lengthSection(context);
  }
}

} // namespace stretch::ui
