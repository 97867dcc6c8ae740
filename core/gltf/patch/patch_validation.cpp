#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/patch_parts.h"
#include "core/gltf/source/fields.h"
#include "core/math/finite.h"

namespace stretch::gltf {

namespace {

Error unfit(std::string what) {
  return {"an edit does not fit the file: " + what, "", "report this as a fault of the program"};
}

bool hasFiniteNumbers(const Transform& rest) {
  const double sum = rest.translation.x + rest.translation.y + rest.translation.z + rest.rotation.x +
                     rest.rotation.y + rest.rotation.z + rest.rotation.w + rest.scale.x + rest.scale.y +
                     rest.scale.z;
  return std::isfinite(sum);
}

bool allFinite(const std::vector<float>& values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

bool isIndex(int index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

Status validateNodes(const Json& json, const std::vector<AddedNode>& nodes) {
  const std::size_t sourceCount = sizeOf(json, "nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const AddedNode& node = nodes[i];
    const bool hasParent = node.parent == NodeIndex::none || isIndex(node.parent.value, sourceCount + i);
    const bool hasMesh = node.meshFrom == NodeIndex::none || isIndex(node.meshFrom.value, sourceCount);
    if (!hasParent || !hasMesh || !hasFiniteNumbers(node.rest)) {
      return unfit(fmt::format("added node '{}'", node.name));
    }
  }
  return Success{};
}

Status validateSlots(const Json& json, const Edits& edits) {
  const std::size_t nodes = sizeOf(json, "nodes") + edits.addedNodes.size();
  for (const SkinSlot& slot : edits.skinSlots) {
    const bool hasSkin = isIndex(slot.skin, sizeOf(json, "skins"));
    const bool hasSlot =
        hasSkin &&
        isIndex(slot.slot, sizeOf(element(json, "skins", static_cast<std::size_t>(slot.skin)), "joints"));
    if (!hasSlot || !isIndex(slot.node.value, nodes) || !isFinite(slot.inverseBind)) {
      return unfit(fmt::format("slot {} of skin {}", slot.slot, slot.skin));
    }
  }
  for (const AddedSlot& slot : edits.addedSlots) {
    if (!isIndex(slot.skin, sizeOf(json, "skins")) || !isIndex(slot.node.value, nodes) ||
        !isFinite(slot.inverseBind)) {
      return unfit(fmt::format("a joint that skin {} gets", slot.skin));
    }
  }
  return Success{};
}

Status validateMoved(const Json& json, const Edits& edits) {
  for (const MovedNode& moved : edits.movedNodes) {
    if (!isIndex(moved.node.value, sizeOf(json, "nodes")) || !isFinite(toMatrix(moved.rest))) {
      return unfit(fmt::format("the new place of node {}", moved.node.value));
    }
  }
  return Success{};
}

Status validateSkins(const Json& json, const Edits& edits) {
  const std::size_t nodes = sizeOf(json, "nodes") + edits.addedNodes.size();
  for (const AddedSkin& skin : edits.addedSkins) {
    const bool isSound =
        !skin.joints.empty() && skin.joints.size() == skin.inverseBind.size() &&
        std::ranges::all_of(skin.joints, [&](NodeIndex joint) { return isIndex(joint.value, nodes); }) &&
        std::ranges::all_of(skin.inverseBind, [](const Mat4& matrix) { return isFinite(matrix); });
    if (!isSound) {
      return unfit(fmt::format("added skin '{}'", skin.name));
    }
  }
  return Success{};
}

std::size_t jointCount(const Json& json, const Edits& edits, int skin) {
  const auto index = static_cast<std::size_t>(skin);
  const std::size_t ofSource = sizeOf(json, "skins");
  if (index >= ofSource) {
    return edits.addedSkins[index - ofSource].joints.size();
  }
  return sizeOf(element(json, "skins", index), "joints") +
         static_cast<std::size_t>(std::ranges::count(edits.addedSlots, skin, &AddedSlot::skin));
}

bool nameJoints(const std::vector<VertexInfluences>& vertices, std::size_t joints) {
  return std::ranges::all_of(vertices, [&](const VertexInfluences& vertex) {
    return std::ranges::all_of(vertex.joints, [&](std::uint16_t joint) { return joint < joints; }) &&
           std::ranges::all_of(vertex.weights, [](float weight) { return std::isfinite(weight); });
  });
}

bool fitsMesh(const Json& json, const Json& mesh, std::size_t joints, const BoundMesh& bound) {
  std::size_t shown = 0;
  for (std::size_t i = 0; i < sizeOf(mesh, "primitives"); ++i) {
    const Json& primitive = element(mesh, "primitives", i);
    if (!holdsTriangles(primitive)) {
      continue;
    }
    const auto accessor = static_cast<std::size_t>(indexOr(*find(primitive, "attributes"), "POSITION"));
    if (shown == bound.influences.size() || !nameJoints(bound.influences[shown], joints) ||
        bound.influences[shown].size() != wholeOr(element(json, "accessors", accessor), "count", 0)) {
      return false;
    }
    ++shown;
  }
  return shown == bound.influences.size();
}

// What is not read of a mesh is lost, or stays behind, where the influences of the rest are divided.
Status canDivide(const Json& mesh, std::size_t index) {
  const std::map<int, std::size_t> triangles = trianglesByPlaces(mesh);
  for (std::size_t i = 0; i < sizeOf(mesh, "primitives"); ++i) {
    const Json& primitive = element(mesh, "primitives", i);
    const Json* const places = findPath(primitive, {"attributes", "POSITION"});
    const bool follows = holdsTriangles(primitive) || places == nullptr ||
                         triangles.contains(static_cast<int>(*wholeNumber(*places)));
    const bool isRead = findPath(primitive, {"attributes", "JOINTS_2"}) == nullptr;
    if (!follows || !isRead) {
      return Error{follows ? "has vertices that follow more than 8 joints, and would lose the others"
                           : "holds points or lines that would stay behind",
                   fmt::format("meshes[{}].primitives[{}]", index, i),
                   "save the stretch in another form: --form scale"};
    }
  }
  return Success{};
}

Status validateBound(const Json& json, const Edits& edits) {
  const std::size_t skins = sizeOf(json, "skins") + edits.addedSkins.size();
  for (const BoundMesh& bound : edits.boundMeshes) {
    const std::size_t nodes = sizeOf(json, "nodes");
    const bool isAdded = isIndex(bound.node.value - static_cast<int>(nodes), edits.addedNodes.size());
    const NodeIndex holder = isAdded ? edits.addedNodes[at(bound.node) - nodes].meshFrom : bound.node;
    const bool isThere = isIndex(holder.value, nodes) && isIndex(bound.skin, skins);
    const int mesh = isThere ? indexOr(element(json, "nodes", at(holder)), "mesh") : -1;
    if (!isIndex(mesh, sizeOf(json, "meshes")) ||
        !fitsMesh(json, element(json, "meshes", static_cast<std::size_t>(mesh)),
                  jointCount(json, edits, bound.skin), bound)) {
      return unfit(fmt::format("the binding of node {}", bound.node.value));
    }
    const auto index = static_cast<std::size_t>(mesh);
    if (Status whole = bound.divides ? canDivide(element(json, "meshes", index), index) : Success{}; !whole) {
      return whole;
    }
  }
  return Success{};
}

bool isWellFormed(const Track& track) {
  const std::size_t perKey = track.interpolation == Interpolation::cubicSpline ? 3 : 1;
  const int vectorWidth = track.channel == Channel::rotation ? 4 : 3;
  const bool hasWidth = track.channel == Channel::weights ? track.width > 0 : track.width == vectorWidth;
  return hasWidth && !track.times.empty() &&
         track.values.size() == track.times.size() * perKey * static_cast<std::size_t>(track.width) &&
         allFinite(track.times) && allFinite(track.values) &&
         std::adjacent_find(track.times.begin(), track.times.end(), std::greater_equal<>()) ==
             track.times.end();
}

Status validateClips(const Json& json, const Edits& edits) {
  const std::size_t nodes = sizeOf(json, "nodes") + edits.addedNodes.size();
  for (const ClipTracks& clip : edits.clips) {
    if (!isIndex(clip.clip, sizeOf(json, "animations"))) {
      return unfit(fmt::format("clip {}", clip.clip));
    }
    for (const Track& track : clip.tracks) {
      if (!isIndex(track.node.value, nodes) || !isWellFormed(track)) {
        return unfit(fmt::format("a track of node {} in clip {}", track.node.value, clip.clip));
      }
    }
  }
  return Success{};
}

} // namespace

Status validateEdits(const Source& source, const Edits& edits) {
  for (const Status& status :
       {validateNodes(source.json, edits.addedNodes), validateMoved(source.json, edits),
        validateSlots(source.json, edits), validateSkins(source.json, edits),
        validateBound(source.json, edits), validateClips(source.json, edits)}) {
    if (!status) {
      return status;
    }
  }
  return Success{};
}

} // namespace stretch::gltf
