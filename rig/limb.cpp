#include "rig/limb.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

constexpr std::array<std::string_view, 9> kindNames{"arm",  "leg", "spine",  "neck", "tail",
                                                    "wing", "fin", "feeler", "chain"};

} // namespace

std::string_view kindName(LimbKind kind) {
  return kindNames[static_cast<std::size_t>(kind)];
}

std::optional<LimbKind> kindNamed(std::string_view name) {
  const auto* const found = std::ranges::find(kindNames, name);
  return found == kindNames.end() ? std::nullopt
                                  : std::optional(static_cast<LimbKind>(found - kindNames.begin()));
}

std::string limbName(const LimbPlace& limb) {
  const std::string_view side = limb.side == LimbSide::left    ? "left-"
                                : limb.side == LimbSide::right ? "right-"
                                                               : "";
  return std::string(side).append(kindName(limb.kind));
}

LimbPlace mirrored(const LimbPlace& limb) {
  const LimbSide side = limb.side == LimbSide::left    ? LimbSide::right
                        : limb.side == LimbSide::right ? LimbSide::left
                                                       : LimbSide::middle;
  return {limb.kind, side, limb.row};
}

const Limb* limbAt(const std::vector<Limb>& limbs, const LimbPlace& place) {
  const auto found = std::ranges::find_if(limbs, [&](const Limb& limb) {
    return static_cast<const LimbPlace&>(limb) == place && !limb.joints.empty();
  });
  return found == limbs.end() ? nullptr : &*found;
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

Vec3 leadingPosition(const Limb& limb, const FrameState& frame) {
  return limb.ledByFirst ? positionOf(frame.worlds[at(limb.joints.front())]) : endPosition(limb, frame);
}

Vec3 stayingPosition(const Limb& limb, const FrameState& frame) {
  return limb.ledByFirst ? endPosition(limb, frame) : positionOf(frame.worlds[at(limb.joints.front())]);
}

std::vector<Vec3> pointsToLead(const Limb& limb, const FrameState& frame) {
  std::vector<Vec3> points = limbPoints(limb, frame);
  if (limb.ledByFirst) {
    std::ranges::reverse(points);
  }
  return points;
}

std::vector<NodeIndex> jointsAndEnd(const Limb& limb) {
  std::vector<NodeIndex> nodes = limb.joints;
  if (limb.endNode.exists()) {
    nodes.push_back(limb.endNode);
  }
  return nodes;
}

NodeIndex stayingNode(const Limb& limb) {
  const NodeIndex end = limb.endNode.exists() ? limb.endNode : limb.joints.back();
  return limb.ledByFirst ? end : limb.joints.front();
}

double limbLength(const Limb& limb, const FrameState& frame) {
  return glm::length(endPosition(limb, frame) - positionOf(frame.worlds[at(limb.joints.front())]));
}

} // namespace stretch::rig
