#include "ui/render/skeleton_drawing.h"

#include <algorithm>

#include <glm/common.hpp>

namespace stretch::ui {

namespace {

int parentOf(const Scene& scene, int node) {
  return scene.nodes[static_cast<std::size_t>(node)].parent;
}

void markSkinJoints(const Scene& scene, std::vector<bool>& isJoint) {
  for (const Skin& skin : scene.skins) {
    for (const int joint : skin.joints) {
      isJoint[static_cast<std::size_t>(joint)] = true;
    }
  }
}

void markRigidBody(const Scene& scene, std::vector<bool>& isJoint) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].mesh < 0) {
      continue;
    }
    for (int node = static_cast<int>(i); node >= 0; node = parentOf(scene, node)) {
      isJoint[static_cast<std::size_t>(node)] = true;
    }
  }
}

float selectedShare(std::span<const float> selection, int node) {
  const auto index = static_cast<std::size_t>(node);
  return index < selection.size() ? std::clamp(selection[index], 0.0F, 1.0F) : 0.0F;
}

} // namespace

std::vector<int> jointsOf(const Scene& scene) {
  std::vector<bool> isJoint(scene.nodes.size(), false);
  markSkinJoints(scene, isJoint);
  if (scene.skins.empty()) {
    markRigidBody(scene, isJoint);
  }
  std::vector<int> joints;
  for (std::size_t i = 0; i < isJoint.size(); ++i) {
    if (isJoint[i]) {
      joints.push_back(static_cast<int>(i));
    }
  }
  return joints;
}

std::vector<BoneSegment> boneSegments(const Scene& scene, const FrameState& frame,
                                      std::span<const int> joints) {
  std::vector<bool> isJoint(scene.nodes.size(), false);
  for (const int joint : joints) {
    isJoint[static_cast<std::size_t>(joint)] = true;
  }
  std::vector<BoneSegment> bones;
  for (const int joint : joints) {
    int above = parentOf(scene, joint);
    while (above >= 0 && !isJoint[static_cast<std::size_t>(above)]) {
      above = parentOf(scene, above);
    }
    if (above >= 0) {
      bones.push_back({above, positionOf(frame.worlds[static_cast<std::size_t>(above)]),
                       positionOf(frame.worlds[static_cast<std::size_t>(joint)])});
    }
  }
  return bones;
}

SkeletonStyle skeletonStyle(const Palette& palette) {
  return {palette.bone, palette.boneSelected, 3.0F, 3.0F};
}

Overlay drawSkeleton(const Scene& scene, const FrameState& frame, const SkeletonStyle& style,
                     std::span<const float> selection, std::optional<int> hovered) {
  Overlay overlay;
  const std::vector<int> joints = jointsOf(scene);
  const auto colorOf = [&](int node) {
    const float share = hovered == node ? 1.0F : selectedShare(selection, node);
    return glm::mix(style.bone, style.selected, share);
  };
  for (const BoneSegment& bone : boneSegments(scene, frame, joints)) {
    const glm::vec4 color = colorOf(bone.node);
    const float width = hovered == bone.node ? 1.6F * style.widthPoints : style.widthPoints;
    Polyline line;
    line.points = {{bone.fromWorld, color, width}, {bone.toWorld, color, 0.45F * width}};
    line.depth = OverlayDepth::onTop;
    line.outlined = true;
    overlay.lines.push_back(std::move(line));
  }
  for (const int joint : joints) {
    const float emphasis = hovered == joint ? 1.35F : 1.0F;
    Marker dot;
    dot.world = positionOf(frame.worlds[static_cast<std::size_t>(joint)]);
    dot.radiusPoints = emphasis * style.jointPoints;
    dot.fill = colorOf(joint);
    dot.edge = glm::vec4(0.07F, 0.075F, 0.085F, 0.85F);
    dot.edgePoints = 1.0F;
    dot.depth = OverlayDepth::onTop;
    overlay.markers.push_back(dot);
  }
  return overlay;
}

} // namespace stretch::ui
