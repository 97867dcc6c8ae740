#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/clip_reference.h"
#include "core/base/result.h"

namespace stretch::app {

/// Images of one folder whose names differ in the number at their end alone, from the named one on.
struct ImageSeries {
  struct Numbered {
    std::uint64_t number = 0;
    std::filesystem::path file;
  };
  std::vector<Numbered> images; ///< By number; a single one where the name has no number. Empty: none.
};

/// Endings of the images that can be read, in small letters: ".png", ".jpg" and so on.
[[nodiscard]] const std::vector<std::string>& imageEndings();
/// Whether the name ends so.
[[nodiscard]] bool isImageName(const std::filesystem::path& path);

/// Finds the series that begins with this image. An error where it is not there or is no image by its name.
[[nodiscard]] Result<ImageSeries> imageSeriesFrom(const std::filesystem::path& first);

/// The image that a frame of the clip shows: of a number that is missing the one before it; null before the
/// first and after the last one. A single image stands all the time.
[[nodiscard]] const std::filesystem::path* imageAt(const ImageSeries& series, const ReferenceImages& settings,
                                                   double frame, double framesPerSecond);

} // namespace stretch::app
