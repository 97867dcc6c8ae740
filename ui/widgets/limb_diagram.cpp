#include "ui/widgets/limb_diagram.h"

#include <algorithm>
#include <array>
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

  [[nodiscard]] ImVec2 at(float x, float y) const { return {origin.x + x * size, origin.y + y * size}; }
  [[nodiscard]] TaperedCapsule bone(const ImVec2& a, float ra, const ImVec2& b, float rb) const {
    return {at(a.x, a.y), at(b.x, b.y), ra * size, rb * size};
  }
};

Figure figureIn(const Rect& box) {
  const float size = std::min(box.width() / figureWidth, box.height() / figureHeight);
  return {{box.centre().x, box.centre().y - figureHeight * 0.5F * size}, size};
}

std::vector<TaperedCapsule> armOf(const Figure& figure, float side) {
  return {figure.bone({side * 31.0F, 66.0F}, 10.0F, {side * 50.0F, 99.0F}, 8.0F),
          figure.bone({side * 50.0F, 99.0F}, 8.0F, {side * 66.0F, 131.0F}, 6.0F),
          figure.bone({side * 67.5F, 134.0F}, 7.5F, {side * 71.0F, 143.0F}, 6.5F)};
}

std::vector<TaperedCapsule> legOf(const Figure& figure, float side) {
  return {figure.bone({side * 13.0F, 132.0F}, 12.0F, {side * 17.0F, 174.0F}, 9.0F),
          figure.bone({side * 17.0F, 174.0F}, 9.0F, {side * 19.0F, 212.0F}, 6.5F),
          figure.bone({side * 19.5F, 217.0F}, 6.5F, {side * 29.0F, 220.0F}, 5.5F)};
}

std::vector<TaperedCapsule> shapesOf(const Figure& figure, BodyPart part) {
  switch (part) {
  case BodyPart::leftArm:
    return armOf(figure, 1.0F);
  case BodyPart::rightArm:
    return armOf(figure, -1.0F);
  case BodyPart::leftLeg:
    return legOf(figure, 1.0F);
  case BodyPart::rightLeg:
    return legOf(figure, -1.0F);
  case BodyPart::spine:
    return {figure.bone({0.0F, 72.0F}, 19.0F, {0.0F, 112.0F}, 15.0F),
            figure.bone({0.0F, 108.0F}, 14.0F, {0.0F, 116.0F}, 15.5F)};
  case BodyPart::neck:
    return {figure.bone({0.0F, 40.0F}, 6.5F, {0.0F, 50.0F}, 8.0F),
            figure.bone({0.0F, 21.0F}, 16.0F, {0.0F, 30.0F}, 12.5F)};
  }
  return {};
}

ImVec2 centreOf(const Figure& figure, BodyPart part) {
  const TaperedCapsule first = shapesOf(figure, part).front();
  return {(first.from.x + first.to.x) * 0.5F, (first.from.y + first.to.y) * 0.5F};
}

/// Where the limb ends: what a trail is drawn for.
ImVec2 endOf(const Figure& figure, BodyPart part) {
  switch (part) {
  case BodyPart::leftArm:
    return figure.at(69.0F, 138.5F);
  case BodyPart::rightArm:
    return figure.at(-69.0F, 138.5F);
  case BodyPart::leftLeg:
    return figure.at(20.5F, 217.0F);
  case BodyPart::rightLeg:
    return figure.at(-20.5F, 217.0F);
  case BodyPart::spine:
    return figure.at(0.0F, 66.0F);
  case BodyPart::neck:
    return figure.at(0.0F, 24.0F);
  }
  return figure.origin;
}

ImVec2 keyPlace(const Figure& figure, BodyPart part) {
  switch (part) {
  case BodyPart::leftArm:
    return figure.at(70.0F, 104.0F);
  case BodyPart::rightArm:
    return figure.at(-70.0F, 104.0F);
  case BodyPart::leftLeg:
    return figure.at(38.0F, 184.0F);
  case BodyPart::rightLeg:
    return figure.at(-38.0F, 184.0F);
  case BodyPart::spine:
    return figure.at(0.0F, 104.0F);
  case BodyPart::neck:
    return figure.at(28.0F, 22.0F);
  }
  return figure.origin;
}

struct PartLook {
  ImU32 fill;
  ImU32 edge;
  ImU32 key;
};

PartLook lookOf(const ThemeColours& colours, const BodyPartState& state, bool hovered) {
  if (!state.found) {
    return {mixed(colours.panel, colours.sunken, 0.6F), mixed(colours.panel, colours.quietText, 0.35F),
            faded(colours.quietText, 0.5F)};
  }
  const ImU32 rest = mixed(colours.pressed, colours.quietText, 0.22F);
  const ImU32 fill = state.selected ? colours.accent : hovered ? mixed(rest, colours.text, 0.25F) : rest;
  const ImU32 edge = state.trail ? *state.trail : hovered ? colours.text : colours.panel;
  return {hovered && state.selected ? mixed(fill, colours.text, 0.25F) : fill, edge, colours.quietText};
}

void drawPart(const WidgetContext& context, const Figure& figure, BodyPart part, const BodyPartState& state,
              bool hovered) {
  const Theme& theme = context.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const PartLook look = lookOf(theme.colours, state, hovered);
  const std::vector<TaperedCapsule> shapes = shapesOf(figure, part);
  const float edge = state.trail ? theme.px(2.5F) : theme.px(1.5F);
  for (TaperedCapsule grown : shapes) {
    grown.fromRadius += edge;
    grown.toRadius += edge;
    addCapsule(list, grown, look.edge);
  }
  for (const TaperedCapsule& shape : shapes) {
    addCapsule(list, shape, look.fill);
  }
  if (state.trail) {
    const ImVec2 end = endOf(figure, part);
    list.AddCircleFilled(end, theme.px(5.0F), theme.colours.panel);
    list.AddCircleFilled(end, theme.px(3.5F), *state.trail);
  }
}

void drawMarks(const WidgetContext& context, const Figure& figure, BodyPart part,
               const BodyPartState& state) {
  const Theme& theme = context.theme;
  const ImVec2 place = keyPlace(figure, part);
  const float half = theme.px(9.0F);
  const Rect box{{place.x - half, place.y - half}, {place.x + half, place.y + half}};
  const bool onFill = part == BodyPart::spine && state.selected;
  const ImU32 quiet = state.found ? theme.colours.quietText : faded(theme.colours.quietText, 0.45F);
  const ImU32 spine =
      onFill ? theme.colours.onAccent : mixed(theme.colours.quietText, theme.colours.text, 0.6F);
  if (state.found && state.lowConfidence) {
    ImGui::GetWindowDrawList()->AddCircleFilled(place, half * 0.85F, theme.colours.warning);
    drawText(context, theme.fonts.strong, box, theme.colours.panel, "?", 0.5F);
    return;
  }
  drawText(context, theme.fonts.label, box, part == BodyPart::spine && state.found ? spine : quiet,
           state.keyText, 0.5F);
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

std::optional<BodyPart> bodyPartAt(const Rect& box, const ImVec2& point) {
  const Figure figure = figureIn(box);
  for (const float margin : {0.0F, 4.0F}) {
    for (int i = 0; i < bodyPartCount; ++i) {
      const auto part = static_cast<BodyPart>(i);
      const std::vector<TaperedCapsule> shapes = shapesOf(figure, part);
      if (std::any_of(shapes.begin(), shapes.end(),
                      [&](const TaperedCapsule& s) { return isInside(s, point, margin * figure.size); })) {
        return part;
      }
    }
  }
  return std::nullopt;
}

ImVec2 bodyPartCentre(const Rect& box, BodyPart part) {
  return centreOf(figureIn(box), part);
}

namespace {

struct ControllerPlace {
  const char* id;
  float x;
  float y;
};

constexpr std::array<ControllerPlace, 14> controllerPlaces{{{"head", 0.0F, 6.0F},
                                                            {"spine-top", 0.0F, 62.0F},
                                                            {"spine-mid", 0.0F, 78.0F},
                                                            {"spine-low", 0.0F, 119.0F},
                                                            {"hips", 0.0F, 135.0F},
                                                            {"body", 0.0F, 224.0F},
                                                            {"left-hand", 73.0F, 152.0F},
                                                            {"right-hand", -73.0F, 152.0F},
                                                            {"left-elbow", 52.0F, 99.0F},
                                                            {"right-elbow", -52.0F, 99.0F},
                                                            {"left-foot", 34.0F, 222.0F},
                                                            {"right-foot", -34.0F, 222.0F},
                                                            {"left-knee", 18.0F, 172.0F},
                                                            {"right-knee", -18.0F, 172.0F}}};

std::optional<ImVec2> placeOfController(const Figure& figure, const std::string& id) {
  const auto* const found =
      std::ranges::find_if(controllerPlaces, [&](const ControllerPlace& place) { return id == place.id; });
  return found == controllerPlaces.end() ? std::nullopt : std::optional(figure.at(found->x, found->y));
}

/// The controller whose mark lies under the mouse; null where none does.
const DiagramController* controllerUnder(const Figure& figure,
                                         const std::vector<DiagramController>& controllers,
                                         const ImVec2& mouse, float radius) {
  for (const DiagramController& controller : controllers) {
    const std::optional<ImVec2> place = placeOfController(figure, controller.id);
    const float x = place ? mouse.x - place->x : 2.0F * radius;
    const float y = place ? mouse.y - place->y : 0.0F;
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
  const std::optional<ImVec2> place = placeOfController(figure, controller.id);
  if (!place) {
    return;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = theme.px(hovered ? 7.0F : 6.0F);
  const ImU32 colour = controller.selected ? colours.accent
                       : hovered           ? colours.text
                                           : mixed(colours.quietText, colours.text, 0.4F);
  addDiamond(list, *place, radius + theme.px(2.0F), colours.panel); // Stands off from limbs and trails.
  addKeyMark(theme, list, *place, radius, controller.keys, colour,
             controller.selected ? mixed(colours.panel, colours.accent, 0.35F) : colours.panel);
  context.items.add(id + "/" + controller.id, {place->x - radius, place->y - radius},
                    {place->x + radius, place->y + radius});
}

void drawSides(const WidgetContext& context, const Rect& box) {
  const Theme& theme = context.theme;
  const float row = theme.px(18.0F);
  const ImU32 colour = faded(theme.colours.quietText, 0.8F);
  drawText(context, theme.fonts.label, {box.min, {box.max.x, box.min.y + row}}, colour, "R");
  drawText(context, theme.fonts.label, {box.min, {box.max.x, box.min.y + row}}, colour, "L", 1.0F);
}

/// Selected and coloured edges lie over the plain ones.
void drawBody(const WidgetContext& context, const Figure& figure, const std::string& id,
              const std::array<BodyPartState, bodyPartCount>& parts, std::optional<BodyPart> under) {
  for (const bool raised : {false, true}) {
    for (int i = 0; i < bodyPartCount; ++i) {
      const BodyPartState& state = parts[static_cast<std::size_t>(i)];
      const bool hovered = under == static_cast<BodyPart>(i);
      if ((state.selected || state.trail.has_value() || hovered) == raised) {
        drawPart(context, figure, static_cast<BodyPart>(i), state, hovered);
      }
    }
  }
  for (int i = 0; i < bodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    const BodyPartState& state = parts[static_cast<std::size_t>(i)];
    drawMarks(context, figure, part, state);
    const ImVec2 centre = centreOf(figure, part);
    if (state.hasWeight) {
      drawWeight(context, centre, state.selected);
    }
    const float half = context.theme.px(4.0F);
    context.items.add(id + "/" + state.id, {centre.x - half, centre.y - half},
                      {centre.x + half, centre.y + half}, state.found);
  }
}

} // namespace

DiagramClick limbDiagram(const WidgetContext& context, const std::string& id,
                         const std::array<BodyPartState, bodyPartCount>& parts,
                         const std::vector<DiagramController>& controllers, float height) {
  const Control control = takePlace(context, id, {ImGui::GetContentRegionAvail().x, height});
  if (!control.visible) {
    return {};
  }
  const Figure figure = figureIn(control.box);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const DiagramController* const held =
      control.hovered ? controllerUnder(figure, controllers, mouse, context.theme.px(7.0F)) : nullptr;
  const std::optional<BodyPart> under =
      control.hovered && held == nullptr ? bodyPartAt(control.box, mouse) : std::nullopt;
  drawBody(context, figure, id, parts, under);
  for (const DiagramController& controller : controllers) {
    drawController(context, figure, id, controller, held == &controller);
  }
  drawSides(context, control.box);
  if (held != nullptr) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltipNow(context, held->help);
  } else if (under) {
    const BodyPartState& state = parts[static_cast<std::size_t>(*under)];
    ImGui::SetMouseCursor(state.found ? ImGuiMouseCursor_Hand : ImGuiMouseCursor_NotAllowed);
    tooltipNow(context, state.help);
  }
  return control.clicked ? DiagramClick{under, held == nullptr ? "" : held->id} : DiagramClick{};
}

} // namespace stretch::ui
