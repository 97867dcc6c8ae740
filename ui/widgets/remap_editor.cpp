#include "ui/widgets/remap_editor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <imgui_internal.h>

namespace stretch::ui {

namespace {

constexpr double largestPercentSum = 0.98;
constexpr double offBelow = 0.005;

struct RemapPlot {
  Rect box;

  [[nodiscard]] ImVec2 toScreen(const Vec2& p) const {
    return {box.min.x + static_cast<float>(p.x) * box.width(),
            box.max.y - static_cast<float>(p.y) * box.height()};
  }
  [[nodiscard]] Vec2 toCurve(const ImVec2& p) const {
    return {static_cast<double>((p.x - box.min.x) / box.width()),
            static_cast<double>((box.max.y - p.y) / box.height())};
  }
};

void drawGrid(const Theme& theme, const RemapPlot& plot) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ThemeColours& colours = theme.colours;
  list->AddRectFilled(plot.box.min, plot.box.max, colours.sunken, theme.corner());
  for (const double part : {0.25, 0.5, 0.75}) {
    const ImU32 line = faded(colours.border, 0.5F);
    list->AddLine(plot.toScreen({part, 0.0}), plot.toScreen({part, 1.0}), line);
    list->AddLine(plot.toScreen({0.0, part}), plot.toScreen({1.0, part}), line);
  }
  list->AddRect(plot.box.min, plot.box.max, colours.border, theme.corner());
  list->AddLine(plot.toScreen({0.0, 0.0}), plot.toScreen({1.0, 1.0}), faded(colours.quietText, 0.35F));
}

void drawCurve(const Theme& theme, const RemapPlot& plot, const std::function<double(double)>& curve,
               ImU32 colour) {
  std::vector<ImVec2> line;
  constexpr int pieces = 64;
  for (int i = 0; i <= pieces; ++i) {
    const double r = static_cast<double>(i) / pieces;
    line.push_back(plot.toScreen({r, std::clamp(curve(r), 0.0, 1.0)}));
  }
  ImGui::GetWindowDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()), colour,
                                          ImDrawFlags_None, theme.px(2.0F));
}

struct Handle {
  bool isEaseIn = true;
  Vec2* point = nullptr;

  [[nodiscard]] bool isOff() const { return point->x <= 0.0; }
  [[nodiscard]] Vec2 place() const {
    if (isOff()) {
      return isEaseIn ? Vec2(0.0, 0.0) : Vec2(1.0, 1.0);
    }
    return isEaseIn ? *point : Vec2(1.0 - point->x, point->y);
  }
  void moveTo(const Vec2& target) const {
    const double percent = isEaseIn ? target.x : 1.0 - target.x;
    *point = {std::round(percent * 100.0) / 100.0, std::round(target.y * 100.0) / 100.0};
    if (percent < offBelow) {
      *point = {0.0, isEaseIn ? 0.1 : 0.9};
    }
  }
};

std::string describe(const Handle& handle) {
  if (handle.isOff()) {
    return "off: drag it into the graph to turn it on";
  }
  char text[64];
  std::snprintf(text, sizeof text, "%.0f %% of the path, value %.2f", handle.point->x * 100.0,
                handle.point->y);
  return text;
}

void drawHandle(const WidgetContext& context, const ImVec2& at, bool off, bool lit, ImU32 colour) {
  const Theme& theme = context.theme;
  const float radius = theme.px(lit ? 7.0F : 5.5F);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(at, radius, theme.colours.panel);
  if (off) {
    list->AddCircle(at, radius - theme.px(1.0F), faded(colour, lit ? 1.0F : 0.6F), 0, theme.px(1.5F));
  } else {
    list->AddCircleFilled(at, radius - theme.px(1.5F), colour);
  }
}

EditPhase editHandle(const WidgetContext& context, const std::string& id, const RemapPlot& plot,
                     const Handle& handle, RemapPoints& points, ImU32 colour) {
  const ImVec2 at = plot.toScreen(handle.place());
  const float reach = context.theme.px(11.0F);
  ImGui::SetCursorScreenPos({at.x - reach, at.y - reach});
  const Control control = takePlace(context, id, {reach * 2.0F, reach * 2.0F});
  EditPhase phase;
  const RemapPoints before = points;
  if (control.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    handle.moveTo(handle.isEaseIn ? Vec2(0.0, 0.0) : Vec2(1.0, 1.0));
  } else if (control.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, context.theme.px(2.0F))) {
    handle.moveTo(plot.toCurve(ImGui::GetIO().MousePos));
    points = clampedRemap(points);
  }
  phase.changed = !(points == before);
  phase.ended = ImGui::IsItemDeactivated();
  drawHandle(context, plot.toScreen(handle.place()), handle.isOff(), control.hovered || control.held, colour);
  if (control.hovered || control.held) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    tooltipNow(context, {.title = handle.isEaseIn ? "Ease-in" : "Ease-out", .text = describe(handle)});
  }
  return phase;
}

/// A drag that begins anywhere else takes the nearer of the two points along.
EditPhase editNearest(const WidgetContext& context, const std::string& id, const RemapPlot& plot,
                      RemapPoints& points) {
  ImGui::SetCursorScreenPos(plot.box.min);
  const Control control = takePlace(context, id + "/curve", {plot.box.width(), plot.box.height()});
  ImGui::SetItemAllowOverlap();
  EditPhase phase;
  ImGuiStorage* const storage = ImGui::GetStateStorage();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const std::array<Handle, 2> handles{Handle{true, &points.easeIn}, Handle{false, &points.easeOut}};
  if (ImGui::IsItemActivated()) {
    const auto apart = [&](const Handle& handle) {
      return std::abs(plot.toScreen(handle.place()).x - mouse.x);
    };
    storage->SetInt(control.id, apart(handles[0]) <= apart(handles[1]) ? 0 : 1);
  }
  if (control.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, context.theme.px(2.0F))) {
    const RemapPoints before = points;
    handles[static_cast<std::size_t>(storage->GetInt(control.id))].moveTo(plot.toCurve(mouse));
    points = clampedRemap(points);
    phase.changed = !(points == before);
  }
  if (control.hovered || control.held) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  phase.ended = ImGui::IsItemDeactivated();
  tooltip(context, {"Transition",
                    "Drag anywhere: the nearer point comes along. A double click on a point "
                    "takes it away.",
                    {}});
  return phase;
}

} // namespace

RemapPoints clampedRemap(RemapPoints points) {
  points.easeIn = {std::clamp(points.easeIn.x, 0.0, largestPercentSum),
                   std::clamp(points.easeIn.y, 0.0, 0.5)};
  points.easeOut = {std::clamp(points.easeOut.x, 0.0, largestPercentSum),
                    std::clamp(points.easeOut.y, 0.5, 1.0)};
  const double excess = points.easeIn.x + points.easeOut.x - largestPercentSum;
  if (excess > 0.0) {
    points.easeIn.x = std::max(0.0, points.easeIn.x - excess * 0.5);
    points.easeOut.x = largestPercentSum - points.easeIn.x;
  }
  return points;
}

EditPhase remapEditor(const WidgetContext& context, const std::string& id,
                      const std::function<double(double)>& curve, RemapPoints& points, ImU32 colour,
                      float height) {
  const Theme& theme = context.theme;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float margin = theme.px(8.0F);
  const RemapPlot plot{
      {{corner.x + margin, corner.y + margin}, {corner.x + width - margin, corner.y + height - margin}}};
  drawGrid(theme, plot);
  drawCurve(theme, plot, curve, colour);
  const float row = theme.px(18.0F);
  const Rect caption{{plot.box.min.x + theme.unit(), plot.box.max.y - row},
                     {plot.box.max.x - theme.unit(), plot.box.max.y}};
  drawText(context, theme.fonts.label, caption, faded(theme.colours.quietText, 0.8F),
           "pivot \xE2\x86\x92 tip", 1.0F);
  RemapPoints edited = points;
  const EditPhase anywhere = editNearest(context, id, plot, edited);
  const EditPhase in = editHandle(context, id + "/ease-in", plot, {true, &edited.easeIn}, edited, colour);
  const EditPhase out = editHandle(context, id + "/ease-out", plot, {false, &edited.easeOut}, edited, colour);
  points = edited;
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({width, height});
  return {in.changed || out.changed || anywhere.changed, in.ended || out.ended || anywhere.ended};
}

} // namespace stretch::ui
