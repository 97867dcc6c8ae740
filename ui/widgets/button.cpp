#include "ui/widgets/button.h"

#include <cmath>

namespace stretch::ui {

namespace {

struct Face {
  ImU32 fill;
  ImU32 text;
};

Face faceOf(const ThemeColours& colours, const ButtonSpec& spec, const Control& control) {
  const bool lit = spec.enabled && control.hovered;
  if (spec.emphasis == Emphasis::primary) {
    return {lit ? mixed(colours.accent, colours.text, 0.15F) : colours.accent, colours.onAccent};
  }
  if (spec.on) {
    return {lit ? mixed(colours.accentQuiet, colours.accent, 0.25F) : colours.accentQuiet, colours.accent};
  }
  const ImU32 rest = spec.emphasis == Emphasis::quiet ? faded(colours.raised, 0.0F) : colours.raised;
  const ImU32 fill = control.held && lit ? colours.pressed : lit ? colours.hovered : rest;
  const ImU32 quiet = lit ? colours.text : colours.quietText;
  const ImU32 text = spec.emphasis == Emphasis::danger  ? colours.error
                     : spec.emphasis == Emphasis::quiet ? quiet
                                                        : colours.text;
  return {fill, text};
}

std::string contentOf(const Theme& theme, const ButtonSpec& spec) {
  const bool hasIcon = theme.fonts.hasIcons && spec.icon[0] != '\0';
  if (!hasIcon) {
    return spec.text.empty() ? spec.fallback : spec.text;
  }
  return spec.text.empty() ? std::string(spec.icon) : std::string(spec.icon) + "  " + spec.text;
}

void drawFace(const Theme& theme, const Rect& box, ImU32 fill, bool enabled) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(box.min, box.max, enabled ? fill : faded(fill, 0.5F), theme.corner());
  if (theme.kind != ThemeKind::dark && (fill >> IM_COL32_A_SHIFT) != 0) {
    list->AddRect(box.min, box.max, theme.colours.border, theme.corner());
  }
}

} // namespace

bool button(const WidgetContext& context, const ButtonSpec& spec) {
  const Theme& theme = context.theme;
  const std::string content = contentOf(theme, spec);
  ImFont* font = theme.fonts.body;
  const float padding = spec.text.empty() ? theme.px(6.0F) : theme.px(10.0F);
  const float fit = std::ceil(textSize(font, content).x + padding * 2.0F);
  const float width = spec.width > 0.0F ? spec.width : std::max(fit, theme.rowHeight());
  const Control control = takePlace(context, spec.id, {width, theme.rowHeight()}, spec.enabled);
  if (control.visible) {
    const Face face = faceOf(theme.colours, spec, control);
    drawFace(theme, control.box, face.fill, spec.enabled);
    if (spec.focused) {
      const float away = theme.px(2.0F);
      ImGui::GetWindowDrawList()->AddRect({control.box.min.x - away, control.box.min.y - away},
                                          {control.box.max.x + away, control.box.max.y + away},
                                          theme.colours.text, theme.corner() + away, 0, theme.px(1.5F));
    }
    const float inset = theme.px(4.0F);
    const Rect inner{{control.box.min.x + inset, control.box.min.y},
                     {control.box.max.x - inset, control.box.max.y}};
    const bool tight = !spec.text.empty() && textSize(font, content).x > inner.width();
    drawText(context, font, inner, spec.enabled ? face.text : faded(face.text, 0.4F),
             tight ? spec.text : content, 0.5F); // The word says more than its picture.
  }
  tooltip(context, spec.help);
  return control.clicked;
}

bool toggle(const WidgetContext& context, const std::string& id, const std::string& label, bool on,
            const Help& help, bool enabled) {
  const Theme& theme = context.theme;
  const float trackWidth = theme.px(28.0F);
  const float trackHeight = theme.px(16.0F);
  const float gap = label.empty() ? 0.0F : theme.unit();
  const float width = trackWidth + gap + textSize(theme.fonts.body, label).x;
  const Control control = takePlace(context, id, {width, theme.rowHeight()}, enabled);
  if (control.visible) {
    const ThemeColours& colours = theme.colours;
    const float opacity = enabled ? 1.0F : 0.4F;
    const float centreY = std::floor(control.box.centre().y);
    const Rect track{{control.box.min.x, centreY - trackHeight * 0.5F},
                     {control.box.min.x + trackWidth, centreY + trackHeight * 0.5F}};
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 off = control.hovered && enabled ? colours.pressed : colours.hovered;
    list->AddRectFilled(track.min, track.max, faded(on ? colours.accent : off, opacity), trackHeight * 0.5F);
    if (theme.kind != ThemeKind::dark) {
      list->AddRect(track.min, track.max, colours.border, trackHeight * 0.5F);
    }
    const float radius = trackHeight * 0.5F - theme.px(3.0F);
    const float knobX = on ? track.max.x - trackHeight * 0.5F : track.min.x + trackHeight * 0.5F;
    list->AddCircleFilled({knobX, centreY}, radius,
                          faded(on ? colours.onAccent : colours.quietText, opacity));
    drawText(context, theme.fonts.body, {{track.max.x + gap, control.box.min.y}, control.box.max},
             faded(colours.text, opacity), label);
  }
  tooltip(context, help);
  return control.clicked;
}

namespace {

/// Equal widths, or where a text would be cut widths that follow the texts.
std::vector<float> segmentWidths(const Theme& theme, const std::vector<Choice>& choices, float available) {
  std::vector<float> texts;
  float sum = 0.0F;
  float widest = 0.0F;
  for (const Choice& choice : choices) {
    texts.push_back(textSize(theme.fonts.label, choice.text).x + theme.px(12.0F));
    sum += texts.back();
    widest = std::max(widest, texts.back());
  }
  const float equal = std::floor(available / static_cast<float>(choices.size()));
  std::vector<float> widths(choices.size(), equal);
  for (std::size_t i = 0; i < widths.size() && widest > equal; ++i) {
    widths[i] = std::floor(available * texts[i] / sum);
  }
  return widths;
}

} // namespace

int segmented(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
              int selected) {
  const Theme& theme = context.theme;
  const float gap = theme.px(1.0F);
  const float available = ImGui::GetContentRegionAvail().x;
  const int count = static_cast<int>(choices.size());
  const std::vector<float> widths =
      segmentWidths(theme, choices, available - gap * static_cast<float>(count - 1));
  int clicked = -1;
  for (int i = 0; i < count; ++i) {
    const Choice& choice = choices[static_cast<std::size_t>(i)];
    if (i > 0) {
      ImGui::SameLine(0.0F, gap);
    }
    const Control control =
        takePlace(context, id + "/" + choice.text, {widths[static_cast<std::size_t>(i)], theme.rowHeight()},
                  choice.enabled);
    if (control.visible) {
      const ThemeColours& colours = theme.colours;
      const bool lit = control.hovered && choice.enabled;
      const ImU32 fill = i == selected ? colours.accentQuiet : lit ? colours.hovered : colours.raised;
      const ImDrawFlags corners = count == 1       ? ImDrawFlags_RoundCornersAll
                                  : i == 0         ? ImDrawFlags_RoundCornersLeft
                                  : i == count - 1 ? ImDrawFlags_RoundCornersRight
                                                   : ImDrawFlags_RoundCornersNone;
      ImGui::GetWindowDrawList()->AddRectFilled(control.box.min, control.box.max, fill, theme.corner(),
                                                corners);
      const ImU32 text = i == selected    ? colours.accent
                         : choice.enabled ? colours.text
                                          : faded(colours.text, 0.4F);
      drawText(context, theme.fonts.label, control.box, text, choice.text, 0.5F);
    }
    tooltip(context, choice.help);
    clicked = control.clicked ? i : clicked;
  }
  return clicked;
}

ImU32 axisColour(const Theme& theme, int axis) {
  const bool light = theme.kind == ThemeKind::light;
  constexpr std::array<ImU32, 3> onDark{IM_COL32(0xF0, 0x7C, 0x82, 255), IM_COL32(0x8C, 0xC8, 0x6A, 255),
                                        IM_COL32(0x6C, 0xA8, 0xF0, 255)};
  constexpr std::array<ImU32, 3> onLight{IM_COL32(0xB8, 0x28, 0x30, 255), IM_COL32(0x3C, 0x7A, 0x1E, 255),
                                         IM_COL32(0x1C, 0x5C, 0xB4, 255)};
  return (light ? onLight : onDark)[static_cast<std::size_t>(axis)];
}

int axisButtons(const WidgetContext& context, const std::string& id, const std::array<bool, 3>& axes,
                const Help& help) {
  const Theme& theme = context.theme;
  const float gap = theme.px(4.0F);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap * 2.0F) / 3.0F);
  int clicked = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const char* const names[] = {"X", "Y", "Z"};
    const bool on = axes[static_cast<std::size_t>(axis)];
    if (axis > 0) {
      ImGui::SameLine(0.0F, gap);
    }
    const Control control = takePlace(context, id + "/" + names[axis], {width, theme.rowHeight()});
    if (control.visible) {
      const ImU32 colour = axisColour(theme, axis);
      const ImU32 rest = on ? mixed(theme.colours.panel, colour, 0.28F) : theme.colours.raised;
      drawFace(theme, control.box, control.hovered ? mixed(rest, colour, 0.18F) : rest, true);
      drawText(context, theme.fonts.strong, control.box, on ? colour : theme.colours.quietText, names[axis],
               0.5F);
    }
    Help axisHelp = help;
    axisHelp.title = std::string(names[axis]) + (on ? " is on" : " is off");
    tooltip(context, axisHelp);
    clicked = control.clicked ? axis : clicked;
  }
  return clicked;
}

} // namespace stretch::ui
