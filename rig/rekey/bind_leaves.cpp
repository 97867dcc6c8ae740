#include "rig/rekey/bind_leaves.h"

#include <algorithm>
#include <map>

#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/math/rotation.h"
#include "core/scene/bind_chains.h"

namespace stretch::rig {

namespace {

struct Leaf {
  NodeIndex node;
  Quat axis{1.0, 0.0, 0.0, 0.0}; // A
  bool axisIsFixed = true;       // over all clips, and as the file has it
  bool turnsBack = false;        // has a second leaf
  NodeIndex bindNode;            // index in the saved file
  NodeIndex endNode;
  const BindChain* made = nullptr; // of the file as it was opened
};

// A leaf that the file has keeps the axis that it has at rest: other clips go by it.
Leaf newLeaf(const Scene& scene, const StretchKeys& stretch) {
  Leaf leaf;
  leaf.node = stretch.node;
  leaf.axis = stretch.axes.front();
  leaf.made = findBindChain(scene, stretch.node);
  if (leaf.made != nullptr) {
    leaf.axis = scene.nodes[at(leaf.made->leaf)].rest.rotation;
    leaf.axisIsFixed = !leaf.made->endLeaf.exists();
  }
  return leaf;
}

// Across the axis all directions are scaled alike: turning A about it changes nothing.
bool hasOneAxis(const StretchKeys& stretch) {
  constexpr double negligible = 1e-6;
  return std::ranges::all_of(stretch.scales,
                             [](const Vec3& scale) { return std::abs(scale.y - scale.z) < negligible; });
}

// Whether the stretch can be told in these axes as well as in its own fixed ones.
bool fitsAxes(const StretchKeys& stretch, const Quat& axes) {
  constexpr double negligibleRadians = 1e-6;
  const auto sameDirection = [&](const Vec3& v) {
    return angleBetween(stretch.axes.front() * v, axes * v) < negligibleRadians;
  };
  return stretch.axisIsFixed() && sameDirection(Vec3(1, 0, 0)) &&
         (hasOneAxis(stretch) || sameDirection(Vec3(0, 1, 0)));
}

std::vector<Leaf> leavesOf(const Scene& scene, const std::vector<ClipStretches>& clips) {
  std::map<NodeIndex, Leaf> leaves;
  for (const ClipStretches& clip : clips) {
    for (const StretchKeys& stretch : clip.stretches) {
      Leaf& leaf = leaves.try_emplace(stretch.node, newLeaf(scene, stretch)).first->second;
      leaf.axisIsFixed = leaf.axisIsFixed && fitsAxes(stretch, leaf.axis);
    }
  }
  std::vector<Leaf> ordered;
  for (auto& [node, leaf] : leaves) {
    const Node& holder = scene.nodes[at(node)];
    leaf.turnsBack = !leaf.axisIsFixed || (holder.mesh >= 0 && holder.skin < 0);
    ordered.push_back(leaf);
  }
  return ordered;
}

bool deformsAnything(const Scene& scene, NodeIndex node) {
  const Node& holder = scene.nodes[at(node)];
  return (holder.mesh >= 0 && holder.skin < 0) ||
         std::any_of(scene.skins.begin(), scene.skins.end(), [&](const Skin& skin) {
           return std::find(skin.joints.begin(), skin.joints.end(), node) != skin.joints.end();
         });
}

void addNodes(const Scene& scene, Leaf& leaf, gltf::Edits& edits) {
  const Node& holder = scene.nodes[at(leaf.node)];
  const auto nextIndex = [&] { return NodeIndex(scene.nodes.size() + edits.addedNodes.size()); };
  if (leaf.made != nullptr) {
    leaf.bindNode = leaf.made->leaf;
    leaf.endNode = leaf.made->lastLeaf();
  } else {
    leaf.bindNode = nextIndex();
    leaf.endNode = leaf.bindNode;
    gltf::AddedNode bind;
    bind.name = holder.name + "_bind";
    bind.parent = leaf.node;
    bind.rest.rotation = leaf.axis;
    edits.addedNodes.push_back(bind);
  }
  if (leaf.turnsBack && leaf.endNode == leaf.bindNode) {
    leaf.endNode = nextIndex();
    gltf::AddedNode end;
    end.name = holder.name + "_bind_end";
    end.parent = leaf.bindNode;
    end.rest.rotation = glm::inverse(leaf.axis);
    end.meshFrom = holder.mesh >= 0 && holder.skin < 0 ? leaf.node : NodeIndex::none;
    edits.addedNodes.push_back(end);
  }
}

void moveSkinSlots(const Scene& scene, const Leaf& leaf, gltf::Edits& edits) {
  if (leaf.made != nullptr && leaf.made->lastLeaf() == leaf.endNode) {
    return; // they follow it already
  }
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    const Skin& skin = scene.skins[s];
    for (std::size_t slot = 0; slot < skin.joints.size(); ++slot) {
      if (skin.joints[slot] == leaf.node) {
        const Mat4 inverseBind = leaf.turnsBack
                                     ? skin.inverseBind[slot]
                                     : glm::mat4_cast(glm::inverse(leaf.axis)) * skin.inverseBind[slot];
        edits.skinSlots.push_back({static_cast<int>(s), static_cast<int>(slot), leaf.endNode, inverseBind});
      }
    }
  }
}

Track rotationTrack(NodeIndex node, const std::vector<float>& times, const std::vector<Quat>& turns) {
  Track track;
  track.node = node;
  track.channel = Channel::rotation;
  track.width = 4;
  Quat before = turns.front();
  track.times = times;
  for (std::size_t i = 0; i < times.size(); ++i) {
    Quat turn = turns.size() == 1 ? turns.front() : turns[i];
    turn = glm::dot(before, turn) < 0.0 ? -turn : turn;
    before = turn;
    for (const double number : {turn.x, turn.y, turn.z, turn.w}) {
      track.values.push_back(static_cast<float>(number));
    }
  }
  return track;
}

std::vector<Quat> inverses(const std::vector<Quat>& turns) {
  std::vector<Quat> result;
  std::transform(turns.begin(), turns.end(), std::back_inserter(result),
                 [](const Quat& q) { return glm::inverse(q); });
  return result;
}

void addTracks(const Leaf& leaf, const StretchKeys& stretch, std::vector<Track>& tracks) {
  Track scale;
  scale.node = leaf.bindNode;
  scale.channel = Channel::scale;
  scale.times = stretch.times;
  for (const Vec3& factors : stretch.scales) {
    for (const double number : {factors.x, factors.y, factors.z}) {
      scale.values.push_back(static_cast<float>(number));
    }
  }
  tracks.push_back(std::move(scale));
  if (!leaf.axisIsFixed) {
    tracks.push_back(rotationTrack(leaf.bindNode, stretch.times, stretch.axes));
    tracks.push_back(rotationTrack(leaf.endNode, stretch.times, inverses(stretch.axes)));
  }
}

} // namespace

std::vector<Track>& tracksOf(int clip, gltf::Edits& edits) {
  const auto found =
      std::ranges::find_if(edits.clips, [&](const gltf::ClipTracks& c) { return c.clip == clip; });
  if (found != edits.clips.end()) {
    return found->tracks;
  }
  edits.clips.push_back({clip, {}});
  return edits.clips.back().tracks;
}

void addBindLeaves(const Scene& scene, const std::vector<ClipStretches>& clips, gltf::Edits& edits) {
  for (Leaf& leaf : leavesOf(scene, clips)) {
    if (!deformsAnything(scene, leaf.node)) {
      continue;
    }
    addNodes(scene, leaf, edits);
    moveSkinSlots(scene, leaf, edits);
    for (const ClipStretches& clip : clips) {
      for (const StretchKeys& stretch : clip.stretches) {
        if (stretch.node == leaf.node) {
          addTracks(leaf, stretch, tracksOf(clip.clip, edits));
        }
      }
    }
  }
}

} // namespace stretch::rig
