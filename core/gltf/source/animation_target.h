#pragma once

#include <string>

#include "core/gltf/json/json.h"
#include "core/scene/node_index.h"

namespace stretch::gltf {

/// Node and property that a channel of an animation drives.
struct AnimationTarget {
  NodeIndex node;   ///< None: nothing of a node.
  std::string path; ///< "translation" and so on; of a pointer to something else the pointer itself.
  bool isPointer = false;
};

/// Reads the target of a channel, by KHR_animation_pointer too: "/nodes/3/rotation" is the rotation of
/// node 3.
[[nodiscard]] AnimationTarget animationTarget(const Json& target);

} // namespace stretch::gltf
