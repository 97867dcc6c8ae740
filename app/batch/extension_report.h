#pragma once

#include <string>
#include <vector>

#include "core/gltf/read/extensions.h"

namespace stretch::app {

/// [{"name", "required", "shown"}...]
[[nodiscard]] gltf::Json extensionsJson(const std::vector<gltf::ExtensionUse>& extensions);

/// One of them as a line of text.
[[nodiscard]] std::string extensionLine(const gltf::Json& extension);

} // namespace stretch::app
