#include "ui/widgets/slider.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include <imgui_internal.h>

#include "ui/widgets/arithmetic.h"

namespace stretch::ui {

namespace {

double snapped(const SliderSpec& spec, double value) {
  const double step = ImGui::GetIO().KeyShift && spec.fineStep > 0.0 ? spec.fineStep : spec.step;
  const double stepped = step > 0.0 ? std::round(value / step) * step : value;
  return std::clamp(stepped, spec.minimum, spec.maximum);
}

double hardClamped(const SliderSpec& spec, double value) {
  return std::clamp(value, spec.hardMinimum.value_or(spec.minimum), spec.hardMaximum.value_or(spec.maximum));
}

/// Draws the field; the fill is the part of the range left of the value.
void drawField(const WidgetContext& context, const SliderSpec& spec, const Control& control, double value) {
  const Theme& theme = context.theme;
  const ThemeColours& colours = theme.colours;
  const float opacity = spec.enabled ? 1.0F : 0.45F;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool lit = spec.enabled && (control.hovered || control.held);
  list->AddRectFilled(control.box.min, control.box.max,
                      faded(lit ? colours.hovered : colours.raised, opacity), theme.corner());
  const double span = spec.maximum - spec.minimum;
  if (spec.showsFill && span > 0.0) {
    const float part = static_cast<float>(std::clamp((value - spec.minimum) / span, 0.0, 1.0));
    const float edge = std::floor(control.box.min.x + control.box.width() * part);
    list->PushClipRect(control.box.min, {edge, control.box.max.y}, true);
    list->AddRectFilled(control.box.min, control.box.max, faded(colours.accentQuiet, opacity),
                        theme.corner());
    list->PopClipRect();
    const float bar = theme.px(2.0F);
    const float left = std::clamp(edge - bar, control.box.min.x, control.box.max.x - bar);
    list->AddRectFilled({left, control.box.min.y + theme.px(5.0F)},
                        {left + bar, control.box.max.y - theme.px(5.0F)}, faded(colours.accent, opacity),
                        theme.px(1.0F));
  }
  if (theme.kind != ThemeKind::dark) {
    list->AddRect(control.box.min, control.box.max, colours.border, theme.corner());
  }
  const Rect inner{{control.box.min.x + theme.unit(), control.box.min.y},
                   {control.box.max.x - theme.unit(), control.box.max.y}};
  drawText(context, theme.fonts.body, inner, faded(colours.text, opacity), sliderText(spec, value),
           spec.showsFill ? 1.0F : 0.5F);
}

EditPhase dragged(const SliderSpec& spec, const Control& control, double& value) {
  EditPhase phase;
  ImGuiStorage* storage = ImGui::GetStateStorage();
  if (ImGui::IsItemActivated()) {
    storage->SetFloat(control.id, static_cast<float>(value));
  }
  const ImGuiIO& io = ImGui::GetIO();
  if (control.held && io.MouseDelta.x != 0.0F && control.box.width() > 0.0F) {
    const double speed =
        (spec.maximum - spec.minimum) / static_cast<double>(control.box.width()) * (io.KeyShift ? 0.1 : 1.0);
    const double loose =
        static_cast<double>(storage->GetFloat(control.id)) + static_cast<double>(io.MouseDelta.x) * speed;
    const double kept = std::clamp(loose, spec.minimum, spec.maximum);
    storage->SetFloat(control.id, static_cast<float>(kept));
    const double next = snapped(spec, kept);
    phase.changed = next != value;
    value = next;
  }
  return phase;
}

/// Takes what was written, within the hard limits.
EditPhase takeWritten(const SliderSpec& spec, std::string_view text, double before, double& value) {
  EditPhase phase;
  if (const std::optional<double> number = typedNumber(text, before * spec.displayFactor)) {
    const double wanted = *number / spec.displayFactor;
    const double next = hardClamped(spec, wanted);
    phase.cut = std::abs(next - wanted) > 1e-9 * std::max(1.0, std::abs(wanted));
    phase.changed = next != value;
    value = next;
  }
  return phase;
}

/// While a field is typed in, the value that it had: sums go on from it.
EditPhase typed(const SliderSpec& spec, const Control& control, double& value, bool begins) {
  ImGuiStorage* storage = ImGui::GetStateStorage();
  if (begins) {
    storage->SetFloat(control.id, static_cast<float>(value));
  }
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", spec.decimals, value * spec.displayFactor);
  const ImRect box(control.box.min, control.box.max);
  // A click that is over begins it: Dear ImGui's own field begins at a press.
  bool& pressed = ImGui::GetIO().MouseClicked[ImGuiMouseButton_Left];
  const bool pressedBefore = std::exchange(pressed, pressed || begins);
  const bool written =
      ImGui::TempInputText(box, control.id, hiddenLabel(spec.id).c_str(), buffer.data(),
                           static_cast<int>(buffer.size()), ImGuiInputTextFlags_AutoSelectAll);
  pressed = pressedBefore;
  return written ? takeWritten(spec, buffer.data(), static_cast<double>(storage->GetFloat(control.id)), value)
                 : EditPhase{};
}

/// A click without a drag; Ctrl+click and a double click come to the same.
bool wantsTyping(const Control& control) {
  constexpr float slack = 3.0F; // Pixels that a hand moves in a click.
  return control.clicked && ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < slack * slack;
}

/// One entry of a field's menu.
bool menuEntry(const WidgetContext& context, const SliderSpec& spec, const char* text, bool enabled) {
  const bool chosen = ImGui::MenuItem(text, nullptr, false, enabled);
  context.items.add(spec.id + "/" + text, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), enabled);
  return chosen;
}

EditPhase fieldMenu(const WidgetContext& context, const SliderSpec& spec, const Control& control,
                    double& value) {
  const std::string name = hiddenLabel(spec.id) + "/menu";
  EditPhase phase;
  if (spec.enabled && control.hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
    ImGui::OpenPopup(name.c_str());
  }
  if (!ImGui::BeginPopup(name.c_str())) {
    return phase;
  }
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    ImGui::CloseCurrentPopup();
  }
  if (menuEntry(context, spec, "Reset", spec.defaultValue.has_value())) {
    phase.changed = value != *spec.defaultValue;
    value = *spec.defaultValue;
    phase.ended = true;
  }
  if (menuEntry(context, spec, "Copy", true)) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.9g", value * spec.displayFactor);
    ImGui::SetClipboardText(buffer.data());
  }
  const char* const copied = ImGui::GetClipboardText();
  const bool usable = copied != nullptr && typedNumber(copied, 0.0).has_value();
  if (menuEntry(context, spec, "Paste", usable)) {
    phase = takeWritten(spec, copied, value, value);
    phase.ended = true;
  }
  ImGui::EndPopup();
  return phase;
}

} // namespace

std::string sliderText(const SliderSpec& spec, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%s%.*f%s", spec.prefix, spec.decimals,
                value * spec.displayFactor, spec.suffix);
  return buffer.data();
}

EditPhase slider(const WidgetContext& context, const SliderSpec& spec, double& value) {
  const Theme& theme = context.theme;
  const float width = spec.width > 0.0F ? spec.width : ImGui::GetContentRegionAvail().x;
  const bool typing =
      ImGui::TempInputIsActive(ImGui::GetCurrentWindow()->GetID(hiddenLabel(spec.id).c_str()));
  const Control control = takePlace(context, spec.id, {width, theme.rowHeight()}, spec.enabled && !typing);
  EditPhase phase;
  const bool begins = !typing && spec.enabled && wantsTyping(control);
  if (typing || begins) {
    phase = typed(spec, control, value, begins);
    phase.ended = ImGui::IsItemDeactivated();
    return phase;
  }
  phase = dragged(spec, control, value);
  phase.ended = ImGui::IsItemDeactivated();
  if (control.visible) {
    drawField(context, spec, control, value);
  }
  if (control.hovered && spec.enabled) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  tooltip(context, spec.help);
  const EditPhase menu = fieldMenu(context, spec, control, value);
  return menu.changed || menu.ended ? menu : phase;
}

} // namespace stretch::ui
