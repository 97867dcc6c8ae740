#include "ui/render/png.h"

#include <stb_image_write.h>

#include "core/base/file.h"

namespace stretch::ui {

namespace {

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

} // namespace

Result<std::vector<std::uint8_t>> encodePng(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const bool complete =
      image.width > 0 && image.height > 0 &&
      image.rgba.size() == 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (!complete || stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(),
                                          4 * image.width) == 0) {
    return Error{"the picture has no pixels to write", "PNG", ""};
  }
  return bytes;
}

Status writePng(const std::filesystem::path& path, const Image& image) {
  const Result<std::vector<std::uint8_t>> bytes = encodePng(image);
  if (!bytes) {
    return bytes.error();
  }
  return writeFile(path, *bytes);
}

} // namespace stretch::ui
