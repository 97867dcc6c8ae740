#include "ui/widgets/limb_diagram.h"

#include <algorithm>
#include <vector>

#include "ui/widgets/shapes.h"

namespace stretch::ui {

namespace {

// The figure stands in a box 180 wide and 232 high; x = 0 is its middle, y grows downwards.
constexpr float figureWidth = 180.0F;
constexpr float figureHeight = 232.0F;

struct Figure {
  ImVec2 origin;
  float size = 1.0F;

  [[nodiscard]] ImVec2 at(const ImVec2& point) const {
    return {origin.x + point.x * size, origin.y + point.y * size};
  }
  [[nodiscard]] TaperedCapsule bone(const DiagramBone& bone) const {
    return {at(bone.from), at(bone.to), bone.fromRadius * size, bone.toRadius * size};
  }
};

Figure figureIn(const Rect& box) {
  const float size = std::min(box.width() / figureWidth, box.height() / figureHeight);
  return {{box.centre().x, box.centre().y - figureHeight * 0.5F * size}, size};
}

std::vector<TaperedCapsule> shapesOf(const Figure& figure, const DiagramPart& part) {
  std::vector<TaperedCapsule> shapes;
  for (const DiagramBone& bone : part.bones) {
    shapes.push_back(figure.bone(bone));
  }
  return shapes;
}

ImVec2 centreOf(const Figure& figure, const DiagramPart& part) {
  const TaperedCapsule first = shapesOf(figure, part).front();
  return {(first.from.x + first.to.x) * 0.5F, (first.from.y + first.to.y) * 0.5F};
}

bool isOn(const Figure& figure, const DiagramPart& part, const ImVec2& point, float margin) {
  return std::ranges::any_of(shapesOf(figure, part), [&](const TaperedCapsule& shape) {
    return isInside(shape, point, margin * figure.size);
  });
}

struct PartLook {
  ImU32 fill;
  ImU32 edge;
  ImU32 key;
};

PartLook lookOf(const ThemeColours& colours, const DiagramPart& state, bool hovered) {
  if (!state.found) {
    return {mixed(colours.panel, colours.sunken, 0.6F), mixed(colours.panel, colours.quietText, 0.35F),
            faded(colours.quietText, 0.5F)};
  }
  const ImU32 rest = mixed(colours.pressed, colours.quietText, 0.22F);
  const ImU32 fill = state.selected ? colours.accent : hovered ? mixed(rest, colours.text, 0.25F) : rest;
  const ImU32 edge = state.trail ? *state.trail : hovered ? colours.text : colours.panel;
  return {hovered && state.selected ? mixed(fill, colours.text, 0.25F) : fill, edge, colours.quietText};
}

void drawPart(const WidgetContext& context, const Figure& figure, const DiagramPart& part, bool hovered) {
  const Theme& theme = context.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const PartLook look = lookOf(theme.colours, part, hovered);
  const std::vector<TaperedCapsule> shapes = shapesOf(figure, part);
  const float edge = part.trail ? theme.px(2.5F) : theme.px(1.5F);
  for (TaperedCapsule grown : shapes) {
    grown.fromRadius += edge;
    grown.toRadius += edge;
    addCapsule(list, grown, look.edge);
  }
  for (const TaperedCapsule& shape : shapes) {
    addCapsule(list, shape, look.fill);
  }
  if (part.trail) {
    const ImVec2 end = figure.at(part.end);
    list.AddCircleFilled(end, theme.px(5.0F), theme.colours.panel);
    list.AddCircleFilled(end, theme.px(3.5F), *part.trail);
  }
}

void drawMarks(const WidgetContext& context, const Figure& figure, const DiagramPart& part) {
  const Theme& theme = context.theme;
  const ImVec2 place = figure.at(part.key);
  const float half = theme.px(9.0F);
  const Rect box{{place.x - half, place.y - half}, {place.x + half, place.y + half}};
  const bool isInside = isOn(figure, part, place, 0.0F);
  const bool onFill = isInside && part.selected;
  const ImU32 quiet = part.found ? theme.colours.quietText : faded(theme.colours.quietText, 0.45F);
  const ImU32 inside =
      onFill ? theme.colours.onAccent : mixed(theme.colours.quietText, theme.colours.text, 0.6F);
  if (part.found && part.lowConfidence) {
    ImGui::GetWindowDrawList()->AddCircleFilled(place, half * 0.85F, theme.colours.warning);
    drawText(context, theme.fonts.strong, box, theme.colours.panel, "?", 0.5F);
    return;
  }
  drawText(context, theme.fonts.label, box, isInside && part.found ? inside : quiet, part.keyText, 0.5F);
}

// A ring about the limb's end where it strikes or steps: the stronger, the plainer.
void drawMoment(const WidgetContext& context, const Figure& figure, const DiagramPart& part) {
  const Theme& theme = context.theme;
  ImGui::GetWindowDrawList()->AddCircle(figure.at(part.end), theme.px(11.0F),
                                        faded(theme.colours.text, 0.25F + 0.65F * part.moment), 0,
                                        theme.px(1.0F + 1.5F * part.moment));
}

// A small weight that hangs on the limb: it points down.
void drawWeight(const WidgetContext& context, const ImVec2& centre, bool onFill) {
  const Theme& theme = context.theme;
  const float half = theme.px(4.5F);
  const ImVec2 left{centre.x - half, centre.y - 0.7F * half};
  const ImVec2 right{centre.x + half, centre.y - 0.7F * half};
  const ImVec2 tip{centre.x, centre.y + half};
  ImGui::GetWindowDrawList()->AddTriangleFilled(left, right, tip,
                                                onFill ? theme.colours.onAccent : theme.colours.text);
}

} // namespace

std::optional<std::size_t> partAt(const Rect& box, const std::vector<DiagramPart>& parts,
                                  const ImVec2& point) {
  const Figure figure = figureIn(box);
  for (const float margin : {0.0F, 4.0F}) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (isOn(figure, parts[i], point, margin)) {
        return i;
      }
    }
  }
  return std::nullopt;
}

namespace {

/// The controller whose mark lies under the mouse; null where none does.
const DiagramController* controllerUnder(const Figure& figure,
                                         const std::vector<DiagramController>& controllers,
                                         const ImVec2& mouse, float radius) {
  for (const DiagramController& controller : controllers) {
    const ImVec2 place = figure.at(controller.place);
    const float x = mouse.x - place.x;
    const float y = mouse.y - place.y;
    if (x * x + y * y <= radius * radius) {
      return &controller;
    }
  }
  return nullptr;
}

void drawController(const WidgetContext& context, const Figure& figure, const std::string& id,
                    const DiagramController& controller, bool hovered) {
  const Theme& theme = context.theme;
  const ThemeColours& colours = theme.colours;
  const ImVec2 place = figure.at(controller.place);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = theme.px(hovered ? 7.0F : 6.0F);
  const ImU32 colour = controller.selected ? colours.accent
                       : hovered           ? colours.text
                                           : mixed(colours.quietText, colours.text, 0.4F);
  addDiamond(list, place, radius + theme.px(2.0F), colours.panel); // Stands off from limbs and trails.
  addKeyMark(theme, list, place, radius, controller.keys, colour,
             controller.selected ? mixed(colours.panel, colours.accent, 0.35F) : colours.panel);
  context.items.add(id + "/" + controller.id, {place.x - radius, place.y - radius},
                    {place.x + radius, place.y + radius});
}

void drawSides(const WidgetContext& context, const Rect& box, bool leftIsOnTheRight) {
  const Theme& theme = context.theme;
  const float row = theme.px(18.0F);
  const ImU32 colour = faded(theme.colours.quietText, 0.8F);
  const Rect line{box.min, {box.max.x, box.min.y + row}};
  drawText(context, theme.fonts.label, line, colour,
           leftIsOnTheRight ? "R  \xC2\xB7  front" : "L  \xC2\xB7  above");
  drawText(context, theme.fonts.label, line, colour, leftIsOnTheRight ? "L" : "R", 1.0F);
}

/// Selected and coloured edges lie over the plain ones.
void drawBody(const WidgetContext& context, const Figure& figure, const std::string& id,
              const std::vector<DiagramPart>& parts, std::optional<std::size_t> under) {
  for (const bool raised : {false, true}) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool hovered = under == i;
      if ((parts[i].selected || parts[i].trail.has_value() || hovered) == raised) {
        drawPart(context, figure, parts[i], hovered);
      }
    }
  }
  for (const DiagramPart& part : parts) {
    drawMarks(context, figure, part);
    if (part.moment > 0.0F) {
      drawMoment(context, figure, part);
    }
    const ImVec2 centre = centreOf(figure, part);
    if (part.hasWeight) {
      drawWeight(context, centre, part.selected);
    }
    const float half = context.theme.px(4.0F);
    context.items.add(id + "/" + part.id, {centre.x - half, centre.y - half},
                      {centre.x + half, centre.y + half}, part.found);
  }
}

} // namespace

DiagramClick limbDiagram(const WidgetContext& context, const std::string& id, const DiagramFigure& body,
                         float height) {
  const Control control = takePlace(context, id, {ImGui::GetContentRegionAvail().x, height});
  if (!control.visible) {
    return {};
  }
  const Figure figure = figureIn(control.box);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const DiagramController* const held =
      control.hovered ? controllerUnder(figure, body.controllers, mouse, context.theme.px(7.0F)) : nullptr;
  const std::optional<std::size_t> under =
      control.hovered && held == nullptr ? partAt(control.box, body.parts, mouse) : std::nullopt;
  drawBody(context, figure, id, body.parts, under);
  for (const DiagramController& controller : body.controllers) {
    drawController(context, figure, id, controller, held == &controller);
  }
  drawSides(context, control.box, body.leftIsOnTheRight);
  if (held != nullptr) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltipNow(context, held->help);
  } else if (under) {
    const DiagramPart& part = body.parts[*under];
    ImGui::SetMouseCursor(part.found ? ImGuiMouseCursor_Hand : ImGuiMouseCursor_NotAllowed);
    tooltipNow(context, part.help);
  }
  const std::string controller = held == nullptr ? "" : held->id;
  return control.clicked ? DiagramClick{under, controller, under, controller}
                         : DiagramClick{{}, {}, under, controller};
}

} // namespace stretch::ui
