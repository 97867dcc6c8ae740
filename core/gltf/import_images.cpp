#include <limits>
#include <memory>
#include <optional>
#include <span>

#include <fmt/core.h>
#include <stb/stb_image.h>
#include <tbb/parallel_for.h>

#include "core/gltf/fields.h"
#include "core/gltf/import.h"
#include "core/gltf/json.h"
#include "core/gltf/uri.h"
#include "core/gltf/webp_image.h"

namespace stretch::gltf {

namespace {

constexpr std::size_t mostPixelsAnImage = std::size_t{1} << 26U;
constexpr std::size_t mostPixelsAFile = std::size_t{1} << 28U;

std::optional<Bytes> bytesOfView(const Source& source, int bufferView) {
  const Json& view = element(source.json, "bufferViews", static_cast<std::size_t>(bufferView));
  const Bytes& buffer = source.buffers[static_cast<std::size_t>(indexOr(view, "buffer"))];
  const std::uint64_t start = wholeOr(view, "byteOffset", 0);
  const std::uint64_t end = start + wholeOr(view, "byteLength", 0);
  if (end > buffer.size()) {
    return std::nullopt;
  }
  return Bytes(buffer.begin() + static_cast<std::ptrdiff_t>(start),
               buffer.begin() + static_cast<std::ptrdiff_t>(end));
}

std::optional<Bytes> bytesOfUri(const Source& source, const std::string& uri) {
  if (isDataUri(uri)) {
    std::optional<DataUri> data = decodeDataUri(uri);
    return data ? std::optional(std::move(data->bytes)) : std::nullopt;
  }
  const std::optional<std::filesystem::path> relative = relativePath(uri);
  if (!relative) {
    return std::nullopt;
  }
  Result<Bytes> bytes = readFile(source.path.parent_path() / *relative);
  return bytes ? std::optional(std::move(bytes.value())) : std::nullopt;
}

// A picture that waits to be decoded.
struct Encoded {
  Bytes bytes;
  std::size_t pixels = 0; ///< As it says itself; 0 when it is none that can be decoded.
};

// Size is asked for before anything is allocated: a small file can claim to be a huge picture.
std::size_t claimedPixels(const Bytes& bytes) {
  int width = 0;
  int height = 0;
  int channels = 0;
  const bool isPicture =
      bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
      stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height, &channels) != 0;
  const std::size_t pixels =
      isPicture ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : webpPixels(bytes);
  return pixels <= mostPixelsAnImage ? pixels : 0;
}

Image decode(const Encoded& encoded) {
  Image image;
  if (encoded.pixels == 0) {
    return image;
  }
  if (webpPixels(encoded.bytes) > 0) {
    return decodeWebp(encoded.bytes);
  }
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
      stbi_load_from_memory(encoded.bytes.data(), static_cast<int>(encoded.bytes.size()), &image.width,
                            &image.height, &channels, STBI_rgb_alpha),
      stbi_image_free);
  if (decoded == nullptr) {
    return {};
  }
  const std::span<const stbi_uc> rgba(decoded.get(), encoded.pixels * 4);
  image.rgba.assign(rgba.begin(), rgba.end());
  return image;
}

std::vector<bool> shownImages(std::size_t count, const std::vector<Material>& materials) {
  std::vector<bool> shown(count, false);
  for (const Material& material : materials) {
    for (const int image : {material.baseColorTexture.image, material.emissiveTexture.image}) {
      if (image >= 0) {
        shown[static_cast<std::size_t>(image)] = true;
      }
    }
  }
  return shown;
}

std::vector<Encoded> readEncoded(const Source& source, const std::vector<bool>& shown, Problems& problems) {
  std::vector<Encoded> encoded(shown.size());
  std::size_t pixelsLeft = mostPixelsAFile;
  for (std::size_t i = 0; i < encoded.size(); ++i) {
    const Json& json = element(source.json, "images", i);
    std::optional<Bytes> bytes = shown[i] ? encodedImage(source, json) : Bytes();
    if (!bytes) {
      const std::string uri = textOr(json, "uri").substr(0, 200);
      problems.warning(at("images", i), fmt::format("'{}' cannot be read; its texture is not shown", uri));
      continue;
    }
    const std::size_t pixels = claimedPixels(*bytes);
    encoded[i] = {*std::move(bytes), pixels <= pixelsLeft ? pixels : 0};
    pixelsLeft -= encoded[i].pixels;
  }
  return encoded;
}

} // namespace

std::optional<Bytes> encodedImage(const Source& source, const Json& image) {
  if (const int view = indexOr(image, "bufferView"); view >= 0) {
    return bytesOfView(source, view);
  }
  return find(image, "uri") != nullptr ? bytesOfUri(source, textOr(image, "uri")) : std::nullopt;
}

std::vector<Image> importImages(const Source& source, const std::vector<Material>& materials,
                                Problems& problems) {
  const std::vector<Encoded> encoded =
      readEncoded(source, shownImages(sizeOf(source.json, "images"), materials), problems);
  std::vector<Image> images(encoded.size());
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) { images[i] = decode(encoded[i]); });
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (images[i].rgba.empty() && !encoded[i].bytes.empty()) {
      problems.warning(at("images", i),
                       "is no picture that can be shown (PNG, JPEG or WebP); its texture is not shown");
    }
  }
  return images;
}

} // namespace stretch::gltf
