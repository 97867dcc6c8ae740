#include "rig/corners/bind_corners.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/anim/sampling.h"
#include "core/scene/bind_chains.h"
#include "core/scene/morphs.h"
#include "rig/corners/corner_set.h"
#include "rig/corners/vertex_split.h"

namespace stretch::rig {

namespace {

using CornerOfJoint = std::pair<NodeIndex, int>;
using Splits = std::vector<std::vector<VertexSplit::Answer>>; // of a mesh: by primitive and vertex

class CornerBinding {
public:
  CornerBinding(const Scene& scene, const CornerOptions& options, gltf::Edits& edits)
      : scene_(scene), worlds_(worldMatrices(scene, restPose(scene))), options_(options), edits_(edits) {}

  CornerFit bind(const std::vector<ClipStretches>& clips) {
    const std::vector<MovedMesh> meshes = meshesOf(scene_, jointsOf(clips));
    sets_ = cornerSets(scene_, clips, meshes,
                       options_.mostInfluences < VertexInfluences::capacity ? furtherCorners : 0);
    for (const MovedMesh& mesh : meshes) {
      if (getsCorners(mesh)) {
        bindMesh(mesh);
      }
    }
    addTracks(clips);
    return fitTold();
  }

private:
  [[nodiscard]] static std::vector<NodeIndex> jointsOf(const std::vector<ClipStretches>& clips) {
    std::vector<NodeIndex> joints;
    for (const ClipStretches& clip : clips) {
      for (const StretchKeys& stretch : clip.stretches) {
        joints.push_back(stretch.node);
      }
    }
    return joints;
  }

  // Whether a vertex of the mesh comes to follow corners that the file has not: then all of its weights are
  // made anew, those of the file's own corners among them.
  [[nodiscard]] bool getsCorners(const MovedMesh& mesh) {
    const bool isNew = std::ranges::any_of(mesh.joints, [&](NodeIndex joint) {
      const auto set = sets_.find(joint);
      return set != sets_.end() && set->second.made.empty();
    });
    for (const NodeIndex joint : isNew ? mesh.joints : std::vector<NodeIndex>{}) {
      const BindChain* const chain = findBindChain(scene_, joint);
      if (chain != nullptr && !chain->corners.empty() && !sets_.contains(joint)) {
        sets_.emplace(joint, madeSet(scene_, *chain));
      }
    }
    return isNew;
  }

  void bindMesh(const MovedMesh& mesh) {
    const std::pair<int, int> shared(scene_.nodes[at(mesh.node)].mesh, mesh.skin);
    const auto known = bound_.find(shared);
    if (mesh.skin >= 0 && known != bound_.end()) {
      gltf::BoundMesh again = known->second;
      again.node = mesh.node;
      edits_.boundMeshes.push_back(std::move(again));
      return;
    }
    const Splits splits = splitsOf(mesh);
    gltf::BoundMesh bound{mesh.node, mesh.skin, {}, true};
    if (mesh.skin < 0) {
      bound = onOwnSkin(mesh, splits);
    }
    for (const auto& primitive : splits) {
      std::vector<VertexInfluences>& influences = bound.influences.emplace_back();
      for (const VertexSplit::Answer& vertex : primitive) {
        influences.push_back(written(mesh, bound.skin, vertex));
      }
    }
    bound_.emplace(shared, bound);
    edits_.boundMeshes.push_back(std::move(bound));
  }

  [[nodiscard]] Splits splitsOf(const MovedMesh& mesh) {
    VertexSplit split(mesh, sets_, options_);
    Splits splits;
    const Node& holder = scene_.nodes[at(mesh.node)];
    const Mesh& shape = scene_.meshes[at(holder.mesh)];
    for (const Primitive& primitive : shape.primitives) {
      const std::vector<VertexInfluences> influences = influencesOf(primitive, mesh);
      auto& answers = splits.emplace_back();
      for (std::size_t v = 0; v < influences.size(); ++v) {
        const VertexInfluences* const onCorners =
            mesh.skin < 0 || primitive.onCorners.empty() ? nullptr : &primitive.onCorners[v];
        answers.push_back(
            split.of(influences[v], onCorners, morphedPlace(shape, primitive, holder.morphWeights, v)));
        if (answers.back().isMoved || answers.back().isFitted) {
          const double ofMorphs = missOfMorphs(mesh, primitive, influences[v], v);
          misses_.push_back((answers.back().miss + ofMorphs) / options_.height);
          fit_.fitted += answers.back().isFitted ? 1 : 0;
        }
      }
    }
    return splits;
  }

  // How far off a vertex is, world units, where a clip's morph weights move it from where it is split:
  // corners carry that offset, and do not stretch it.
  [[nodiscard]] double missOfMorphs(const MovedMesh& mesh, const Primitive& primitive,
                                    const VertexInfluences& influences, std::size_t vertex) const {
    const Node& holder = scene_.nodes[at(mesh.node)];
    const Mesh& shape = scene_.meshes[at(holder.mesh)];
    double miss = 0.0;
    for (const FrameState& moment : options_.moments) {
      const std::vector<float>& weights = moment.pose.weights[at(mesh.node)];
      if (weights == holder.morphWeights) {
        continue;
      }
      const Vec3 offset = morphedPlace(shape, primitive, weights, vertex) -
                          morphedPlace(shape, primitive, holder.morphWeights, vertex);
      Vec3 lost(0.0);
      for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
        const std::size_t slot = influences.joints[i];
        if (influences.weights[i] > 0.0F && slot < mesh.joints.size() && sets_.contains(mesh.joints[slot])) {
          const NodeIndex joint = mesh.joints[slot];
          const Vec3 own = transformVector(mesh.inverseBind[slot], offset);
          const Mat3 stretch = moment.stretch.empty() ? Mat3(1.0) : moment.stretch[at(joint)];
          lost += static_cast<double>(influences.weights[i]) *
                  transformVector(moment.worlds[at(joint)], stretch * own - own);
        }
      }
      miss = std::max(miss, glm::length(lost));
    }
    return miss;
  }

  // A skin for a mesh that hung on a joint rigidly: the joint, and the corners that its vertices follow. The
  // mesh moves to a node of its own under none, which a skinned mesh should have.
  gltf::BoundMesh onOwnSkin(const MovedMesh& mesh, const Splits& splits) {
    std::set<int> used;
    for (const auto& primitive : splits) {
      for (const VertexSplit::Answer& vertex : primitive) {
        for (const CornerInfluence& part : vertex.parts) {
          used.insert(part.corner);
        }
      }
    }
    used.erase(-1);
    for (std::size_t corner = 0; !used.empty() && corner < sets_.at(mesh.node).enclosing; ++corner) {
      used.insert(static_cast<int>(corner));
    }
    const int skin = static_cast<int>(scene_.skins.size() + edits_.addedSkins.size());
    gltf::AddedSkin added{scene_.nodes[at(mesh.node)].name, {mesh.node}, {Mat4(1.0)}};
    for (const int corner : used) {
      slots_[{skin, {mesh.node, corner}}] = static_cast<std::uint16_t>(added.joints.size());
      added.joints.push_back(nodeOf({mesh.node, corner}));
      added.inverseBind.push_back(glm::translate(Mat4(1.0), -placeOf({mesh.node, corner})));
    }
    edits_.addedSkins.push_back(std::move(added));
    // Its own matrix moves no vertex of a skin, but tells viewers which side of a triangle is outside.
    Transform side;
    side.scale.x = glm::determinant(Mat3(worlds_[at(mesh.node)])) < 0.0 ? -1.0 : 1.0;
    gltf::AddedNode holder{scene_.nodes[at(mesh.node)].name + "_mesh", NodeIndex::none, side, mesh.node,
                           false};
    const NodeIndex node = nextNode();
    edits_.addedNodes.push_back(std::move(holder));
    return {node, skin, {}, true};
  }

  VertexInfluences written(const MovedMesh& mesh, int skin, const VertexSplit::Answer& vertex) {
    VertexInfluences influences;
    double sum = 0.0;
    for (const CornerInfluence& part : vertex.parts) {
      sum += part.weight;
    }
    float rest = 1.0F;
    for (std::size_t i = vertex.parts.size(); i-- > 0;) {
      const CornerInfluence& part = vertex.parts[i];
      influences.joints[i] = part.corner < 0 ? part.slot : slotOf(mesh, skin, part);
      influences.weights[i] = i == 0 ? rest : static_cast<float>(part.weight / sum);
      rest -= influences.weights[i];
    }
    return influences;
  }

  std::uint16_t slotOf(const MovedMesh& mesh, int skin, const CornerInfluence& part) {
    const NodeIndex joint = mesh.joints[part.slot];
    const CornerOfJoint corner(joint, part.corner);
    const CornerSet& set = sets_.at(joint);
    if (!set.made.empty()) {
      const std::map<int, int>& slots = set.made[at(part.corner)].slotOf;
      if (const auto own = slots.find(skin); own != slots.end()) {
        return static_cast<std::uint16_t>(own->second);
      }
    }
    const auto known = slots_.find({skin, corner});
    if (known != slots_.end()) {
      return known->second;
    }
    // Those that enclose come first, and all of them, so that they are known again in the file.
    for (int first = 0; set.made.empty() && first < std::min(part.corner, static_cast<int>(set.enclosing));
         ++first) {
      slotOf(mesh, skin, {part.slot, first});
    }
    const std::size_t slot = scene_.skins[at(skin)].jointsInFile() + addedTo_[skin]++;
    edits_.addedSlots.push_back(
        {skin, nodeOf(corner), glm::translate(Mat4(1.0), -placeOf(corner)) * mesh.inverseBind[part.slot]});
    return slots_[{skin, corner}] = static_cast<std::uint16_t>(slot);
  }

  [[nodiscard]] Vec3 placeOf(const CornerOfJoint& corner) const {
    return sets_.at(corner.first).places[at(corner.second)];
  }

  [[nodiscard]] NodeIndex nextNode() const {
    return NodeIndex(scene_.nodes.size() + edits_.addedNodes.size());
  }

  NodeIndex nodeOf(const CornerOfJoint& corner) {
    if (const std::vector<BindCorner>& made = sets_.at(corner.first).made; !made.empty()) {
      return made[at(corner.second)].node;
    }
    const auto [found, isNew] = nodes_.try_emplace(corner, nextNode());
    if (isNew) {
      gltf::AddedNode node;
      node.name = fmt::format("{}_corner_{}", scene_.nodes[at(corner.first)].name, corner.second + 1);
      node.parent = corner.first;
      node.rest.translation = placeOf(corner);
      node.isBindCorner = true;
      edits_.addedNodes.push_back(std::move(node));
    }
    return found->second;
  }

  // Nodes of a joint's corners that have weight, in their order; none for those without.
  [[nodiscard]] NodeIndex weightedNode(const CornerSet& set, std::size_t corner) const {
    if (!set.made.empty()) {
      return set.made[corner].node;
    }
    const auto found = nodes_.find({set.joint, static_cast<int>(corner)});
    return found == nodes_.end() ? NodeIndex::none : found->second;
  }

  void addTracks(const std::vector<ClipStretches>& clips) {
    for (const ClipStretches& clip : clips) {
      for (const StretchKeys& stretch : clip.stretches) {
        const auto set = sets_.find(stretch.node);
        for (std::size_t corner = 0; set != sets_.end() && corner < set->second.places.size(); ++corner) {
          const NodeIndex node = weightedNode(set->second, corner);
          if (node.exists()) {
            tracksOf(clip.clip, edits_).push_back(cornerTrack(node, set->second.places[corner], stretch));
          }
        }
      }
    }
  }

  [[nodiscard]] CornerFit fitTold() {
    for (const auto& [joint, set] : sets_) {
      std::size_t corners = 0;
      for (std::size_t corner = 0; corner < set.places.size(); ++corner) {
        corners += weightedNode(set, corner).exists() ? 1 : 0;
      }
      fit_.corners += corners;
      fit_.joints += corners > 0 ? 1 : 0;
    }
    std::ranges::sort(misses_);
    fit_.vertices = misses_.size();
    const auto share = [&](double part) {
      return misses_.empty()
                 ? 0.0
                 : misses_[static_cast<std::size_t>(part * static_cast<double>(misses_.size() - 1))];
    };
    fit_.median = share(0.5);
    fit_.percentile99 = share(0.99);
    fit_.worst = share(1.0);
    return fit_;
  }

  const Scene& scene_;
  std::vector<Mat4> worlds_; // at rest, by node
  const CornerOptions& options_;
  gltf::Edits& edits_;
  std::map<NodeIndex, CornerSet> sets_;
  std::map<std::pair<int, int>, gltf::BoundMesh> bound_;         // by mesh and skin
  std::map<CornerOfJoint, NodeIndex> nodes_;                     // of new corners
  std::map<std::pair<int, CornerOfJoint>, std::uint16_t> slots_; // of new corners, by skin
  std::map<int, std::size_t> addedTo_;                           // joints that skins get
  std::vector<double> misses_;                                   // of the moved vertices
  CornerFit fit_;
};

} // namespace

CornerFit addBindCorners(const Scene& scene, const std::vector<ClipStretches>& clips,
                         const CornerOptions& options, gltf::Edits& edits) {
  return CornerBinding(scene, options, edits).bind(clips);
}

} // namespace stretch::rig
