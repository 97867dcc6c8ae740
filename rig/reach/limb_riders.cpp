#include "rig/reach/limb_riders.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

namespace {

struct BoneLine {
  Vec3 start{0.0};
  Vec3 end{0.0};

  [[nodiscard]] double length() const { return glm::length(end - start); }
  [[nodiscard]] double fraction(const Vec3& p) const {
    const Vec3 axis = end - start;
    const double squared = glm::dot(axis, axis);
    return squared > 0.0 ? glm::dot(p - start, axis) / squared : 0.0;
  }
  [[nodiscard]] double distance(const Vec3& p) const {
    return glm::length(p - (start + (end - start) * fraction(p)));
  }
};

// A twist, roll or split joint lies along the bone, off its ends' neighbours and close to its line.
bool liesAlong(const BoneLine& bone, const Vec3& point) {
  constexpr double slack = 0.02;
  constexpr double nearness = 0.12;
  const double fraction = bone.fraction(point);
  return fraction > -slack && fraction < 1.0 - slack && bone.distance(point) < nearness * bone.length();
}

Vec3 centreOf(const Bounds& bounds) {
  return 0.5 * (bounds.low + bounds.high);
}

// Calls `look` with every mesh in the subtree of a node.
template <typename Look>
void forEachMesh(const Scene& scene, const BindPlaces& places, NodeIndex root, const Look& look) {
  std::vector<NodeIndex> nodes{root};
  while (!nodes.empty()) {
    const NodeIndex node = nodes.back();
    nodes.pop_back();
    if (!places.meshes[at(node)].empty()) {
      look(places.meshes[at(node)]);
    }
    const std::vector<NodeIndex>& children = scene.nodes[at(node)].children;
    nodes.insert(nodes.end(), children.begin(), children.end());
  }
}

template <typename Holds>
bool everyMesh(const Scene& scene, const BindPlaces& places, NodeIndex root, const Holds& holds) {
  bool any = false;
  bool all = true;
  forEachMesh(scene, places, root, [&](const Bounds& mesh) {
    any = true;
    all = all && holds(mesh);
  });
  return any && all;
}

// Finds what stands at the end of a limb and hangs elsewhere.
class CompanionSearch {
public:
  CompanionSearch(const Scene& scene, const Limb& limb, const std::vector<Limb>& others,
                  const BindPlaces& places)
      : scene_(scene), limb_(limb), places_(places), end_(endPosition(limb, places.worlds)),
        near_((isLeg(limb) ? 0.3 : 0.2) * limb.restLength) {
    for (const Limb& other : others) {
      body_.insert(other.joints.begin(), other.joints.end());
      if (other.endNode.exists() && other.id != limb.id) {
        body_.insert(other.endNode);
        otherEnds_.push_back(endPosition(other, places.worlds));
      }
      const NodeIndex base = other.joints.front();
      trunk_ = !trunk_.exists() ? base : commonAncestor(scene, trunk_, base);
    }
    body_.insert(limb.joints.begin(), limb.joints.end());
    // Where the limbs meet is the body, unless it is a mere root.
    if (trunk_.exists() && !places.meshes[at(trunk_)].empty()) {
      body_.insert(trunk_);
    }
  }

  [[nodiscard]] std::vector<NodeIndex> all() const {
    std::vector<NodeIndex> found;
    if (const NodeIndex master = masterOfEnd(); master.exists()) {
      found.push_back(master);
    }
    for (const NodeIndex node : parentsFirst(scene_)) {
      const bool below =
          std::ranges::any_of(found, [&](NodeIndex above) { return isAncestorOrSelf(scene_, above, node); });
      if (!below && !places_.meshes[at(node)].empty() && isApart(node) && standsAtEnd(node)) {
        found.push_back(node);
      }
    }
    return found;
  }

private:
  // What stands where a detached end stands and carries it, as the master of a deforming joint does; fingers
  // hang from it.
  [[nodiscard]] NodeIndex masterOfEnd() const {
    const NodeIndex above = scene_.nodes[at(limb_.endNode)].parent;
    if (isAncestorOrSelf(scene_, limb_.joints.back(), limb_.endNode) || !above.exists()) {
      return NodeIndex::none;
    }
    constexpr double same = 0.02; // of the limb
    const bool stands = glm::distance(positionOf(places_.worlds[at(above)]), end_) < same * limb_.restLength;
    const bool carriesBody = std::any_of(
        body_.begin(), body_.end(), [&](NodeIndex joint) { return isAncestorOrSelf(scene_, above, joint); });
    return stands && !carriesBody ? above : NodeIndex::none;
  }

  // Neither on the trunk, nor on a limb, nor carrying one, nor moved by the end joint.
  [[nodiscard]] bool isApart(NodeIndex node) const {
    if (node == limb_.endNode || isAncestorOrSelf(scene_, limb_.endNode, node)) {
      return false;
    }
    for (NodeIndex above = node; above.exists(); above = scene_.nodes[at(above)].parent) {
      if (body_.count(above) != 0) {
        return false;
      }
    }
    return std::ranges::none_of(body_,
                                [&](NodeIndex joint) { return isAncestorOrSelf(scene_, node, joint); });
  }

  [[nodiscard]] bool standsAtEnd(NodeIndex node) const {
    return everyMesh(scene_, places_, node, [&](const Bounds& mesh) {
      const double distance = glm::distance(centreOf(mesh), end_);
      return distance < near_ && mesh.largestExtent() < 3.0 * near_ &&
             std::ranges::all_of(otherEnds_, [&](const Vec3& other) {
               return glm::distance(centreOf(mesh), other) > distance;
             });
    });
  }

  const Scene& scene_;
  const Limb& limb_;
  const BindPlaces& places_;
  Vec3 end_;
  double near_ = 0.0;
  std::set<NodeIndex> body_; // joints of all limbs and of the trunk between them
  NodeIndex trunk_;
  std::vector<Vec3> otherEnds_;
};

// Whether another limb stands at the end of a trunk limb without hanging on it. A neck carries what belongs
// to the head: shoulders as high as its end are the spine's.
bool standsOnEnd(const Scene& scene, const Limb& limb, const Limb& other, const BindPlaces& places) {
  const std::vector<NodeIndex> own = jointsAndEnd(limb);
  const NodeIndex base = other.joints.front();
  const Vec3 place = positionOf(places.worlds[at(base)]);
  const Vec3 start = positionOf(places.worlds[at(limb.joints.front())]);
  return !limb.ledByFirst &&
         (limb.kind == LimbKind::spine || other.kind == LimbKind::feeler || other.kind == LimbKind::chain) &&
         glm::distance(place, endPosition(limb, places.worlds)) < glm::distance(place, start) &&
         std::ranges::none_of(own, [&](NodeIndex joint) { return isAncestorOrSelf(scene, joint, base); });
}

// What carries the other limbs that stand at the end of a trunk limb, as in a file whose deforming joints
// hang side by side.
std::vector<NodeIndex> limbsAtEnd(const Scene& scene, const Limb& limb, const std::vector<Limb>& others,
                                  const BindPlaces& places) {
  std::vector<NodeIndex> carried;
  std::vector<NodeIndex> kept = jointsAndEnd(limb);
  for (const Limb& other : others) {
    if (other.id != limb.id && !other.joints.empty()) {
      std::vector<NodeIndex>& list = standsOnEnd(scene, limb, other, places) ? carried : kept;
      const std::vector<NodeIndex> nodes = jointsAndEnd(other);
      list.insert(list.end(), nodes.begin(), nodes.end());
    }
  }
  return highestCarriers(scene, carried, kept);
}

} // namespace

Riders::Riders(const Scene& scene, const Limb& limb, const BindPlaces& places,
               std::set<NodeIndex> othersJoints)
    : scene_(scene), limb_(limb), places_(places), othersJoints_(std::move(othersJoints)),
      skinned_(skinJoints(scene)), points_(limbPoints(limb, places.worlds)) {}

bool Riders::holdsOthers(NodeIndex node) const {
  return std::ranges::any_of(othersJoints_,
                             [&](NodeIndex joint) { return isAncestorOrSelf(scene_, node, joint); });
}

bool Riders::isRigidPart(NodeIndex node) const {
  const Node& holder = scene_.nodes[at(node)];
  return holder.mesh >= 0 && holder.skin < 0 && !places_.meshes[at(node)].empty();
}

// A part of the body has its middle beside the bone; what is held or worn reaches away from it.
bool Riders::covers(NodeIndex node, std::size_t bone) const {
  const BoneLine line{points_[bone], points_[bone + 1]};
  const Vec3 centre = centreOf(places_.meshes[at(node)]);
  const double fraction = line.fraction(centre);
  const bool wide = isTrunk(limb_);
  return fraction > -0.25 && fraction < 1.1 && line.distance(centre) < (wide ? 1.5 : 0.5) * line.length();
}

void Riders::collect(NodeIndex node, std::size_t bone, std::vector<NodeIndex>& riders) const {
  if (holdsOthers(node)) {
    return;
  }
  const bool isJoint = skinned_.count(node) != 0;
  const BoneLine line{points_[bone], points_[bone + 1]};
  const bool twists = isJoint && liesAlong(line, positionOf(places_.worlds[at(node)]));
  const bool rides = twists || (isRigidPart(node) && covers(node, bone));
  if (!rides && (isJoint || isRigidPart(node))) {
    return;
  }
  // A node that holds nothing itself rides where something below it does.
  const std::size_t before = riders.size();
  riders.push_back(node);
  for (const NodeIndex child : scene_.nodes[at(node)].children) {
    collect(child, bone, riders);
  }
  if (!rides && riders.size() == before + 1) {
    riders.pop_back();
  }
}

void Riders::collectOnPath(const std::vector<NodeIndex>& path, std::size_t bone,
                           std::vector<NodeIndex>& riders) const {
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const NodeIndex node = path[k];
    if (skinned_.count(node) != 0 || isRigidPart(node)) {
      riders.push_back(node);
    }
    for (const NodeIndex child : scene_.nodes[at(node)].children) {
      if (child != path[k + 1]) {
        collect(child, bone, riders);
      }
    }
  }
}

bool Riders::isAtEnd(NodeIndex node) const {
  if (!limb_.endNode.exists() || holdsOthers(node)) {
    return false;
  }
  const BoneLine line{points_[points_.size() - 2], points_.back()};
  constexpr double nearEnd = 0.9; // of the bone: a twist joint there moves what lies before the end
  constexpr double past = 0.97;
  return line.fraction(positionOf(places_.worlds[at(node)])) > nearEnd &&
         everyMesh(scene_, places_, node,
                   [&](const Bounds& mesh) { return line.fraction(centreOf(mesh)) > past; });
}

std::vector<NodeIndex> companionsElsewhere(const Scene& scene, const Limb& limb,
                                           const std::vector<Limb>& others, const BindPlaces& places) {
  if (!limb.endNode.exists() || limb.kind == LimbKind::chain) {
    return {};
  }
  return isTrunk(limb) ? limbsAtEnd(scene, limb, others, places)
                       : CompanionSearch(scene, limb, others, places).all();
}

std::vector<NodeIndex> highestCarriers(const Scene& scene, const std::vector<NodeIndex>& carried,
                                       const std::vector<NodeIndex>& kept) {
  const auto isFree = [&](NodeIndex node) {
    return node.exists() &&
           std::ranges::none_of(kept, [&](NodeIndex other) { return isAncestorOrSelf(scene, node, other); });
  };
  std::set<NodeIndex> carriers;
  for (NodeIndex node : carried) {
    if (isFree(node)) {
      while (isFree(scene.nodes[at(node)].parent)) {
        node = scene.nodes[at(node)].parent;
      }
      carriers.insert(node);
    }
  }
  return {carriers.begin(), carriers.end()};
}

} // namespace stretch::rig
