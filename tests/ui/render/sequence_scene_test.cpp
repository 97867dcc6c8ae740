#include <catch2/catch.hpp>

#include <memory>
#include <utility>

#include <glm/geometric.hpp>

#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/ui/render_frame.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/render/picture/picture.h"
#include "ui/render/scene/sequence_scene.h"
#include "ui/render/scene/value_colors.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

double lightness(std::uint32_t hex) {
  return 0.299 * ((hex >> 16U) & 0xFFU) + 0.587 * ((hex >> 8U) & 0xFFU) + 0.114 * (hex & 0xFFU);
}

/// A sphere whose one half, x > 0, carries the largest error and the other none.
Scene halfWrong() {
  const test::Shape ball = test::sphere(3);
  std::vector<float> errors;
  for (const glm::vec3& p : ball.positions) {
    errors.push_back(p.x > 0.0F ? 2.0F : 0.0F);
  }
  const PlainMesh mesh{ball.positions, ball.triangles, valueColors(ValueScale::error, errors, 2.0)};
  return sceneOfMeshes(std::span(&mesh, 1));
}

struct Pixel {
  int red = 0;
  int green = 0;
  int blue = 0;
};

Pixel pixelAt(const Image& image, double x, double y) {
  const auto column = static_cast<std::size_t>(x * image.width);
  const auto row = static_cast<std::size_t>(y * image.height);
  const std::size_t i = 4 * (row * static_cast<std::size_t>(image.width) + column);
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

} // namespace

TEST_CASE("colours of values keep their ends and read by lightness where they pass from nothing to some") {
  CHECK(valueColorHex(ValueScale::error, -1.0) == valueColorHex(ValueScale::error, 0.0));
  CHECK(valueColorHex(ValueScale::error, 7.0) == valueColorHex(ValueScale::error, 1.0));
  CHECK(lightness(valueColorHex(ValueScale::error, 0.35)) > lightness(valueColorHex(ValueScale::error, 0.0)));
  double before = 0.0;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double now = lightness(valueColorHex(ValueScale::thickness, share));
    CHECK(now > before);
    before = now;
  }
}

TEST_CASE("values without a scale are drawn as nothing") {
  const std::vector<float> values{0.0F, 3.0F};
  const auto colors = valueColors(ValueScale::error, values, 0.0);
  CHECK(colors[0] == colors[1]);
  CHECK(colors[0] == valueColor(ValueScale::error, 0.0));
}

TEST_CASE("a frame becomes a scene: one node for each mesh, smooth normals, colours as given") {
  const test::Shape ball = test::sphere(2);
  const std::vector<PlainMesh> meshes{{ball.positions, ball.triangles, {glm::vec4(1.0F, 0.0F, 0.0F, 1.0F)}},
                                      {ball.positions, ball.triangles, {glm::vec4(0.0F, 1.0F, 0.0F, 1.0F)}}};
  const Scene scene = sceneOfMeshes(meshes);
  REQUIRE(scene.roots.size() == 2);
  const Primitive& primitive = scene.meshes[1].primitives[0];
  CHECK(primitive.colors.size() == ball.positions.size());
  CHECK(primitive.colors.back() == glm::vec4(0.0F, 1.0F, 0.0F, 1.0F));
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    CHECK(glm::dot(primitive.normals[v], ball.positions[v]) > 0.99F);
  }
}

TEST_CASE("pictures of a sequence show the frames that were asked for, one scene for all") {
  const auto tube = std::make_shared<const MeshSequence>(test::shorteningTube(6, 2.0, 0.0, 0.0));
  SequenceContent content{tube, nullptr, nullptr, tube};
  app::SequenceView compared;
  compared.look = app::SequenceLook::compare;
  const auto pictures = picturesOfSequence(content, compared, {}, {0.0, 5.0}, {});
  REQUIRE(pictures);
  REQUIRE(pictures->pictures.size() == 2);
  CHECK(pictures->drawing->scene().meshes.size() == 2);
  const SceneShape last = pictures->pictures[1].content.shape();
  REQUIRE(last.size() == 2);
  const std::size_t vertex = tube->vertexCount / 2;
  CHECK(last[1].positions[vertex] == std::as_const(*tube).frame(5)[vertex]);
  CHECK(pictures->pictures[1].label == "frame 5");
}

TEST_CASE("a frame between two shows the nearer one, by whose number it is told beside others") {
  const auto tube = std::make_shared<const MeshSequence>(test::shorteningTube(6, 2.0, 0.0, 0.0));
  const SequenceContent content{tube, nullptr, nullptr, nullptr};
  const auto labels = [&](const std::string& name, const std::vector<double>& frames) {
    std::vector<std::string> found;
    const auto drawn = picturesOfSequence(content, {}, {false, name}, frames, {});
    REQUIRE(drawn);
    for (const PictureFrame& picture : drawn->pictures) {
      found.push_back(picture.label);
    }
    return found;
  };
  CHECK(labels("", {1.4, 2.6}) == std::vector<std::string>{"frame 1", "frame 3"});
  CHECK(labels("mesh", {1.4, 5.4}) == std::vector<std::string>{"mesh, frame 1", "mesh, frame 5"});
  CHECK(labels("mesh", {2.6}) == std::vector<std::string>{"mesh"});
  CHECK(labels("", {2.6}) == std::vector<std::string>{""});
  CHECK_FALSE(picturesOfSequence(content, {}, {}, {5.6}, {}));
}

TEST_CASE("frames that are not there and clips of other meshes are refused") {
  const auto tube = std::make_shared<const MeshSequence>(test::shorteningTube(6, 2.0, 0.0, 0.0));
  const auto shorter = std::make_shared<const MeshSequence>(test::shorteningTube(5, 2.0, 0.0, 0.0));
  CHECK_FALSE(picturesOfSequence({tube, nullptr, nullptr, nullptr}, {}, {}, {6.0}, {}));
  CHECK_FALSE(picturesOfSequence({tube, nullptr, nullptr, nullptr}, {}, {}, {-1.0}, {}));
  CHECK_FALSE(picturesOfSequence({tube, nullptr, nullptr, shorter}, {}, {}, {0.0}, {}));
}

TEST_CASE("Picture: the wrong half of a body is red, the right one grey") {
  const Scene scene = halfWrong();
  PictureOptions options;
  options.widthPixels = 160;
  options.heightPixels = 160;
  options.view = ViewDirection::front;
  PictureFrame picture{{.frame = restOf(scene)}};
  picture.content.style.floor = false;
  const auto image = test::renderFrame(scene, picture, options);
  REQUIRE(image);
  const Pixel wrong = pixelAt(*image, 0.62, 0.5);
  const Pixel right = pixelAt(*image, 0.38, 0.5);
  CHECK(wrong.red > wrong.blue + 60);
  CHECK(std::abs(right.red - right.blue) < 40);
}
