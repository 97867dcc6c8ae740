#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace stretch::ui {

/// Whether the name ends as one of the videos that are written: .mp4, .webm or .gif.
[[nodiscard]] bool isVideoName(const std::filesystem::path& path);

/// A sound that a video is heard with.
struct FilmSound {
  std::filesystem::path file;
  double fromSeconds = 0.0; ///< Time of the sound where the video begins; below 0 it begins so much later.
  double volume = 1.0;      ///< 0..1.
};

struct VideoPlan {
  std::filesystem::path path;
  int widthPixels = 0; ///< Of every picture.
  int heightPixels = 0;
  double framesPerSecond = 30.0;       ///< Of the pictures, above 0.
  std::optional<FilmSound> sound = {}; ///< A GIF has none.
};

/// A video that grows by pictures: an ffmpeg of the system's takes them in one after the other. The file
/// stands at its place when it is finished, and not before; one that is not finished leaves nothing.
class VideoWriter {
public:
  /// Error: a name that is no video's, no ffmpeg, a folder that cannot be written.
  [[nodiscard]] static Result<VideoWriter> open(const VideoPlan& plan);
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  ~VideoWriter();

  /// The picture has the plan's size. Error: what ffmpeg says.
  Status add(const Image& picture);
  Status finish();

private:
  struct Process;
  explicit VideoWriter(std::unique_ptr<Process> process);
  std::unique_ptr<Process> process_;
};

} // namespace stretch::ui
