#include "app/evaluate/left_behind.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/named.h"
#include "core/math/bounds.h"
#include "rig/limb.h"
#include "rig/reach/bind_places.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

// Something that is drawn: what follows one node, or a skinned mesh as a whole.
struct Part {
  std::string name;
  Bounds bounds;
  NodeIndex hangsOn; // of the trunk
};

class Search {
public:
  Search(const Document& document, const rig::Limb& limb, const std::vector<bool>& moved,
         const rig::BindPlaces& places)
      : scene_(*document.scene), limb_(limb), moved_(moved), places_(places),
        end_(rig::endPosition(limb, places_.worlds)) {
    for (const rig::Limb& other : document.body.limbs) {
      const bool trunk = isTrunk(other);
      (trunk ? trunk_ : others_).insert(other.joints.begin(), other.joints.end());
      if (!trunk && other.id != limb.id) {
        otherEnds_.push_back(rig::endPosition(other, places_.worlds));
      }
    }
    trunk_.insert({document.body.hips, document.body.head});
  }

  [[nodiscard]] std::vector<Part> all() const {
    std::vector<Part> parts;
    for (std::size_t node = 0; node < scene_.nodes.size(); ++node) {
      const Part part = partOf(NodeIndex(node));
      if (part.hangsOn.exists() && isAtEnd(part)) {
        parts.push_back(part);
      }
    }
    for (const NodeIndex holder : skinning::drawnMeshNodes(scene_)) {
      const Part part = wholeMesh(holder);
      if (part.hangsOn.exists() && isAtEnd(part)) {
        parts.push_back(part);
      }
    }
    return parts;
  }

private:
  // What carries the node's mesh, if that is the trunk itself: chains of cloth and tails are none.
  [[nodiscard]] Part partOf(NodeIndex node) const {
    const Bounds& mesh = places_.meshes[at(node)];
    if (mesh.empty() || moved_[at(node)] || isBody(node)) {
      return {};
    }
    NodeIndex above = scene_.nodes[at(node)].parent;
    while (above.exists() && !isBody(above) && places_.meshes[at(above)].empty()) {
      above = scene_.nodes[at(above)].parent;
    }
    return {scene_.nodes[at(node)].name, mesh, trunk_.count(above) != 0 ? above : NodeIndex::none};
  }

  // A skinned mesh of its own whose vertices all follow one joint of the trunk.
  [[nodiscard]] Part wholeMesh(NodeIndex holder) const {
    const Node& node = scene_.nodes[at(holder)];
    std::optional<NodeIndex> only;
    Bounds bounds;
    for (const Primitive& primitive : scene_.meshes[at(node.mesh)].primitives) {
      const std::size_t count = node.skin >= 0 ? primitive.influences.size() : 0;
      for (std::size_t vertex = 0; vertex < count; ++vertex) {
        const Skin& skin = scene_.skins[at(node.skin)];
        const VertexInfluences& influences = primitive.influences[vertex];
        const auto strongest = static_cast<std::size_t>(std::ranges::max_element(influences.weights) -
                                                        influences.weights.begin());
        const std::size_t slot = influences.joints[strongest];
        if (slot >= skin.joints.size() || (only && *only != skin.joints[slot])) {
          return {};
        }
        only = skin.joints[slot];
        bounds.add(transformPoint(places_.worlds[at(*only)] * skin.inverseBind[slot],
                                  Vec3(primitive.positions[vertex])));
      }
    }
    const bool onTrunk = only && !moved_[at(*only)] && trunk_.count(*only) != 0;
    const std::string& own = scene_.meshes[at(node.mesh)].name;
    return {node.name.empty() ? own : node.name, bounds, onTrunk ? *only : NodeIndex::none};
  }

  [[nodiscard]] bool isBody(NodeIndex node) const {
    return trunk_.count(node) != 0 || others_.count(node) != 0;
  }

  // Near the end, small, nearer to it than to any other, and far from where it hangs.
  [[nodiscard]] bool isAtEnd(const Part& part) const {
    constexpr double farFromTrunk = 0.35;
    const double near = (isLeg(limb_) ? 0.3 : 0.2) * limb_.restLength;
    const Vec3 centre = 0.5 * (part.bounds.low + part.bounds.high);
    const double distance = glm::distance(centre, end_);
    const double fromTrunk = glm::distance(centre, positionOf(places_.worlds[at(part.hangsOn)]));
    return distance < near && part.bounds.largestExtent() < 3.0 * near &&
           distance < farFromTrunk * fromTrunk && std::ranges::all_of(otherEnds_, [&](const Vec3& other) {
             return glm::distance(centre, other) > distance;
           });
  }

  const Scene& scene_;
  const rig::Limb& limb_;
  const std::vector<bool>& moved_;
  const rig::BindPlaces& places_;
  Vec3 end_;
  std::set<NodeIndex> trunk_;
  std::set<NodeIndex> others_; // joints of arms and legs
  std::vector<Vec3> otherEnds_;
};

} // namespace

std::vector<std::string> partsLeftBehind(const Document& document, const rig::Limb& limb,
                                         const std::vector<bool>& moved, const rig::BindPlaces& places) {
  std::vector<std::string> warnings;
  if (!reachesOut(limb)) {
    return warnings;
  }
  for (const Part& part : Search(document, limb, moved, places).all()) {
    const NodeIndex end = limb.endNode.exists() ? limb.endNode : limb.joints.back();
    warnings.push_back(
        fmt::format("the mesh \"{}\" stands at the limb's end but hangs on \"{}\", so it stays where it is; "
                    "hang it on \"{}\" where the file was made",
                    part.name, nodeTitle(document, part.hangsOn), nodeTitle(document, end)));
  }
  return warnings;
}

} // namespace stretch::app
