#include "core/gltf/import/webp_image.h"

#include <memory>

#include <webp/decode.h>

namespace stretch::gltf {

std::size_t webpPixels(std::span<const std::uint8_t> bytes) {
  int width = 0;
  int height = 0;
  const bool isPicture = WebPGetInfo(bytes.data(), bytes.size(), &width, &height) != 0;
  return isPicture && width > 0 && height > 0
             ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height)
             : 0;
}

Image decodeWebp(std::span<const std::uint8_t> bytes) {
  Image image;
  const std::unique_ptr<std::uint8_t, void (*)(void*)> rgba(
      WebPDecodeRGBA(bytes.data(), bytes.size(), &image.width, &image.height), WebPFree);
  if (rgba == nullptr) {
    return {};
  }
  const std::size_t size =
      std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const std::span<const std::uint8_t> pixels(rgba.get(), size);
  image.rgba.assign(pixels.begin(), pixels.end());
  return image;
}

} // namespace stretch::gltf
