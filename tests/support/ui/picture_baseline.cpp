#include "picture_baseline.h"

#include <cstdlib>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <stb_image.h>

#include "ui/render/png.h"

namespace stretch::test {

namespace {

std::filesystem::path baselinePath(const std::string& name) {
  return std::filesystem::path(STRETCH_SOURCE_DIR) / "tests" / "render" / "baselines" / (name + ".png");
}

std::filesystem::path keepForALook(const std::string& name, const Image& picture) {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "render-differences";
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = folder / (name + ".png");
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

struct Difference {
  double mean = 0.0;     // of a channel, 0..255
  double farShare = 0.0; // of the pixels
};

Difference differenceOf(const Image& a, const Image& b) {
  constexpr int farOff = 40;
  double sum = 0.0;
  double far = 0.0;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int largest = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int difference = std::abs(a.rgba[pixel + channel] - b.rgba[pixel + channel]);
      sum += difference;
      largest = std::max(largest, difference);
    }
    far += largest > farOff ? 1.0 : 0.0;
  }
  const auto pixels = static_cast<double>(a.rgba.size() / 4);
  return {sum / (3.0 * pixels), far / pixels};
}

} // namespace

std::string differenceFromBaseline(const std::string& name, const Image& picture) {
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
  const Difference difference = differenceOf(baseline, picture);
  constexpr double largestMean = 1.0;
  constexpr double largestFarShare = 0.01;
  if (difference.mean <= largestMean && difference.farShare <= largestFarShare) {
    return {};
  }
  return fmt::format("{} differs by {:.2f} on average, {:.2f} % of its pixels far: the picture is at {}; {}",
                     name, difference.mean, 100.0 * difference.farShare, keepForALook(name, picture).string(),
                     remedy);
}

} // namespace stretch::test
