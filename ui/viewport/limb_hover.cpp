#include "ui/viewport/limb_hover.h"

#include <algorithm>

#include "app/commands/table/selection.h"
#include "rig/limb_nodes.h"
#include "ui/render/picking/picking.h"
#include "ui/viewport/viewport_scene.h"

namespace stretch::ui {

namespace {

constexpr double nearBonePoints = 18.0;

void updateSurface(app::Session& session, const FrameState& pose, LimbHover& hover) {
  const app::Document& document = session.document();
  const auto motion = session.sharedMotion();
  const bool original = session.view().showOriginal;
  const bool inBindPose = app::showsLocators(session);
  if (hover.motion != motion || hover.frame != session.view().frame || hover.original != original ||
      hover.inBindPose != inBindPose || hover.unkeyed != session.view().unkeyed) {
    hover.surface = posedSurface(*document.scene, pose);
    hover.motion = motion;
    hover.frame = session.view().frame;
    hover.original = original;
    hover.inBindPose = inBindPose;
    hover.unkeyed = session.view().unkeyed;
  }
  std::vector<rig::Limb> limbs = app::allLimbs(document);
  if (hover.limbs != limbs || hover.limbOfNode.size() != document.scene->nodes.size()) {
    hover.limbOfNode = rig::limbOfNodes(*document.scene, limbs, document.body.hips);
    hover.limbs = std::move(limbs);
  }
}

/// The limb that carries most of the place that was hit.
LimbUnderMouse limbOfHit(const Scene& scene, const SurfaceHit& hit, const LimbHover& hover) {
  std::vector<double> carried(hover.limbs.size(), 0.0);
  std::vector<double> carriedByEnd(hover.limbs.size(), 0.0);
  const NodeIndex joint = std::ranges::max_element(hit.shares, {}, &SurfaceShare::weight)->node;
  double nobody = 0.0;
  for (const SurfaceShare& share : hit.shares) {
    const int owner = hover.limbOfNode[at(share.node)];
    if (owner < 0) {
      nobody += share.weight;
      continue;
    }
    const auto limb = static_cast<std::size_t>(owner);
    carried[limb] += share.weight;
    carriedByEnd[limb] += rig::isAtEnd(scene, hover.limbs[limb], share.node) ? share.weight : 0.0;
  }
  const auto most = std::max_element(carried.begin(), carried.end());
  if (most == carried.end() || *most <= nobody) {
    return {{}, false, joint};
  }
  const auto limb = static_cast<std::size_t>(most - carried.begin());
  return {hover.limbs[limb].id, carriedByEnd[limb] > 0.5 * *most, joint};
}

} // namespace

LimbUnderMouse limbUnderMouse(app::Session& session, const View& view, const Vec2& mousePixels,
                              LimbHover& hover) {
  const double frame = session.view().frame;
  const FrameState& pose = session.view().showOriginal ? session.originalAt(frame) : session.shownAt(frame);
  updateSurface(session, pose, hover);
  const Scene& scene = *session.document().scene;
  if (const auto hit = pickSurface(view, scene, hover.surface, mousePixels)) {
    return limbOfHit(scene, *hit, hover);
  }
  const LimbBones bones = limbBones(session.document(), pose);
  const auto bone = pickBone(view, bones.bones, mousePixels, nearBonePoints);
  return bone ? LimbUnderMouse{bones.limbOf[*bone], false, bones.bones[*bone].node} : LimbUnderMouse{};
}

} // namespace stretch::ui
