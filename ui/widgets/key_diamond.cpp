#include "ui/widgets/key_diamond.h"

#include "ui/widgets/shapes.h"

namespace stretch::ui {

void addKeyMark(const Theme& theme, ImDrawList& list, const ImVec2& centre, float radius, KeyMark mark,
                ImU32 colour, ImU32 inside) {
  const float edge = theme.px(1.5F);
  addDiamond(list, centre, radius, colour);
  if (mark == KeyMark::here) {
    return;
  }
  addDiamond(list, centre, radius - 1.4F * edge, inside);
  if (mark == KeyMark::elsewhere) {
    list.PushClipRect({centre.x - radius, centre.y}, {centre.x + radius, centre.y + radius}, true);
    addDiamond(list, centre, radius, colour);
    list.PopClipRect();
  }
}

bool keyDiamond(const WidgetContext& context, const std::string& id, KeyMark mark, const Help& help) {
  const Theme& theme = context.theme;
  const ThemeColours& colours = theme.colours;
  const float size = theme.rowHeight();
  const Control control = takePlace(context, id, {size, size});
  if (!control.visible) {
    return false;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (control.hovered) {
    list.AddRectFilled(control.box.min, control.box.max, colours.hovered, theme.corner());
  }
  const ImU32 colour = mark == KeyMark::none ? colours.quietText : colours.accent;
  addKeyMark(theme, list, control.box.centre(), theme.px(7.0F), mark, colour,
             control.hovered ? colours.hovered : colours.panel);
  tooltip(context, help);
  return control.clicked;
}

} // namespace stretch::ui
