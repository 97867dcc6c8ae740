#include "ui/render/overlay/skeleton_drawing.h"

#include <algorithm>

#include <glm/common.hpp>

namespace stretch::ui {

namespace {

NodeIndex parentOf(const Scene& scene, NodeIndex node) {
  return scene.nodes[at(node)].parent;
}

void markSkinJoints(const Scene& scene, std::vector<bool>& isJoint) {
  for (const Skin& skin : scene.skins) {
    for (const NodeIndex joint : skin.joints) {
      isJoint[at(joint)] = true;
    }
  }
}

void markRigidBody(const Scene& scene, std::vector<bool>& isJoint) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].mesh < 0) {
      continue;
    }
    for (NodeIndex node(i); node.exists(); node = parentOf(scene, node)) {
      isJoint[at(node)] = true;
    }
  }
}

void markTree(const Scene& scene, std::vector<bool>& isJoint) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    isJoint[i] = scene.nodes[i].parent.exists() || !scene.nodes[i].children.empty();
  }
}

float selectedShare(std::span<const float> selection, NodeIndex node) {
  const auto index = at(node);
  return index < selection.size() ? std::clamp(selection[index], 0.0F, 1.0F) : 0.0F;
}

} // namespace

std::vector<NodeIndex> jointsOf(const Scene& scene) {
  std::vector<bool> isJoint(scene.nodes.size(), false);
  markSkinJoints(scene, isJoint);
  if (scene.skins.empty() && isStickFigure(scene)) {
    markTree(scene, isJoint);
  } else if (scene.skins.empty()) {
    markRigidBody(scene, isJoint);
  }
  std::vector<NodeIndex> joints;
  for (std::size_t i = 0; i < isJoint.size(); ++i) {
    if (isJoint[i]) {
      joints.emplace_back(i);
    }
  }
  return joints;
}

bool isStickFigure(const Scene& scene) {
  return std::ranges::none_of(scene.nodes, [](const Node& node) { return node.mesh >= 0; });
}

std::vector<BoneSegment> boneSegments(const Scene& scene, const FrameState& frame,
                                      std::span<const NodeIndex> joints) {
  std::vector<bool> isJoint(scene.nodes.size(), false);
  for (const NodeIndex joint : joints) {
    isJoint[at(joint)] = true;
  }
  std::vector<BoneSegment> bones;
  for (const NodeIndex joint : joints) {
    NodeIndex above = parentOf(scene, joint);
    while (above.exists() && !isJoint[at(above)]) {
      above = parentOf(scene, above);
    }
    if (above.exists()) {
      bones.push_back({above, positionOf(frame.worlds[at(above)]), positionOf(frame.worlds[at(joint)])});
    }
  }
  return bones;
}

SkeletonStyle skeletonStyle(const Palette& palette) {
  return {palette.bone, palette.boneSelected, 3.0F, 3.0F};
}

Overlay drawSkeleton(const Scene& scene, const FrameState& frame, const SkeletonStyle& style,
                     std::span<const float> selection, std::optional<NodeIndex> hovered) {
  Overlay overlay;
  const std::vector<NodeIndex> joints = jointsOf(scene);
  const auto colorOf = [&](NodeIndex node) {
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
  for (const NodeIndex joint : joints) {
    const float emphasis = hovered == joint ? 1.35F : 1.0F;
    Marker dot;
    dot.world = positionOf(frame.worlds[at(joint)]);
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
