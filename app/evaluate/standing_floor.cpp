#include "app/evaluate/standing_floor.h"

#include <algorithm>

#include "rig/motion/bind_places.h"
#include "rig/motion/floor.h"
#include "rig/motion/part_motion.h"

namespace stretch::app {

namespace {

// From the leg's end down to the lowest vertex of what hangs on it, in the bind pose.
double soleDepth(const Scene& scene, const rig::Limb& leg, const rig::BindPlaces& places) {
  double lowest = rig::endPosition(leg, places.worlds).y;
  const double ankle = lowest;
  const NodeIndex foot = leg.endNode.exists() ? leg.endNode : leg.joints.back();
  for (const NodeIndex node : rig::withSubtrees(scene, {foot})) {
    const Bounds& mesh = places.meshes[at(node)];
    lowest = mesh.empty() ? lowest : std::min(lowest, mesh.low.y);
  }
  return ankle - lowest;
}

} // namespace

std::optional<double> standingAnkles(const Document& document, int clip) {
  std::optional<double> lowest;
  for (const rig::Limb& limb : document.biped.limbs) {
    const std::optional<double> height =
        isLeg(limb) ? rig::standingHeight(*document.scene, clipOf(document, clip), limb) : std::nullopt;
    lowest = height ? std::optional(std::min(lowest.value_or(*height), *height)) : lowest;
  }
  return lowest;
}

std::optional<rig::StopPlane> floorForLegs(const Document& document, int clip) {
  const std::optional<double> height = standingAnkles(document, clip);
  return height ? std::optional(rig::StopPlane{{0.0, *height, 0.0}, {0.0, -1.0, 0.0}}) : std::nullopt;
}

std::optional<double> floorHeight(const Document& document, int clip) {
  const std::optional<double> ankles = standingAnkles(document, clip);
  if (!ankles) {
    return std::nullopt;
  }
  const rig::BindPlaces places = rig::bindPlaces(*document.scene);
  double depth = 0.0;
  for (const rig::Limb& limb : document.biped.limbs) {
    depth = isLeg(limb) ? std::max(depth, soleDepth(*document.scene, limb, places)) : depth;
  }
  return *ankles - depth;
}

} // namespace stretch::app
