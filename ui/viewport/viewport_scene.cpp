#include "ui/viewport/viewport_scene.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/commands/frames.h"
#include "app/edits/mirror_edits.h"

namespace stretch::ui {

namespace {

std::vector<rig::Limb> allLimbs(const app::Document& document) {
  std::vector<rig::Limb> limbs = document.biped.limbs;
  limbs.insert(limbs.end(), document.chains.begin(), document.chains.end());
  return limbs;
}

} // namespace

PictureSelection selectionOf(const app::Session& session, const ViewportState& viewport) {
  PictureSelection selection;
  selection.limbs = session.view().selectedLimbs;
  selection.trail = session.view().selectedTrail;
  selection.spheres = session.view().selectedSpheres;
  selection.hoveredLimb = viewport.hoveredLimb;
  selection.hoveredTrail = viewport.hoveredTrail;
  selection.hoveredSphere = viewport.hoveredSphere;
  selection.hoveredAxis = viewport.hoveredAxis;
  return selection;
}

PictureContent workPicture(app::Session& session, const ViewportState& viewport,
                           const ViewportOverlays& overlays, const Palette& palette,
                           const SceneMeasures& measures) {
  const double at = session.view().frame;
  const FrameState& pose = session.view().showOriginal ? session.originalAt(at) : session.frameAt(at);
  return assemblePicture({session.document(), session.motion(), viewport.shown, at, pose, measures},
                         selectionOf(session, viewport), overlays, palette);
}

PictureContent originalPicture(app::Session& session, const ViewportState& viewport,
                               const ViewportOverlays& overlays, const Palette& palette,
                               const SceneMeasures& measures) {
  const double at = session.view().frame;
  return assembleBare(
      {session.document(), session.motion(), viewport.shown, at, session.originalAt(at), measures},
      selectionOf(session, viewport), overlays, palette);
}

LimbBones limbBones(const app::Document& document, const FrameState& frame) {
  LimbBones result;
  for (const rig::Limb& limb : allLimbs(document)) {
    const int index = static_cast<int>(result.limbIds.size());
    result.limbIds.push_back(limb.id);
    const auto place = [&](int node) { return positionOf(frame.worlds[static_cast<std::size_t>(node)]); };
    for (std::size_t i = 0; i + 1 < limb.joints.size(); ++i) {
      result.bones.push_back({index, place(limb.joints[i]), place(limb.joints[i + 1])});
    }
    if (limb.joints.empty()) {
      continue;
    }
    const Vec3 last = place(limb.joints.back());
    const Vec3 end =
        limb.endNode >= 0
            ? place(limb.endNode)
            : transformPoint(frame.worlds[static_cast<std::size_t>(limb.joints.back())], limb.endOffset);
    result.bones.push_back({index, last, end});
  }
  return result;
}

Box selectionBox(app::Session& session, const ShownTrails& shown) {
  Box box;
  const app::Document& document = session.document();
  const FrameState& frame = session.frameAt(session.view().frame);
  const LimbBones bones = limbBones(document, frame);
  const auto& limbs = session.view().selectedLimbs;
  for (const BoneSegment& bone : bones.bones) {
    const std::string& id = bones.limbIds[static_cast<std::size_t>(bone.node)];
    if (std::find(limbs.begin(), limbs.end(), id) != limbs.end()) {
      box.add(bone.fromWorld);
      box.add(bone.toWorld);
    }
  }
  if (const ShownTrail* trail = findShown(shown, session.view().selectedTrail)) {
    for (const Vec3& point : trail->drawn.original) {
      box.add(point);
    }
    for (const Vec3& point : trail->drawn.exaggerated) {
      box.add(point);
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
