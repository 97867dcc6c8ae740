#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "../../support/ui/picture_baseline.h"
#include "../../support/ui/render_scenes.h"
#include "app/evaluate/evaluate.h"
#include "tests/support/ui/render_frame.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/overlay/skeleton_drawing.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/picture.h"
#include "ui/render/picture/picture_content.h"
#include "ui/render/picture/viewport_renderer.h"

using namespace stretch;
using namespace stretch::ui;
using namespace stretch::test;

namespace {

PictureOptions smallPicture(ViewDirection view) {
  PictureOptions options;
  options.widthPixels = 320;
  options.heightPixels = 240;
  options.view = view;
  return options;
}

// An arc of the left hand, and the same arc twice as large.
TrailPicture handTrail() {
  TrailPicture trail;
  trail.samplesPerFrame = 4;
  for (int i = 0; i <= 32; ++i) {
    const double share = i / 32.0;
    const double angle = 2.6 * share * share;
    const Vec3 offset(0.25 * std::sin(angle), 0.4 - 0.4 * std::cos(angle), 0.3 * std::sin(0.5 * angle));
    trail.original.push_back(Vec3(0.45, 0.9, 0.1) + offset);
    trail.exaggerated.push_back(Vec3(0.45, 0.9, 0.1) + 1.6 * offset);
  }
  trail.spheres = {{trail.exaggerated[0], false, false},
                   {trail.exaggerated[16], true, false},
                   {trail.exaggerated[32], false, true}};
  trail.pivot = trail.exaggerated[0];
  trail.tip = trail.exaggerated[32];
  trail.currentSample = 22.0;
  return trail;
}

PictureFrame atRest(const Scene& scene) {
  return {{.frame = frameOf(scene, restPose(scene), 0.0)}};
}

PictureFrame waving(const Scene& scene) {
  return {{.frame = wavingFrame(scene), .trails = {{handTrail(), {}}}}};
}

} // namespace

TEST_CASE("Picture: the biped from the front") {
  const Scene scene = bipedScene();
  const auto image = renderFrame(scene, atRest(scene), smallPicture(ViewDirection::front));
  REQUIRE(image);
  const std::string difference = differenceFromBaseline("biped-front", *image);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("Picture: trail, skeleton and ghosts from three quarters") {
  const Scene scene = bipedScene();
  PictureFrame picture = waving(scene);
  picture.content.skeleton = true;
  picture.content.ghosts = {{frameOf(scene, restPose(scene), 0.0), rgba(okabe::skyBlue, 0.4F)}};
  const auto image = renderFrame(scene, picture, smallPicture(ViewDirection::threeQuarter));
  REQUIRE(image);
  const std::string difference = differenceFromBaseline("biped-trail", *image);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("Picture: stretch as colour, wires and a light background from the side") {
  const Scene scene = bipedScene();
  PictureFrame picture{{.frame = wavingFrame(scene)}};
  picture.content.style.shading = SurfaceShading::stretchHeat;
  picture.content.style.wireframe = true;
  picture.content.style.palette = lightPalette();
  FrameState& frame = picture.content.frame;
  frame.stretch.assign(scene.nodes.size(), Mat3(1.0));
  frame.stretch[at(BipedNodes{}.leftForearm)] = Mat3(1.0, 0, 0, 0, 2.2, 0, 0, 0, 1.0);
  frame.stretch[at(BipedNodes{}.head)] = Mat3(1.0, 0, 0, 0, 0.6, 0, 0, 0, 1.0);
  const auto image = renderFrame(scene, picture, smallPicture(ViewDirection::side));
  REQUIRE(image);
  const std::string difference = differenceFromBaseline("biped-stretch", *image);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("Picture: the selected limb and its handles at twice the display scale") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = ViewportRenderer::create();
  REQUIRE(renderer);
  const Scene scene = bipedScene();
  const FrameState frame = wavingFrame(scene);
  renderer->setScene(scene);
  SceneStyle style;
  style.palette = highContrastPalette();
  style.measures.characterHeight = 1.8;
  style.highlight.assign(scene.nodes.size(), 0.0F);
  const BipedNodes nodes;
  for (const NodeIndex node : {nodes.leftUpperArm, nodes.leftForearm, nodes.leftHand}) {
    style.highlight[at(node)] = 1.0F;
  }
  const Viewport viewport{320.0, 240.0, 2.0};
  const View view = makeView(
      fitted(lookFrom({}, ViewDirection::threeQuarter), viewport, BoundsSampler(scene).boxOf(scene, frame)),
      viewport);
  AxisHandles handles;
  handles.origin = positionOf(frame.worlds[at(nodes.leftHand)]);
  handles.lengthPoints = 36.0;
  RenderTarget target;
  REQUIRE(renderer->draw(target, view, {frame, {}, drawAxisHandles(view, handles, 1), style}).ok());
  Image image = target.readPixels();
  makeOpaque(image);
  const std::string difference = differenceFromBaseline("biped-handles", image);
  INFO(difference);
  CHECK(difference.empty());
}

namespace {

/// Pixels of the picture that have a colour, to a few steps of a channel.
int pixelsOf(const Image& image, const glm::vec4& colour) {
  int count = 0;
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    bool isIt = true;
    for (int channel = 0; channel < 3; ++channel) {
      const double value = image.rgba[i + static_cast<std::size_t>(channel)];
      isIt = isIt && std::abs(value - 255.0 * static_cast<double>(colour[channel])) < 24.0;
    }
    count += isIt ? 1 : 0;
  }
  return count;
}

} // namespace

TEST_CASE("A selected limb has a light and a dark line around it, whatever colour the body has") {
  const BipedNodes nodes;
  for (const Palette& palette : {darkPalette(), lightPalette(), highContrastPalette()}) {
    for (const glm::vec4& body : {rgba(okabe::orange), rgba(0xFFFFFF), rgba(0x101010), rgba(0xE8B89A)}) {
      Scene scene = bipedScene();
      for (Material& material : scene.materials) {
        material.baseColor = body;
      }
      PictureFrame picture = atRest(scene);
      picture.content.style.palette = palette;
      const auto plain = renderFrame(scene, picture, smallPicture(ViewDirection::threeQuarter));
      picture.content.style.highlight.assign(scene.nodes.size(), 0.0F);
      picture.content.style.highlight[at(nodes.leftForearm)] = 1.0F;
      const auto selected = renderFrame(scene, picture, smallPicture(ViewDirection::threeQuarter));
      REQUIRE(plain);
      REQUIRE(selected);
      const auto more = [&](const glm::vec4& colour) {
        return pixelsOf(*selected, colour) - pixelsOf(*plain, colour);
      };
      // The one that is like the body or the ground is not seen there: the other one is.
      CHECK(std::max(more(palette.selectionLine), more(palette.selectionGround)) > 20);
    }
  }
}

TEST_CASE("The same picture twice has the same bytes") {
  const Scene scene = bipedScene();
  PictureFrame picture = waving(scene);
  picture.label = "frame 7";
  const auto first = renderFrame(scene, picture, smallPicture(ViewDirection::threeQuarter));
  const auto second = renderFrame(scene, picture, smallPicture(ViewDirection::threeQuarter));
  REQUIRE(first);
  REQUIRE(second);
  CHECK(*encodePng(*first) == *encodePng(*second));
}

TEST_CASE("A standard view makes room for ghosts and for both paths of trails") {
  const Scene scene = bipedScene();
  PictureFrame picture = atRest(scene);
  const Box alone = boxOfPictures(scene, std::vector<PictureFrame>{picture});
  FrameState beside = picture.content.frame;
  for (Mat4& world : beside.worlds) {
    world[3].x += 3.0;
  }
  picture.content.ghosts = {{beside, glm::vec4(1.0F)}};
  StyledTrail trail;
  trail.path.original = {{0.0, 1.0, 0.0}, {-5.0, 1.0, 0.0}};
  trail.path.exaggerated = {{0.0, 1.0, 0.0}, {0.0, 9.0, 4.0}};
  picture.content.trails = {trail};
  const Box box = boxOfPictures(scene, std::vector<PictureFrame>{atRest(scene), picture});
  CHECK(box.maximum.x == Approx(alone.maximum.x + 3.0));
  CHECK(box.minimum.x == -5.0);
  CHECK(box.maximum.y == 9.0);
  CHECK(box.maximum.z == 4.0);
  CHECK(box.minimum.y == Approx(alone.minimum.y).margin(1e-9));
}

TEST_CASE("A contact sheet holds every picture in its cell") {
  const Scene scene = bipedScene();
  PictureOptions options = smallPicture(ViewDirection::front);
  options.widthPixels = 64;
  options.heightPixels = 64;
  std::vector<PictureFrame> pictures(5, atRest(scene));
  const auto sheet = renderSheet(scene, pictures, options, 3);
  REQUIRE(sheet);
  CHECK(sheet->width == 3 * 64 + 2 * 2);
  CHECK(sheet->height == 2 * 64 + 2);
  const auto pixel = [&](int x, int y) {
    return sheet->rgba[4 * static_cast<std::size_t>(y * sheet->width + x) + 1];
  };
  CHECK(static_cast<int>(pixel(32, 20)) > 60);
  CHECK(pixel(66 + 32, 66 + 20) == pixel(32, 20));
  CHECK(static_cast<int>(pixel(132 + 32, 66 + 20)) < 60); // the sixth cell stays empty
}

TEST_CASE("A contact sheet needs a picture and a size that fits") {
  const Scene scene = triangleScene();
  CHECK_FALSE(renderSheet(scene, {}, smallPicture(ViewDirection::front)));
  PictureOptions huge = smallPicture(ViewDirection::front);
  huge.widthPixels = 9000;
  CHECK_FALSE(renderFrame(scene, atRest(scene), huge));
}

TEST_CASE("A series stops when a picture cannot be kept") {
  const Scene scene = triangleScene();
  PictureOptions options = smallPicture(ViewDirection::front);
  const std::vector<PictureFrame> pictures(3, atRest(scene));
  std::size_t kept = 0;
  const Status status = renderSeries(scene, pictures, options, [&](std::size_t index, const Image&) {
    kept = index;
    return index == 1 ? Status(Error{"the disk is full", "", ""}) : Status(Success{});
  });
  CHECK_FALSE(status);
  CHECK(kept == 1);
}

TEST_CASE("Sheets come out about square, whatever the shape of their pictures") {
  CHECK(layOutSheet(16, 100, 100, 0).columns == 4);
  CHECK(layOutSheet(8, 100, 200, 0).columns == 4);
  CHECK(layOutSheet(2, 100, 100, 7).columns == 2);
  CHECK(layOutSheet(1, 100, 100, 0).widthPixels == 100);
}

TEST_CASE("A sheet has at least one picture, and at most 16384 pixels along each side") {
  CHECK(checkSheet({.widthPixels = 16384, .heightPixels = 16384}, 1));
  CHECK_FALSE(checkSheet({.widthPixels = 16385, .heightPixels = 16384}, 1));
  CHECK_FALSE(checkSheet({.widthPixels = 16384, .heightPixels = 16385}, 1));
  CHECK_FALSE(checkSheet({.widthPixels = 16, .heightPixels = 16}, 0));
  const SheetLayout layout = layOutSheet(7, 100, 50, 3);
  CHECK((layout.widthPixels == 304 && layout.heightPixels == 154)); // two pixels between three by three
  CHECK((layout.left(5) == 204 && layout.top(5) == 52));
}

TEST_CASE("Reducing a picture rounds to the nearest, and leaves out what makes no whole block") {
  Image image = filled(5, 3, glm::vec3(0.0F));
  image.rgba[0] = 1; // Of four: a quarter is nothing, a half is one.
  image.rgba[8] = 2;
  const Image half = reduced(image, 2);
  CHECK((half.width == 2 && half.height == 1));
  CHECK(half.rgba[0] == 0);
  CHECK(half.rgba[4] == 1);
}

TEST_CASE("Reducing a picture averages its blocks") {
  Image image = filled(4, 2, glm::vec3(0.0F));
  image.rgba[0] = 200;
  const Image half = reduced(image, 2);
  REQUIRE(half.width == 2);
  REQUIRE(half.height == 1);
  CHECK(half.rgba[0] == 50);
  CHECK(half.rgba[4] == 0);
}

TEST_CASE("A picture that cannot be written leaves what was there") {
  CHECK_FALSE(writePng("/nonexistent-folder/picture.png", filled(2, 2, glm::vec3(0.5F))));
  CHECK_FALSE(encodePng(Image{}));
}
