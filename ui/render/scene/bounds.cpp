#include "ui/render/scene/bounds.h"

#include <algorithm>
#include <cmath>

#include "core/math/finite.h"
#include "ui/render/overlay/skeleton_drawing.h"

namespace stretch::ui {

namespace {

std::size_t vertexCountOf(const Scene& scene) {
  std::size_t count = 0;
  for (const Node& node : scene.nodes) {
    for (std::size_t i = 0;
         node.mesh >= 0 && i < scene.meshes[static_cast<std::size_t>(node.mesh)].primitives.size(); ++i) {
      count += scene.meshes[static_cast<std::size_t>(node.mesh)].primitives[i].positions.size();
    }
  }
  return count;
}

/// For each mesh the number of its first primitive, counted through all meshes.
std::vector<std::size_t> firstPrimitivesOf(const Scene& scene) {
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    first.push_back(count);
    count += mesh.primitives.size();
  }
  return first;
}

Vec3 posed(const glm::vec3& position, const VertexInfluences& influences, const std::vector<Mat4>& matrices) {
  Vec3 sum(0.0);
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    if (influences.weights[i] != 0.0F && influences.joints[i] < matrices.size()) {
      sum += static_cast<double>(influences.weights[i]) *
             transformPoint(matrices[influences.joints[i]], Vec3(position));
    }
  }
  return sum;
}

} // namespace

BoundsSampler::BoundsSampler(const Scene& scene, std::size_t sampleCount)
    : step_(std::max<std::size_t>(1, vertexCountOf(scene) / std::max<std::size_t>(1, sampleCount))) {
  const std::vector<std::size_t> firstPrimitives = firstPrimitivesOf(scene);
  for (std::size_t nodeIndex = 0; nodeIndex < scene.nodes.size(); ++nodeIndex) {
    const Node& node = scene.nodes[nodeIndex];
    if (node.mesh < 0) {
      continue;
    }
    std::size_t number = firstPrimitives[static_cast<std::size_t>(node.mesh)];
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      Group group{NodeIndex(nodeIndex), primitive.influences.empty() ? -1 : node.skin, number++, {}};
      for (std::size_t i = 0; i < primitive.positions.size(); i += step_) {
        group.samples.push_back(
            {primitive.positions[i], group.skin >= 0 ? primitive.influences[i] : VertexInfluences{}});
      }
      groups_.push_back(std::move(group));
    }
  }
  if (isStickFigure(scene)) {
    addJoints(scene);
  }
}

void BoundsSampler::addJoints(const Scene& scene) {
  for (const NodeIndex joint : jointsOf(scene)) {
    groups_.push_back({joint, -1, 0, {{glm::vec3(0.0F), VertexInfluences{}}}});
  }
}

void BoundsSampler::reshape(const SceneShape& shape) {
  for (Group& group : groups_) {
    for (std::size_t i = 0; i < group.samples.size(); ++i) {
      group.samples[i].position = shape[group.primitive].positions[i * step_];
    }
  }
}

Box BoundsSampler::boxOf(const Scene& scene, const FrameState& frame) const {
  Box box;
  for (const Group& group : groups_) {
    const std::vector<Mat4> matrices =
        group.skin >= 0 ? skinMatrices(scene.skins[static_cast<std::size_t>(group.skin)], frame)
                        : std::vector<Mat4>{meshMatrix(frame, group.node)};
    for (const Sample& sample : group.samples) {
      const Vec3 point = group.skin >= 0 ? posed(sample.position, sample.influences, matrices)
                                         : transformPoint(matrices.front(), Vec3(sample.position));
      if (isFinite(point)) {
        box.add(point);
      }
    }
  }
  return box;
}

double floorHeightOf(const Box& characterBox) {
  constexpr double tolerance = 0.1;
  if (characterBox.empty()) {
    return 0.0;
  }
  const double lowest = characterBox.minimum.y;
  return std::abs(lowest) <= tolerance * characterBox.size().y ? 0.0 : lowest;
}

SceneMeasures measuresOf(const Scene& scene, const BoundsSampler& bounds) {
  const Box box = bounds.boxOf(scene, frameOf(scene, restPose(scene), 0.0));
  const Vec3 size = box.empty() ? Vec3(1.0) : box.size();
  return {floorHeightOf(box), std::max({size.y, 0.3 * size.x, 0.3 * size.z, 1e-9})};
}

} // namespace stretch::ui
