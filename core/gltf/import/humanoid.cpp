#include <fmt/core.h>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

// VRM 1.0 moved the names of the thumb's bones by one: what 0.x calls proximal is the metacarpal.
std::string modernName(const std::string& name) {
  for (const std::string side : {"left", "right"}) {
    if (name == side + "ThumbProximal") {
      return side + "ThumbMetacarpal";
    }
    if (name == side + "ThumbIntermediate") {
      return side + "ThumbProximal";
    }
  }
  return name;
}

class HumanoidTable {
public:
  HumanoidTable(std::size_t nodeCount, Problems& problems) : nodeCount_(nodeCount), problems_(problems) {}

  void add(const std::string& bone, const Json& entry) {
    const NodeIndex node(indexOr(entry, "node"));
    if (!node.exists() || at(node) >= nodeCount_) {
      problems_.warning("extensions",
                        fmt::format("the humanoid bone '{}' refers to a node that is not there", bone));
      return;
    }
    bones_.emplace(bone, node);
  }

  [[nodiscard]] std::map<std::string, NodeIndex> bones() && { return std::move(bones_); }

private:
  std::size_t nodeCount_;
  Problems& problems_;
  std::map<std::string, NodeIndex> bones_;
};

} // namespace

std::map<std::string, NodeIndex> importHumanoid(const Source& source, Problems& problems) {
  HumanoidTable table(sizeOf(source.json, "nodes"), problems);
  if (const Json* list = findPath(source.json, {"extensions", "VRM", "humanoid", "humanBones"});
      list && list->is_array()) {
    for (const Json& entry : *list) {
      table.add(modernName(textOr(entry, "bone")), entry);
    }
  }
  for (const char* extension : {"VRMC_vrm", "VRMC_vrm_animation"}) {
    const Json* map = findPath(source.json, {"extensions", extension, "humanoid", "humanBones"});
    if (map == nullptr || !map->is_object()) {
      continue;
    }
    for (const auto& [bone, entry] : map->items()) {
      table.add(bone, entry);
    }
  }
  return std::move(table).bones();
}

} // namespace stretch::gltf
