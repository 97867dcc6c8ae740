#include <algorithm>

#include <fmt/format.h>

#include "core/base/number.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"
#include "rig/body/reading/limb_assembly.h"

namespace stretch::rig {

namespace {

Error chainError(const std::string& joint, std::string what, std::string remedy) {
  return {std::move(what), "joint \"" + joint + "\"", std::move(remedy)};
}

Result<NodeIndex> nodeByIndex(const Scene& scene, const std::string& joint) {
  const auto index = parseNumber<std::size_t>(std::string_view(joint).substr(1));
  if (!index || *index >= scene.nodes.size()) {
    return chainError(joint, "no node has this index",
                      fmt::format("the file has {} nodes, counted from #0", scene.nodes.size()));
  }
  return NodeIndex(static_cast<int>(*index));
}

std::string indexList(const std::vector<NodeIndex>& nodes) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(nodes.size(), most); ++i) {
    text += fmt::format("{}#{}", i == 0 ? "" : ", ", nodes[i].value);
  }
  return nodes.size() > most ? text + ", ..." : text;
}

bool isJoint(const Scene& scene, NodeIndex node) {
  return std::ranges::any_of(scene.skins, [&](const Skin& skin) {
    return std::ranges::find(skin.joints, node) != skin.joints.end();
  });
}

// Nodes from `top` to above `bottom`, top first; helper nodes that no skin uses are left out where skins say
// what a joint is.
std::vector<NodeIndex> jointsBetween(const Scene& scene, NodeIndex top, NodeIndex bottom) {
  std::vector<NodeIndex> joints;
  for (NodeIndex node = scene.nodes[at(bottom)].parent; node != top; node = scene.nodes[at(node)].parent) {
    if (scene.skins.empty() || isJoint(scene, node)) {
      joints.push_back(node);
    }
  }
  joints.push_back(top);
  std::ranges::reverse(joints);
  return joints;
}

} // namespace

Result<NodeIndex> jointByName(const Scene& scene, const std::string& joint) {
  std::vector<NodeIndex> found;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].name == joint) {
      found.emplace_back(i);
    }
  }
  if (found.empty() && joint.size() > 1 && joint.front() == '#') {
    return nodeByIndex(scene, joint);
  }
  if (found.empty()) {
    return chainError(joint, "no node has this name", "name a node of the file, or give its index as #N");
  }
  // A mesh may share its joint's name: among several nodes the one that a skin uses is meant.
  std::vector<NodeIndex> joints;
  std::ranges::copy_if(found, std::back_inserter(joints), [&](NodeIndex node) {
    return std::ranges::any_of(scene.skins, [&](const Skin& skin) {
      return std::ranges::find(skin.joints, node) != skin.joints.end();
    });
  });
  if (found.size() > 1 && joints.size() != 1) {
    return chainError(joint, "several nodes have this name", "say which one: " + indexList(found));
  }
  return found.size() == 1 ? found.front() : joints.front();
}

Result<Limb> chainLimb(const Scene& scene, const std::string& jointA, const std::string& jointB) {
  const Result<NodeIndex> top = jointByName(scene, jointA);
  if (!top) {
    return top.error();
  }
  const Result<NodeIndex> bottom = jointByName(scene, jointB);
  if (!bottom) {
    return bottom.error();
  }
  if (*top == *bottom) {
    return chainError(jointB, "a chain needs two different joints", "name a joint below the first one");
  }
  if (!isAncestorOrSelf(scene, *top, *bottom)) {
    const bool reversed = isAncestorOrSelf(scene, *bottom, *top);
    return chainError(jointB, "this joint is not below \"" + jointA + "\"",
                      reversed ? "name the upper joint first" : "choose two joints of one chain");
  }
  Limb limb =
      body::makeLimb({}, jointsBetween(scene, *top, *bottom), {.node = *bottom}, bindPoseWorlds(scene));
  if (!body::isSound(limb)) {
    return chainError(jointB, "the chain has no length in the bind pose", "choose joints that stand apart");
  }
  limb.id = jointA + ".." + jointB;
  limb.reasons = {"chosen by hand"};
  return limb;
}

} // namespace stretch::rig
