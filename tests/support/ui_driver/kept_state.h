#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/shell/shell.h"

namespace stretch::ui {

/// State of what the user keeps beside the work: "selection-sets", "group.name", "poses",
/// "pose-library-open" and "pose-picture" while one is being drawn; "reference-images" and "reference-sound",
/// names of files, "reference-open" and "reference-shown". Nothing for another name. A character is open.
[[nodiscard]] std::optional<std::string> keptState(const Shell& shell, std::string_view name);

} // namespace stretch::ui
