#include "ui/widgets/scatter_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stretch::ui {

namespace {

constexpr float scatterValueColumn = 40.0F;
constexpr float labelRow = 18.0F;
constexpr float reachOfMouse = 8.0F;

struct ScatterArea {
  Rect box;
  Axis x;
  Axis y;

  [[nodiscard]] ImVec2 at(const Vec2& point) const { return {x.toPixel(point.x), y.toPixel(point.y)}; }
};

ScatterArea plotOf(const Theme& theme, const Rect& box, const ScatterPlotModel& model) {
  ScatterArea plot;
  plot.box = {{box.min.x + theme.px(scatterValueColumn), box.min.y + theme.px(labelRow)},
              {box.max.x - theme.px(6.0F), box.max.y - theme.px(2.0F * labelRow)}};
  const Span across = plottedSpan(model, 0);
  const Span up = plottedSpan(model, 1);
  plot.x = {across.start, across.end, plot.box.min.x, plot.box.max.x};
  plot.y = {up.start, up.end, plot.box.max.y, plot.box.min.y};
  return plot;
}

std::string markText(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 5);
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < step * 1e-6 ? 0.0 : value);
  return text;
}

void drawGrid(const WidgetContext& context, const ScatterArea& plot) {
  const Theme& theme = context.theme;
  const ImU32 line = faded(theme.colours.border, 0.45F);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(plot.box.min, plot.box.max, theme.colours.sunken, theme.corner());
  const float half = theme.px(9.0F);
  const double stepX = markStep(plot.x, theme.px(40.0F), false);
  for (const double value : marks(plot.x, stepX)) {
    const float x = plot.x.toPixel(value);
    list->AddLine({x, plot.box.min.y}, {x, plot.box.max.y}, line);
    const float wide = theme.px(24.0F);
    drawText(context, theme.fonts.label,
             {{x - wide, plot.box.max.y}, {x + wide, plot.box.max.y + theme.px(labelRow)}},
             theme.colours.quietText, markText(value, stepX), 0.5F);
  }
  const double stepY = markStep(plot.y, theme.px(28.0F), false);
  for (const double value : marks(plot.y, stepY)) {
    const float y = plot.y.toPixel(value);
    list->AddLine({plot.box.min.x, y}, {plot.box.max.x, y}, line);
    if (y - half < plot.box.min.y) {
      continue; // The label of the axis stands there.
    }
    drawText(context, theme.fonts.label,
             {{plot.box.min.x - theme.px(scatterValueColumn), y - half},
              {plot.box.min.x - theme.px(5.0F), y + half}},
             theme.colours.quietText, markText(value, stepY), 1.0F);
  }
}

void drawLabels(const WidgetContext& context, const Rect& box, const ScatterArea& plot,
                const ScatterPlotModel& model) {
  const Theme& theme = context.theme;
  drawText(context, theme.fonts.label, {box.min, {box.max.x, box.min.y + theme.px(labelRow)}},
           theme.colours.quietText, model.yLabel);
  drawText(context, theme.fonts.label, {{plot.box.min.x, box.max.y - theme.px(labelRow)}, box.max},
           theme.colours.quietText, model.xLabel, 1.0F);
}

void drawContent(const WidgetContext& context, const ScatterArea& plot, const ScatterPlotModel& model) {
  const Theme& theme = context.theme;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(plot.box.min, plot.box.max, true);
  for (const PlotPoint& point : model.points) {
    const float radius = theme.px(2.5F);
    if (point.quiet) {
      list->AddCircle(plot.at(point.at), radius, faded(theme.colours.quietText, 0.8F), 0, theme.px(1.0F));
    } else {
      list->AddCircleFilled(plot.at(point.at), radius, faded(model.pointColour, 0.85F));
    }
  }
  for (const PlotLine& line : model.lines) {
    std::vector<ImVec2> points;
    for (const Vec2& point : line.points) {
      points.push_back(plot.at(point));
    }
    list->AddPolyline(points.data(), static_cast<int>(points.size()), line.colour, ImDrawFlags_None,
                      theme.px(2.0F));
  }
  if (model.current && *model.current < model.points.size()) {
    const ImVec2 at = plot.at(model.points[*model.current].at);
    list->AddCircle(at, theme.px(6.0F), theme.colours.text, 0, theme.px(1.5F));
  }
  list->PopClipRect();
}

std::optional<std::size_t> pointUnder(const Theme& theme, const ScatterArea& plot,
                                      const ScatterPlotModel& model, const ImVec2& mouse) {
  std::optional<std::size_t> nearest;
  float least = theme.px(reachOfMouse);
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const ImVec2 at = plot.at(model.points[i].at);
    const float distance = std::hypot(at.x - mouse.x, at.y - mouse.y);
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

} // namespace

Span plottedSpan(const ScatterPlotModel& model, int direction) {
  double low = 1e300;
  double high = -1e300;
  const auto add = [&](const Vec2& point) {
    const double value = direction == 0 ? point.x : point.y;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const PlotPoint& point : model.points) {
    add(point.at);
  }
  for (const PlotLine& line : model.lines) {
    std::for_each(line.points.begin(), line.points.end(), add);
  }
  if (low > high) {
    return {0.0, 1.0};
  }
  const double margin = std::max(0.06 * (high - low), 1e-6 * (1.0 + std::abs(high)));
  return {low - margin, high + margin};
}

std::optional<std::size_t> scatterPlot(const WidgetContext& context, const std::string& id,
                                       const ScatterPlotModel& model, float height) {
  const Control place = takePlace(context, id, {ImGui::GetContentRegionAvail().x, height});
  if (!place.visible) {
    return std::nullopt;
  }
  const ScatterArea plot = plotOf(context.theme, place.box, model);
  drawGrid(context, plot);
  drawLabels(context, place.box, plot, model);
  drawContent(context, plot, model);
  const auto under = place.hovered ? pointUnder(context.theme, plot, model, ImGui::GetIO().MousePos)
                                   : std::optional<std::size_t>();
  if (under && model.describe) {
    tooltipNow(context, {.title = model.describe(*under), .text = "Click to go there."});
  }
  return place.clicked ? under : std::nullopt;
}

} // namespace stretch::ui
