#include <limits>
#include <memory>
#include <optional>
#include <span>

#include <fmt/core.h>
#include <stb/stb_image.h>

#include "core/gltf/fields.h"
#include "core/gltf/files.h"
#include "core/gltf/import.h"
#include "core/gltf/uri.h"

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

std::optional<Bytes> encodedBytes(const Source& source, const Json& image) {
  if (const int view = indexOr(image, "bufferView"); view >= 0) {
    return bytesOfView(source, view);
  }
  return find(image, "uri") != nullptr ? bytesOfUri(source, textOr(image, "uri")) : std::nullopt;
}

// Size is asked for before anything is allocated: a small file can claim to be a huge picture.
std::optional<Image> decode(const Bytes& bytes, std::size_t& pixelsLeft) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return std::nullopt;
  }
  const int length = static_cast<int>(bytes.size());
  Image image;
  int channels = 0;
  if (stbi_info_from_memory(bytes.data(), length, &image.width, &image.height, &channels) == 0) {
    return std::nullopt;
  }
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (pixels > mostPixelsAnImage || pixels > pixelsLeft) {
    return std::nullopt;
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
      stbi_load_from_memory(bytes.data(), length, &image.width, &image.height, &channels, STBI_rgb_alpha),
      stbi_image_free);
  if (decoded == nullptr) {
    return std::nullopt;
  }
  pixelsLeft -= pixels;
  const std::span<const stbi_uc> rgba(decoded.get(), pixels * 4);
  image.rgba.assign(rgba.begin(), rgba.end());
  return image;
}

std::vector<bool> shownImages(std::size_t count, const std::vector<Material>& materials) {
  std::vector<bool> shown(count, false);
  for (const Material& material : materials) {
    if (material.baseColorImage >= 0) {
      shown[static_cast<std::size_t>(material.baseColorImage)] = true;
    }
  }
  return shown;
}

} // namespace

std::vector<Image> importImages(const Source& source, const std::vector<Material>& materials,
                                Problems& problems) {
  std::vector<Image> images(sizeOf(source.json, "images"));
  const std::vector<bool> shown = shownImages(images.size(), materials);
  std::size_t pixelsLeft = mostPixelsAFile;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Json& json = element(source.json, "images", i);
    if (!shown[i]) {
      continue;
    }
    const std::optional<Bytes> bytes = encodedBytes(source, json);
    if (!bytes) {
      problems.warning(at("images", i), fmt::format("'{}' cannot be read; its texture is not shown",
                                                    textOr(json, "uri").substr(0, 200)));
      continue;
    }
    if (std::optional<Image> image = decode(*bytes, pixelsLeft)) {
      images[i] = *std::move(image);
    } else {
      problems.warning(at("images", i),
                       "is no picture that can be shown (PNG or JPEG); its texture is not shown");
    }
  }
  return images;
}

} // namespace stretch::gltf
