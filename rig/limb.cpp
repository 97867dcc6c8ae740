#include "rig/limb.h"

#include <glm/geometric.hpp>

namespace stretch::rig {

std::string_view limbName(LimbKind kind) {
  switch (kind) {
  case LimbKind::leftArm:
    return "left-arm";
  case LimbKind::rightArm:
    return "right-arm";
  case LimbKind::leftLeg:
    return "left-leg";
  case LimbKind::rightLeg:
    return "right-leg";
  case LimbKind::spine:
    return "spine";
  case LimbKind::neck:
    return "neck";
  case LimbKind::chain:
    break;
  }
  return "chain";
}

Vec3 endPosition(const Limb& limb, const std::vector<Mat4>& worlds) {
  return limb.endNode.exists() ? positionOf(worlds[at(limb.endNode)])
                               : transformPoint(worlds[at(limb.joints.back())], limb.endOffset);
}

std::vector<Vec3> limbPoints(const Limb& limb, const std::vector<Mat4>& worlds) {
  std::vector<Vec3> points;
  points.reserve(limb.joints.size() + 1);
  for (const NodeIndex joint : limb.joints) {
    points.push_back(positionOf(worlds[at(joint)]));
  }
  points.push_back(endPosition(limb, worlds));
  return points;
}

Vec3 endPosition(const Limb& limb, const FrameState& frame) {
  if (limb.endNode.exists()) {
    return positionOf(frame.worlds[at(limb.endNode)]);
  }
  return transformPoint(meshMatrix(frame, limb.joints.back()), limb.endOffset);
}

std::vector<Vec3> limbPoints(const Limb& limb, const FrameState& frame) {
  std::vector<Vec3> points = limbPoints(limb, frame.worlds);
  points.back() = endPosition(limb, frame);
  return points;
}

double limbLength(const Limb& limb, const FrameState& frame) {
  return glm::length(endPosition(limb, frame) - positionOf(frame.worlds[at(limb.joints.front())]));
}

} // namespace stretch::rig
