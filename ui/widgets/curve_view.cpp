#include "ui/widgets/curve_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>

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

/// The keys of a curve that are in sight.
std::span<const CurveKey> keysBetween(const Curve& curve, double start, double end) {
  const auto isBefore = [](const CurveKey& key, double frame) { return key.at.x < frame; };
  const auto first = std::lower_bound(curve.keys.begin(), curve.keys.end(), start, isBefore);
  const auto last = std::lower_bound(first, curve.keys.end(), end, isBefore);
  return {first, last};
}

std::span<const CurveKey> visibleKeys(const Plot& plot, const Curve& curve) {
  return keysBetween(curve, plot.frames.start - 1.0, plot.frames.end + 1.0);
}

/// What is worth drawing of many curves: with thousands of keys in sight none says anything.
struct Detail {
  bool keys = true;
  bool pickedKeys = true; ///< Else their curves are drawn as keys would be.
  bool thin = false;
};

Detail detailOf(const Plot& plot, const CurveViewModel& model) {
  constexpr std::size_t mostKeys = 8000;
  constexpr std::size_t mostPoints = 20000;
  std::size_t keys = 0;
  std::size_t picked = 0;
  std::size_t points = 0;
  for (const Curve& curve : model.curves) {
    const std::size_t visible = curve.hidden ? 0 : visibleKeys(plot, curve).size();
    keys += visible;
    picked += std::min(visible, curve.picked);
    points += curve.hidden ? 0 : curve.points.size();
  }
  return {keys <= mostKeys, picked <= mostKeys, points > mostPoints};
}

void drawMark(ImDrawList& list, const ImVec2& at, float radius, bool isOffset, ImU32 colour) {
  if (isOffset) {
    list.AddCircleFilled(at, radius, colour);
  } else {
    addDiamond(list, at, radius, colour);
  }
}

void drawKeys(const Theme& theme, const Plot& plot, const Curve& curve, const Detail& detail) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  float lastX = -1e9F;
  if (!detail.keys && (curve.picked == 0 || !detail.pickedKeys)) {
    return;
  }
  for (const CurveKey& key : visibleKeys(plot, curve)) {
    const ImVec2 at = plot.at(key.at);
    if (key.picked && detail.pickedKeys) {
      drawMark(*list, at, theme.px(6.0F), curve.offsetKeys, theme.colours.background);
      drawMark(*list, at, theme.px(5.0F), curve.offsetKeys, theme.colours.text);
    } else if (detail.keys && at.x - lastX >= theme.px(4.0F)) {
      drawMark(*list, at, theme.px(curve.offsetKeys ? 3.5F : 4.0F), curve.offsetKeys, curve.colour);
      lastX = at.x;
    }
  }
}

void drawCurve(const Theme& theme, const Plot& plot, const Curve& curve, const Detail& detail) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (!curve.source.empty() && !detail.thin) {
    const std::vector<ImVec2> ghost = screenLine(plot, curve.source);
    list->AddPolyline(ghost.data(), static_cast<int>(ghost.size()), faded(theme.colours.quietText, 0.5F),
                      ImDrawFlags_None, theme.px(1.0F));
  }
  if (!curve.before.empty() && !detail.thin) {
    addDashedPolyline(*list, screenLine(plot, curve.before), faded(curve.colour, 0.55F), theme.px(1.0F),
                      theme.px(4.0F), theme.px(4.0F));
  }
  const std::vector<ImVec2> line = screenLine(plot, curve.points);
  const ImU32 colour = curve.picked > 0 && !detail.pickedKeys ? theme.colours.text : curve.colour;
  list->AddPolyline(line.data(), static_cast<int>(line.size()), detail.thin ? faded(colour, 0.6F) : colour,
                    ImDrawFlags_None, detail.thin ? 1.0F : theme.px(1.75F));
}

constexpr float handleLength = 44.0F; ///< Design pixels.
constexpr std::size_t mostHandles = 24;

/// Where the end of a key's tangent is drawn.
ImVec2 handleTip(const Theme& theme, const Plot& plot, const CurveKey& key, bool after) {
  const ImVec2 at = plot.at(key.at);
  const double slope = after ? key.slopes.y : key.slopes.x;
  const double x = 1.0 / plot.frames.valuesPerPixel();
  const double y = slope / plot.values.valuesPerPixel();
  const double scale = static_cast<double>(theme.px(handleLength)) / std::hypot(x, y) * (after ? 1.0 : -1.0);
  return {at.x + static_cast<float>(scale * x), at.y + static_cast<float>(scale * y)};
}

/// The keys that show their tangents: a few that are picked.
struct KeyHandle {
  std::size_t curve = 0;
  const CurveKey& key;
};
std::vector<KeyHandle> handlesOf(const Plot& plot, const CurveViewModel& model) {
  std::vector<KeyHandle> handles;
  for (std::size_t i = 0; i < model.curves.size() && model.editable; ++i) {
    if (model.curves[i].hidden || model.curves[i].picked == 0) {
      continue;
    }
    for (const CurveKey& key : visibleKeys(plot, model.curves[i])) {
      if (key.picked && handles.size() == mostHandles) {
        return {};
      }
      if (key.picked) {
        handles.push_back({i, key});
      }
    }
  }
  return handles;
}

void drawHandles(const Theme& theme, const Plot& plot, const CurveViewModel& model) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const KeyHandle& handle : handlesOf(plot, model)) {
    for (const bool after : {false, true}) {
      const ImVec2 tip = handleTip(theme, plot, handle.key, after);
      list->AddLine(plot.at(handle.key.at), tip, theme.colours.text, theme.px(1.0F));
      list->AddCircleFilled(tip, theme.px(3.5F), theme.colours.text);
    }
  }
}

float distance(const ImVec2& a, const ImVec2& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// What a press at the mouse takes hold of.
struct CurveHit {
  CurveGesture::Part part = CurveGesture::Part::box;
  CurveKeyHit key;
  bool after = true;
  bool picked = false;
};

CurveHit keyHit(const Theme& theme, const Plot& plot, const CurveViewModel& model, const ImVec2& mouse) {
  CurveHit hit;
  float nearest = theme.px(8.0F);
  const double start = plot.frames.toValue(mouse.x - theme.px(9.0F));
  const double end = plot.frames.toValue(mouse.x + theme.px(9.0F));
  for (std::size_t i = 0; i < model.curves.size(); ++i) {
    if (model.curves[i].hidden) {
      continue;
    }
    for (const CurveKey& key : keysBetween(model.curves[i], start, end)) {
      const float away = distance(plot.at(key.at), mouse) - (key.picked ? theme.px(1.0F) : 0.0F);
      if (away < nearest) {
        nearest = away;
        hit = {CurveGesture::Part::keys, {i, key.key}, true, key.picked};
      }
    }
  }
  return hit;
}

CurveHit hitOf(const Theme& theme, const Plot& plot, const CurveViewModel& model, const ImVec2& mouse) {
  if (!plot.box.contains(mouse) || !model.editable) {
    return {CurveGesture::Part::playhead, {}, true, false};
  }
  for (const KeyHandle& handle : handlesOf(plot, model)) {
    for (const bool after : {false, true}) {
      if (distance(handleTip(theme, plot, handle.key, after), mouse) < theme.px(7.0F)) {
        return {CurveGesture::Part::tangent, {handle.curve, handle.key.key}, after, true};
      }
    }
  }
  return keyHit(theme, plot, model, mouse);
}

Vec2 valueAt(const Plot& plot, const ImVec2& mouse) {
  return {plot.frames.toValue(mouse.x), plot.values.toValue(mouse.y)};
}

/// The press: what is held, and keys that it picks.
void pressCurves(const Plot& plot, const CurveHit& hit, const ImVec2& mouse, CurveGesture& gesture,
                 CurveViewOutcome& outcome) {
  const ImGuiIO& io = ImGui::GetIO();
  gesture = {hit.part, valueAt(plot, mouse), hit.key.curve, hit.key.key, hit.after, false};
  outcome.addToPicks = io.KeyShift;
  if (hit.part == CurveGesture::Part::keys && !hit.picked) {
    outcome.pickedKey = hit.key;
  }
  if (hit.part == CurveGesture::Part::box && io.KeyCtrl) {
    outcome.insertAt = gesture.from.x;
    gesture = {};
  }
}

/// How far keys are dragged: Shift keeps to the direction in which the mouse went further.
Vec2 draggedBy(const Plot& plot, const CurveViewModel& model, const CurveGesture& gesture,
               const ImVec2& mouse) {
  Vec2 drag = valueAt(plot, mouse) - gesture.from;
  if (ImGui::GetIO().KeyShift) {
    const ImVec2 start = plot.at(gesture.from);
    const bool inTime = std::abs(mouse.x - start.x) >= std::abs(mouse.y - start.y);
    (inTime ? drag.y : drag.x) = 0.0;
  }
  drag.x = model.snap ? std::round(drag.x) : drag.x;
  return drag;
}

void dragTangent(const Plot& plot, const CurveViewModel& model, const CurveGesture& gesture,
                 const ImVec2& mouse, CurveViewOutcome& outcome) {
  const Curve& curve = model.curves[gesture.curve];
  const auto key =
      std::ranges::find_if(curve.keys, [&](const CurveKey& one) { return one.key == gesture.key; });
  if (key == curve.keys.end()) {
    return;
  }
  const Vec2 away = valueAt(plot, mouse) - key->at;
  const double least = 2.0 * plot.frames.valuesPerPixel(); // A handle never stands upright.
  const double frames = gesture.after ? std::max(away.x, least) : std::min(away.x, -least);
  outcome.tangent = CurveKeyHit{gesture.curve, gesture.key};
  outcome.slope = away.y / frames;
  outcome.tangentAfter = gesture.after;
  outcome.tangentAlone = ImGui::GetIO().KeyAlt;
}

/// The held mouse.
void holdCurves(const WidgetContext& context, const Plot& plot, const CurveViewModel& model,
                const ImVec2& mouse, CurveGesture& gesture, CurveViewOutcome& outcome) {
  gesture.moved = gesture.moved || ImGui::IsMouseDragging(ImGuiMouseButton_Left, context.theme.px(3.0F));
  if (gesture.part == CurveGesture::Part::playhead) {
    outcome.playhead = std::round(plot.frames.toValue(mouse.x));
    outcome.playheadMoved = outcome.playhead != model.playhead;
  } else if (gesture.part == CurveGesture::Part::keys && gesture.moved) {
    outcome.keysDragged = true;
    outcome.drag = draggedBy(plot, model, gesture, mouse);
  } else if (gesture.part == CurveGesture::Part::tangent && gesture.moved) {
    dragTangent(plot, model, gesture, mouse, outcome);
  } else if (gesture.part == CurveGesture::Part::box && gesture.moved) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImVec2 from = plot.at(gesture.from);
    const ImVec2 least(std::min(from.x, mouse.x), std::min(from.y, mouse.y));
    const ImVec2 most(std::max(from.x, mouse.x), std::max(from.y, mouse.y));
    list->AddRectFilled(least, most, faded(context.theme.colours.accent, 0.12F));
    list->AddRect(least, most, context.theme.colours.accent);
  }
}

/// The mouse lets go.
void releaseCurves(const Plot& plot, const ImVec2& mouse, CurveGesture& gesture, CurveViewOutcome& outcome) {
  outcome.gestureEnded = true;
  outcome.addToPicks = ImGui::GetIO().KeyShift;
  if (gesture.part == CurveGesture::Part::box && gesture.moved) {
    const Vec2 to = valueAt(plot, mouse);
    outcome.boxDrawn = true;
    outcome.boxFrames = {std::min(gesture.from.x, to.x), std::max(gesture.from.x, to.x)};
    outcome.boxValues = {std::min(gesture.from.y, to.y), std::max(gesture.from.y, to.y)};
  }
  outcome.clickedBeside = gesture.part == CurveGesture::Part::box && !gesture.moved;
  gesture = {};
}

/// Where a key is, for scripts that take it by its curve and number.
void recordKeys(const WidgetContext& context, const std::string& id, const Plot& plot,
                const CurveViewModel& model) {
  constexpr std::size_t most = 200;
  const float reach = context.theme.px(4.0F);
  const auto add = [&](const std::string& name, const ImVec2& at) {
    context.items.add(id + name, {at.x - reach, at.y - reach}, {at.x + reach, at.y + reach});
  };
  std::size_t recorded = 0;
  for (const Curve& curve : model.curves) {
    for (const CurveKey& key : curve.hidden ? std::span<const CurveKey>{} : visibleKeys(plot, curve)) {
      if (++recorded > most) {
        return;
      }
      const std::string row = curve.row == 0 ? "" : "row-" + std::to_string(curve.row) + "/";
      const std::string name = "-key/" + row + curve.label + "/" + std::to_string(key.key);
      add(name, plot.at(key.at));
      if (key.picked) {
        add(name + "/in", handleTip(context.theme, plot, key, false));
        add(name + "/out", handleTip(context.theme, plot, key, true));
      }
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
  constexpr int mostLines = 6;
  std::string text;
  int lines = 0;
  for (const Curve& curve : model.curves) {
    if (!curve.hidden && !curve.points.empty() && ++lines <= mostLines) {
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
    for (const std::vector<Vec2>* points : {&curve.points, &curve.before, &curve.source}) {
      for (const Vec2& point : *points) {
        low = curve.hidden ? low : std::min(low, point.y);
        high = curve.hidden ? high : std::max(high, point.y);
      }
    }
  }
  if (low > high) {
    return {-1.0, 1.0};
  }
  constexpr double level = 0.1; // What a curve that does not move is shown within.
  const bool isLevel = high - low < 1e-6 * std::max(1.0, std::abs(high));
  const double margin = isLevel ? level * std::max(1.0, std::abs(high)) : (high - low) * 0.12;
  return {low - margin, high + margin};
}

bool lostFromSight(std::vector<Curve>& curves, const Span& values) {
  bool lost = false;
  for (Curve& curve : curves) {
    const bool inSight =
        !curve.hidden && std::any_of(curve.points.begin(), curve.points.end(), [&](const Vec2& point) {
          return point.y >= values.start && point.y <= values.end;
        });
    lost = lost || (curve.seen && !inSight && !curve.hidden);
    curve.seen = inSight;
  }
  return lost;
}

std::optional<CurveFit> fittedPicks(std::span<const Curve> curves) {
  Vec2 low(HUGE_VAL);
  Vec2 high(-HUGE_VAL);
  for (const Curve& curve : curves) {
    for (const CurveKey& key : curve.keys) {
      low = key.picked ? glm::min(low, key.at) : low;
      high = key.picked ? glm::max(high, key.at) : high;
    }
  }
  if (low.x > high.x) {
    return std::nullopt;
  }
  const Vec2 margin(std::max(2.0, 0.15 * (high.x - low.x)),
                    std::max({0.2 * (high.y - low.y), std::abs(high.y) * 1e-2, 1e-3}));
  return CurveFit{{low.x - margin.x, high.x + margin.x}, {low.y - margin.y, high.y + margin.y}};
}

namespace {

void drawPlot(const WidgetContext& context, const Rect& box, const Plot& plot, const CurveViewModel& model) {
  const Theme& theme = context.theme;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(box.min, box.max, theme.colours.sunken, theme.corner());
  drawValueGrid(context, box, plot);
  drawFrameGrid(context, box, plot, model);
  list->PushClipRect(plot.box.min, plot.box.max, true);
  const Detail detail = detailOf(plot, model);
  for (const Curve& curve : model.curves) {
    if (!curve.hidden) {
      drawCurve(theme, plot, curve, detail);
    }
  }
  for (const Curve& curve : model.curves) {
    if (!curve.hidden) {
      drawKeys(theme, plot, curve, detail);
    }
  }
  drawHandles(theme, plot, model);
  const float x = std::round(plot.frames.toPixel(model.playhead));
  list->AddRectFilled({x - theme.px(0.75F), plot.box.min.y}, {x + theme.px(0.75F), plot.box.max.y},
                      theme.colours.text);
}

} // namespace

CurveViewOutcome curveView(const WidgetContext& context, const std::string& id, const CurveViewModel& model,
                           CurveGesture& gesture, float height) {
  CurveViewOutcome outcome;
  const Control control = takePlace(context, id, {ImGui::GetContentRegionAvail().x, height});
  if (!control.visible) {
    return outcome;
  }
  const Plot plot = plotOf(context.theme, control.box, model);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  drawPlot(context, control.box, plot, model);
  const CurveHit hit =
      control.hovered && !control.held ? hitOf(context.theme, plot, model, mouse) : CurveHit{};
  if (control.hovered && !control.held && plot.box.contains(mouse) &&
      (!model.editable || hit.part == CurveGesture::Part::box)) {
    readout(context, plot, model, mouse);
  }
  if (ImGui::IsItemActivated()) {
    pressCurves(plot, hitOf(context.theme, plot, model, mouse), mouse, gesture, outcome);
  }
  if (control.held) {
    holdCurves(context, plot, model, mouse, gesture, outcome);
  }
  ImGui::GetWindowDrawList()->PopClipRect();
  if (ImGui::IsItemDeactivated()) {
    releaseCurves(plot, mouse, gesture, outcome);
  }
  if (control.hovered) {
    navigate(plot, model, mouse, outcome);
    outcome.fitAsked = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (model.editable && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
      const CurveHit below = keyHit(context.theme, plot, model, mouse);
      const bool isOnKey = below.part == CurveGesture::Part::keys;
      outcome.menu = {isOnKey ? std::optional<CurveKeyHit>(below.key) : std::nullopt, below.picked};
    }
  }
  outcome.hovered = control.hovered;
  outcome.mouse = valueAt(plot, mouse);
  recordKeys(context, id, plot, model);
  return outcome;
}

int curveLegend(const WidgetContext& context, const std::string& id, std::span<const Curve> curves,
                std::size_t count) {
  const Theme& theme = context.theme;
  int clicked = -1;
  for (std::size_t i = 0; i < std::min(count, curves.size()); ++i) {
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
