#pragma once

#include <string_view>

namespace stretch::ui {

/// Text of a file of assets/shaders ("surface.frag"), compiled into the program; empty for an unknown name.
[[nodiscard]] std::string_view shaderSource(std::string_view name);

} // namespace stretch::ui
