#include "skinning/surface_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/transform.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::skinning {

// Walks through the drawn meshes twice: for what follows the nodes, and for what stands beside it.
class SurfacePart::Builder {
public:
  Builder(const Scene& scene, const std::vector<bool>& follows, SurfacePart& part)
      : scene_(scene), follows_(follows), part_(part) {}

  void build(SurfaceEdges edges) {
    const std::vector<NodeIndex> holders = drawnMeshNodes(scene_);
    for (const NodeIndex holder : holders) {
      forEachPrimitive(holder, [&](const Primitive& primitive) { addMoved(holder, primitive); });
    }
    part_.movedCount_ = part_.vertices_.size();
    if (edges == SurfaceEdges::all) {
      std::size_t piece = 0;
      for (const NodeIndex holder : holders) {
        forEachPrimitive(holder, [&](const Primitive& primitive) { addEdges(holder, primitive, piece++); });
      }
      std::sort(part_.edges_.begin(), part_.edges_.end());
      part_.edges_.erase(std::unique(part_.edges_.begin(), part_.edges_.end()), part_.edges_.end());
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
    const Node& node = scene_.nodes[at(holder)];
    // The last one is the holder's own.
    slotOfJoint_.assign(node.skin >= 0 ? scene_.skins[at(node.skin)].joints.size() + 1 : 1, none);
    for (const Primitive& primitive : scene_.meshes[at(node.mesh)].primitives) {
      look(primitive);
    }
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
    const VertexInfluences& influences = primitive.influences[vertex];
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      const std::size_t joint = influences.joints[i];
      if (influences.weights[i] != 0.0F && joint < skin->joints.size() && follows_[at(skin->joints[joint])]) {
        return true;
      }
    }
    return false;
  }

  std::uint32_t slotOf(std::size_t joint, NodeIndex node, const Mat4& inverseBind) {
    if (slotOfJoint_[joint] == none) {
      slotOfJoint_[joint] = static_cast<std::uint32_t>(part_.slots_.size());
      part_.slots_.push_back({node, inverseBind});
    }
    return slotOfJoint_[joint];
  }

  std::uint32_t addVertex(NodeIndex holder, const Primitive& primitive, std::size_t vertex) {
    const Node& node = scene_.nodes[at(holder)];
    const std::vector<float>& weights =
        node.morphWeights.empty() ? scene_.meshes[at(node.mesh)].morphWeights : node.morphWeights;
    const auto first = static_cast<std::uint32_t>(part_.influences_.size());
    if (const Skin* const skin = skinOf(holder, primitive)) {
      const VertexInfluences& influences = primitive.influences[vertex];
      for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
        const std::size_t joint = influences.joints[i];
        if (influences.weights[i] != 0.0F && joint < skin->joints.size()) {
          part_.influences_.push_back(
              {slotOf(joint, skin->joints[joint], skin->inverseBind[joint]), influences.weights[i]});
        }
      }
    } else {
      part_.influences_.push_back({slotOf(slotOfJoint_.size() - 1, holder, Mat4(1.0)), 1.0F});
    }
    part_.vertices_.push_back({glm::vec3(morphedPosition(primitive, weights, vertex)), first,
                               static_cast<std::uint32_t>(part_.influences_.size()) - first});
    return static_cast<std::uint32_t>(part_.vertices_.size() - 1);
  }

  void addMoved(NodeIndex holder, const Primitive& primitive) {
    std::vector<std::uint32_t>& places = places_.emplace_back(primitive.positions.size(), none);
    for (std::size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
      if (isMoved(holder, primitive, vertex)) {
        places[vertex] = addVertex(holder, primitive, vertex);
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
  std::vector<std::uint32_t> slotOfJoint_;         // of the mesh that is walked through
  std::vector<std::vector<std::uint32_t>> places_; // of the vertices of each primitive
};

SurfacePart::SurfacePart(const Scene& scene, const std::vector<bool>& follows, SurfaceEdges edges) {
  Builder(scene, follows, *this).build(edges);
  measureSlots();
}

void SurfacePart::measureSlots() {
  std::vector<Bounds> boxes(slots_.size());
  const auto eachInfluence = [&](const auto& look) {
    for (std::size_t vertex = 0; vertex < movedCount_; ++vertex) {
      const Vertex& one = vertices_[vertex];
      for (std::uint32_t i = 0; i < one.influences; ++i) {
        look(Vec3(one.position), influences_[one.firstInfluence + i].slot);
      }
    }
  };
  eachInfluence([&](const Vec3& place, std::uint32_t slot) { boxes[slot].add(place); });
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    if (!boxes[slot].empty()) {
      slots_[slot].centre = 0.5 * (boxes[slot].low + boxes[slot].high);
    }
  }
  eachInfluence([&](const Vec3& place, std::uint32_t slot) {
    slots_[slot].radius = std::max(slots_[slot].radius, glm::length(place - slots_[slot].centre));
  });
  for (std::size_t vertex = 0; vertex < movedCount_; ++vertex) {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < vertices_[vertex].influences; ++i) {
      sum += static_cast<double>(std::abs(influences_[vertices_[vertex].firstInfluence + i].weight));
    }
    largestWeight_ = std::max(largestWeight_, sum);
  }
}

double SurfacePart::farthestMove(const FrameState& from, const FrameState& to) const {
  double farthest = 0.0;
  for (const Slot& slot : slots_) {
    if (slot.radius < 0.0) {
      continue;
    }
    const Mat4 change = (meshMatrix(to, slot.node) - meshMatrix(from, slot.node)) * slot.inverseBind;
    const Mat3 turn(change);
    const double most = std::sqrt(glm::dot(turn[0], turn[0]) + glm::dot(turn[1], turn[1]) +
                                  glm::dot(turn[2], turn[2])); // no vector grows by more
    farthest = std::max(farthest, glm::length(transformPoint(change, slot.centre)) + most * slot.radius);
  }
  return largestWeight_ * farthest;
}

void SurfacePart::positions(const FrameState& frame, std::size_t first, std::size_t last,
                            std::vector<glm::vec3>& out) const {
  out.resize(vertices_.size());
  if (first == last) {
    return;
  }
  std::vector<glm::mat4> matrices;
  matrices.reserve(slots_.size());
  for (const Slot& slot : slots_) {
    matrices.emplace_back(meshMatrix(frame, slot.node) * slot.inverseBind);
  }
  for (std::size_t vertex = first; vertex < last; ++vertex) {
    const Vertex& one = vertices_[vertex];
    const Influence* const influences = &influences_[one.firstInfluence];
    glm::vec4 position(0.0F);
    for (std::uint32_t i = 0; i < one.influences; ++i) {
      const glm::mat4& matrix = matrices[influences[i].slot];
      position += influences[i].weight * (matrix[0] * one.position.x + matrix[1] * one.position.y +
                                          matrix[2] * one.position.z + matrix[3]);
    }
    out[vertex] = glm::vec3(position);
  }
}

void SurfacePart::positions(const FrameState& frame, std::vector<glm::vec3>& out) const {
  positions(frame, 0, vertices_.size(), out);
}

void SurfacePart::movedPositions(const FrameState& frame, std::vector<glm::vec3>& out) const {
  positions(frame, 0, movedCount_, out);
}

void SurfacePart::stillPositions(const FrameState& frame, std::vector<glm::vec3>& out) const {
  positions(frame, movedCount_, vertices_.size(), out);
}

} // namespace stretch::skinning
