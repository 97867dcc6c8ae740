#pragma once

#include <vector>

#include "app/bundled_files.h"
#include "ui/panels/state/ui_state.h"

namespace stretch::ui {

/// Entry that can be opened while nothing is: a bundled clip, the dialog that asks for a file, or a recent
/// file.
struct WelcomeEntry {
  enum class Kind { bundled, dialog, recent } kind = Kind::bundled;
  const app::BundledClip* clip = nullptr; ///< The bundled clip of such an entry.
  std::filesystem::path file = {};        ///< A recent one.
};

/// In the order in which they are shown.
[[nodiscard]] std::vector<WelcomeEntry> welcomeEntries(const UiState& ui);

} // namespace stretch::ui
