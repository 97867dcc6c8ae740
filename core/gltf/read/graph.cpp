#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/core.h>

#include "core/gltf/json/json.h"
#include "core/gltf/read/structure.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

// Parent of every node; a second parent is an error and left out.
std::vector<int> parentsOf(const Json& json, Problems& problems) {
  const std::size_t count = sizeOf(json, "nodes");
  std::vector<int> parents(count, -1);
  for (std::size_t node = 0; node < count; ++node) {
    for (const int child : indicesOf(element(json, "nodes", node), "children")) {
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent >= 0) {
        problems.error(at("nodes", static_cast<std::size_t>(child)),
                       fmt::format("has two parents, nodes[{}] and nodes[{}]", parent, node));
      } else {
        parent = static_cast<int>(node);
      }
    }
  }
  return parents;
}

// Each node has one parent, so a loop is a walk upwards that meets itself. States: 0 not seen, 1 on this
// walk, 2 done.
void validateLoops(const std::vector<int>& parents, Problems& problems) {
  std::vector<int> state(parents.size(), 0);
  for (std::size_t start = 0; start < parents.size(); ++start) {
    int node = static_cast<int>(start);
    while (node >= 0 && state[static_cast<std::size_t>(node)] == 0) {
      state[static_cast<std::size_t>(node)] = 1;
      node = parents[static_cast<std::size_t>(node)];
    }
    if (node >= 0 && state[static_cast<std::size_t>(node)] == 1) {
      problems.error(at("nodes", static_cast<std::size_t>(node)), "is its own ancestor");
    }
    for (int done = static_cast<int>(start); done >= 0 && state[static_cast<std::size_t>(done)] == 1;
         done = parents[static_cast<std::size_t>(done)]) {
      state[static_cast<std::size_t>(done)] = 2;
    }
  }
}

void validateScenes(const Json& json, const std::vector<int>& parents, Problems& problems) {
  for (std::size_t scene = 0; scene < sizeOf(json, "scenes"); ++scene) {
    for (const int node : indicesOf(element(json, "scenes", scene), "nodes")) {
      if (parents[static_cast<std::size_t>(node)] >= 0) {
        problems.error(at("scenes", scene), fmt::format("lists nodes[{}], which has a parent", node));
      }
    }
  }
}

// A viewer computes in single precision.
void validateSizes(const Json& node, const std::string& place, Problems& problems) {
  constexpr double largest = std::numeric_limits<float>::max();
  for (const char* key : {"translation", "scale", "matrix"}) {
    for (const double number : numbersOf(node, key)) {
      if (std::abs(number) > largest) {
        problems.error(place + "." + key,
                       fmt::format("holds {}, which is too large for single precision", number));
        return;
      }
    }
  }
}

void validateTransforms(const Json& json, Problems& problems) {
  for (std::size_t i = 0; i < sizeOf(json, "nodes"); ++i) {
    const Json& node = element(json, "nodes", i);
    const bool hasParts = find(node, "translation") != nullptr || find(node, "rotation") != nullptr ||
                          find(node, "scale") != nullptr;
    if (find(node, "matrix") != nullptr && hasParts) {
      problems.error(at("nodes", i), "has both a matrix and translation, rotation or scale");
    }
    validateSizes(node, at("nodes", i), problems);
    const std::vector<double> rotation = numbersOf(node, "rotation");
    const double square = std::inner_product(rotation.begin(), rotation.end(), rotation.begin(), 0.0);
    if (!rotation.empty() && std::abs(square - 1.0) > 1e-2) {
      problems.violation(at("nodes", i) + ".rotation", "is no unit quaternion", "it is normalised");
    }
  }
}

// Nodes are walked through once, however deep they hang.
bool isAncestorOfAll(const std::vector<int>& parents, int ancestor, const std::vector<int>& joints) {
  std::vector<bool> isBelow(parents.size(), false);
  isBelow[static_cast<std::size_t>(ancestor)] = true;
  return std::ranges::all_of(joints, [&](int joint) {
    int above = joint;
    while (above >= 0 && !isBelow[static_cast<std::size_t>(above)]) {
      above = parents[static_cast<std::size_t>(above)];
    }
    for (int node = joint; node != above && above >= 0; node = parents[static_cast<std::size_t>(node)]) {
      isBelow[static_cast<std::size_t>(node)] = true;
    }
    return above >= 0;
  });
}

void validateSkins(const Json& json, const std::vector<int>& parents, Problems& problems) {
  for (std::size_t i = 0; i < sizeOf(json, "skins"); ++i) {
    const Json& skin = element(json, "skins", i);
    const std::vector<int> joints = indicesOf(skin, "joints");
    if (joints.empty()) {
      problems.error(at("skins", i) + ".joints", "is empty");
    }
    const int skeleton = indexOr(skin, "skeleton");
    if (skeleton >= 0 && !isAncestorOfAll(parents, skeleton, joints)) {
      problems.warning(at("skins", i) + ".skeleton", "is no common ancestor of the joints; it is not used");
    }
  }
}

} // namespace

void validateGraph(const Json& json, Problems& problems) {
  const std::vector<int> parents = parentsOf(json, problems);
  validateLoops(parents, problems);
  validateScenes(json, parents, problems);
  validateTransforms(json, problems);
  if (!problems.hasErrors()) {
    validateSkins(json, parents, problems);
  }
}

} // namespace stretch::gltf
