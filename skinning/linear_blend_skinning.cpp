#include "skinning/linear_blend_skinning.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/scene/morphs.h"

namespace stretch::skinning {

namespace {

const std::vector<float>& morphWeights(const Mesh& mesh, const FrameState& frame, NodeIndex node) {
  const std::vector<float>& animated = frame.pose.weights[at(node)];
  return animated.empty() ? mesh.morphWeights : animated;
}

using Affine = glm::dmat4x3; ///< A Mat4 without its last row, which is always 0 0 0 1.

Affine blended(const VertexInfluences& influences, const std::vector<Affine>& matrices) {
  Affine sum(0.0);
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    if (influences.weights[i] != 0.0F && influences.joints[i] < matrices.size()) {
      sum += static_cast<double>(influences.weights[i]) * matrices[influences.joints[i]];
    }
  }
  return sum;
}

Vec3 morphedNormal(const Primitive& primitive, const std::vector<float>& weights, std::size_t vertex) {
  return morphed(Vec3(primitive.normals[vertex]), &MorphTarget::normals, primitive, weights, vertex);
}

// Normals turn by the inverse transpose, up to their length: the matrix of cofactors, which a flat matrix has
// as well.
Vec3 turnedNormal(const Affine& matrix, const Vec3& normal, NormalMatrix by) {
  const Mat3 linear(matrix);
  if (by == NormalMatrix::plain) {
    const Vec3 plain = linear * normal;
    const double size = glm::length(plain);
    return size > 0.0 ? plain / size : Vec3(0.0, 1.0, 0.0);
  }
  const Mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                       glm::cross(linear[0], linear[1]));
  const Vec3 turned = (glm::determinant(linear) < 0.0 ? -1.0 : 1.0) * (cofactors * normal);
  const double length = glm::length(turned);
  return length > 0.0 ? turned / length : Vec3(0.0, 1.0, 0.0);
}

NodeIndex strongestJoint(const Skin& skin, const VertexInfluences& influences) {
  const auto strongest =
      static_cast<std::size_t>(std::ranges::max_element(influences.weights) - influences.weights.begin());
  const std::size_t slot = influences.joints[strongest];
  return slot < skin.joints.size() ? skin.joints[slot] : NodeIndex::none;
}

/// Calls `visit(primitive, weights, vertex, matrix, isSkinned)` for every vertex that is drawn, in order.
template <typename Visit>
void eachDrawnVertex(const Scene& scene, const FrameState& frame, const Visit& visit) {
  for (const NodeIndex node : drawnMeshNodes(scene)) {
    const Node& holder = scene.nodes[at(node)];
    const Mesh& mesh = scene.meshes[at(holder.mesh)];
    std::vector<Affine> joints;
    if (holder.skin >= 0) {
      for (const Mat4& matrix : skinMatrices(scene.skins[at(holder.skin)], frame)) {
        joints.emplace_back(matrix);
      }
    }
    const Affine rigid(meshMatrix(frame, node));
    const std::vector<float>& weights = morphWeights(mesh, frame, node);
    for (const Primitive& primitive : mesh.primitives) {
      const bool skinned = !joints.empty() && !primitive.influences.empty();
      for (std::size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
        visit(primitive, weights, vertex, skinned ? blended(primitive.influences[vertex], joints) : rigid,
              skinned);
      }
    }
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
  return morphed(Vec3(primitive.positions[vertex]), &MorphTarget::positions, primitive, weights, vertex);
}

std::vector<NodeIndex> strongestNodes(const Scene& scene) {
  std::vector<NodeIndex> nodes;
  nodes.reserve(vertexCount(scene));
  for (const NodeIndex node : drawnMeshNodes(scene)) {
    const Node& holder = scene.nodes[at(node)];
    for (const Primitive& primitive : scene.meshes[at(holder.mesh)].primitives) {
      const bool isSkinned = holder.skin >= 0 && !primitive.influences.empty();
      for (std::size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
        nodes.push_back(isSkinned ? strongestJoint(scene.skins[at(holder.skin)], primitive.influences[vertex])
                                  : node);
      }
    }
  }
  return nodes;
}

std::vector<Triangle> drawnTriangles(const Scene& scene) {
  std::vector<Triangle> triangles;
  std::uint32_t before = 0;
  for (const NodeIndex node : drawnMeshNodes(scene)) {
    for (const Primitive& primitive : scene.meshes[at(scene.nodes[at(node)].mesh)].primitives) {
      for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        triangles.push_back({before + primitive.indices[i], before + primitive.indices[i + 1],
                             before + primitive.indices[i + 2]});
      }
      before += static_cast<std::uint32_t>(primitive.positions.size());
    }
  }
  return triangles;
}

std::vector<Vec3> skinnedPositions(const Scene& scene, const FrameState& frame) {
  std::vector<Vec3> positions;
  positions.reserve(vertexCount(scene));
  eachDrawnVertex(scene, frame,
                  [&](const Primitive& primitive, const std::vector<float>& weights, std::size_t vertex,
                      const Affine& matrix, bool) {
                    positions.push_back(matrix * Vec4(morphedPosition(primitive, weights, vertex), 1.0));
                  });
  return positions;
}

FrameState turningFrame(const Scene& scene, FrameState frame, bool newToo) {
  std::vector<bool> turns(frame.stretch.size(), !newToo);
  for (const BindChain& chain : scene.bindChains) {
    if (at(chain.joint) < turns.size()) {
      turns[at(chain.joint)] = chain.corners.empty();
    }
  }
  for (std::size_t node = 0; node < turns.size(); ++node) {
    frame.stretch[node] = turns[node] ? frame.stretch[node] : Mat3(1.0);
  }
  return frame;
}

std::vector<Vec3> skinnedNormals(const Scene& scene, const FrameState& frame, NormalMatrix by) {
  std::vector<Vec3> normals;
  eachDrawnVertex(scene, frame,
                  [&](const Primitive& primitive, const std::vector<float>& weights, std::size_t vertex,
                      const Affine& matrix, bool isSkinned) {
                    normals.push_back(turnedNormal(matrix, morphedNormal(primitive, weights, vertex),
                                                   isSkinned ? by : NormalMatrix::inverseTranspose));
                  });
  return normals;
}

} // namespace stretch::skinning
