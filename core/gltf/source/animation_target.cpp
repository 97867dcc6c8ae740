#include "core/gltf/source/animation_target.h"

#include "core/base/number.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

AnimationTarget animationTarget(const Json& target) {
  AnimationTarget driven{NodeIndex(indexOr(target, "node")), textOr(target, "path"), false};
  const Json* extension = findPath(target, {"extensions", "KHR_animation_pointer"});
  if (driven.path != "pointer" || extension == nullptr || !extension->is_object()) {
    return driven;
  }
  driven = {NodeIndex::none, textOr(*extension, "pointer"), true};
  constexpr std::string_view nodes = "/nodes/";
  const std::string_view pointer = driven.path;
  const std::size_t slash = pointer.find('/', nodes.size());
  if (!pointer.starts_with(nodes) || slash == std::string_view::npos) {
    return driven;
  }
  const std::string_view property = pointer.substr(slash + 1);
  const auto node = parseNumber<int>(pointer.substr(nodes.size(), slash - nodes.size()));
  if (node && *node >= 0 &&
      (property == "translation" || property == "rotation" || property == "scale" || property == "weights")) {
    return {NodeIndex(*node), std::string(property), true};
  }
  return driven;
}

} // namespace stretch::gltf
