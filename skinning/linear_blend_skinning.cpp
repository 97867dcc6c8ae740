#include "skinning/linear_blend_skinning.h"

#include <algorithm>

namespace stretch::skinning {

namespace {

const std::vector<float>& morphWeights(const Mesh& mesh, const FrameState& frame, NodeIndex node) {
  const std::vector<float>& animated = frame.pose.weights[at(node)];
  return animated.empty() ? mesh.morphWeights : animated;
}

Mat4 blended(const VertexInfluences& influences, const std::vector<Mat4>& matrices) {
  Mat4 sum(0.0);
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    if (influences.weights[i] != 0.0F && influences.joints[i] < matrices.size()) {
      sum += static_cast<double>(influences.weights[i]) * matrices[influences.joints[i]];
    }
  }
  return sum;
}

void appendPrimitive(const Primitive& primitive, const std::vector<float>& weights,
                     const std::vector<Mat4>& joints, const Mat4& rigid, std::vector<Vec3>& out) {
  const bool skinned = !joints.empty() && !primitive.influences.empty();
  for (std::size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
    const Vec3 position = morphedPosition(primitive, weights, vertex);
    out.push_back(transformPoint(skinned ? blended(primitive.influences[vertex], joints) : rigid, position));
  }
}

} // namespace

std::vector<NodeIndex> drawnMeshNodes(const Scene& scene) {
  std::vector<NodeIndex> nodes;
  std::vector<bool> seen(scene.nodes.size(), false);
  std::vector<NodeIndex> shown = scene.roots;
  while (!shown.empty()) {
    const NodeIndex node = shown.back();
    shown.pop_back();
    if (seen[at(node)]) {
      continue;
    }
    seen[at(node)] = true;
    if (scene.nodes[at(node)].mesh >= 0) {
      nodes.push_back(node);
    }
    const std::vector<NodeIndex>& children = scene.nodes[at(node)].children;
    shown.insert(shown.end(), children.begin(), children.end());
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

Vec3 morphedPosition(const Primitive& primitive, const std::vector<float>& weights, std::size_t vertex) {
  Vec3 position(primitive.positions[vertex]);
  const std::size_t targets = std::min(weights.size(), primitive.morphTargets.size());
  for (std::size_t target = 0; target < targets; ++target) {
    const std::vector<glm::vec3>& offsets = primitive.morphTargets[target].positions;
    if (weights[target] != 0.0F && vertex < offsets.size()) {
      position += static_cast<double>(weights[target]) * Vec3(offsets[vertex]);
    }
  }
  return position;
}

std::vector<Vec3> skinnedPositions(const Scene& scene, const FrameState& frame) {
  std::vector<Vec3> positions;
  for (const NodeIndex node : drawnMeshNodes(scene)) {
    const Node& holder = scene.nodes[at(node)];
    const Mesh& mesh = scene.meshes[at(holder.mesh)];
    const std::vector<Mat4> joints =
        holder.skin >= 0 ? skinMatrices(scene.skins[at(holder.skin)], frame) : std::vector<Mat4>{};
    for (const Primitive& primitive : mesh.primitives) {
      appendPrimitive(primitive, morphWeights(mesh, frame, node), joints, meshMatrix(frame, node), positions);
    }
  }
  return positions;
}

} // namespace stretch::skinning
