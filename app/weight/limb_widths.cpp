#include "app/weight/limb_widths.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "core/base/index.h"
#include "core/scene/mesh_sequence.h"
#include "rig/body/detection.h"
#include "rig/motion/limb_topology.h"
#include "skinning/geometry/shape_diameter.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

// The bone that each node's surface follows; -1 for none of the limb's.
std::vector<int> bonesOfNodes(const Scene& scene, const rig::Limb& limb,
                              const std::vector<rig::Limb>& others) {
  constexpr int undecided = -2;
  std::vector<int> own(scene.nodes.size(), undecided);
  for (const rig::Limb& other : others) {
    for (const NodeIndex joint : other.joints) {
      own[at(joint)] = -1;
    }
  }
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    own[at(limb.joints[i])] = static_cast<int>(i);
  }
  if (limb.endNode.exists()) {
    own[at(limb.endNode)] = -1;
  }
  std::vector<int> bones(scene.nodes.size(), -1);
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    bones[at(node)] = own[at(node)] != undecided ? own[at(node)] : (parent.exists() ? bones[at(parent)] : -1);
  }
  return bones;
}

NodeIndex strongestJoint(const Skin& skin, const VertexInfluences& influences) {
  const auto strongest = std::max_element(influences.weights.begin(), influences.weights.end());
  const auto slot = static_cast<std::size_t>(strongest - influences.weights.begin());
  const std::size_t joint = influences.joints[slot];
  return *strongest > 0.0F && joint < skin.joints.size() ? skin.joints[joint] : NodeIndex::none;
}

// The part of the surface that follows the limb, as it stands in the bind pose.
struct LimbSurface {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<int> boneOf; // of each triangle
};

class SurfaceCollector {
public:
  SurfaceCollector(const Scene& scene, std::vector<int> boneOfNode)
      : scene_(scene), boneOfNode_(std::move(boneOfNode)) {}

  LimbSurface collect(const std::vector<Vec3>& positions) {
    std::size_t first = 0;
    for (const NodeIndex node : skinning::drawnMeshNodes(scene_)) {
      for (const Primitive& primitive : scene_.meshes[at(scene_.nodes[at(node)].mesh)].primitives) {
        add(node, primitive, positions, first);
        first += primitive.positions.size();
      }
    }
    return std::move(surface_);
  }

private:
  [[nodiscard]] int boneOfVertex(NodeIndex node, const Primitive& primitive, std::uint32_t vertex) const {
    const int skin = scene_.nodes[at(node)].skin;
    const NodeIndex joint = skin >= 0 && !primitive.influences.empty()
                                ? strongestJoint(scene_.skins[at(skin)], primitive.influences[vertex])
                                : node;
    return joint.exists() ? boneOfNode_[at(joint)] : -1;
  }

  void add(NodeIndex node, const Primitive& primitive, const std::vector<Vec3>& positions,
           std::size_t first) {
    constexpr auto unused = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> renumbered(primitive.positions.size(), unused);
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
      const std::uint32_t* corners = &primitive.indices[i];
      const int bone = boneOfVertex(node, primitive, corners[0]);
      if (bone < 0) {
        continue;
      }
      Triangle triangle{};
      for (std::size_t c = 0; c < 3; ++c) {
        std::uint32_t& number = renumbered[corners[c]];
        if (number == unused) {
          number = static_cast<std::uint32_t>(surface_.positions.size());
          surface_.positions.emplace_back(positions[first + corners[c]]);
        }
        triangle[c] = number;
      }
      surface_.triangles.push_back(triangle);
      surface_.boneOf.push_back(bone);
    }
  }

  const Scene& scene_;
  std::vector<int> boneOfNode_;
  LimbSurface surface_;
};

} // namespace

LimbSize limbSize(const Scene& scene, const rig::Limb& limb, const std::vector<rig::Limb>& others) {
  FrameState bind = frameOf(scene, restPose(scene), 0.0);
  bind.worlds = rig::bindPoseWorlds(scene);
  const std::vector<Vec3> points = rig::limbPoints(limb, bind.worlds);
  LimbSize size;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    constexpr double shortest = 1e-6; // of the limb
    size.lengths.push_back(
        std::max({glm::length(points[i + 1] - points[i]), shortest * limb.restLength, 1e-12}));
  }
  const LimbSurface surface = SurfaceCollector(scene, bonesOfNodes(scene, limb, others))
                                  .collect(skinning::skinnedPositions(scene, bind));
  // Means over hundreds of faces need few rays each.
  const Result<skinning::ShapeDiameters> diameters = skinning::shapeDiameters(
      surface.positions.data(), surface.positions.size(), surface.triangles, {120.0, 16, 0});
  size.widths.assign(size.lengths.size(), 0.0);
  if (diameters) {
    size.widths = skinning::meanByGroup(surface.positions.data(), surface.triangles, diameters->faces,
                                        surface.boneOf, size.lengths.size());
  }
  for (std::size_t i = 0; i < size.widths.size(); ++i) {
    size.widths[i] = size.widths[i] > 0.0 ? size.widths[i] : size.lengths[i] / 6.0;
  }
  return size;
}

} // namespace stretch::app
