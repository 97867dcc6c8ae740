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

// Nodes of a scene by name; none for a name that says not which.
class NodesByName {
public:
  explicit NodesByName(const Scene& scene) {
    const std::set<NodeIndex> joints = skinJoints(scene);
    std::map<std::string, int> counts;
    for (const bool ofSkin : {true, false}) {
      for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const NodeIndex index(i);
        if (joints.contains(index) != ofSkin || node.name.empty() || node.isBindLeaf) {
          continue;
        }
        const bool isFirst = nodes_.emplace(node.name, index).second;
        const bool repeats = !isFirst && joints.contains(nodes_[node.name]) == ofSkin;
        counts[node.name] += repeats ? 1 : 0;
      }
    }
    for (const auto& [name, repeated] : counts) {
      if (repeated > 0) {
        nodes_[name] = NodeIndex::none;
      }
    }
  }

  [[nodiscard]] NodeIndex find(const std::string& name) const {
    const auto found = nodes_.find(name);
    return found == nodes_.end() ? NodeIndex::none : found->second;
  }

private:
  std::map<std::string, NodeIndex> nodes_;
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

CopiedTracks copyTracks(const Scene& from, const Clip& clip, const Scene& to) {
  const NodesByName names(to);
  CopiedTracks copied{clip, {}, 0};
  copied.clip.sourceIndex = -1;
  copied.clip.tracks.clear();
  std::set<NodeIndex> told;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    const std::string& name = from.nodes[at(track->node)].name;
    const NodeIndex node = names.find(name);
    const bool isWeights = track->channel == Channel::weights;
    const bool isTaken = node.exists() && (!isWeights || takesWeights(to, node, track->width));
    const bool isFirst = told.insert(track->node).second;
    if (isTaken) {
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

bool haveSameBones(const Scene& from, const Clip& clip, const Scene& to) {
  constexpr double alikeShare = 0.05; // of the bone's length
  constexpr double mostlyShare = 0.9;
  const NodesByName names(to);
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
    const bool isComparable = parent.exists() && ownParent.exists() && seen.insert(node).second &&
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
