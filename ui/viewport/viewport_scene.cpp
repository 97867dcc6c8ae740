#include "ui/viewport/viewport_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/mirror_edits.h"
#include "rig/limb.h"

namespace stretch::ui {

PictureSelection selectionOf(const app::Session& session, const ViewportState& viewport) {
  PictureSelection selection;
  selection.limbs = session.view().selection.limbs();
  selection.trail = session.view().selection.trail();
  selection.spheres = session.view().selection.spheres();
  selection.hoveredLimb = viewport.hoveredLimb;
  selection.hoveredTrail = viewport.hoveredTrail;
  selection.hoveredSphere = viewport.hoveredSphere;
  selection.hoveredAxis = viewport.hoveredAxis;
  selection.controllers =
      controllerPictures(viewport.controllers, selectedHandles(session), viewport.hoveredController);
  selection.controllerHandles = controllerHandles(session, viewport.controllers);
  selection.activeHandle = viewport.hoveredHandle;
  selection.tipFrame = viewport.tipFrame;
  selection.weightsOf = viewport.weightsOf;
  return selection;
}

PictureContent workPicture(app::Session& session, const ViewportState& viewport,
                           const ViewportOverlays& overlays, const Palette& palette,
                           const SceneMeasures& measures) {
  const double at = session.view().frame;
  const auto withReference = [&](PictureContent content) {
    content.style.backdrop = viewport.look.reference;
    return content;
  };
  const FrameState& pose = session.view().showOriginal ? session.originalAt(at) : session.shownAt(at);
  if (app::showsLocators(session)) { // nothing moves
    PictureContent content =
        assembleBare({session.document(), session.motion(), viewport.shown, at, pose, measures},
                     selectionOf(session, viewport), overlays, palette);
    content.skeleton = overlays.skeleton || viewport.weightsOf.exists();
    addHandles(selectionOf(session, viewport), content);
    return withReference(std::move(content));
  }
  return withReference(
      assemblePicture({session.document(), session.motion(), viewport.shown, at, pose, measures},
                      selectionOf(session, viewport), overlays, palette));
}

PictureContent originalPicture(app::Session& session, const ViewportState& viewport,
                               const ViewportOverlays& overlays, const Palette& palette,
                               const SceneMeasures& measures) {
  const double at = session.view().frame;
  PictureContent content = assembleBare(
      {session.document(), session.motion(), viewport.shown, at, session.originalAt(at), measures},
      selectionOf(session, viewport), overlays, palette);
  content.style.backdrop = viewport.look.reference;
  return content;
}

LimbBones limbBones(const app::Document& document, const FrameState& frame) {
  LimbBones result;
  for (const rig::Limb& limb : app::allLimbs(document)) {
    const std::vector<Vec3> points = rig::limbPoints(limb, frame);
    for (std::size_t i = 0; i < limb.joints.size(); ++i) {
      result.bones.push_back({limb.joints[i], points[i], points[i + 1]});
      result.limbOf.push_back(limb.id);
    }
  }
  return result;
}

double fleshRadius(const app::Document& document, int trailId) {
  constexpr double shareOfLimb = 0.3; // As long as a hand is for its arm, and a foot for its leg.
  const rig::Trail* const trail = app::findTrail(document, trailId);
  const rig::Limb* const limb = trail == nullptr ? nullptr : app::findLimb(document, trail->limb);
  return limb == nullptr ? 0.0 : shareOfLimb * limb->restLength;
}

namespace {

/// Around the selected controllers, with room for what they are on.
Box controllerBox(app::Session& session) {
  constexpr double roomShare = 0.15; // of the height
  const Vec3 room(roomShare * session.document().body.height);
  const std::vector<std::string>& selected = session.view().selection.controllers();
  Box box;
  if (selected.empty()) {
    return box;
  }
  for (const rig::PlacedController& placed : session.controllersAt(session.view().frame)) {
    if (std::find(selected.begin(), selected.end(), placed.id) != selected.end()) {
      box.add(placed.placeWorld - room);
      box.add(placed.placeWorld + room);
    }
  }
  return box;
}

} // namespace

Box selectionBox(app::Session& session, const ShownTrails& shown) {
  Box box = controllerBox(session);
  const app::Document& document = session.document();
  const FrameState& frame = session.shownAt(session.view().frame);
  const LimbBones bones = limbBones(document, frame);
  const auto& limbs = session.view().selection.limbs();
  for (std::size_t i = 0; i < bones.bones.size(); ++i) {
    if (std::find(limbs.begin(), limbs.end(), bones.limbOf[i]) != limbs.end()) {
      box.add(bones.bones[i].fromWorld);
      box.add(bones.bones[i].toWorld);
    }
  }
  if (const ShownTrail* trail = findShown(shown, session.view().selection.trail())) {
    for (const Vec3& point : trail->drawn.original) {
      box.add(point);
    }
    const Vec3 flesh(fleshRadius(document, trail->id));
    for (const Vec3& point : trail->drawn.exaggerated) {
      box.add(point - flesh);
      box.add(point + flesh);
    }
  }
  return box;
}

double facingYaw(const app::Document& document, int clip) {
  const Vec3 left =
      app::hasClip(document, clip) ? app::sagittalNormal(document, clip, 0.0) : Vec3(1.0, 0.0, 0.0);
  const Vec3 forward = glm::cross(left, Vec3(0.0, 1.0, 0.0));
  // The view is the scene's own (front, side, top as animators know them) from the character's side of it: a
  // boxer who stands half turned is still seen along the axes.
  const double quarterTurn = 0.5 * pi;
  return quarterTurn * std::round(std::atan2(forward.x, forward.z) / quarterTurn);
}

} // namespace stretch::ui
