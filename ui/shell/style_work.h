#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/auto/exaggerate_clip.h"
#include "app/commands/table/command.h"
#include "app/sequence/job.h"
#include "rig/trail/trail.h"

namespace stretch::ui {

struct Shell;
struct TrailPanels;

/// A clip that is exaggerated in a style beside the window.
struct StyleWork {
  std::unique_ptr<app::Job<app::AutoClip>> job; ///< Null: none is being made.
  bool begun = false;                           ///< The session shows what comes of it.
  std::vector<rig::Trail> kept = {};            ///< Trails that were made and kept, as they were.
};

/// "Exaggerate the clip", and taking, importing and exporting styles.
[[nodiscard]] std::vector<app::Command<Shell>> styleCommands();

/// Offers the styles of the user's folder with those that the program brings along.
void loadStyles(TrailPanels& panels);

/// Drops what is shown and closes the dialog: another file is about to be opened.
void closeClipStyle(Shell& shell);

/// Once per frame: works out what the dialog asks for, shows it, and keeps or drops it as one step.
void updateClipStyle(Shell& shell);

/// The style that the dialog has chosen.
[[nodiscard]] const rig::Style& chosenStyle(const Shell& shell);

/// Takes a style from a file into the user's own, and chooses it; writes the chosen one.
void importStyle(Shell& shell, const std::filesystem::path& path);
void exportStyle(Shell& shell, const std::filesystem::path& path);

} // namespace stretch::ui
