#include "ui/panels/files/welcome_entries.h"

#include <algorithm>

namespace stretch::ui {

std::vector<WelcomeEntry> welcomeEntries(const UiState& ui) {
  constexpr std::size_t recentShown = 5;
  std::vector<WelcomeEntry> entries;
  for (const app::BundledClip& clip : app::bundledClips()) {
    entries.push_back({WelcomeEntry::Kind::bundled, &clip});
  }
  entries.push_back({WelcomeEntry::Kind::dialog});
  const std::size_t count = std::min(recentShown, ui.recentFiles.size());
  for (std::size_t i = 0; i < count; ++i) {
    entries.push_back({WelcomeEntry::Kind::recent, nullptr, ui.recentFiles[i]});
  }
  return entries;
}

} // namespace stretch::ui
