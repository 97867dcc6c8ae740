#include "ui/viewport/viewport_labels.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "core/anim/frames.h"
#include "rig/limb.h"
#include "rig/motion/motion.h"
#include "rig/trail/exaggeration.h"
#include "ui/panels/context/panel_support.h"
#include "ui/render/overlay/skeleton_drawing.h"
#include "ui/viewport/cube_marker.h"
#include "ui/viewport/viewport_legend.h"
#include "ui/viewport/viewport_scene.h"
#include "ui/widgets/button.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

std::optional<ImVec2> placeOf(const ViewportState& viewport, const Vec3& world) {
  const auto point = projectToPixels(viewport.view, world);
  if (!point) {
    return std::nullopt;
  }
  return ImVec2(viewport.box.min.x + static_cast<float>(point->pixels.x / viewport.pixelsPerUnit),
                viewport.box.min.y + static_cast<float>(point->pixels.y / viewport.pixelsPerUnit));
}

namespace {

/// Text on a dark ground of its own, so that it reads over anything.
void label(const PanelContext& context, const ImVec2& corner, const std::string& text, ImU32 colour) {
  const Theme& theme = context.theme;
  ImFont* font = theme.fonts.label != nullptr ? theme.fonts.label : ImGui::GetFont();
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text.c_str());
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({corner.x - theme.px(4.0F), corner.y - theme.px(1.0F)},
                      {corner.x + size.x + theme.px(4.0F), corner.y + size.y + theme.px(1.0F)},
                      faded(theme.colours.background, 0.72F), theme.corner());
  draw->AddText(font, font->FontSize, corner, colour, text.c_str());
}

void recordSpheres(ViewportContext& context) {
  const ShownTrail* trail =
      findShown(context.viewport.shown, context.open.character()->view().selection.trail());
  if (trail == nullptr) {
    return;
  }
  const float reach = context.theme.px(20.0F);
  for (const app::PlacedSphere& sphere : trail->spheres) {
    if (const auto place = placeOf(context.viewport, sphere.positionWorld)) {
      context.items.add(fmt::format("viewport/sphere/{:.0f}", sphere.frame),
                        {place->x - reach, place->y - reach}, {place->x + reach, place->y + reach});
    }
  }
  const double frame = context.open.character()->view().frame;
  if (const auto place = placeOf(context.viewport, pointOnTrail(*trail, frame, trail->exaggerated))) {
    context.items.add("viewport/trail", {place->x - reach, place->y - reach},
                      {place->x + reach, place->y + reach});
  }
}

void recordHandles(ViewportContext& context) {
  const app::ViewState& view = context.open.character()->view();
  const auto handles = handlesOf(context.viewport.shown, view.selection.trail(), view.selection.spheres());
  if (!handles) {
    return;
  }
  const float reach = context.theme.px(6.0F);
  const std::array<Vec3, 3> tips = handleTips(context.viewport.view, *handles);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (const auto place = placeOf(context.viewport, glm::mix(handles->origin, tips[axis], 0.8))) {
      context.items.add(std::string("viewport/axis/") + "xyz" [axis], { place->x - reach, place->y - reach },
                        {place->x + reach, place->y + reach});
    }
  }
}

void recordPlace(ViewportContext& context, const std::string& id, const Vec3& world) {
  const float reach = context.theme.px(6.0F);
  if (const auto place = placeOf(context.viewport, world)) {
    context.items.add(id, {place->x - reach, place->y - reach}, {place->x + reach, place->y + reach});
  }
}

/// Of a ring the point in the middle of its near half.
Vec3 nearPoint(const View& view, const ControllerHandles& handles, const std::vector<Vec3>& ring) {
  const auto nearest = std::ranges::min_element(
      ring, {}, [&](const Vec3& point) { return glm::dot(point - handles.origin, view.forward); });
  return *nearest;
}

/// Where the mouse takes the shape of a controller.
Vec3 heldPoint(const ControllerPicture& picture) {
  return picture.knob   ? *picture.knob
         : picture.ring ? *picture.ring
                        : picture.lines.front()[picture.lines.front().size() / 3];
}

void recordControllers(ViewportContext& context) {
  for (const ShownController& shown : context.viewport.controllers) {
    recordPlace(context, "viewport/controller/" + shown.placed.id, heldPoint(shown.picture));
  }
  const auto handles = controllerHandles(*context.open.character(), context.viewport.controllers);
  if (!handles) {
    return;
  }
  for (const HandlePart& part : partsOf(*handles)) {
    const char* const kind = part.kind == HandleKind::axis    ? "move-"
                             : part.kind == HandleKind::plane ? "plane-"
                                                              : "turn-";
    const std::vector<Vec3> points = pointsOf(context.viewport.view, *handles, part);
    const Vec3 place = part.kind == HandleKind::axis    ? glm::mix(points[0], points[1], 0.9)
                       : part.kind == HandleKind::plane ? 0.5 * (points[0] + points[2])
                                                        : nearPoint(context.viewport.view, *handles, points);
    recordPlace(context, std::string("viewport/handle/") + kind + "xyz"[part.axis], place);
  }
}

void recordLimbs(ViewportContext& context, const FrameState& frame) {
  const LimbBones bones = limbBones(context.open.character()->document(), frame);
  const float reach = context.theme.px(6.0F);
  for (std::size_t i = 0; i < bones.bones.size(); ++i) {
    const BoneSegment& bone = bones.bones[i];
    if (const auto place = placeOf(context.viewport, 0.5 * (bone.fromWorld + bone.toWorld))) {
      context.items.add("viewport/limb/" + bones.limbOf[i], {place->x - reach, place->y - reach},
                        {place->x + reach, place->y + reach});
    }
  }
}

/// Hands, feet and head, where a drag pulls them.
void recordEnds(ViewportContext& context, const FrameState& frame) {
  const float reach = context.theme.px(6.0F);
  for (const rig::Limb& limb : app::allLimbs(context.open.character()->document())) {
    if (const auto place = placeOf(context.viewport, rig::leadingPosition(limb, frame))) {
      context.items.add("viewport/end/" + limb.id, {place->x - reach, place->y - reach},
                        {place->x + reach, place->y + reach});
    }
  }
}

void drawFrameNumbers(ViewportContext& context) {
  const ShownTrail* trail =
      findShown(context.viewport.shown, context.open.character()->view().selection.trail());
  if (trail == nullptr || !context.ui.overlays.trailFrameNumbers) {
    return;
  }
  for (const app::PlacedSphere& sphere : trail->spheres) {
    if (const auto place = placeOf(context.viewport, sphere.positionWorld)) {
      label(context, {place->x + context.theme.px(12.0F), place->y - context.theme.px(18.0F)},
            fmt::format("{:.4g}", sphere.frame), context.theme.colours.text);
    }
  }
}

/// The number of the sphere under the mouse, and how far it was pulled.
void drawHoverLabel(ViewportContext& context) {
  const ShownTrail* trail =
      findShown(context.viewport.shown, context.open.character()->view().selection.trail());
  if (!context.viewport.hoveredSphere || trail == nullptr) {
    return;
  }
  for (const app::PlacedSphere& sphere : trail->spheres) {
    const auto place = placeOf(context.viewport, sphere.positionWorld);
    if (place && sameFrame(sphere.frame, *context.viewport.hoveredSphere)) {
      label(context, {place->x + context.theme.px(16.0F), place->y + context.theme.px(10.0F)},
            fmt::format("frame {:.4g}", sphere.frame), context.theme.colours.text);
    }
  }
}

/// The limb under the mouse by its name, and what a drag there does.
void drawLimbName(ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  if (viewport.hoveredLimb.empty() || isRunning(context.tool) || viewport.gesture != ViewportGesture::none) {
    return;
  }
  std::string text = limbHeading(context.open.character()->document(), viewport.hoveredLimb);
  text += viewport.hoveredEnd ? ": drag to pull it" : "";
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  label(context, {mouse.x + context.theme.px(16.0F), mouse.y + context.theme.px(14.0F)}, text,
        context.theme.colours.text);
}

/// The controller under the mouse by its name, and what a drag does.
void drawControllerName(ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  const ShownController* const shown = findShown(viewport.controllers, viewport.hoveredController);
  if (shown == nullptr || isRunning(context.tool) || viewport.gesture != ViewportGesture::none) {
    return;
  }
  const std::string title =
      app::controllerTitle(context.open.character()->document(), viewport.hoveredController);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  label(context, {mouse.x + context.theme.px(16.0F), mouse.y + context.theme.px(14.0F)},
        capitalised(title) + (shown->placed.moves ? ": drag to move it" : ": drag to turn it"),
        context.theme.colours.text);
}

/// A pin where a hand or foot is held: its point at the place, weaker while it comes and goes.
void drawPin(ViewportContext& context, const std::string& limb, const Vec3& world, double strength) {
  const auto point = placeOf(context.viewport, world);
  if (!point) {
    return;
  }
  const Theme& theme = context.theme;
  const auto weight = static_cast<float>(0.35 + 0.65 * strength);
  const ImVec2 head{point->x + theme.px(7.0F), point->y - theme.px(15.0F)};
  const ImU32 edge = faded(theme.colours.background, 0.85F * weight);
  const ImU32 colour = faded(theme.colours.text, weight);
  ImDrawList* const draw = ImGui::GetWindowDrawList();
  draw->AddLine(*point, head, edge, theme.px(4.0F));
  draw->AddLine(*point, head, colour, theme.px(1.75F));
  draw->AddCircleFilled(head, theme.px(6.0F), edge);
  draw->AddCircleFilled(head, theme.px(4.5F), faded(theme.colours.accent, weight));
  draw->AddCircleFilled(*point, theme.px(2.5F), colour);
  const float reach = theme.px(6.0F);
  context.items.add("viewport/pin/" + limb, {head.x - reach, head.y - reach},
                    {head.x + reach, head.y + reach});
}

/// The pins that hold at the playhead.
void drawPins(ViewportContext& context) {
  app::Session& session = *context.open.character();
  if (session.view().clip < 0 || session.view().showOriginal) {
    return;
  }
  const rig::SolvedHolds& holds = session.motion().holds;
  const double seconds = session.view().frame / session.motion().framesPerSecond;
  for (const std::optional<rig::SolvedPin>& pin : holds.pins) {
    const double strength = pin ? pin->span.strengthAt(seconds) : 0.0;
    if (strength > 0.0) {
      drawPin(context, holds.limbs[pin->limb].limb.id, pin->place.position, strength);
    }
  }
}

void drawJointNames(ViewportContext& context, const FrameState& frame) {
  if (!context.ui.overlays.jointNames) {
    return;
  }
  const Scene& scene = *context.open.character()->document().scene;
  for (const NodeIndex joint : jointsOf(scene)) {
    const auto index = at(joint);
    if (const auto place = placeOf(context.viewport, positionOf(frame.worlds[index]))) {
      label(context, {place->x + context.theme.px(6.0F), place->y - context.theme.px(8.0F)},
            scene.nodes[index].name, context.theme.colours.quietText);
    }
  }
}

void drawSelectionBox(ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  if (viewport.gesture != ViewportGesture::boxSelect) {
    return;
  }
  const auto corner = [&](const Vec2& pixels) {
    return ImVec2(viewport.box.min.x + static_cast<float>(pixels.x / viewport.pixelsPerUnit),
                  viewport.box.min.y + static_cast<float>(pixels.y / viewport.pixelsPerUnit));
  };
  const ImVec2 low = corner(glm::min(viewport.pressPixels, viewport.mousePixels));
  const ImVec2 high = corner(glm::max(viewport.pressPixels, viewport.mousePixels));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, faded(context.theme.colours.accent, 0.15F));
  draw->AddRect(low, high, context.theme.colours.accent);
}

/// Where the tip of a handle is: under the mouse while it is pulled.
Vec3 tangentTip(const ViewportContext& context, const ShownTangent& tangent) {
  const auto* const grab = std::get_if<GrabTool>(&context.tool);
  const bool held =
      grab != nullptr && grab->tangent && (grab->tangent->frames < 0.0) == (tangent.handle.frames < 0.0);
  return held ? grab->anchor + app::worldChange(grab->modal) : tangent.tipWorld;
}

/// The tangent handles of the selected sphere: a thin line and a small square at its end.
void drawTangents(ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  const Theme& theme = context.theme;
  ImDrawList* const draw = ImGui::GetWindowDrawList();
  const float reach = theme.px(6.0F);
  for (std::size_t i = 0; i < viewport.tangents.handles.size(); ++i) {
    const ShownTangent& tangent = viewport.tangents.handles[i];
    const auto from = placeOf(viewport, tangent.handle.sphereWorld);
    const auto to = placeOf(viewport, tangentTip(context, tangent));
    if (!from || !to) {
      continue;
    }
    const bool hovered = viewport.hoveredTangent == i;
    const float half = theme.px(hovered ? 5.5F : 4.0F);
    draw->AddLine(*from, *to, faded(theme.colours.background, 0.8F), theme.px(3.5F));
    draw->AddLine(*from, *to, theme.colours.text, theme.px(1.5F));
    draw->AddRectFilled({to->x - half, to->y - half}, {to->x + half, to->y + half},
                        hovered ? theme.colours.accent : theme.colours.text);
    draw->AddRect({to->x - half, to->y - half}, {to->x + half, to->y + half}, theme.colours.background, 0.0F,
                  0, theme.px(1.0F));
    context.items.add(tangent.handle.frames < 0.0 ? "viewport/tangent/before" : "viewport/tangent/after",
                      {to->x - reach, to->y - reach}, {to->x + reach, to->y + reach});
  }
}

/// The circle within which neighbours follow a pulled sphere.
void drawFalloff(ViewportContext& context) {
  const auto* grab = std::get_if<GrabTool>(&context.tool);
  if (grab == nullptr || grab->falloffRadius <= 0.0 || grab->tangent) {
    return;
  }
  const Vec3 centre = grab->anchor + app::worldChange(grab->modal);
  const double pixels = grab->falloffRadius / unitsPerPixel(context.viewport.view, centre);
  if (const auto place = placeOf(context.viewport, centre)) {
    ImGui::GetWindowDrawList()->AddCircle(*place, static_cast<float>(pixels / context.viewport.pixelsPerUnit),
                                          faded(context.theme.colours.accent, 0.7F), 64,
                                          context.theme.px(1.5F));
  }
}

/// The remap curve beside the trail while its ease is edited by keys.
void drawEaseCurve(ViewportContext& context) {
  const auto* tool = std::get_if<ExaggerateTool>(&context.tool);
  const bool easing = tool != nullptr && (tool->modal.field == app::ExaggerateField::easeIn ||
                                          tool->modal.field == app::ExaggerateField::easeOut);
  const ShownTrail* trail =
      findShown(context.viewport.shown, context.open.character()->view().selection.trail());
  if (!easing || trail == nullptr) {
    return;
  }
  const Theme& theme = context.theme;
  const float side = theme.px(112.0F);
  const Rect& box = context.viewport.box;
  const ImVec2 tip =
      placeOf(context.viewport, pointOnTrail(*trail, trail->endFrame, true)).value_or(box.centre());
  const ImVec2 corner{
      std::clamp(tip.x + theme.px(24.0F), box.min.x + theme.unit(), box.max.x - side - theme.unit()),
      std::clamp(tip.y - 0.5F * side, box.min.y + theme.unit(), box.max.y - side - theme.unit())};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(corner, {corner.x + side, corner.y + side}, faded(theme.colours.sunken, 0.9F),
                      theme.corner());
  draw->AddRect(corner, {corner.x + side, corner.y + side}, theme.colours.border, theme.corner());
  const rig::TrailSettings& settings = tool->modal.settings;
  const rig::Remap remap(settings.remap, settings.easeIn, settings.easeOut);
  const float inset = theme.unit();
  const auto place = [&](double ratio, double weight) {
    return ImVec2(corner.x + inset + static_cast<float>(ratio) * (side - 2.0F * inset),
                  corner.y + side - inset - static_cast<float>(weight) * (side - 2.0F * inset));
  };
  constexpr int pieces = 48;
  for (int i = 0; i < pieces; ++i) {
    const double from = static_cast<double>(i) / pieces;
    const double to = static_cast<double>(i + 1) / pieces;
    draw->AddLine(place(from, remap.at(from)), place(to, remap.at(to)),
                  trailColour(trail->colour, context.theme.kind), theme.px(2.0F));
  }
  const bool in = tool->modal.field == app::ExaggerateField::easeIn;
  const double ratio = in ? settings.easeIn.percent : 1.0 - settings.easeOut.percent;
  draw->AddCircleFilled(place(ratio, remap.at(ratio)), theme.px(4.5F), theme.colours.text);
}

/// The picture of the file's camera, with what lies outside of it dimmed, and the safe frame.
void drawCameraFrame(ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  const auto aspect = viewport.look.through ? viewport.look.through->lens.aspect : std::nullopt;
  const auto boxOf = [&](double share) {
    const PixelBox pixels = frameIn(viewport.view.viewport, aspect, share);
    const auto corner = [&](const Vec2& place) {
      return ImVec2(viewport.box.min.x + static_cast<float>(place.x / viewport.pixelsPerUnit),
                    viewport.box.min.y + static_cast<float>(place.y / viewport.pixelsPerUnit));
    };
    return Rect{corner(pixels.low), corner(pixels.high)};
  };
  ImDrawList* const draw = ImGui::GetWindowDrawList();
  const Rect frame = boxOf(1.0);
  if (viewport.look.through && aspect) {
    const ImU32 dim = faded(context.theme.colours.background, 0.6F);
    draw->AddRectFilled(viewport.box.min, {viewport.box.max.x, frame.min.y}, dim);
    draw->AddRectFilled({viewport.box.min.x, frame.max.y}, viewport.box.max, dim);
    draw->AddRectFilled({viewport.box.min.x, frame.min.y}, {frame.min.x, frame.max.y}, dim);
    draw->AddRectFilled({frame.max.x, frame.min.y}, {viewport.box.max.x, frame.max.y}, dim);
    draw->AddRect(frame.min, frame.max, context.theme.colours.border);
  }
  if (context.ui.overlays.safeFrame) {
    const Rect safe = boxOf(safeFrame);
    draw->AddRect(safe.min, safe.max, faded(context.theme.colours.text, 0.6F));
    context.items.add("viewport/safe-frame", safe.min, safe.max);
  }
}

/// The lens, and the rate of the clip.
void drawLens(ViewportContext& context) {
  const Theme& theme = context.theme;
  const app::Session& session = *context.open.character();
  std::string text = lensText(context.viewport.look, context.viewport.camera);
  if (app::hasClip(session.document(), session.view().clip)) {
    text += fmt::format(", {:.4g} fps", app::clipOf(session.document(), session.view().clip).framesPerSecond);
  }
  ImFont* const font = theme.fonts.label != nullptr ? theme.fonts.label : ImGui::GetFont();
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text.c_str());
  const Rect& box = context.viewport.box;
  // Above the label of what the picture shows; messages come at the top.
  const ImVec2 corner{box.min.x + theme.unit() * 1.5F, box.max.y - theme.unit() * 1.5F - theme.px(38.0F)};
  if (corner.x + size.x < box.max.x - theme.px(120.0F)) {
    label(context, corner, text, theme.colours.quietText);
    context.items.add("viewport/lens", corner, {corner.x + size.x, corner.y + size.y});
  }
}

/// What the picture shows when it is not the plain result.
void drawStateLabels(ViewportContext& context) {
  const Rect& box = context.viewport.box;
  const float inset = context.theme.unit() * 1.5F;
  const ImVec2 corner{box.min.x + inset, box.max.y - inset - context.theme.px(16.0F)};
  // The colour of original paths, but apart enough from the label's ground in every theme.
  const ImU32 original = mixed(originalColour(context.theme.kind), context.theme.colours.text, 0.5F);
  if (context.ui.overlays.sideBySide) {
    const float left = 2.0F * box.min.x - box.max.x; // The other half's edge.
    label(context, {left + inset, corner.y}, "Original", original);
    label(context, corner, "Exaggerated", context.theme.colours.text);
  } else if (context.open.character()->view().showOriginal) {
    label(context, corner, "Original", original);
  }
}

} // namespace

void drawViewportLabels(ViewportContext& context, const FrameState& frame) {
  ImGui::PushClipRect(context.viewport.box.min, context.viewport.box.max, true);
  drawCameraFrame(context);
  recordLimbs(context, frame);
  recordEnds(context, frame);
  recordSpheres(context);
  recordHandles(context);
  recordControllers(context);
  drawPins(context);
  drawJointNames(context, frame);
  drawFrameNumbers(context);
  drawHoverLabel(context);
  drawLimbName(context);
  drawControllerName(context);
  drawTangents(context);
  drawFalloff(context);
  drawEaseCurve(context);
  drawSelectionBox(context);
  drawLegends(context);
  drawViewCube(context);
  drawLens(context);
  ImGui::PopClipRect();
  drawStateLabels(context);
}

} // namespace stretch::ui
