#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/core.h>
#include <stb/stb_image.h>
#include <tbb/parallel_for.h>

#include "core/gltf/import/import.h"
#include "core/gltf/import/webp_image.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/uri.h"

namespace stretch::gltf {

namespace {

constexpr std::size_t mostPixelsAnImage = std::size_t{1} << 26U;
constexpr std::size_t mostPixelsAFile = std::size_t{1} << 28U;
constexpr std::size_t pixelsOfSmallImage = std::size_t{1} << 24U;
constexpr std::size_t pixelsOfSmallFile = std::size_t{1} << 26U;
constexpr std::size_t pixelsOfOneByte = 256;
constexpr std::size_t mostBytesAFile = std::size_t{1} << 30U; // Of all its pictures, packed as they are.

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
  if (!relative || escapesFolder(*relative)) {
    return std::nullopt;
  }
  Result<Bytes> bytes = readFile(source.path.parent_path() / *relative);
  return bytes ? std::optional(std::move(bytes.value())) : std::nullopt;
}

// The decoder takes memory for each part of a PNG as that says how long it is, whether the bytes are there or
// not.
bool partsFit(std::string_view png) {
  constexpr std::size_t signature = 8;
  constexpr std::size_t aroundPart = 12; // its length, its kind and its checksum
  for (std::size_t start = signature; start + aroundPart <= png.size();) {
    std::size_t length = 0;
    for (const char byte : png.substr(start, 4)) {
      length = length << 8U | static_cast<unsigned char>(byte);
    }
    if (length > png.size() - start - aroundPart) {
      return false;
    }
    if (png.substr(start + 4, 4) == "IEND") {
      return true;
    }
    start += aroundPart + length;
  }
  return true;
}

bool isPngOrJpeg(const Bytes& bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with("\xFF\xD8\xFF") || (text.starts_with("\x89PNG") && partsFit(text));
}

// Size is asked for before anything is allocated: a small file can claim to be a huge picture.
std::size_t claimedPixels(const Bytes& bytes) {
  int width = 0;
  int height = 0;
  int channels = 0;
  const bool isPicture =
      isPngOrJpeg(bytes) && bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
      stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height, &channels) != 0;
  const std::size_t pixels =
      isPicture ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : webpPixels(bytes);
  const std::size_t most = std::min(mostPixelsAnImage, pixelsOfSmallImage + pixelsOfOneByte * bytes.size());
  return pixels <= most ? pixels : 0;
}

Image decode(const Bytes& bytes) {
  if (webpPixels(bytes) > 0) {
    return decodeWebp(bytes);
  }
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
      stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height,
                            &channels, STBI_rgb_alpha),
      stbi_image_free);
  if (decoded == nullptr) {
    return {};
  }
  const std::size_t size =
      std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const std::span<const stbi_uc> rgba(decoded.get(), size);
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

// What is shown of the images of a file. Their bytes are read one image at a time, here and when it is
// decoded: a small file can name a large picture over and over.
class ImageChoice {
public:
  ImageChoice(const Source& source, Problems& problems) : source_(source), problems_(problems) {}

  /// Whether the image is to be decoded.
  bool take(std::size_t index) {
    const Json& json = element(source_.json, "images", index);
    const std::optional<Bytes> bytes = encodedImage(source_, json);
    if (!bytes) {
      const std::string uri = textOr(json, "uri").substr(0, 200);
      problems_.warning(at("images", index),
                        fmt::format("'{}' cannot be read; its texture is not shown", uri));
      return false;
    }
    const std::size_t pixels = claimedPixels(*bytes);
    const bool isTaken = pixels > 0 && pixels_ + pixels <= mostPixels(bytes_ + bytes->size()) &&
                         bytes_ + bytes->size() <= mostBytesAFile;
    pixels_ += isTaken ? pixels : 0;
    bytes_ += bytes->size();
    if (!isTaken && !bytes->empty()) {
      tellUnshown(index);
    }
    return isTaken;
  }

  void tellUnshown(std::size_t index) {
    problems_.warning(at("images", index), "is not a picture that can be shown (PNG, JPEG or WebP); its "
                                           "texture is not shown");
  }

  [[nodiscard]] bool isSpent() const { return bytes_ > mostBytesAFile; }

private:
  static std::size_t mostPixels(std::size_t bytes) {
    return std::min(mostPixelsAFile, pixelsOfSmallFile + pixelsOfOneByte * bytes);
  }

  const Source& source_;
  Problems& problems_;
  std::size_t pixels_ = 0; ///< Of what was taken.
  std::size_t bytes_ = 0;  ///< Of what was looked at.
};

} // namespace

std::optional<Bytes> encodedImage(const Source& source, const Json& image) {
  if (const int view = indexOr(image, "bufferView"); view >= 0) {
    return bytesOfView(source, view);
  }
  return find(image, "uri") != nullptr ? bytesOfUri(source, textOr(image, "uri")) : std::nullopt;
}

std::vector<Image> importImages(const Source& source, const std::vector<Material>& materials,
                                Problems& problems, Pictures pictures) {
  std::vector<bool> wanted = shownImages(sizeOf(source.json, "images"), materials);
  ImageChoice choice(source, problems);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = wanted[i] && !choice.isSpent() && choice.take(i);
  }
  std::vector<Image> images(wanted.size());
  if (pictures == Pictures::headers) {
    return images;
  }
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    const std::optional<Bytes> bytes =
        wanted[i] ? encodedImage(source, element(source.json, "images", i)) : std::nullopt;
    images[i] = bytes ? decode(*bytes) : Image();
  });
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (wanted[i] && images[i].rgba.empty()) {
      choice.tellUnshown(i);
    }
  }
  return images;
}

} // namespace stretch::gltf
