#include "ui/render/png.h"

#include <fstream>
#include <system_error>

#include <stb_image_write.h>

namespace stretch::ui {

namespace {

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

Error cannotWrite(const std::filesystem::path& path) {
  return {"the picture cannot be written", path.string(),
          "choose a folder that exists and may be written to"};
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
  std::filesystem::path temporary = path;
  temporary += ".part";
  std::error_code failure;
  {
    std::ofstream file(temporary, std::ios::binary);
    // The stream takes characters; bytes are bytes.
    file.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    file.close();
    if (!file) {
      std::filesystem::remove(temporary, failure);
      return cannotWrite(path);
    }
  }
  std::filesystem::rename(temporary, path, failure);
  return failure ? Status(cannotWrite(path)) : Status(Success{});
}

} // namespace stretch::ui
