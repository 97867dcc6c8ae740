#include "ui/render/picture/image_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <stb/stb_image.h>
#include <stb_image_write.h>

#include "core/base/file.h"

namespace stretch::ui {

namespace {

constexpr int gapPixels = 2;

std::size_t offsetOf(const Image& image, int x, int y) {
  return 4 *
         (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

int averageOf(const Image& image, int x, int y, int factor, std::size_t channel) {
  int sum = 0;
  for (int row = 0; row < factor; ++row) {
    for (int column = 0; column < factor; ++column) {
      sum += image.rgba[offsetOf(image, x + column, y + row) + channel];
    }
  }
  return (sum + factor * factor / 2) / (factor * factor);
}

int clampedSide(long long side) {
  return static_cast<int>(std::min<long long>(side, std::numeric_limits<int>::max()));
}

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

} // namespace

Image reduced(const Image& image, int factor) {
  if (factor <= 1) {
    return image;
  }
  Image small = filled(image.width / factor, image.height / factor, glm::vec3(0.0F));
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      for (std::size_t channel = 0; channel < 4; ++channel) {
        small.rgba[offsetOf(small, x, y) + channel] =
            static_cast<std::uint8_t>(averageOf(image, x * factor, y * factor, factor, channel));
      }
    }
  }
  return small;
}

void makeOpaque(Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = 255;
  }
}

Image filled(int widthPixels, int heightPixels, const glm::vec3& colorSrgb) {
  Image image;
  image.width = widthPixels;
  image.height = heightPixels;
  image.rgba.resize(4 * static_cast<std::size_t>(widthPixels) * static_cast<std::size_t>(heightPixels), 255);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    for (glm::length_t channel = 0; channel < 3; ++channel) {
      image.rgba[i + channel] = static_cast<std::uint8_t>(std::lround(255.0F * colorSrgb[channel]));
    }
  }
  return image;
}

void paste(Image& sheet, const Image& picture, int x, int y) {
  const int left = std::max(0, -x);
  const int right = std::min(picture.width, sheet.width - x);
  for (int row = std::max(0, -y); row < std::min(picture.height, sheet.height - y) && left < right; ++row) {
    const auto* first = picture.rgba.data() + offsetOf(picture, left, row);
    std::copy(first, first + 4 * (right - left), sheet.rgba.data() + offsetOf(sheet, x + left, y + row));
  }
}

void outline(Image& image, const PixelBox& box, const glm::vec3& colorSrgb) {
  const int thick = std::max(1, image.height / 540);
  const int left = static_cast<int>(std::lround(box.low.x));
  const int top = static_cast<int>(std::lround(box.low.y));
  const int width = static_cast<int>(std::lround(box.high.x)) - left;
  const int height = static_cast<int>(std::lround(box.high.y)) - top;
  const Image across = filled(std::max(width, thick), thick, colorSrgb);
  const Image down = filled(thick, std::max(height, thick), colorSrgb);
  paste(image, across, left, top);
  paste(image, across, left, top + height - thick);
  paste(image, down, left, top);
  paste(image, down, left + width - thick, top);
}

int SheetLayout::left(std::size_t index) const {
  return static_cast<int>(index % static_cast<std::size_t>(columns)) * cellWidth;
}
int SheetLayout::top(std::size_t index) const {
  return static_cast<int>(index / static_cast<std::size_t>(columns)) * cellHeight;
}

SheetLayout layOutSheet(std::size_t count, int pictureWidth, int pictureHeight, int columns) {
  const auto number = static_cast<double>(std::max<std::size_t>(count, 1));
  const double square = std::sqrt(number * std::max(pictureHeight, 1) / std::max(pictureWidth, 1));
  SheetLayout layout;
  layout.columns = columns > 0 ? columns : std::max(1, static_cast<int>(std::lround(square)));
  layout.columns = static_cast<int>(std::min<double>(layout.columns, number));
  const auto rows = static_cast<long long>(std::ceil(number / layout.columns));
  layout.cellWidth = pictureWidth + gapPixels;
  layout.cellHeight = pictureHeight + gapPixels;
  layout.widthPixels = clampedSide(static_cast<long long>(layout.columns) * layout.cellWidth - gapPixels);
  layout.heightPixels = clampedSide(rows * layout.cellHeight - gapPixels);
  return layout;
}

Status checkSheet(const SheetLayout& layout, std::size_t count) {
  constexpr int largestSheet = 16384;
  if (count > 0 && layout.widthPixels <= largestSheet && layout.heightPixels <= largestSheet) {
    return Success{};
  }
  return Error{
      "a contact sheet of " + std::to_string(count) + " pictures cannot be made", "sheet",
      "choose between 1 frame and what fits on 16384 pixels along a side: a smaller size or a larger step"};
}

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

Result<Image> readImage(const std::filesystem::path& path) {
  const Result<std::vector<std::uint8_t>> bytes = readFile(path);
  if (!bytes) {
    return bytes.error();
  }
  constexpr std::int64_t mostPixels = 100'000'000;
  Image image;
  int channels = 0;
  const auto size = static_cast<int>(std::min<std::size_t>(bytes->size(), std::numeric_limits<int>::max()));
  if (stbi_info_from_memory(bytes->data(), size, &image.width, &image.height, &channels) != 0 &&
      std::int64_t{image.width} * image.height > mostPixels) {
    return Error{"the picture has over 100 million pixels", path.string(), "give a smaller one"};
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes->data(), size, &image.width, &image.height, &channels, 4), stbi_image_free);
  if (pixels == nullptr) {
    return Error{"this is not a picture that can be read", path.string(), "give a PNG, JPEG, BMP or TGA"};
  }
  image.rgba.assign(pixels.get(), pixels.get() + std::size_t{4} * static_cast<std::size_t>(image.width) *
                                                     static_cast<std::size_t>(image.height));
  return image;
}

} // namespace stretch::ui
