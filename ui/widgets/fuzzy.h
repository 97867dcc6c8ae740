#pragma once

#include <optional>
#include <string_view>

namespace stretch::ui {

/// How well a text answers what was typed: every typed letter in order, case aside; matches at the start of
/// words and beside each other count more. Empty when it does not match; the higher the better. Nothing typed
/// matches everything.
[[nodiscard]] std::optional<int> fuzzyScore(std::string_view typed, std::string_view text);

} // namespace stretch::ui
