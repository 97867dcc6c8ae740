#include "rig/adjust/foot_roll.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "rig/reach/pose_writer.h"

namespace stretch::rig {

namespace {

const Vec3 upwards(0.0, 1.0, 0.0);

Vec3 level(const Vec3& vector) {
  return {vector.x, 0.0, vector.z};
}

// The joint below the foot that reaches farthest over the ground.
NodeIndex toesOf(const Scene& scene, NodeIndex foot, const BindPlaces& places) {
  const Vec3 ankle = positionOf(places.worlds[at(foot)]);
  const std::set<NodeIndex> joints = skinJoints(scene);
  NodeIndex toes;
  double farthest = 0.0;
  for (const NodeIndex child : scene.nodes[at(foot)].children) {
    const double reach = glm::length(level(positionOf(places.worlds[at(child)]) - ankle));
    if ((joints.empty() || joints.contains(child)) && reach > farthest) {
      farthest = reach;
      toes = child;
    }
  }
  return toes;
}

Bounds soleOf(const Scene& scene, const Limb& leg, const LimbTopology& topology, const BindPlaces& places) {
  std::vector<NodeIndex> nodes = topology.companions;
  nodes.push_back(leg.endNode);
  Bounds bounds;
  for (const NodeIndex node : withSubtrees(scene, nodes)) {
    if (const Bounds& mesh = places.meshes[at(node)]; !mesh.empty()) {
      bounds.add(mesh.low);
      bounds.add(mesh.high);
    }
  }
  return bounds;
}

// How far the box reaches from a point along a level direction.
double reachAlong(const Bounds& box, const Vec3& from, const Vec3& direction) {
  const double x = direction.x > 0.0 ? box.high.x - from.x : box.low.x - from.x;
  const double z = direction.z > 0.0 ? box.high.z - from.z : box.low.z - from.z;
  return std::max(0.0, direction.x * x + direction.z * z);
}

} // namespace

FootRoll footRoll(const Scene& scene, const Limb& leg, const LimbTopology& topology,
                  const BindPlaces& places) {
  FootRoll roll;
  if (!leg.endNode.exists()) {
    return roll;
  }
  const Mat4& foot = places.worlds[at(leg.endNode)];
  const Vec3 ankle = positionOf(foot);
  const Bounds sole = soleOf(scene, leg, topology, places);
  roll.toes = toesOf(scene, leg.endNode, places);
  const Vec3 toesPlace = roll.toes.exists() ? positionOf(places.worlds[at(roll.toes)]) : ankle;
  const Vec3 front = roll.toes.exists() || sole.empty() ? toesPlace : 0.5 * (sole.low + sole.high);
  if (!(glm::length(level(front - ankle)) > 1e-3 * leg.restLength)) {
    return roll;
  }
  const Vec3 forward = glm::normalize(level(front - ankle));
  const double ground = sole.empty() ? toesPlace.y : sole.low.y;
  const double back = sole.empty() ? 0.0 : reachAlong(sole, ankle, -forward);
  constexpr double ballOfFoot = 0.7; // of the way from the ankle to the tip, where no joint tells
  const double ahead = sole.empty() ? 0.0 : ballOfFoot * reachAlong(sole, ankle, forward);
  const Vec3 heel = Vec3(ankle.x, ground, ankle.z) - back * forward;
  const Vec3 ball = roll.toes.exists() ? toesPlace : Vec3(ankle.x, ground, ankle.z) + ahead * forward;
  const Mat4 toFoot = inverseOf(foot);
  roll.ball = transformPoint(toFoot, ball);
  roll.heel = transformPoint(toFoot, heel);
  roll.axis = glm::inverse(rotationOf(foot)) * glm::cross(upwards, forward);
  return roll;
}

double rollRadians(double roll) {
  constexpr double heelLift = 60.0 * pi / 180.0;
  constexpr double toeLift = 40.0 * pi / 180.0;
  return roll * (roll > 0.0 ? heelLift : toeLift);
}

} // namespace stretch::rig
