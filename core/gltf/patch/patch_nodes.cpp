#include <algorithm>
#include <set>
#include <vector>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/patch_parts.h"
#include "core/gltf/source/animation_target.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

using Pointer = Json::json_pointer;

Json nodeJson(const AddedNode& node) {
  Json json = Json::object();
  if (!node.name.empty()) {
    json["name"] = node.name;
  }
  const Transform identity;
  if (node.rest.translation != identity.translation) {
    json["translation"] = {node.rest.translation.x, node.rest.translation.y, node.rest.translation.z};
  }
  if (node.rest.rotation != identity.rotation) {
    const Quat q = glm::normalize(node.rest.rotation);
    json["rotation"] = {q.x, q.y, q.z, q.w};
  }
  if (node.rest.scale != identity.scale) {
    json["scale"] = {node.rest.scale.x, node.rest.scale.y, node.rest.scale.z};
  }
  if (node.isBindLeaf) {
    json["extras"] = {{"stretch_engine", {{"bind", true}}}};
    if (node.isBindCorner) {
      json["extras"]["stretch_engine"]["corner"] = true;
    }
  }
  return json;
}

// Channels that drive the morph weights of a node follow its mesh.
void moveWeightChannels(std::size_t from, std::size_t to, Journal& journal) {
  for (std::size_t clip = 0; clip < sizeOf(journal.json(), "animations"); ++clip) {
    const Json& animation = element(journal.json(), "animations", clip);
    for (std::size_t i = 0; i < sizeOf(animation, "channels"); ++i) {
      const AnimationTarget driven = animationTarget(*find(element(animation, "channels", i), "target"));
      if (driven.path != "weights" || driven.node != NodeIndex(from)) {
        continue;
      }
      const Pointer target = Pointer("/animations") / clip / "channels" / i / "target";
      if (driven.isPointer) {
        journal.set(target / "extensions" / "KHR_animation_pointer" / "pointer",
                    "/nodes/" + std::to_string(to) + "/weights");
      } else {
        journal.set(target / "node", to);
      }
    }
  }
}

// VRM 1.0 refers to the nodes of meshes: where they are visible in first person, and the morph targets of
// expressions.
void moveVrmReferences(const Pointer& list, std::size_t from, std::size_t to, Journal& journal) {
  const std::size_t count = journal.json().contains(list) ? journal.json().at(list).size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (indexOr(journal.json().at(list / i), "node") == static_cast<int>(from)) {
      journal.set(list / i / "node", to);
    }
  }
}

void moveVrmMesh(std::size_t from, std::size_t to, Journal& journal) {
  const Pointer vrm("/extensions/VRMC_vrm");
  moveVrmReferences(vrm / "firstPerson" / "meshAnnotations", from, to, journal);
  for (const char* group : {"preset", "custom"}) {
    const Json* found = findPath(journal.json(), {"extensions", "VRMC_vrm", "expressions", group});
    if (found == nullptr || !found->is_object()) {
      continue;
    }
    const Json expressions = *found; // a copy: the journal changes what it came from
    for (const auto& [name, expression] : expressions.items()) {
      moveVrmReferences(vrm / "expressions" / group / name / "morphTargetBinds", from, to, journal);
    }
  }
}

void moveMesh(std::size_t from, std::size_t to, Journal& journal) {
  const Pointer source = Pointer("/nodes") / from;
  const Pointer target = Pointer("/nodes") / to;
  for (const char* property : {"mesh", "weights"}) {
    if (const Json* value = find(journal.json().at(source), property)) {
      journal.set(target / property, Json(*value));
      journal.erase(source / property);
    }
  }
  constexpr const char* instances = "EXT_mesh_gpu_instancing"; // of the mesh
  if (const Json* const value = findPath(journal.json().at(source), {"extensions", instances})) {
    const bool isAlone = journal.json().at(source / "extensions").size() == 1;
    journal.set(target / "extensions", Json{{instances, *value}});
    journal.erase(isAlone ? source / "extensions" : source / "extensions" / instances);
  }
  moveWeightChannels(from, to, journal);
  moveVrmMesh(from, to, journal);
}

// The topmost node above one, or itself.
std::size_t topOf(const Json& json, std::size_t node) {
  std::vector<int> parents(sizeOf(json, "nodes"), -1);
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const Json& parent = element(json, "nodes", i);
    for (std::size_t k = 0; k < sizeOf(parent, "children"); ++k) {
      parents[element(parent, "children", k).get<std::size_t>()] = static_cast<int>(i);
    }
  }
  while (parents[node] >= 0) {
    node = static_cast<std::size_t>(parents[node]);
  }
  return node;
}

// A node that hangs on none goes into the scene that is shown; one that takes over a mesh, into all that show
// the mesh.
void attach(const AddedNode& node, std::size_t child, Journal& journal) {
  if (node.parent.exists()) {
    journal.append(Pointer("/nodes") / at(node.parent) / "children", child);
    return;
  }
  const int shown = indexOr(journal.json(), "scene", 0);
  const Json top = node.meshFrom.exists() ? Json(topOf(journal.json(), at(node.meshFrom))) : Json();
  for (std::size_t i = 0; i < sizeOf(journal.json(), "scenes"); ++i) {
    const Json* const tops = find(element(journal.json(), "scenes", i), "nodes");
    const bool showsMesh = tops != nullptr && std::ranges::find(*tops, top) != tops->end();
    if (top.is_null() ? static_cast<int>(i) == shown : showsMesh) {
      journal.append(Pointer("/scenes") / i / "nodes", child);
    }
  }
}

} // namespace

void patchNodes(const std::vector<AddedNode>& nodes, Journal& journal) {
  for (const AddedNode& node : nodes) {
    const std::size_t index = journal.append(Pointer("/nodes"), nodeJson(node));
    if (node.meshFrom.exists()) {
      moveMesh(at(node.meshFrom), index, journal);
    }
    attach(node, index, journal);
  }
}

void showJoints(std::size_t skin, NodeIndex node, Journal& journal) {
  const std::size_t scenes = sizeOf(journal.json(), "scenes");
  if (scenes < 2) {
    return;
  }
  std::set<int> tops;
  for (const int joint : indicesOf(element(journal.json(), "skins", skin), "joints")) {
    tops.insert(static_cast<int>(topOf(journal.json(), at(NodeIndex(joint)))));
  }
  const auto top = static_cast<int>(topOf(journal.json(), at(node)));
  for (std::size_t i = 0; i < scenes; ++i) {
    const std::vector<int> shown = indicesOf(element(journal.json(), "scenes", i), "nodes");
    for (const int other : tops) {
      if (std::ranges::find(shown, top) != shown.end() && std::ranges::find(shown, other) == shown.end()) {
        journal.append(Pointer("/scenes") / i / "nodes", other);
      }
    }
  }
}

void moveNodes(const std::vector<MovedNode>& nodes, Journal& journal) {
  for (const MovedNode& moved : nodes) {
    const Pointer node = Pointer("/nodes") / at(moved.node);
    const Transform& rest = moved.rest;
    if (journal.json().at(node).contains("matrix")) {
      journal.erase(node / "matrix");
      journal.set(node / "scale", {rest.scale.x, rest.scale.y, rest.scale.z});
    }
    const Quat turn = glm::normalize(rest.rotation);
    journal.set(node / "translation", {rest.translation.x, rest.translation.y, rest.translation.z});
    journal.set(node / "rotation", {turn.x, turn.y, turn.z, turn.w});
  }
}

} // namespace stretch::gltf
