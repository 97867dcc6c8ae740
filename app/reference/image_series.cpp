#include "app/reference/image_series.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/lower_case.h"

namespace stretch::app {

namespace {

namespace fs = std::filesystem;

/// A stem, split before the digits at its end.
struct SplitStem {
  std::string_view name;
  std::string_view digits;
};

SplitStem splitStem(std::string_view stem) {
  const std::size_t last = stem.find_last_not_of("0123456789");
  const std::size_t begin = last == std::string_view::npos ? 0 : last + 1;
  return {stem.substr(0, begin), stem.substr(begin)};
}

/// Nothing without digits, and for more of them than a number has.
std::optional<std::uint64_t> numberOf(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return problem == std::errc() && !digits.empty() ? std::optional(number) : std::nullopt;
}

} // namespace

const std::vector<std::string>& imageEndings() {
  static const std::vector<std::string> endings{".png", ".jpg", ".jpeg", ".bmp", ".tga"};
  return endings;
}

bool isImageName(const fs::path& path) {
  return std::ranges::find(imageEndings(), lowerCase(path.extension().string())) != imageEndings().end();
}

Result<ImageSeries> imageSeriesFrom(const fs::path& first) {
  if (!isImageName(first)) {
    return Error{"is not an image that can be a reference", first.string(),
                 "give a PNG, JPEG, BMP or TGA; a film becomes images by: ffmpeg -i film.mp4 film-%04d.png"};
  }
  std::error_code failed;
  if (!fs::is_regular_file(first, failed)) {
    return Error{"the image is not there", first.string(), "choose it again"};
  }
  const std::string stem = first.stem().string();
  const SplitStem named = splitStem(stem);
  const std::optional<std::uint64_t> start = numberOf(named.digits);
  ImageSeries series;
  series.images.push_back({start.value_or(0), first});
  if (!start) {
    return series;
  }
  const fs::path folder = first.has_parent_path() ? first.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, failed); !failed && entry != fs::directory_iterator();
       entry.increment(failed)) {
    const fs::path& file = entry->path();
    const std::string other = file.stem().string();
    const SplitStem split = splitStem(other);
    const std::optional<std::uint64_t> number = numberOf(split.digits);
    // Of one number the chosen image is meant, else any.
    if (number && *number > *start && split.name == named.name && file.extension() == first.extension() &&
        entry->is_regular_file(failed)) {
      series.images.push_back({*number, file});
    }
    failed.clear();
  }
  std::ranges::sort(series.images, {}, &ImageSeries::Numbered::number);
  return series;
}

const fs::path* imageAt(const ImageSeries& series, const ReferenceImages& settings, double frame,
                        double framesPerSecond) {
  if (series.images.empty()) {
    return nullptr;
  }
  if (series.images.size() == 1) {
    return &series.images.front().file;
  }
  constexpr double justBefore = 1e-6; // A frame that was counted in another rate and back.
  const double imagesPerFrame = settings.imagesPerSecond.value_or(framesPerSecond) / framesPerSecond;
  const double place = std::floor((frame - settings.startFrame) * imagesPerFrame + justBefore);
  const std::uint64_t first = series.images.front().number;
  if (place < 0.0 || place > static_cast<double>(series.images.back().number - first)) {
    return nullptr;
  }
  const std::uint64_t number = first + static_cast<std::uint64_t>(place);
  const auto after = std::ranges::upper_bound(series.images, number, {}, &ImageSeries::Numbered::number);
  return &std::prev(after)->file;
}

} // namespace stretch::app
