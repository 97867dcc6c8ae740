#include "rig/body/evidence/height.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "rig/body/evidence/body_view.h"

namespace stretch::rig::body {

namespace {

bool hasMesh(const Scene& scene, bool skinned) {
  return std::ranges::any_of(scene.nodes,
                             [&](const Node& node) { return node.mesh >= 0 && (node.skin >= 0) == skinned; });
}

NodeIndex topmost(const Scene& scene, NodeIndex node) {
  while (node.exists() && scene.nodes[at(node)].parent.exists()) {
    node = scene.nodes[at(node)].parent;
  }
  return node;
}

double extentY(const Bounds& bounds) {
  return bounds.empty() ? 0.0 : bounds.high.y - bounds.low.y;
}

Bounds boundsOf(const Scene& scene, const BindPose& bindPose, NodeIndex root, bool skinned) {
  const std::vector<std::vector<Vec3>> clouds =
      vertexClouds(scene, bindPose, skinned ? RigidMeshes::none : RigidMeshes::all);
  Bounds bounds;
  for (std::size_t node = 0; node < clouds.size(); ++node) {
    if (clouds[node].empty() ||
        (!skinned && root.exists() && !isAncestorOrSelf(scene, root, NodeIndex(node)))) {
      continue;
    }
    for (const Vec3& point : clouds[node]) {
      bounds.add(point);
    }
  }
  return bounds;
}

Bounds jointBounds(const Scene& scene, const BindPose& bindPose) {
  Bounds bounds;
  for (const Skin& skin : scene.skins) {
    for (const NodeIndex joint : skin.joints) {
      if (joint.exists() && at(joint) < bindPose.worlds.size()) {
        bounds.add(positionOf(bindPose.worlds[at(joint)]));
      }
    }
  }
  if (bounds.empty()) {
    for (const Mat4& world : bindPose.worlds) {
      bounds.add(positionOf(world));
    }
  }
  return bounds;
}

// Of skinned meshes, and of the rigid ones as well where these are most of the body: gloves alone may be
// skinned.
Bounds vertexBounds(const Scene& scene, const BindPose& bindPose, NodeIndex hips) {
  if (!hasMesh(scene, true)) {
    return boundsOf(scene, bindPose, topmost(scene, hips), false);
  }
  const Bounds skinned = boundsOf(scene, bindPose, hips, true);
  if (!hips.exists() || !hasMesh(scene, false)) {
    return skinned;
  }
  const Bounds all = boundsOf(scene, bindPose, hips, false);
  return extentY(all) > 2.0 * extentY(skinned) ? all : skinned;
}

} // namespace

CharacterExtent characterExtent(const Scene& scene, const BindPose& bindPose, NodeIndex hips,
                                const Vec3& bodyUp) {
  Bounds bounds = vertexBounds(scene, bindPose, hips);
  if (bounds.empty()) {
    bounds = jointBounds(scene, bindPose);
  }
  if (bounds.empty()) {
    return {};
  }
  const Vec3 extent = bounds.high - bounds.low;
  const double largest = std::max({extent.x, extent.y, extent.z});
  const double length = glm::length(bodyUp);
  const double leastCosine = std::cos(35.0 * pi / 180.0);
  const bool stands = length <= 0.0 || std::abs(bodyUp.y) >= leastCosine * length;
  const double height = stands && extent.y > 1e-6 * largest ? extent.y : largest;
  return height > 0.0 && std::isfinite(largest) ? CharacterExtent{height, largest} : CharacterExtent{};
}

} // namespace stretch::rig::body
