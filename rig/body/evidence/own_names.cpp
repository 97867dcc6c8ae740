#include "rig/body/evidence/own_names.h"

#include <map>
#include <string_view>

#include "rig/body/evidence/name_text.h"

namespace stretch::rig::body {

namespace {

constexpr std::size_t fewestJoints = 5;
constexpr double nearlyAll = 0.9;             // of the joints
constexpr std::size_t longestBeginning = 256; // bytes

// Of a file without skins: every node may be a joint.
std::vector<NodeIndex> jointsOf(const Scene& scene) {
  const std::set<NodeIndex> joints = skinJoints(scene);
  if (joints.empty()) {
    return parentsFirst(scene);
  }
  return {joints.begin(), joints.end()};
}

// Joints that carry half of all: the trunk, down to where its limbs part.
std::vector<NodeIndex> trunkOf(const Scene& scene, const std::vector<NodeIndex>& joints) {
  std::vector<std::size_t> below(scene.nodes.size(), 0);
  for (const NodeIndex joint : joints) {
    below[at(joint)] = 1;
  }
  const std::vector<NodeIndex> order = parentsFirst(scene);
  for (auto lowest = order.rbegin(); lowest != order.rend(); ++lowest) {
    if (const NodeIndex parent = scene.nodes[at(*lowest)].parent; parent.exists()) {
      below[at(parent)] += below[at(*lowest)];
    }
  }
  std::vector<NodeIndex> trunk;
  std::ranges::copy_if(joints, std::back_inserter(trunk),
                       [&](NodeIndex joint) { return 2 * below[at(joint)] >= joints.size(); });
  return trunk;
}

// How many of the joints' names begin with each row of parts that is not a whole name.
std::map<std::string_view, std::size_t> countBeginnings(const Scene& scene,
                                                        const std::vector<NodeIndex>& joints) {
  std::map<std::string_view, std::size_t> count;
  for (const NodeIndex joint : joints) {
    const std::string_view name = scene.nodes[at(joint)].name;
    for (const std::size_t start : partStarts(name.substr(0, longestBeginning))) {
      ++count[name.substr(0, start)];
    }
  }
  return count;
}

std::string_view sharedBeginning(const Scene& scene) {
  const std::vector<NodeIndex> joints = jointsOf(scene);
  if (joints.size() < fewestJoints) {
    return {};
  }
  const std::vector<NodeIndex> trunk = trunkOf(scene, joints);
  const std::map<std::string_view, std::size_t> ofTrunk = countBeginnings(scene, trunk);
  std::string_view longest;
  for (const auto& [beginning, count] : countBeginnings(scene, joints)) {
    const bool isShared = static_cast<double>(count) >= nearlyAll * static_cast<double>(joints.size());
    const auto here = ofTrunk.find(beginning);
    const bool isOfTrunk = here != ofTrunk.end() && 2 * here->second >= trunk.size();
    longest = isShared && isOfTrunk && beginning.size() > longest.size() ? beginning : longest;
  }
  return longest;
}

} // namespace

std::vector<std::string> ownNames(const Scene& scene) {
  const std::string_view shared = sharedBeginning(scene);
  std::vector<std::string> names;
  names.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) {
    const bool goesOn = node.name.size() > shared.size() && node.name.starts_with(shared);
    names.push_back(goesOn ? node.name.substr(shared.size()) : node.name);
  }
  return names;
}

} // namespace stretch::rig::body
