#include "picture_baseline.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <stb_image.h>

#include "ui/render/picture/image_edits.h"
#include "ui/render/view/quality.h"

namespace stretch::test {

namespace {

std::filesystem::path baselinePath(const std::string& name) {
  return std::filesystem::path(STRETCH_SOURCE_DIR) / "tests" / "render" / "baselines" / (name + ".png");
}

std::filesystem::path keepForALook(const std::string& name, const Image& picture) {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "render-differences";
  std::filesystem::create_directories(folder);
  std::filesystem::path path = folder / (name + ".png");
  (void)ui::writePng(path, picture);
  return path;
}

Image readPng(const std::filesystem::path& path) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load(path.c_str(), &image.width, &image.height, &channels, 4), stbi_image_free);
  if (pixels) {
    image.rgba.assign(pixels.get(), pixels.get() + 4 * image.width * image.height);
  }
  return image;
}

constexpr int farOff = 48; // of a channel: 0..255

int largestChannelDifference(const Image& a, const Image& b, std::size_t pixel) {
  int largest = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    largest = std::max(largest, std::abs(a.rgba[4 * pixel + channel] - b.rgba[4 * pixel + channel]));
  }
  return largest;
}

/// Pixels of one tile that are far off.
int farPixelsOfTile(const Image& a, const Image& b, int left, int top) {
  int far = 0;
  for (int y = top; y < std::min(top + tileSide, a.height); ++y) {
    for (int x = left; x < std::min(left + tileSide, a.width); ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x);
      far += largestChannelDifference(a, b, pixel) > farOff ? 1 : 0;
    }
  }
  return far;
}

} // namespace

std::string differenceFromBaseline(const std::string& name, const Image& picture, PictureKind kind) {
  const std::filesystem::path path = baselinePath(name);
  const Image baseline = readPng(path);
  const std::string remedy = "look at it and, if it is right, copy it to " + path.string();
  if (baseline.rgba.empty()) {
    return fmt::format("there is no baseline {}: the picture is at {}; {}", name,
                       keepForALook(name, picture).string(), remedy);
  }
  if (baseline.width != picture.width || baseline.height != picture.height) {
    return fmt::format("{} has another size: the picture is at {}; {}", name,
                       keepForALook(name, picture).string(), remedy);
  }
  const PictureDifference difference = differenceBetween(baseline, picture);
  if (!isVisible(difference, mostFarPixels(kind))) {
    return {};
  }
  return fmt::format(
      "{} differs by {:.2f} on average, most at ({}, {}) where {} of {} pixels are far off: the "
      "picture is at {}; {}",
      name, difference.mean, difference.worstLeft, difference.worstTop, difference.worstTile,
      tileSide * tileSide, keepForALook(name, picture).string(), remedy);
}

PictureDifference differenceBetween(const Image& a, const Image& b) {
  PictureDifference difference;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    sum += std::abs(a.rgba[i] - b.rgba[i]);
  }
  difference.mean = sum / std::max(0.75 * static_cast<double>(a.rgba.size()), 1.0); // alpha never differs
  for (int top = 0; top < a.height; top += tileSide) {
    for (int left = 0; left < a.width; left += tileSide) {
      const int far = farPixelsOfTile(a, b, left, top);
      if (far > difference.worstTile) {
        difference = {difference.mean, far, left, top};
      }
    }
  }
  return difference;
}

int mostFarPixels(PictureKind kind) {
  const int share = kind == PictureKind::panel ? 32 : ui::drawsInSoftware() ? 16 : 8;
  return tileSide * tileSide / share;
}

bool isVisible(const PictureDifference& difference, int mostFar) {
  constexpr double largestMean = 1.0;
  return difference.mean > largestMean || difference.worstTile > mostFar;
}

} // namespace stretch::test
