// A mesh sequence drawn with what its source says of its looks.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/ui/picture_baseline.h"
#include "tests/support/ui/render_frame.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/scene/sequence_surface.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// Squares of four colours, so that every corner of the picture is told apart.
Image weave() {
  Image image = filled(16, 16, {0.9F, 0.1F, 0.1F});
  paste(image, filled(8, 8, {0.1F, 0.8F, 0.1F}), 8, 0);
  paste(image, filled(8, 8, {0.1F, 0.1F, 0.9F}), 0, 8);
  return image;
}

/// The file of the two sheets with the picture beside it.
std::filesystem::path sheetsIn(const test::TemporaryFolder& folder) {
  REQUIRE(writePng(folder / "weave.png", weave()));
  test::twoSheets("weave.png").write(folder / "sheets.glb");
  return folder / "sheets.glb";
}

PictureOptions smallPictures() {
  PictureOptions options;
  options.widthPixels = 320;
  options.heightPixels = 200;
  options.view = ViewDirection::front;
  return options;
}

struct BothWays {
  Image asCharacter;
  Image asSequence;
};

/// A frame of the file, drawn as a character and as a mesh sequence, by the same camera.
BothWays drawn(const std::filesystem::path& path, double frame) {
  auto sequence = skinning::readSequence({path});
  REQUIRE(sequence);
  const auto mesh = std::make_shared<const MeshSequence>(std::move(sequence).value());
  PictureOptions options = smallPictures();
  auto pictures = picturesOfSequence({mesh, nullptr, nullptr, nullptr}, {}, {}, {frame}, options);
  REQUIRE(pictures);
  pictures->pictures[0].content.style.floor = false; // its shadows are those of a character's rest
  options.camera = pictures->camera;
  const auto asSequence = test::renderFrame(pictures->drawing->scene(), pictures->pictures[0], options);
  const auto document = app::openDocument(path);
  REQUIRE(document);
  const auto motion = std::make_shared<const rig::MotionState>(app::prepareMotion(*document, 0));
  PictureFrame character = picturesOfCharacter(*document, motion, {frame}, {})[0];
  character.content.style.floor = false;
  const auto asCharacter = test::renderFrame(*document->scene, character, options);
  REQUIRE(asSequence);
  REQUIRE(asCharacter);
  return {*asCharacter, *asSequence};
}

/// Share of the pixels in which one channel stands out.
double vividShare(const Image& image) {
  std::size_t vivid = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const auto [least, most] = std::minmax({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    vivid += most - least > 90 ? 1 : 0;
  }
  return 4.0 * static_cast<double>(vivid) / static_cast<double>(image.rgba.size());
}

/// A box whose six sides have normals of their own, as a file with hard edges gives it; frame 1 is turned by
/// a quarter around y.
MeshSequence turningBox() {
  MeshSequence box;
  box.vertexCount = 8;
  for (const bool isTurned : {false, true}) {
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 p((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
      box.positions.push_back(isTurned ? glm::vec3(p.z, p.y, -p.x) : p);
    }
  }
  gltf::MeshSurface surface;
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  const std::array<glm::vec3, 6> normals{
      {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const auto first = static_cast<std::uint32_t>(surface.places.size());
    for (const std::uint32_t corner : faces[face]) {
      surface.places.push_back(corner);
      surface.normals.push_back(normals[face]);
    }
    for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}}) {
      surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      box.triangles.push_back({faces[face][t[0]], faces[face][t[1]], faces[face][t[2]]});
    }
  }
  surface.parts = {{"box", -1, 0, surface.triangles.size()}};
  box.surface = std::make_shared<const gltf::MeshSurface>(std::move(surface));
  return box;
}

} // namespace

TEST_CASE("Picture: a sequence with pictures and painted vertices looks as its file does") {
  const test::TemporaryFolder folder;
  const auto path = sheetsIn(folder);
  const double frame = GENERATE(0.0, 6.0, 12.0);
  const BothWays pictures = drawn(path, frame);
  const test::PictureDifference difference =
      test::differenceBetween(pictures.asCharacter, pictures.asSequence);
  CAPTURE(frame, difference.mean, difference.worstTile, difference.worstLeft, difference.worstTop);
  CHECK_FALSE(test::isVisible(difference));
  CHECK(vividShare(pictures.asSequence) > 0.02);
}

TEST_CASE("hard edges stay hard while a body turns, and its normals turn with it") {
  const MeshSequence box = turningBox();
  const SequenceSurface surface(box);
  const SceneShape turned = surface.shapeAt(box.frame(1));
  REQUIRE(turned.size() == 1);
  REQUIRE(turned[0].normals.size() == 24);
  for (std::size_t v = 0; v < 24; ++v) {
    const glm::vec3 before = box.surface->normals[v];
    CHECK(glm::distance(turned[0].normals[v], glm::vec3(before.z, before.y, -before.x)) < 1e-5F);
  }
}

TEST_CASE("a sequence that says nothing of its looks is smooth, grey and seen from both sides") {
  MeshSequence ball = test::still(test::sphere(2));
  const SequenceSurface surface(ball);
  const Scene scene = surface.scene();
  REQUIRE(scene.meshes.size() == 1);
  const Primitive& primitive = scene.meshes[0].primitives.at(0);
  const Material& material = scene.materials.at(static_cast<std::size_t>(primitive.material));
  CHECK(material.doubleSided);
  CHECK(material.baseColor == clayColor());
  for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
    CHECK(glm::dot(primitive.normals[v], primitive.positions[v]) > 0.99F);
  }
}

TEST_CASE("moved vertices are drawn where the shape says, and their shadow is looked for there") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = SceneRenderer::create();
  REQUIRE(renderer);
  const MeshSequence tube = test::shorteningTube(6, 2.0, 0.0, 0.0);
  const SequenceSurface surface(tube);
  const Scene scene = surface.scene();
  renderer->setScene(scene);
  const SceneShape shape = surface.shapeAt(tube.frame(5));
  renderer->reshape(shape);
  const std::vector<glm::vec3> posed = renderer->posedPositions(restOf(scene), 0);
  REQUIRE(posed.size() == shape[0].positions.size());
  double farthest = 0.0;
  for (std::size_t v = 0; v < posed.size(); ++v) {
    farthest = std::max(farthest, static_cast<double>(glm::distance(posed[v], shape[0].positions[v])));
  }
  CHECK(farthest < 1e-5);

  BoundsSampler bounds(scene);
  bounds.reshape(shape);
  Box exact;
  std::ranges::for_each(shape[0].positions, [&](const glm::vec3& p) { exact.add(Vec3(p)); });
  const Box sampled = bounds.boxOf(scene, restOf(scene));
  CHECK(glm::distance(sampled.minimum, exact.minimum) < 0.1);
  CHECK(glm::distance(sampled.maximum, exact.maximum) < 0.1);
}
