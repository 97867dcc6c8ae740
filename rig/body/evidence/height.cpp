#include "rig/body/evidence/height.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/math/bounds.h"
#include "core/math/finite.h"
#include "core/math/median.h"
#include "core/scene/morphs.h"
#include "rig/body/evidence/body_view.h"

namespace stretch::rig::body {

namespace {

bool hasSkinnedMesh(const Scene& scene) {
  return std::ranges::any_of(scene.nodes, [](const Node& node) { return node.mesh >= 0 && node.skin >= 0; });
}

NodeIndex topmost(const Scene& scene, NodeIndex node) {
  while (node.exists() && scene.nodes[at(node)].parent.exists()) {
    node = scene.nodes[at(node)].parent;
  }
  return node;
}

// For each node whether a mesh that hangs on it rigidly is one of the body's.
std::vector<bool> rigidParts(const Scene& scene, const BodyParts& parts) {
  std::vector<bool> counts(scene.nodes.size(), !parts.hips.exists() && !hasSkinnedMesh(scene));
  const auto mark = [&](const std::vector<NodeIndex>& tops, bool isPart) {
    for (const NodeIndex node : withSubtrees(scene, tops)) {
      counts[at(node)] = isPart;
    }
  };
  if (parts.hips.exists() && !hasSkinnedMesh(scene)) {
    mark({topmost(scene, parts.hips)}, true);
  } else if (parts.hips.exists()) {
    mark({parts.hips}, true);
    mark(parts.hands, false);
  }
  return counts;
}

void addFinite(Bounds& bounds, const Vec3& point) {
  if (isFinite(point)) {
    bounds.add(point);
  }
}

Bounds bindBounds(const Scene& scene, const BindPose& bindPose, const std::vector<bool>& rigid) {
  Bounds bounds;
  for (const std::vector<Vec3>& cloud : vertexClouds(scene, bindPose, RigidMeshes::none)) {
    std::ranges::for_each(cloud, [&](const Vec3& point) { bounds.add(point); });
  }
  const std::vector<std::vector<Vec3>> all = vertexClouds(scene, bindPose, RigidMeshes::all);
  for (std::size_t node = 0; node < all.size(); ++node) {
    if (rigid[node]) {
      std::ranges::for_each(all[node], [&](const Vec3& point) { bounds.add(point); });
    }
  }
  return bounds;
}

void addSkinned(Bounds& bounds, const Mesh& mesh, const Primitive& primitive,
                const std::vector<float>& weights, const std::vector<Mat4>& joints) {
  const std::size_t count = std::min(primitive.positions.size(), primitive.influences.size());
  for (std::size_t vertex = 0; vertex < count; ++vertex) {
    const VertexInfluences& influences = primitive.influences[vertex];
    Mat4 moved(0.0);
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      if (influences.weights[i] > 0.0F && influences.joints[i] < joints.size()) {
        moved += static_cast<double>(influences.weights[i]) * joints[influences.joints[i]];
      }
    }
    if (moved[3][3] > 0.0) {
      addFinite(bounds, transformPoint(moved / moved[3][3], morphedPlace(mesh, primitive, weights, vertex)));
    }
  }
}

bool isDrawn(const Scene& scene, NodeIndex node) {
  return std::ranges::find(scene.roots, topmost(scene, node)) != scene.roots.end();
}

Bounds shownBounds(const Scene& scene, const FrameState& shown, const std::vector<bool>& rigid) {
  Bounds bounds;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const Node& holder = scene.nodes[node];
    const bool isSkinned = holder.skin >= 0;
    if (holder.mesh < 0 || !(isSkinned || rigid[node]) || !isDrawn(scene, NodeIndex(node))) {
      continue;
    }
    const std::vector<Mat4> joints =
        isSkinned ? skinMatrices(scene.skins[at(holder.skin)], shown) : std::vector<Mat4>{};
    const Mat4 carried = meshMatrix(shown, NodeIndex(node));
    const Mesh& mesh = scene.meshes[at(holder.mesh)];
    const std::vector<float>& weights = shown.pose.weights[node];
    for (const Primitive& primitive : mesh.primitives) {
      if (isSkinned && !primitive.influences.empty()) {
        addSkinned(bounds, mesh, primitive, weights, joints);
        continue;
      }
      for (std::size_t vertex = 0; vertex < primitive.positions.size() && rigid[node]; ++vertex) {
        addFinite(bounds, transformPoint(carried, morphedPlace(mesh, primitive, weights, vertex)));
      }
    }
  }
  return bounds;
}

Bounds jointBounds(const Scene& scene, const std::vector<Mat4>& worlds) {
  Bounds bounds;
  for (const NodeIndex joint : skinJoints(scene)) {
    addFinite(bounds, positionOf(worlds[at(joint)]));
  }
  if (bounds.empty()) {
    std::ranges::for_each(worlds, [&](const Mat4& world) { addFinite(bounds, positionOf(world)); });
  }
  return bounds;
}

Vec3 extentOf(const Bounds& bounds) {
  return bounds.empty() ? Vec3(0.0) : bounds.high - bounds.low;
}

// How many times as long as in the bind pose the bones of a frame are: the median. Clips that scale the node
// above the skeleton change it.
double scaleBeside(const Scene& scene, const std::vector<Mat4>& bind, const std::vector<Mat4>& shown,
                   double least) {
  const std::set<NodeIndex> joints = skinJoints(scene);
  std::vector<double> ratios;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const NodeIndex parent = scene.nodes[node].parent;
    const bool isBone =
        parent.exists() && (joints.empty() || (joints.contains(NodeIndex(node)) && joints.contains(parent)));
    const double before = isBone ? glm::distance(positionOf(bind[node]), positionOf(bind[at(parent)])) : 0.0;
    const double now = isBone ? glm::distance(positionOf(shown[node]), positionOf(shown[at(parent)])) : 0.0;
    if (before > least && std::isfinite(now / before)) {
      ratios.push_back(now / before);
    }
  }
  const double ratio = medianOf(std::move(ratios), 1.0);
  return ratio > 0.0 ? ratio : 1.0;
}

} // namespace

CharacterExtent characterExtent(const Scene& scene, const BindPose& bindPose, const BodyParts& parts,
                                const FrameState& shown) {
  const std::vector<bool> rigid = rigidParts(scene, parts);
  const Bounds vertices = bindBounds(scene, bindPose, rigid);
  const Vec3 bound = extentOf(vertices.empty() ? jointBounds(scene, bindPose.worlds) : vertices);
  const double largest = std::max({bound.x, bound.y, bound.z});
  if (!(largest > 0.0) || !std::isfinite(largest)) {
    return {};
  }
  const double length = glm::length(parts.up);
  const double leastCosine = std::cos(35.0 * pi / 180.0);
  const bool stands = length <= 0.0 || std::abs(parts.up.y) >= leastCosine * length;
  const double scale = scaleBeside(scene, bindPose.worlds, shown.worlds, 1e-3 * largest);
  const double stature = scale * (stands && bound.y > 1e-6 * largest ? bound.y : largest);
  const Vec3 seen =
      extentOf(vertices.empty() ? jointBounds(scene, shown.worlds) : shownBounds(scene, shown, rigid));
  return {std::max(std::isfinite(seen.y) ? seen.y : 0.0, 0.5 * stature), stature, scale * largest};
}

} // namespace stretch::rig::body
