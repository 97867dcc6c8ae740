#include <catch2/catch.hpp>

#include <cstdlib>
#include <memory>
#include <optional>

#include <glm/geometric.hpp>

#include "tests/support/temporary_folder.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/viewport_renderer.h"
#include "ui/viewport/shown/shown_reference.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

BackdropImage given(const std::shared_ptr<const Image>& image) {
  return [image] { return image; };
}

/// Red above blue, twice as high as wide.
std::shared_ptr<const Image> flag() {
  return std::make_shared<const Image>(Image{1, 2, {255, 0, 0, 255, 0, 0, 255, 255}});
}

/// An empty scene of 100 by 100 pixels before the backdrop; with a floor it is seen from above.
Image drawn(ViewportRenderer& renderer, const std::optional<Backdrop>& backdrop, bool floor = false) {
  static const Scene scene;
  SceneStyle style;
  style.floor = floor;
  style.backdrop = backdrop;
  renderer.setScene(scene);
  RenderTarget target;
  const View view = makeView(Camera{.pitchRadians = floor ? 0.8 : 0.0}, {100.0, 100.0, 1.0});
  REQUIRE(renderer.draw(target, view, {{}, {}, Overlay{}, style}).ok());
  return target.readPixels();
}

glm::ivec3 colourAt(const Image& image, int x, int y) {
  const auto index =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[index], image.rgba[index + 1], image.rgba[index + 2]};
}

bool sameBox(const Vec4& box, const Vec4& expected) {
  return glm::length(box - expected) < 1e-12;
}

} // namespace

TEST_CASE("An image keeps its proportions, stands in the middle or at an end, as high as it is asked to be") {
  const Viewport wide{200.0, 100.0, 1.0};
  const Image square{10, 10, {}};
  const auto box = [&](double across, double height) {
    return backdropBox({.across = across, .height = height}, square, wide);
  };
  CHECK(sameBox(box(0.5, 1.0), {0.25, 0.0, 0.75, 1.0}));
  CHECK(sameBox(box(0.0, 0.5), {0.0, 0.25, 0.25, 0.75}));
  CHECK(sameBox(box(1.0, 0.5), {0.75, 0.25, 1.0, 0.75}));
  CHECK(sameBox(box(0.5, 4.0), {-0.5, -1.5, 1.5, 2.5})); // Larger than the view it is cut at both ends.
  CHECK(sameBox(backdropBox({}, {20, 10, {}}, wide), {0.0, 0.0, 1.0, 1.0}));
}

TEST_CASE("A reference stands behind the character, or half as high at the left or the right end") {
  using app::ReferencePlace;
  const auto placed = [](ReferencePlace place, double size) {
    return backdropOf({.place = place, .size = size, .opacity = 0.25}, given(flag()));
  };
  CHECK(placed(ReferencePlace::behind, 0.8).across == 0.5);
  CHECK(placed(ReferencePlace::behind, 0.8).height == 0.8);
  CHECK(placed(ReferencePlace::left, 0.8).across == 0.0);
  CHECK(placed(ReferencePlace::left, 0.8).height == 0.4);
  CHECK(placed(ReferencePlace::right, 2.0).across == 1.0);
  CHECK(placed(ReferencePlace::right, 2.0).height == 1.0);
  CHECK(placed(ReferencePlace::right, 2.0).opacity == 0.25);
}

TEST_CASE("A reference of more than 2048 pixels along a side is read smaller, but never to nothing") {
  const test::TemporaryFolder folder;
  const auto sizeRead = [&](int width, int height) {
    REQUIRE(writePng(folder / "image.png", filled(width, height, glm::vec3(0.5F))));
    const Result<Image> image = readReferenceImage(folder / "image.png");
    REQUIRE(image);
    return glm::ivec2(image->width, image->height);
  };
  CHECK(sizeRead(2048, 4) == glm::ivec2(2048, 4));
  CHECK(sizeRead(2050, 4) == glm::ivec2(1025, 2));
  CHECK(sizeRead(4, 2050) == glm::ivec2(2, 1025));
  CHECK(sizeRead(4098, 6) == glm::ivec2(1366, 2));
  CHECK(sizeRead(4098, 2) == glm::ivec2(2049, 1)); // A third of it would leave no line.
  CHECK_FALSE(readReferenceImage(folder / "none.png"));
}

TEST_CASE("The image is upright, covers the background where it stands, and nothing beside it") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = ViewportRenderer::create();
  REQUIRE(renderer);
  const Image plain = drawn(*renderer, std::nullopt);
  const Image image = drawn(*renderer, Backdrop{.image = given(flag())});
  CHECK(colourAt(image, 50, 10) == glm::ivec3(255, 0, 0));
  CHECK(colourAt(image, 50, 90) == glm::ivec3(0, 0, 255));
  CHECK(colourAt(image, 24, 10) == colourAt(plain, 24, 10)); // 50 wide, from 25 to 75
  CHECK(colourAt(image, 26, 10) == glm::ivec3(255, 0, 0));
  CHECK(colourAt(image, 73, 10) == glm::ivec3(255, 0, 0));
  CHECK(colourAt(image, 76, 10) == colourAt(plain, 76, 10));
  const Image right = drawn(*renderer, Backdrop{.image = given(flag()), .across = 1.0, .height = 0.5});
  CHECK(colourAt(right, 99, 30) == glm::ivec3(255, 0, 0));
  CHECK(colourAt(right, 99, 70) == glm::ivec3(0, 0, 255));
  CHECK(colourAt(right, 99, 20) == colourAt(plain, 99, 20));
  CHECK(colourAt(right, 50, 30) == colourAt(plain, 50, 30));
}

TEST_CASE("An image is mixed with the background as far as it is opaque, and another one replaces it") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = ViewportRenderer::create();
  REQUIRE(renderer);
  const glm::ivec3 plain = colourAt(drawn(*renderer, std::nullopt), 50, 10);
  const glm::ivec3 half =
      colourAt(drawn(*renderer, Backdrop{.image = given(flag()), .opacity = 0.5}), 50, 10);
  CHECK(std::abs(half.r - (plain.r + 255) / 2) <= 1);
  CHECK(std::abs(half.g - plain.g / 2) <= 1);
  CHECK(colourAt(drawn(*renderer, Backdrop{.image = given(flag()), .opacity = 0.0}), 50, 10) == plain);
  const auto green = std::make_shared<const Image>(Image{1, 1, {0, 255, 0, 255}});
  CHECK(colourAt(drawn(*renderer, Backdrop{.image = given(green)}), 50, 10) == glm::ivec3(0, 255, 0));
  const auto clear = std::make_shared<const Image>(Image{1, 1, {0, 255, 0, 0}});
  CHECK(colourAt(drawn(*renderer, Backdrop{.image = given(clear)}), 50, 10) == plain);
  CHECK(colourAt(drawn(*renderer, Backdrop{.image = given(nullptr)}), 50, 10) == plain);
  const BackdropImage broken = [] { return Result<std::shared_ptr<const Image>>(Error{"broken", "", ""}); };
  CHECK(colourAt(drawn(*renderer, Backdrop{.image = broken}), 50, 10) == plain);
}

TEST_CASE("The floor hides an image beside the character no more than one behind it: its lines lie over it") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = ViewportRenderer::create();
  REQUIRE(renderer);
  const auto green = std::make_shared<const Image>(Image{1, 1, {0, 255, 0, 255}});
  const auto clearPixels = [&](double across) {
    const Image image =
        drawn(*renderer, Backdrop{.image = given(green), .across = across, .height = 0.9}, true);
    int clear = 0;
    for (int y = 10; y < 90; ++y) {
      clear += colourAt(image, 50, y).g > 180 ? 1 : 0;
    }
    return clear;
  };
  CHECK(clearPixels(0.5) > 30);
  CHECK(clearPixels(0.0) == clearPixels(0.5));
  CHECK(clearPixels(1.0) == clearPixels(0.5));
}
