#include "rig/retarget/copy_tracks.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/transform.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"

namespace stretch::rig {

namespace {

// Of each node, how many nodes the ways from the top to it and to the hips share: more in the character that
// is meant than in another one.
std::vector<int> sharedWays(const Scene& scene, NodeIndex hips) {
  const auto climb = [&](NodeIndex node, const std::vector<int>& until) {
    std::vector<NodeIndex> way;
    for (; node.exists() && until[at(node)] < 0; node = scene.nodes[at(node)].parent) {
      way.push_back(node);
    }
    return std::pair(way, node);
  };
  std::vector<int> shared(scene.nodes.size(), -1);
  std::vector<NodeIndex> toHips = climb(hips, shared).first;
  for (int length = 1; !toHips.empty(); ++length, toHips.pop_back()) {
    shared[at(toHips.back())] = length;
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const auto [way, known] = climb(NodeIndex(i), shared);
    for (const NodeIndex node : way) {
      shared[at(node)] = known.exists() ? shared[at(known)] : 0;
    }
  }
  return shared;
}

// Nodes of a scene by name; none for a name that says not which.
class NodesByName {
public:
  NodesByName(const Scene& scene, NodeIndex hips) {
    const std::set<NodeIndex> joints = skinJoints(scene);
    const std::vector<int> shared = sharedWays(scene, hips);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      const NodeIndex node(i);
      const std::string& name = scene.nodes[i].name;
      if (name.empty() || scene.nodes[i].isBindLeaf) {
        continue;
      }
      const std::pair rank(joints.contains(node), shared[i]);
      const auto [known, isFirst] = nodes_.try_emplace(name, node, rank);
      if (!isFirst && rank >= known->second.second) {
        known->second = {rank > known->second.second ? node : NodeIndex::none, rank};
      }
    }
  }

  [[nodiscard]] NodeIndex find(const std::string& name) const {
    const auto found = nodes_.find(name);
    return found == nodes_.end() ? NodeIndex::none : found->second.first;
  }

private:
  std::map<std::string, std::pair<NodeIndex, std::pair<bool, int>>> nodes_; // With what speaks for each.
};

// The nodes that a clip moves. Where several characters have nodes of one name it is taken as that of `hips`,
// without one of the first that it moves; where it moves more nodes of another one, as that one's.
class MovedNodes {
public:
  MovedNodes(const Scene& scene, const Clip& clip, NodeIndex hips)
      : scene_(scene), character_(scene, hips.exists() ? hips : firstTop(scene, clip)) {
    for (const CopyOnWrite<Track>& track : clip.tracks) {
      moved_[scene.nodes[at(track->node)].name].insert(track->node);
    }
    int balance = 0;
    NodeIndex other;
    for (const auto& [name, nodes] : moved_) {
      const NodeIndex own = character_.find(name);
      const bool isOfOther = own.exists() && !nodes.contains(own);
      balance += isOfOther ? -1 : (own.exists() ? 1 : 0);
      other = isOfOther && !other.exists() ? *nodes.begin() : other;
    }
    if (balance < 0) {
      character_ = NodesByName(scene, other);
    }
  }

  [[nodiscard]] bool isOfOther(NodeIndex node) const {
    const NodeIndex own = character_.find(scene_.nodes[at(node)].name);
    return own.exists() && own != node;
  }

  // Whether its name says not which of several that are moved it is.
  [[nodiscard]] bool isDoubtful(NodeIndex node) const {
    const std::string& name = scene_.nodes[at(node)].name;
    return !character_.find(name).exists() && moved_.at(name).size() > 1;
  }

private:
  static NodeIndex firstTop(const Scene& scene, const Clip& clip) {
    NodeIndex top = clip.tracks.empty() ? NodeIndex::none : clip.tracks.front()->node;
    while (top.exists() && scene.nodes[at(top)].parent.exists()) {
      top = scene.nodes[at(top)].parent;
    }
    return top;
  }

  const Scene& scene_;
  NodesByName character_;
  std::map<std::string, std::set<NodeIndex>> moved_;
};

bool takesWeights(const Scene& scene, NodeIndex node, int targets) {
  const int mesh = scene.nodes[at(node)].mesh;
  if (mesh < 0) {
    return false;
  }
  const std::vector<Primitive>& primitives = scene.meshes[at(mesh)].primitives;
  return !primitives.empty() && std::ranges::all_of(primitives, [&](const Primitive& primitive) {
    return static_cast<int>(primitive.morphTargets.size()) == targets;
  });
}

Vec3 offsetFromParent(const std::vector<Mat4>& worlds, NodeIndex parent, NodeIndex node) {
  return transformPoint(glm::inverse(worlds[at(parent)]), positionOf(worlds[at(node)]));
}

} // namespace

CopiedTracks copyTracks(const Scene& from, const Clip& clip, const Scene& to, NodeIndex hips,
                        NodeIndex fromHips) {
  const NodesByName names(to, hips);
  const MovedNodes moved(from, clip, fromHips);
  CopiedTracks copied{clip, {}, {}, 0};
  copied.clip.sourceIndex = -1;
  copied.clip.tracks.clear();
  std::set<NodeIndex> told;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    const std::string& name = from.nodes[at(track->node)].name;
    const NodeIndex node = names.find(name);
    const bool isWeights = track->channel == Channel::weights;
    const bool isTaken = node.exists() && !moved.isDoubtful(track->node) &&
                         (!isWeights || takesWeights(to, node, track->width));
    const bool isFirst = told.insert(track->node).second;
    if (moved.isOfOther(track->node)) {
      if (isFirst) {
        copied.ofOthers.push_back(name);
      }
    } else if (isTaken) {
      Track taken = *track;
      taken.node = node;
      taken.sourceChannel = -1;
      copied.clip.tracks.emplace_back(std::move(taken));
      copied.joints += isFirst ? 1 : 0;
    } else if (isFirst) {
      copied.missing.push_back(name.empty() ? fmt::format("#{}", track->node.value) : name);
    }
  }
  return copied;
}

bool haveSameBones(const Scene& from, const Clip& clip, const Scene& to, NodeIndex hips, NodeIndex fromHips) {
  constexpr double alikeShare = 0.05; // of the bone's length
  constexpr double mostlyShare = 0.9;
  const NodesByName names(to, hips);
  const MovedNodes moved(from, clip, fromHips);
  const std::vector<Mat4> sourceBind = bindPoseWorlds(from);
  const std::vector<Mat4> bind = bindPoseWorlds(to);
  std::set<NodeIndex> seen;
  std::size_t compared = 0;
  std::size_t alike = 0;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    const NodeIndex node = track->node;
    const NodeIndex parent = from.nodes[at(node)].parent;
    const NodeIndex own = names.find(from.nodes[at(node)].name);
    const NodeIndex ownParent = own.exists() ? to.nodes[at(own)].parent : NodeIndex::none;
    const bool isComparable = parent.exists() && ownParent.exists() && !moved.isOfOther(node) &&
                              seen.insert(node).second &&
                              names.find(from.nodes[at(parent)].name) == ownParent;
    if (!isComparable) {
      continue;
    }
    const Vec3 there = offsetFromParent(sourceBind, parent, node);
    const Vec3 here = offsetFromParent(bind, ownParent, own);
    const double longer = std::max(glm::length(there), glm::length(here));
    ++compared;
    alike += glm::length(there - here) <= alikeShare * longer ? 1 : 0;
  }
  return static_cast<double>(alike) >= mostlyShare * static_cast<double>(compared);
}

} // namespace stretch::rig
