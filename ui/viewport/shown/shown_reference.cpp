#include "ui/viewport/shown/shown_reference.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/reference/reference_edits.h"
#include "ui/render/picture/image_edits.h"

namespace stretch::ui {

Result<Image> readReferenceImage(const std::filesystem::path& file) {
  constexpr int longest = 2048; // Pixels: more than a view shows of it.
  Result<Image> image = readImage(file);
  if (image) {
    const int side = std::max(image->width, image->height);
    // Something is left of the shorter side.
    *image = reduced(*image, std::min({(side + longest - 1) / longest, image->width, image->height}));
  }
  return image;
}

Backdrop backdropOf(const app::ReferenceImages& images, BackdropImage image) {
  const bool isBehind = images.place == app::ReferencePlace::behind;
  return {.image = std::move(image),
          .across = isBehind                                    ? 0.5
                    : images.place == app::ReferencePlace::left ? 0.0
                                                                : 1.0,
          .height = images.size * (isBehind ? 1.0 : 0.5),
          .opacity = images.opacity};
}

Result<Backdrops> backdropsOf(const app::Document& document, int clip) {
  const app::ReferenceImages settings = app::referenceOf(document, clip).images;
  if (settings.file.empty()) {
    return Backdrops();
  }
  Result<app::ImageSeries> series = app::imageSeriesFrom(settings.file);
  if (!series) {
    return series.error();
  }
  struct LastRead {
    std::filesystem::path file;
    std::shared_ptr<const Image> image;
  };
  return Backdrops([settings, series = std::move(*series), last = std::make_shared<LastRead>(),
                    rate = app::clipOf(document, clip).framesPerSecond](double frame) {
    const std::filesystem::path* const file = app::imageAt(series, settings, frame, rate);
    if (file == nullptr) {
      return std::optional<Backdrop>();
    }
    return std::optional(backdropOf(settings, [file = *file, last]() -> Result<std::shared_ptr<const Image>> {
      if (last->image == nullptr || last->file != file) {
        Result<Image> read = readReferenceImage(file);
        if (!read) {
          return read.error();
        }
        *last = {file, std::make_shared<const Image>(std::move(*read))};
      }
      return last->image;
    }));
  });
}

} // namespace stretch::ui
