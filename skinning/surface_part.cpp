#include "skinning/surface_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/transform.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::skinning {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

} // namespace

// Walks through the drawn meshes twice: for what follows the nodes, and for what stands beside it.
class SurfacePart::Builder {
public:
  Builder(const Scene& scene, const std::vector<bool>& follows, SurfacePart& part)
      : scene_(scene), follows_(follows), part_(part), slotsOfSkins_(scene.skins.size()),
        slotsOfNodes_(scene.nodes.size(), none) {
    for (std::size_t skin = 0; skin < scene.skins.size(); ++skin) {
      slotsOfSkins_[skin].assign(scene.skins[skin].joints.size(), none);
    }
  }

  void build(SurfaceEdges edges) {
    const std::vector<NodeIndex> holders = drawnMeshNodes(scene_);
    makeRoom(holders);
    for (const NodeIndex holder : holders) {
      forEachPrimitive(holder, [&](const Primitive& primitive) { addMoved(holder, primitive, edges); });
    }
    part_.movedCount_ = part_.vertices_.size();
    if (edges == SurfaceEdges::all) {
      std::size_t piece = 0;
      for (const NodeIndex holder : holders) {
        forEachPrimitive(holder, [&](const Primitive& primitive) { addEdges(holder, primitive, piece++); });
      }
      std::sort(part_.edges_.begin(), part_.edges_.end());
      part_.edges_.erase(std::unique(part_.edges_.begin(), part_.edges_.end()), part_.edges_.end());
      part_.edges_.shrink_to_fit();
      part_.vertices_.shrink_to_fit();
      part_.influences_.shrink_to_fit();
    }
    for (const Slot& slot : part_.slots_) {
      part_.nodes_.push_back(slot.node);
    }
    std::sort(part_.nodes_.begin(), part_.nodes_.end());
    part_.nodes_.erase(std::unique(part_.nodes_.begin(), part_.nodes_.end()), part_.nodes_.end());
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  template <typename Look>
  void forEachPrimitive(NodeIndex holder, const Look& look) {
    for (const Primitive& primitive : scene_.meshes[at(scene_.nodes[at(holder)].mesh)].primitives) {
      look(primitive);
    }
  }

  // `use`: of a joint's index in the skin and its weight.
  template <typename Use>
  static void forEachInfluence(const Skin& skin, const VertexInfluences& influences, const Use& use) {
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      if (influences.weights[i] != 0.0F && influences.joints[i] < skin.joints.size()) {
        use(std::size_t{influences.joints[i]}, influences.weights[i]);
      }
    }
  }

  // Lists that grow to hold a large mesh would take twice what they need.
  void makeRoom(const std::vector<NodeIndex>& holders) {
    std::size_t vertices = 0;
    std::size_t influences = 0;
    for (const NodeIndex holder : holders) {
      forEachPrimitive(holder, [&](const Primitive& primitive) {
        const Skin* const skin = skinOf(holder, primitive);
        for (std::size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
          if (isMoved(holder, primitive, vertex)) {
            ++vertices;
            influences += skin == nullptr ? 1 : 0;
            if (skin != nullptr) {
              forEachInfluence(*skin, primitive.influences[vertex],
                               [&](std::size_t, float) { ++influences; });
            }
          }
        }
      });
    }
    part_.vertices_.reserve(vertices);
    part_.influences_.reserve(influences);
  }

  [[nodiscard]] const Skin* skinOf(NodeIndex holder, const Primitive& primitive) const {
    const int skin = scene_.nodes[at(holder)].skin;
    return skin >= 0 && !primitive.influences.empty() ? &scene_.skins[at(skin)] : nullptr;
  }

  [[nodiscard]] bool isMoved(NodeIndex holder, const Primitive& primitive, std::size_t vertex) const {
    const Skin* const skin = skinOf(holder, primitive);
    if (skin == nullptr) {
      return follows_[at(holder)];
    }
    bool moved = false;
    forEachInfluence(*skin, primitive.influences[vertex],
                     [&](std::size_t joint, float) { moved = moved || follows_[at(skin->joints[joint])]; });
    return moved;
  }

  std::uint32_t slotOf(std::uint32_t& slot, NodeIndex node, const Mat4& inverseBind) {
    if (slot == none) {
      slot = static_cast<std::uint32_t>(part_.slots_.size());
      part_.slots_.push_back({node, inverseBind});
    }
    return slot;
  }

  std::uint32_t addVertex(NodeIndex holder, const Primitive& primitive, std::size_t vertex) {
    const Node& node = scene_.nodes[at(holder)];
    const std::vector<float>& weights =
        node.morphWeights.empty() ? scene_.meshes[at(node.mesh)].morphWeights : node.morphWeights;
    const auto first = static_cast<std::uint32_t>(part_.influences_.size());
    if (const Skin* const skin = skinOf(holder, primitive)) {
      forEachInfluence(*skin, primitive.influences[vertex], [&](std::size_t joint, float weight) {
        std::uint32_t& slot = slotsOfSkins_[at(node.skin)][joint];
        part_.influences_.push_back({slotOf(slot, skin->joints[joint], skin->inverseBind[joint]), weight});
      });
    } else {
      part_.influences_.push_back({slotOf(slotsOfNodes_[at(holder)], holder, Mat4(1.0)), 1.0F});
    }
    part_.vertices_.push_back({glm::vec3(morphedPosition(primitive, weights, vertex)), first,
                               static_cast<std::uint32_t>(part_.influences_.size()) - first});
    return static_cast<std::uint32_t>(part_.vertices_.size() - 1);
  }

  void addMoved(NodeIndex holder, const Primitive& primitive, SurfaceEdges edges) {
    std::vector<std::uint32_t>& places =
        places_.emplace_back(edges == SurfaceEdges::all ? primitive.positions.size() : 0, none);
    for (std::size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
      if (isMoved(holder, primitive, vertex)) {
        const std::uint32_t place = addVertex(holder, primitive, vertex);
        if (edges == SurfaceEdges::all) {
          places[vertex] = place;
        }
      }
    }
  }

  void addEdges(NodeIndex holder, const Primitive& primitive, std::size_t piece) {
    std::vector<std::uint32_t>& places = places_[piece];
    const auto movedCount = static_cast<std::uint32_t>(part_.movedCount_);
    const auto placeOf = [&](std::uint32_t vertex) {
      places[vertex] = places[vertex] == none ? addVertex(holder, primitive, vertex) : places[vertex];
      return places[vertex];
    };
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
      const std::array corners{primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]};
      for (std::size_t side = 0; side < corners.size(); ++side) {
        const std::uint32_t a = corners[side];
        const std::uint32_t b = corners[(side + 1) % corners.size()];
        if (places[a] < movedCount || places[b] < movedCount) {
          const std::uint32_t first = placeOf(a);
          const std::uint32_t second = placeOf(b);
          part_.edges_.push_back({std::min(first, second), std::max(first, second)}); // what follows comes
                                                                                      // first
        }
      }
    }
  }

  const Scene& scene_;
  const std::vector<bool>& follows_;
  SurfacePart& part_;
  std::vector<std::vector<std::uint32_t>> slotsOfSkins_; // by skin and joint
  std::vector<std::uint32_t> slotsOfNodes_;
  std::vector<std::vector<std::uint32_t>> places_; // of the vertices of each primitive
};

SurfacePart::SurfacePart(const Scene& scene, const std::vector<bool>& follows, SurfaceEdges edges) {
  Builder(scene, follows, *this).build(edges);
  measureSlots();
}

SurfacePart SurfacePart::whole(const Scene& scene) {
  return {scene, std::vector<bool>(scene.nodes.size(), true), SurfaceEdges::none};
}

bool SurfacePart::isMean(std::size_t vertex) const {
  constexpr double rounding = 2e-6;
  double off = -1.0;
  for (const Influence& one : influencesOf(vertex)) {
    off += std::abs(static_cast<double>(one.weight));
  }
  return std::abs(off) < rounding &&
         std::ranges::none_of(influencesOf(vertex), [](const Influence& one) { return one.weight < 0.0F; });
}

void SurfacePart::measureSlots() {
  std::vector<Bounds> boxes(slots_.size());
  firstFollowers_.assign(slots_.size() + 1, 0);
  for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) {
    const Vec3 place(vertices_[vertex].position);
    reach_ = std::max(reach_, glm::length(place));
    areMeans_ = areMeans_ && isMean(vertex);
    for (const Influence& one : vertex < movedCount_ ? influencesOf(vertex) : std::span<const Influence>()) {
      ++firstFollowers_[one.slot + 1];
      boxes[one.slot].add(place);
    }
  }
  std::partial_sum(firstFollowers_.begin(), firstFollowers_.end(), firstFollowers_.begin());
  followers_.resize(firstFollowers_.back());
  std::vector<std::size_t> next = firstFollowers_;
  for (std::uint32_t vertex = 0; vertex < movedCount_; ++vertex) {
    for (const Influence& one : influencesOf(vertex)) {
      followers_[next[one.slot]++] = vertex;
    }
  }
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    if (!boxes[slot].empty()) {
      slots_[slot].centre = 0.5 * (boxes[slot].low + boxes[slot].high);
      slots_[slot].half = 0.5 * (boxes[slot].high - boxes[slot].low);
    }
    for (const std::uint32_t vertex : followersOf(slot)) {
      slots_[slot].radius =
          std::max(slots_[slot].radius, glm::distance(Vec3(vertices_[vertex].position), slots_[slot].centre));
    }
  }
}

double growthOf(const Mat4& matrix) {
  const Mat3 turn(matrix);
  double most = 0.0;
  for (int i = 0; i < 3; ++i) { // circles around the eigenvalues of its square
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
      sum += std::abs(glm::dot(turn[i], turn[k]));
    }
    most = std::max(most, sum);
  }
  return std::sqrt(most);
}

SurfacePart::Posed SurfacePart::posed(const FrameState& frame) const {
  constexpr double share = 2e-5; // of the size of what is added up
  Posed posed;
  for (const Slot& slot : slots_) {
    const Mat4 matrix = meshMatrix(frame, slot.node) * slot.inverseBind;
    posed.rounding =
        std::max(posed.rounding, share * (glm::length(positionOf(matrix)) + growthOf(matrix) * reach_));
    posed.matrices.push_back(matrix);
  }
  posed.rounded.assign(posed.matrices.begin(), posed.matrices.end());
  return posed;
}

void SurfacePart::positions(const FrameState& frame, std::vector<glm::vec3>& out) const {
  const Posed matrices = posed(frame);
  out.resize(vertices_.size());
  for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) {
    out[vertex] = place(vertex, matrices);
  }
}

// A mean is as low only where one of what it is made of is.
std::optional<Vec3> SurfacePart::lowest(const Posed& posed, double limit) const {
  std::vector<std::pair<double, std::size_t>> bottoms;
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    const Mat4& matrix = posed.matrices[slot];
    const Vec3 up(std::abs(matrix[0].y), std::abs(matrix[1].y), std::abs(matrix[2].y));
    const double bottom =
        transformPoint(matrix, slots_[slot].centre).y - glm::dot(up, slots_[slot].half) - posed.rounding;
    bottoms.emplace_back(areMeans_ && bottom > -endless ? bottom : -endless, slot);
  }
  std::ranges::sort(bottoms);
  std::optional<std::pair<double, std::uint32_t>> lowest;
  for (const auto& [bottom, slot] : bottoms) {
    if (bottom > (lowest ? lowest->first : limit)) {
      break;
    }
    for (const std::uint32_t vertex : followersOf(slot)) {
      const std::pair found(static_cast<double>(place(vertex, posed).y), vertex);
      if (lowest ? found < *lowest : found.first < limit) {
        lowest = found;
      }
    }
  }
  return lowest ? std::optional(Vec3(place(lowest->second, posed))) : std::nullopt;
}

std::vector<std::pair<double, std::size_t>> SurfacePart::farthestMoves(const Posed& from,
                                                                       const Posed& to) const {
  std::vector<std::pair<double, std::size_t>> moves;
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    if (!followersOf(slot).empty()) {
      const Mat4 change = to.matrices[slot] - from.matrices[slot];
      const double most = glm::length(transformPoint(change, slots_[slot].centre)) +
                          growthOf(change) * slots_[slot].radius + from.rounding + to.rounding;
      moves.emplace_back(areMeans_ && most < endless ? most : endless, slot);
    }
  }
  std::ranges::sort(moves, std::greater());
  return moves;
}

} // namespace stretch::skinning
