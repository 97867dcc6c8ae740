#include "app/batch/extension_report.h"

#include <fmt/core.h>

#include "core/gltf/json/json.h"

namespace stretch::app {

using gltf::Json;

Json extensionsJson(const std::vector<gltf::ExtensionUse>& extensions) {
  Json list = Json::array();
  for (const gltf::ExtensionUse& use : extensions) {
    list.push_back({{"name", use.name},
                    {"required", use.isRequired},
                    {"shown", use.support == gltf::ExtensionSupport::read}});
  }
  return list;
}

std::string extensionLine(const Json& extension) {
  const bool isShown = extension["shown"].get<bool>();
  const bool isRequired = extension["required"].get<bool>();
  return fmt::format("extension {}{}: {}", extension["name"].get<std::string>(),
                     isRequired ? " (required)" : "", isShown ? "read" : "kept in the file, not shown");
}

} // namespace stretch::app
