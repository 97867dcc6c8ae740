#include "ui/widgets/curve_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/widgets/shapes.h"

namespace stretch::ui {

namespace {

constexpr float valueColumn = 52.0F;
constexpr float frameRow = 20.0F;

struct Plot {
  Rect box;
  Axis frames;
  Axis values;

  [[nodiscard]] ImVec2 at(const Vec2& point) const {
    return {frames.toPixel(point.x), values.toPixel(point.y)};
  }
};

Plot plotOf(const Theme& theme, const Rect& box, const CurveViewModel& model) {
  Plot plot;
  plot.box = {{box.min.x + theme.px(valueColumn), box.min.y}, {box.max.x, box.max.y - theme.px(frameRow)}};
  plot.frames = {model.frames.start, std::max(model.frames.end, model.frames.start + 1e-6),
                 plot.box.min.x + theme.px(8.0F), plot.box.max.x - theme.px(12.0F)};
  plot.values = {model.values.start, std::max(model.values.end, model.values.start + 1e-9), plot.box.max.y,
                 plot.box.min.y};
  return plot;
}

void drawValueGrid(const WidgetContext& context, const Rect& box, const Plot& plot) {
  const Theme& theme = context.theme;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const double step = markStep(plot.values, theme.px(24.0F), false);
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 5);
  for (const double value : marks(plot.values, step)) {
    const float y = plot.values.toPixel(value);
    const bool zero = std::abs(value) < step * 1e-6;
    list->AddLine({plot.box.min.x, y}, {plot.box.max.x, y},
                  faded(zero ? theme.colours.quietText : theme.colours.border, 0.45F));
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, zero ? 0.0 : value);
    const float half = theme.px(9.0F);
    if (y - half > box.min.y && y + half < plot.box.max.y) {
      drawText(context, theme.fonts.label,
               {{box.min.x, y - half}, {plot.box.min.x - theme.px(6.0F), y + half}}, theme.colours.quietText,
               text, 1.0F);
    }
  }
}

void drawFrameGrid(const WidgetContext& context, const Rect& box, const Plot& plot,
                   const CurveViewModel& model) {
  const Theme& theme = context.theme;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float left = std::max(plot.frames.toPixel(model.range.start), plot.box.min.x);
  const float right = std::min(plot.frames.toPixel(model.range.end), plot.box.max.x);
  if (right > left) {
    list->AddRectFilled({left, plot.box.min.y}, {right, plot.box.max.y}, faded(theme.colours.accent, 0.06F));
  }
  for (const double frame : marks(plot.frames, markStep(plot.frames, theme.px(52.0F), true))) {
    const float x = plot.frames.toPixel(frame);
    list->AddLine({x, plot.box.min.y}, {x, plot.box.max.y}, faded(theme.colours.border, 0.45F));
    char text[24];
    std::snprintf(text, sizeof text, "%.0f", frame);
    const float half = theme.px(26.0F);
    drawText(context, theme.fonts.label, {{x - half, plot.box.max.y}, {x + half, box.max.y}},
             theme.colours.quietText, text, 0.5F);
  }
}

std::vector<ImVec2> screenLine(const Plot& plot, const std::vector<Vec2>& points) {
  std::vector<ImVec2> line;
  line.reserve(points.size());
  for (const Vec2& point : points) {
    line.push_back(plot.at(point));
  }
  return line;
}

void drawCurve(const Theme& theme, const Plot& plot, const Curve& curve) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (!curve.before.empty()) {
    addDashedPolyline(*list, screenLine(plot, curve.before), faded(curve.colour, 0.55F), theme.px(1.0F),
                      theme.px(4.0F), theme.px(4.0F));
  }
  const std::vector<ImVec2> line = screenLine(plot, curve.points);
  list->AddPolyline(line.data(), static_cast<int>(line.size()), curve.colour, ImDrawFlags_None,
                    theme.px(1.75F));
  float lastX = -1e9F;
  for (const Vec2& key : curve.keys) {
    const ImVec2 at = plot.at(key);
    if (at.x - lastX >= theme.px(4.0F)) {
      addDiamond(*list, at, theme.px(3.5F), curve.colour);
      lastX = at.x;
    }
  }
}

void readout(const WidgetContext& context, const Plot& plot, const CurveViewModel& model,
             const ImVec2& mouse) {
  const Theme& theme = context.theme;
  const double frame = std::round(plot.frames.toValue(mouse.x));
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float x = plot.frames.toPixel(frame);
  list->AddLine({x, plot.box.min.y}, {x, plot.box.max.y}, faded(theme.colours.quietText, 0.5F));
  std::string text;
  for (const Curve& curve : model.curves) {
    if (!curve.hidden && !curve.points.empty()) {
      const double value = curveValue(curve.points, frame);
      list->AddCircleFilled(plot.at({frame, value}), theme.px(3.0F), curve.colour);
      char line[96];
      std::snprintf(line, sizeof line, "%s%s %.4g%s", text.empty() ? "" : "\n", curve.label.c_str(), value,
                    model.unit);
      text += line;
    }
  }
  char title[32];
  std::snprintf(title, sizeof title, "Frame %.0f", frame);
  tooltipNow(context, {.title = title, .text = text});
}

void navigate(const Plot& plot, const CurveViewModel& model, const ImVec2& mouse, CurveViewOutcome& outcome) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel != 0.0F) {
    const double factor = std::pow(0.85, static_cast<double>(io.MouseWheel));
    if (io.KeyCtrl) {
      outcome.values = zoomed(model.values, plot.values.toValue(mouse.y), factor, 1e-6, 1e7);
      outcome.valuesChanged = true;
    } else {
      outcome.frames = zoomed(model.frames, plot.frames.toValue(mouse.x), factor, 4.0, 1e6);
      outcome.framesChanged = true;
    }
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0F)) {
    const double dx = -plot.frames.valuesPerPixel() * static_cast<double>(io.MouseDelta.x);
    const double dy = plot.values.valuesPerPixel() * static_cast<double>(io.MouseDelta.y);
    outcome.frames = {model.frames.start + dx, model.frames.end + dx};
    outcome.values = {model.values.start + dy, model.values.end + dy};
    outcome.framesChanged = outcome.valuesChanged = true;
  }
}

} // namespace

double curveValue(const std::vector<Vec2>& points, double frame) {
  if (points.empty()) {
    return 0.0;
  }
  const auto after =
      std::upper_bound(points.begin(), points.end(), frame, [](double f, const Vec2& p) { return f < p.x; });
  if (after == points.begin() || after == points.end()) {
    return after == points.begin() ? points.front().y : points.back().y;
  }
  const Vec2& a = *(after - 1);
  const Vec2& b = *after;
  return a.y + (b.y - a.y) * (frame - a.x) / (b.x - a.x);
}

Span fittedValues(const std::vector<Curve>& curves) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Curve& curve : curves) {
    for (const std::vector<Vec2>* points : {&curve.points, &curve.before}) {
      for (const Vec2& point : *points) {
        low = curve.hidden ? low : std::min(low, point.y);
        high = curve.hidden ? high : std::max(high, point.y);
      }
    }
  }
  if (low > high) {
    return {-1.0, 1.0};
  }
  const double margin = std::max((high - low) * 0.12, std::max(std::abs(high) * 1e-3, 1e-3));
  return {low - margin, high + margin};
}

CurveViewOutcome curveView(const WidgetContext& context, const std::string& id, const CurveViewModel& model,
                           float height) {
  const Theme& theme = context.theme;
  CurveViewOutcome outcome;
  const Control control = takePlace(context, id, {ImGui::GetContentRegionAvail().x, height});
  if (!control.visible) {
    return outcome;
  }
  const Plot plot = plotOf(theme, control.box, model);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(control.box.min, control.box.max, theme.colours.sunken, theme.corner());
  drawValueGrid(context, control.box, plot);
  drawFrameGrid(context, control.box, plot, model);
  list->PushClipRect(plot.box.min, plot.box.max, true);
  for (const Curve& curve : model.curves) {
    if (!curve.hidden) {
      drawCurve(theme, plot, curve);
    }
  }
  const float x = std::round(plot.frames.toPixel(model.playhead));
  list->AddRectFilled({x - theme.px(0.75F), plot.box.min.y}, {x + theme.px(0.75F), plot.box.max.y},
                      theme.colours.text);
  if (control.hovered && !control.held && plot.box.contains(mouse)) {
    readout(context, plot, model, mouse);
  }
  list->PopClipRect();
  if (control.held) {
    outcome.playhead = std::round(plot.frames.toValue(mouse.x));
    outcome.playheadMoved = outcome.playhead != model.playhead;
  }
  if (control.hovered) {
    navigate(plot, model, mouse, outcome);
    outcome.fitAsked = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  }
  return outcome;
}

int curveLegend(const WidgetContext& context, const std::string& id, const std::vector<Curve>& curves) {
  const Theme& theme = context.theme;
  int clicked = -1;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i];
    if (i > 0) {
      ImGui::SameLine(0.0F, theme.px(4.0F));
    }
    const float width = theme.px(26.0F) + textSize(theme.fonts.label, curve.label).x;
    const Control control = takePlace(context, id + "/" + curve.label, {width, theme.rowHeight()});
    if (control.visible) {
      ImDrawList* list = ImGui::GetWindowDrawList();
      if (control.hovered) {
        list->AddRectFilled(control.box.min, control.box.max, theme.colours.hovered, theme.corner());
      }
      const float opacity = curve.hidden ? 0.35F : 1.0F;
      const ImVec2 dot(control.box.min.x + theme.px(9.0F), control.box.centre().y);
      list->AddCircleFilled(dot, theme.px(4.0F), faded(curve.colour, opacity));
      const Rect text{{control.box.min.x + theme.px(18.0F), control.box.min.y}, control.box.max};
      drawText(context, theme.fonts.label, text, faded(theme.colours.text, opacity), curve.label);
    }
    tooltip(context, {.title = curve.label,
                      .text = curve.hidden ? "Click to show this curve." : "Click to hide this curve."});
    clicked = control.clicked ? static_cast<int>(i) : clicked;
  }
  return clicked;
}

} // namespace stretch::ui
