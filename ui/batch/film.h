#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "ui/batch/video_writer.h"
#include "ui/render/picture/picture.h"

namespace stretch::ui {

/// Pictures of one scene; two of them stand side by side.
struct FilmSide {
  const Scene* scene = nullptr; ///< Outlives the film.
  std::vector<PictureFrame> pictures;
};

/// A series of pictures of one motion, or of two beside each other: as many of each, with one camera.
struct Film {
  std::vector<FilmSide> sides;   ///< One, or two: the left one first.
  std::vector<double> frames;    ///< Of each picture.
  double framesPerSecond = 30.0; ///< Of the film when it is played.
  std::optional<FilmSound> sound = {};
};

/// The sound that a clip refers to, for a film of these frames; nothing where it refers to none. An error
/// where its file is not there.
[[nodiscard]] Result<std::optional<FilmSound>> filmSoundOf(const app::Document& document, int clip,
                                                           const std::vector<double>& frames);

/// Draws the pictures one after the other, of the options' size as a whole; `keep` gets each as it is made
/// and may stop the work with an error.
[[nodiscard]] Status drawFilm(const Film& film, const PictureOptions& options,
                              const std::function<Status(std::size_t, const Image&)>& keep);

/// Frames of "A:B" or "A:B:STEP", of which there are 100001 at most.
[[nodiscard]] Result<std::vector<double>> parseFrames(const std::string& text);

/// Refuses frames that the clip does not have. `clip` < 0: nothing moves, and any frame shows the same.
[[nodiscard]] Status checkFrames(const app::Document& document, int clip, const std::vector<double>& frames);

/// The name of one picture of a series: "punch-0012.png".
[[nodiscard]] std::filesystem::path numberedName(const std::filesystem::path& path, double frame);

/// `share` is told before each picture, 0 to 1; the work ends with an error where it answers false.
using FilmProgress = std::function<bool(double share)>;

/// Writes it as a video (.mp4, .webm, .gif), or as numbered pictures (.png): "punch-0012.png". Where it fails
/// or is stopped nothing is left.
[[nodiscard]] Status writeFilm(const Film& film, const PictureOptions& options,
                               const std::filesystem::path& path, const FilmProgress& progress);

} // namespace stretch::ui
