#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/sequence/job.h"

namespace stretch::ui {

struct Shell;

/// A video, or numbered pictures, of what the view shows, drawn beside the window.
struct FilmWork {
  std::unique_ptr<app::Job<std::filesystem::path>> job; ///< Null: none is being made.
  std::filesystem::path path;
  std::string drawn; ///< "frames 21 to 27, beside the original".
};

/// Returns which frames a film of the open clip holds: the range that was set by hand, else the whole clip.
/// "frames 21 to 27, beside the original".
[[nodiscard]] std::string filmedText(const Shell& shell);

/// Draws these frames as the view shows them now: its camera, skeleton, ghosts and safe frame, and the
/// original on the left where that stands there.
void startFilm(Shell& shell, const std::filesystem::path& path);

/// Once per frame: tells what became of it.
void updateFilm(Shell& shell);

} // namespace stretch::ui
