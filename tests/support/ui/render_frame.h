#pragma once

#include "ui/render/picture/picture.h"

namespace stretch::test {

/// One picture, whose camera sees what it shows.
[[nodiscard]] inline Result<Image> renderFrame(const Scene& scene, const ui::PictureFrame& picture,
                                               const ui::PictureOptions& options) {
  Result<ui::PictureMaker> maker =
      ui::PictureMaker::create(scene, options, ui::boxOfPictures(scene, {&picture, 1}));
  if (!maker) {
    return maker.error();
  }
  return maker->draw(picture);
}

} // namespace stretch::test
