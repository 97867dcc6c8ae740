#include "skinning/geometry/bone_widths.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/geometry/shape_diameter.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::skinning {

namespace {

NodeIndex strongestJointOf(const Skin& skin, const VertexInfluences& influences) {
  const auto* const strongest = std::max_element(influences.weights.begin(), influences.weights.end());
  const auto slot = static_cast<std::size_t>(strongest - influences.weights.begin());
  const std::size_t joint = influences.joints[slot];
  return *strongest > 0.0F && joint < skin.joints.size() ? skin.joints[joint] : NodeIndex::none;
}

// The part of the surface that follows the bones, as it stands in a pose.
struct BoneSurface {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<int> boneOf; // of each triangle
};

class BoneSurfaceCollector {
public:
  BoneSurfaceCollector(const Scene& scene, std::vector<int> boneOfNode)
      : scene_(scene), boneOfNode_(std::move(boneOfNode)) {}

  BoneSurface collect(const std::vector<Vec3>& positions) {
    std::size_t first = 0;
    for (const NodeIndex node : drawnMeshNodes(scene_)) {
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
                                ? strongestJointOf(scene_.skins[at(skin)], primitive.influences[vertex])
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
  BoneSurface surface_;
};

} // namespace

std::vector<double> boneWidths(const Scene& scene, const FrameState& pose, const std::vector<int>& boneOfNode,
                               std::size_t boneCount) {
  const BoneSurface surface = BoneSurfaceCollector(scene, boneOfNode).collect(skinnedPositions(scene, pose));
  // Means over hundreds of faces need few rays each.
  const Result<ShapeDiameters> diameters =
      shapeDiameters(surface.positions.data(), surface.positions.size(), surface.triangles, {120.0, 16, 0});
  return diameters ? meanByGroup(surface.positions.data(), surface.triangles, diameters->faces,
                                 surface.boneOf, boneCount)
                   : std::vector<double>(boneCount, 0.0);
}

} // namespace stretch::skinning
