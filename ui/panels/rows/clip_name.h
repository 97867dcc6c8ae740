#pragma once

#include <cstddef>
#include <string>

#include "core/anim/clip.h"

namespace stretch::ui {

/// Name of the clip at this place among the character's; its number where it has none.
[[nodiscard]] inline std::string clipName(const Clip& clip, std::size_t index) {
  return clip.name.empty() ? "Clip " + std::to_string(index) : clip.name;
}

} // namespace stretch::ui
