#include "rig/motion/seam.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

namespace {

std::vector<NodeIndex> everyNode(const Scene& scene) {
  std::vector<NodeIndex> nodes;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    nodes.emplace_back(node);
  }
  return nodes;
}

} // namespace

std::optional<Vec3> loopTravel(const Scene& scene, const Clip& clip, NodeIndex hips, double height) {
  constexpr double sameShare = 0.01; // of the height
  if (!(clip.endSeconds > clip.startSeconds)) {
    return std::nullopt;
  }
  const std::vector<NodeIndex> nodes = everyNode(scene);
  const NodeSampler sampler(scene, clip, nodes);
  FrameState first;
  FrameState last;
  sampler.sample(clip.startSeconds, first);
  sampler.sample(clip.endSeconds, last);
  Vec3 travel(0.0);
  if (hips.exists()) {
    travel = positionOf(last.worlds[at(hips)]) - positionOf(first.worlds[at(hips)]);
    travel.y = 0.0;
  }
  const auto isSmall = [&](const Vec3& move) { return glm::length(move) <= sameShare * height; };
  const bool same = std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex node) {
    const Vec3 moved = positionOf(last.worlds[at(node)]) - positionOf(first.worlds[at(node)]);
    // A node above the hips or beside them may stay where it is while they travel.
    return isSmall(moved - travel) || (isSmall(moved) && !isAncestorOrSelf(scene, hips, node));
  });
  return same ? std::optional(travel) : std::nullopt;
}

} // namespace stretch::rig
