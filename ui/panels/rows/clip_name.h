#pragma once

#include <cstddef>
#include <string>

namespace stretch::ui {

/// Name of the clip at this place among its file's; its number, from 1, where it has none.
[[nodiscard]] inline std::string clipName(const std::string& name, std::size_t index) {
  return name.empty() ? "Clip " + std::to_string(index + 1) : name;
}

} // namespace stretch::ui
