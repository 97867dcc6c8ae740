#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/anim/clip.h"

namespace stretch {

// Channels and interpolations by the names that glTF has for them.

namespace detail {
// In the order of the enumerations.
inline constexpr std::array channelNames{"translation", "rotation", "scale", "weights"};
inline constexpr std::array interpolationNames{"STEP", "LINEAR", "CUBICSPLINE"};

template <typename Kind, typename Names>
[[nodiscard]] std::optional<Kind> kindNamed(const Names& names, std::string_view name) {
  const auto found =
      std::ranges::find(names, name, [](const char* known) { return std::string_view(known); });
  return found == names.end() ? std::nullopt : std::optional(static_cast<Kind>(found - names.begin()));
}
} // namespace detail

[[nodiscard]] inline const char* nameOf(Channel channel) {
  return detail::channelNames.at(static_cast<std::size_t>(channel));
}

[[nodiscard]] inline const char* nameOf(Interpolation interpolation) {
  return detail::interpolationNames.at(static_cast<std::size_t>(interpolation));
}

/// Nothing for another name.
[[nodiscard]] inline std::optional<Channel> channelNamed(std::string_view name) {
  return detail::kindNamed<Channel>(detail::channelNames, name);
}

/// Nothing for another name.
[[nodiscard]] inline std::optional<Interpolation> interpolationNamed(std::string_view name) {
  return detail::kindNamed<Interpolation>(detail::interpolationNames, name);
}

} // namespace stretch
