#include "ui/viewport/cube_marker.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <imgui.h>

#include "ui/widgets/button.h"

namespace stretch::ui {

namespace {

constexpr float halfEdgePoints = 20.0F;
constexpr float insetPoints = 46.0F; // Of the centre, from the picture's upper right corner.
constexpr float axisPoints = 22.0F;
constexpr float axesBelowCubePoints = 76.0F;

/// Names of the faces: of each axis towards -1, then towards 1.
constexpr std::array<std::array<const char*, 2>, 3> faceNames{
    {{"right", "left"}, {"under", "top"}, {"back", "front"}}};

const char* faceName(int axis, int side) {
  return faceNames[static_cast<std::size_t>(axis)][side > 0 ? 1 : 0];
}

bool hasRoom(const ViewportContext& context) {
  const Rect& box = context.viewport.box;
  return box.width() >= context.theme.px(360.0F) && box.height() >= context.theme.px(240.0F);
}

ImVec2 centreOf(const ViewportContext& context) {
  const float inset = context.theme.px(insetPoints);
  return {context.viewport.box.max.x - inset, context.viewport.box.min.y + inset};
}

ViewCube cubeOf(const ViewportContext& context) {
  return {context.viewport.view, context.viewport.look.facingYawRadians};
}

/// Draws the directions of the world's axes, the nearest over the others.
void drawAxes(ViewportContext& context, const ImVec2& centre) {
  const Theme& theme = context.theme;
  const View& view = context.viewport.view;
  const Mat3 axes(viewRight(view), viewUp(view), -view.forward);
  const float length = theme.px(axisPoints);
  const WidgetContext widgets{theme, context.items};
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, {}, [&](int axis) { return axes[2][axis]; });
  for (const int axis : order) {
    const auto right = length * static_cast<float>(axes[0][axis]);
    const auto up = length * static_cast<float>(axes[1][axis]);
    const ImU32 colour = faded(axisColour(theme, axis), axes[2][axis] < -0.2 ? 0.55F : 1.0F);
    ImGui::GetWindowDrawList()->AddLine(centre, {centre.x + right, centre.y - up}, colour, theme.px(2.0F));
    const ImVec2 name{centre.x + 1.45F * right, centre.y - 1.45F * up};
    const float half = theme.px(7.0F);
    drawText(widgets, theme.fonts.strong, {{name.x - half, name.y - half}, {name.x + half, name.y + half}},
             colour, std::string(1, "XYZ"[axis]), 0.5F);
  }
  context.items.add("viewport/axes", {centre.x - length, centre.y - length},
                    {centre.x + length, centre.y + length});
}

/// Draws the faces that are seen.
class CubeDrawing {
public:
  CubeDrawing(ViewportContext& context, const ImVec2& centre)
      : context_(context), centre_(centre), cube_(cubeOf(context)), draw_(*ImGui::GetWindowDrawList()) {}

  void draw() const {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        if (cube_.towardsViewer(axis, side) > 0.0) {
          drawFace(axis, side);
        }
      }
    }
  }

private:
  /// A rectangle on a face; `from` and `to` along the two other axes, in their order.
  [[nodiscard]] std::array<ImVec2, 4> cornersOf(int axis, int side, const Vec2& from, const Vec2& to) const {
    std::array<ImVec2, 4> corners;
    const std::array<Vec2, 4> places{from, Vec2(to.x, from.y), to, Vec2(from.x, to.y)};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Vec3 point(0.0);
      point[axis] = side;
      point[axis == 0 ? 1 : 0] = places[i].x;
      point[axis == 2 ? 1 : 2] = places[i].y;
      corners[i] = pixelsOf(cube_.seenAt(point));
    }
    return corners;
  }

  [[nodiscard]] ImVec2 pixelsOf(const Vec2& place) const {
    const float half = context_.theme.px(halfEdgePoints);
    return {centre_.x + half * static_cast<float>(place.x), centre_.y - half * static_cast<float>(place.y)};
  }

  void drawFace(int axis, int side) const {
    const ThemeColours& colours = context_.theme.colours;
    const std::array<ImVec2, 4> face = cornersOf(axis, side, Vec2(-1.0), Vec2(1.0));
    constexpr std::array<float, 3> shades{0.2F, 0.06F, 0.12F}; // Of each axis, so that faces are told apart.
    draw_.AddConvexPolyFilled(face.data(), 4,
                              mixed(colours.raised, colours.text, shades[static_cast<std::size_t>(axis)]));
    lightUp(axis, side);
    draw_.AddPolyline(face.data(), 4, mixed(colours.raised, colours.text, 0.45F), ImDrawFlags_Closed,
                      context_.theme.px(1.0F));
    nameFace(axis, side);
  }

  /// The part of this face that is under the mouse.
  void lightUp(int axis, int side) const {
    const std::optional<CubePart>& part = context_.viewport.look.hoveredPart;
    if (!part || isRunning(context_.tool) || part->side[static_cast<std::size_t>(axis)] != side) {
      return;
    }
    const auto rangeOf = [&](int other) {
      const int towards = part->side[static_cast<std::size_t>(other)];
      return towards == 0  ? Vec2(-cubeMiddle, cubeMiddle)
             : towards > 0 ? Vec2(cubeMiddle, 1.0)
                           : Vec2(-1.0, -cubeMiddle);
    };
    const Vec2 first = rangeOf(axis == 0 ? 1 : 0);
    const Vec2 second = rangeOf(axis == 2 ? 1 : 2);
    const std::array<ImVec2, 4> lit = cornersOf(axis, side, {first.x, second.x}, {first.y, second.y});
    draw_.AddConvexPolyFilled(lit.data(), 4, faded(context_.theme.colours.accent, 0.7F));
  }

  void nameFace(int axis, int side) const {
    constexpr double readable = 0.6; // Of the cosine: a face that is turned farther away has no room for its
                                     // name.
    const Theme& theme = context_.theme;
    Vec3 middle(0.0);
    middle[axis] = side;
    const ImVec2 at = pixelsOf(cube_.seenAt(middle));
    const std::string name = faceName(axis, side);
    const float half = theme.px(6.0F);
    context_.items.add("view-cube/" + name, {at.x - half, at.y - half}, {at.x + half, at.y + half});
    if (cube_.towardsViewer(axis, side) > readable) {
      const float room = theme.px(halfEdgePoints);
      drawText({theme, context_.items}, theme.fonts.label,
               {{at.x - room, at.y - half}, {at.x + room, at.y + half}}, theme.colours.text, name, 0.5F);
    }
  }

  ViewportContext& context_;
  ImVec2 centre_;
  ViewCube cube_;
  ImDrawList& draw_;
};

} // namespace

std::string nameOf(const CubePart& part) {
  std::string name;
  for (const int axis : {2, 0, 1}) {
    if (const int side = part.side[static_cast<std::size_t>(axis)]; side != 0) {
      name += name.empty() ? "" : " ";
      name += faceName(axis, side);
    }
  }
  return name;
}

std::optional<CubePart> cubePartUnderMouse(const ViewportContext& context) {
  if (!context.ui.overlays.viewCube || !hasRoom(context)) {
    return std::nullopt;
  }
  const ImVec2 centre = centreOf(context);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double half = context.theme.px(halfEdgePoints);
  return cubeOf(context).partAt(Vec2(mouse.x - centre.x, centre.y - mouse.y) / half);
}

void drawViewCube(ViewportContext& context) {
  if (!hasRoom(context)) {
    return;
  }
  const ImVec2 centre = centreOf(context);
  if (context.ui.overlays.viewCube) {
    CubeDrawing(context, centre).draw();
    drawAxes(context, {centre.x, centre.y + context.theme.px(axesBelowCubePoints)});
  } else {
    drawAxes(context, centre);
  }
  if (const std::optional<CubePart>& part = context.viewport.look.hoveredPart;
      part && context.viewport.gesture == ViewportGesture::none && !isRunning(context.tool)) {
    tooltipNow({context.theme, context.items},
               {"View from: " + nameOf(*part), "A click looks from there, a drag turns the view.", {}});
  }
}

} // namespace stretch::ui
