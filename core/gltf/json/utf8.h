#pragma once

#include <string>

namespace stretch::gltf {

/// The text with U+FFFD in the place of what is no UTF-8: as JSON that is written holds it.
[[nodiscard]] std::string asUtf8(const std::string& text);

} // namespace stretch::gltf
