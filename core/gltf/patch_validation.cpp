#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/gltf/fields.h"
#include "core/gltf/json.h"
#include "core/gltf/patch_parts.h"
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
  return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
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
  for (const Status& status : {validateNodes(source.json, edits.addedNodes),
                               validateSlots(source.json, edits), validateClips(source.json, edits)}) {
    if (!status) {
      return status;
    }
  }
  return Success{};
}

} // namespace stretch::gltf
