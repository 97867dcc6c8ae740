#include <catch2/catch.hpp>

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "../../support/ui/render_scenes.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/picture/viewport_renderer.h"
#include "ui/render/scene/bounds.h"

using namespace stretch;
using namespace stretch::ui;
using namespace stretch::test;

namespace {

struct Posed {
  Vec3 position{0.0};
  Vec3 normal{0.0};
};

// The reference: linear blend skinning in double precision, written out.
Posed posedOnCpu(const Primitive& primitive, const std::vector<Mat4>& matrices,
                 const std::vector<float>& morphWeights, std::size_t vertex) {
  Vec3 position(primitive.positions[vertex]);
  Vec3 normal(primitive.normals[vertex]);
  for (std::size_t target = 0; target < morphWeights.size(); ++target) {
    const auto weight = static_cast<double>(morphWeights[target]);
    position += weight * Vec3(primitive.morphTargets[target].positions[vertex]);
    normal += weight * Vec3(primitive.morphTargets[target].normals[vertex]);
  }
  Mat4 blended(0.0);
  for (std::size_t k = 0; k < VertexInfluences::capacity; ++k) {
    const VertexInfluences& influences = primitive.influences[vertex];
    blended += static_cast<double>(influences.weights[k]) * matrices[influences.joints[k]];
  }
  return {Vec3(blended * Vec4(position, 1.0)),
          glm::normalize(glm::transpose(glm::inverse(Mat3(blended))) * normal)};
}

SceneStyle plainStyle() {
  SceneStyle style;
  style.quality = qualityOf(0);
  style.floor = false;
  return style;
}

glm::ivec3 colorAt(const Image& image, int x, int y) {
  const auto index =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[index], image.rgba[index + 1], image.rgba[index + 2]};
}

Image pictureOf(const Scene& scene, const FrameState& frame, const View& view, const SceneStyle& style) {
  auto renderer = ViewportRenderer::create();
  REQUIRE(renderer);
  renderer->setScene(scene);
  RenderTarget target;
  REQUIRE(renderer->draw(target, view, {frame, {}, Overlay{}, style}).ok());
  return target.readPixels();
}

// The middle of the triangle, seen from the front.
glm::ivec3 middleOf(const Scene& scene) {
  const View view = makeView(lookFrom({}, ViewDirection::front), {64.0, 64.0, 1.0});
  return colorAt(pictureOf(scene, frameOf(scene, restPose(scene), 0.0), view, plainStyle()), 32, 32);
}

bool isNear(const glm::ivec3& color, const glm::ivec3& expected) {
  return glm::all(glm::lessThanEqual(glm::abs(color - expected), glm::ivec3(2)));
}

// The triangle with a texture of four pixels, red and green above blue and white, seen at one place of it.
Scene texturedTriangle(const glm::vec2& place) {
  Scene scene = triangleScene();
  scene.meshes[0].primitives[0].texCoords.assign(3, place);
  scene.materials[0].baseColorTexture.image = 0;
  scene.materials[0].baseColorTexture.nearestFilter = true;
  scene.images.push_back({2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}});
  return scene;
}

constexpr glm::ivec3 red(255, 0, 0);
constexpr glm::ivec3 green(0, 255, 0);
constexpr glm::ivec3 blue(0, 0, 255);

// A red triangle behind the white one, drawn after it: both half-transparent or solid by their alpha.
Scene twoBlendedTriangles(float frontAlpha) {
  Scene scene = triangleScene();
  scene.materials[0].alphaMode = AlphaMode::blend;
  scene.materials[0].baseColor.a = frontAlpha;
  Material behind = scene.materials[0];
  behind.baseColor = {1.0F, 0.0F, 0.0F, 1.0F};
  scene.materials.push_back(behind);
  Primitive farther = scene.meshes[0].primitives[0];
  farther.material = 1;
  for (glm::vec3& position : farther.positions) {
    position.z -= 0.5F;
  }
  scene.meshes[0].primitives.push_back(farther);
  return scene;
}

} // namespace

TEST_CASE("A texture is read where its transform says, and beyond its edges as its sampler says") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = texturedTriangle({0.25F, 0.25F});
  TextureUse& use = scene.materials[0].baseColorTexture;
  CHECK(isNear(middleOf(scene), red));
  use.uvTransform[2] = {0.5F, 0.0F};
  CHECK(isNear(middleOf(scene), green));
  use.uvTransform = glm::mat3x2(0.0F, 3.0F, 0.0F, 0.0F, 0.25F, 0.0F); // v from u, three times
  CHECK(isNear(middleOf(scene), blue));
  use.uvTransform = glm::mat3x2(1.0F, 0.0F, 0.0F, 1.0F, 1.0F, 0.0F);
  CHECK(isNear(middleOf(scene), red));
  use.wrapU = TextureWrap::clamp;
  CHECK(isNear(middleOf(scene), green));
  use.uvTransform[2] = {1.6F, 0.0F};
  use.wrapU = TextureWrap::mirror;
  CHECK(isNear(middleOf(scene), red));
}

TEST_CASE("Colours of vertices and of the material multiply") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  scene.materials[0].baseColor = {1.0F, 0.5F, 1.0F, 1.0F};
  scene.meshes[0].primitives[0].colors.assign(3, {0.0F, 1.0F, 1.0F, 1.0F});
  CHECK(isNear(middleOf(scene), {0, 188, 255})); // 0.5 in linear light
}

TEST_CASE("A lit surface glows by its emissive texture, an unlit one does not") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = texturedTriangle({0.25F, 0.25F});
  Material& material = scene.materials[0];
  std::swap(material.baseColorTexture, material.emissiveTexture);
  scene.meshes[0].primitives[0].emissiveTexCoords.assign(3, {0.25F, 0.75F});
  material.baseColor = {0.0F, 0.0F, 0.0F, 1.0F};
  material.emissive = glm::vec3(8.0F);
  CHECK(middleOf(scene) == glm::ivec3(0));
  material.unlit = false;
  const glm::ivec3 color = middleOf(scene);
  CHECK(color.b > 245);
  CHECK(color.r < 120);
  scene.images[0] = {}; // cannot be shown: no glow at all
  CHECK(middleOf(scene).b < 120);
}

TEST_CASE(
    "A blended surface shows what is behind it where it is see-through, and hides it where it is solid") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  CHECK(isNear(middleOf(twoBlendedTriangles(1.0F)), glm::ivec3(255)));
  CHECK(isNear(middleOf(twoBlendedTriangles(0.0F)), red));
  const glm::ivec3 half = middleOf(twoBlendedTriangles(0.5F));
  CHECK(half.r > 250);
  CHECK((half.g > 100 && half.g < 200));
}

TEST_CASE("Of a blended surface with two sides the far side is seen through the near one") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  scene.materials[0].alphaMode = AlphaMode::blend;
  scene.materials[0].baseColor.a = 0.5F;
  scene.materials[0].doubleSided = true;
  Primitive& surface = scene.meshes[0].primitives[0]; // white in front, then red behind with its back to us
  surface.colors.assign(3, glm::vec4(1.0F));
  for (int corner = 0; corner < 3; ++corner) {
    const auto i = static_cast<std::size_t>(corner);
    surface.positions.push_back(surface.positions[i] - glm::vec3(0.0F, 0.0F, 0.5F));
    surface.normals.push_back(surface.normals[i]);
    surface.colors.emplace_back(1.0F, 0.0F, 0.0F, 1.0F);
  }
  surface.indices.insert(surface.indices.end(), {3U, 5U, 4U});
  CHECK(middleOf(scene).g > 115); // half of the white, not a quarter of it
}

TEST_CASE("Of two see-through things the near one is seen over the far one, whichever the file has first") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  const auto seen = [](bool nearFirst) {
    Scene scene = triangleScene();
    scene.materials[0].alphaMode = AlphaMode::blend;
    scene.materials[0].baseColor = {0.0F, 0.0F, 1.0F, 0.5F};
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].baseColor = {1.0F, 0.0F, 0.0F, 0.5F};
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].primitives[0].material = 1;
    scene.nodes.push_back(scene.nodes[0]);
    scene.roots.emplace_back(1);
    scene.nodes[0].mesh = nearFirst ? 0 : 1; // The blue one is near.
    scene.nodes[1].mesh = nearFirst ? 1 : 0;
    scene.nodes[0].rest.translation.z = nearFirst ? 0.5 : -0.5;
    scene.nodes[1].rest.translation.z = nearFirst ? -0.5 : 0.5;
    return middleOf(scene);
  };
  CHECK(seen(true).b > seen(true).r + 20);
  CHECK(seen(true) == seen(false));
}

TEST_CASE("What no root of the scene leads to is not drawn, what hangs below one is") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  scene.roots.clear();
  CHECK(middleOf(scene).r < 80);
  Node group;
  group.children.emplace_back(0);
  scene.nodes.push_back(group);
  scene.nodes[0].parent = NodeIndex(1);
  scene.roots.emplace_back(1);
  CHECK(middleOf(scene).r == 255);
}

TEST_CASE("Seen from the front the floor is a line at its height") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  const Scene empty;
  const View view = makeView(lookFrom({}, ViewDirection::front), {64.0, 64.0, 1.0});
  SceneStyle style = plainStyle();
  style.measures.floorHeight = GENERATE(0.0, 0.6);
  style.measures.characterHeight = 1.8;
  const FrameState frame = frameOf(empty, restPose(empty), 0.0);
  const Image without = pictureOf(empty, frame, view, style);
  style.floor = true;
  const Image with = pictureOf(empty, frame, view, style);
  const double wanted = projectToPixels(view, {0.0, style.measures.floorHeight, 0.0})->pixels.y;
  int rows = 0;
  for (int y = 0; y < 64; ++y) {
    const bool isDrawn = !isNear(colorAt(with, 32, y), colorAt(without, 32, y));
    rows += isDrawn ? 1 : 0;
    CAPTURE(y, wanted);
    CHECK((!isDrawn || std::abs(y + 0.5 - wanted) < 2.0));
  }
  CHECK(rows > 0);
}

TEST_CASE("An opaque material shows no alpha") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  scene.materials[0].baseColor.a = 0.1F;
  CHECK(isNear(middleOf(scene), glm::ivec3(255)));
}

TEST_CASE("A triangle covers just the pixels that it covers") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  const Scene scene = triangleScene();
  Camera camera = lookFrom({}, ViewDirection::front);
  camera.target = {0.0, 1.0, 0.0};
  camera.distance = 5.0;
  const View view = makeView(camera, {200.0, 200.0, 1.0});
  const Image image = pictureOf(scene, frameOf(scene, restPose(scene), 0.0), view, plainStyle());
  for (const Vec3& inside : {Vec3(0, 0.1, 0), Vec3(0, 1.9, 0), Vec3(-0.9, 0.05, 0), Vec3(0.4, 1.1, 0)}) {
    const Vec2 pixels = projectToPixels(view, inside)->pixels;
    CHECK(colorAt(image, static_cast<int>(pixels.x), static_cast<int>(pixels.y)) == glm::ivec3(255));
  }
  for (const Vec3& outside : {Vec3(0, -0.1, 0), Vec3(0, 2.1, 0), Vec3(-0.9, 0.4, 0), Vec3(0.6, 1.1, 0)}) {
    const Vec2 pixels = projectToPixels(view, outside)->pixels;
    CHECK(colorAt(image, static_cast<int>(pixels.x), static_cast<int>(pixels.y)).r < 80);
  }
}

TEST_CASE("A single-sided surface is not seen from behind, a double-sided one is") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  const bool doubleSided = GENERATE(false, true);
  scene.materials[0].doubleSided = doubleSided;
  Camera camera = lookFrom({}, ViewDirection::back);
  const View view = makeView(camera, {64.0, 64.0, 1.0});
  const Image image = pictureOf(scene, frameOf(scene, restPose(scene), 0.0), view, plainStyle());
  CHECK((colorAt(image, 32, 32).r > 200) == doubleSided);
}

TEST_CASE("A mirrored surface still shows its front") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  scene.nodes[0].rest.scale.x = -1.0;
  const View view = makeView(lookFrom({}, ViewDirection::front), {64.0, 64.0, 1.0});
  const Image image = pictureOf(scene, frameOf(scene, restPose(scene), 0.0), view, plainStyle());
  CHECK(colorAt(image, 32, 32).r > 200);
}

TEST_CASE("Masked pixels below the cutoff are left out") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  scene.materials[0].alphaMode = AlphaMode::mask;
  const float alpha = GENERATE(0.4F, 0.6F);
  scene.materials[0].baseColor.a = alpha;
  const View view = makeView(lookFrom({}, ViewDirection::front), {64.0, 64.0, 1.0});
  const Image image = pictureOf(scene, frameOf(scene, restPose(scene), 0.0), view, plainStyle());
  CHECK((colorAt(image, 32, 32).r > 200) == (alpha > 0.5F));
}

TEST_CASE("A texture's pixels arrive as the sRGB values that they are") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  Scene scene = triangleScene();
  scene.meshes[0].primitives[0].texCoords.assign(3, {0.5F, 0.5F});
  scene.materials[0].baseColorTexture.image = 0;
  scene.images.push_back({1, 1, {188, 96, 40, 255}});
  const View view = makeView(lookFrom({}, ViewDirection::front), {64.0, 64.0, 1.0});
  const glm::ivec3 color =
      colorAt(pictureOf(scene, frameOf(scene, restPose(scene), 0.0), view, plainStyle()), 32, 32);
  CHECK(std::abs(color.r - 188) <= 1);
  CHECK(std::abs(color.g - 96) <= 1);
  CHECK(std::abs(color.b - 40) <= 1);
}

TEST_CASE("The graphics card poses a skin as the CPU formula does") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = SceneRenderer::create();
  REQUIRE(renderer);
  const Scene scene = manyJointsScene();
  const FrameState frame = twistedFrame(scene);
  renderer->setScene(scene);
  const std::vector<glm::vec3> positions = renderer->posedPositions(frame, 0);
  const std::vector<glm::vec3> normals = renderer->posedNormals(frame, 0);

  const Primitive& primitive = scene.meshes[0].primitives[0];
  const std::vector<Mat4> matrices = skinMatrices(scene.skins[0], frame);
  REQUIRE(positions.size() == primitive.positions.size());
  double farthest = 0.0;
  double mostTurned = 0.0;
  Box box;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Posed expected = posedOnCpu(primitive, matrices, frame.pose.weights.back(), i);
    box.add(expected.position);
    farthest = std::max(farthest, glm::length(Vec3(positions[i]) - expected.position));
    mostTurned = std::max(mostTurned, glm::length(Vec3(normals[i]) - expected.normal));
  }
  const double size = glm::length(box.size());
  REQUIRE(size > 1.0);
  CHECK(farthest <= 1e-5 * size);
  CHECK(mostTurned <= 2e-3);
}

TEST_CASE("Normals by the joints' own matrices are turned on the graphics card as on the CPU") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = SceneRenderer::create();
  REQUIRE(renderer);
  const Scene scene = manyJointsScene();
  FrameState frame = frameOf(scene, restPose(scene), 0.0);
  frame.stretch.assign(scene.nodes.size(), Mat3(1.0));
  for (const NodeIndex joint : scene.skins[0].joints) {
    frame.stretch[at(joint)] = Mat3(2.0, 0.0, 0.0, 0.3, 0.6, 0.0, 0.0, 0.0, 0.7);
  }
  renderer->setScene(scene);
  SceneStyle style;
  style.normals = skinning::NormalMatrix::plain;
  const auto mostApart = [&](const std::vector<glm::vec3>& a, const std::vector<Vec3>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      most = std::max(most, glm::length(Vec3(a[i]) - b[i]));
    }
    return most;
  };
  const std::vector<glm::vec3> plain = renderer->posedNormals(frame, 0, style);
  REQUIRE(plain.size() == scene.meshes[0].primitives[0].positions.size());
  CHECK(mostApart(plain, skinning::skinnedNormals(scene, frame, skinning::NormalMatrix::plain)) < 2e-3);
  CHECK(mostApart(plain, skinning::skinnedNormals(scene, frame)) > 0.1);
  // Told by translations, the stretch moves vertices and turns nothing.
  style.newStretchTurns = false;
  FrameState unstretched = frame;
  unstretched.stretch.assign(scene.nodes.size(), Mat3(1.0));
  CHECK(mostApart(renderer->posedNormals(frame, 0, style), skinning::skinnedNormals(scene, unstretched)) <
        2e-3);
  CHECK(mostApart(renderer->posedNormals(frame, 0), skinning::skinnedNormals(scene, frame)) < 2e-3);
}

TEST_CASE("Morph weights of one frame do not linger in the next") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = SceneRenderer::create();
  REQUIRE(renderer);
  const Scene scene = manyJointsScene();
  const FrameState rest = frameOf(scene, restPose(scene), 0.0);
  renderer->setScene(scene);
  const auto before = renderer->posedPositions(rest, 0);
  const auto twisted = renderer->posedPositions(twistedFrame(scene), 0);
  CHECK(twisted != before);
  CHECK(renderer->posedPositions(rest, 0) == before);
}

TEST_CASE("The sampled box holds the posed character closely") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = SceneRenderer::create();
  REQUIRE(renderer);
  const Scene scene = bipedScene();
  const FrameState frame = wavingFrame(scene);
  renderer->setScene(scene);
  Box exact;
  for (std::size_t primitive = 0; primitive < 3; ++primitive) {
    for (const glm::vec3& position : renderer->posedPositions(frame, primitive)) {
      exact.add(Vec3(position));
    }
  }
  const Box sampled = BoundsSampler(scene).boxOf(scene, frame);
  CHECK(glm::length(sampled.minimum - exact.minimum) < 1e-4);
  CHECK(glm::length(sampled.maximum - exact.maximum) < 1e-4);
}

TEST_CASE("The character is the brightest thing in the dark viewport") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  const Scene scene = bipedScene();
  const FrameState frame = frameOf(scene, restPose(scene), 0.0);
  SceneStyle style;
  style.quality = qualityOf(3);
  style.measures.characterHeight = 1.8;
  Camera camera = lookFrom({}, ViewDirection::threeQuarter);
  const View view = makeView(fitted(camera, {320.0, 240.0, 1.0}, BoundsSampler(scene).boxOf(scene, frame)),
                             {320.0, 240.0, 1.0});
  const Image with = pictureOf(scene, frame, view, style);
  style.mesh = false;
  const Image without = pictureOf(scene, frame, view, style);
  int brightestGround = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      brightestGround = std::max(brightestGround, colorAt(without, x, y).g);
    }
  }
  const Vec2 face = projectToPixels(view, {0.0, 1.66, 0.13})->pixels;
  CHECK(colorAt(with, static_cast<int>(face.x), static_cast<int>(face.y)).g > 2 * brightestGround);
}

TEST_CASE("A frame is drawn into a target without touching the state around it") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto renderer = ViewportRenderer::create();
  REQUIRE(renderer);
  const Scene scene = bipedScene();
  renderer->setScene(scene);
  RenderTarget outer;
  RenderTarget inner;
  REQUIRE(outer.resize(32, 16, 1).ok());
  outer.bind();
  const View view = makeView(Camera{}, {64.0, 64.0, 1.0});
  REQUIRE(renderer->draw(inner, view, {wavingFrame(scene), {}, Overlay{}, SceneStyle{}}).ok());
  CHECK(inner.width() == 64);
  CHECK(inner.textureId() != 0U);
  RenderTarget other;
  REQUIRE(other.resize(8, 8, 1).ok());
  outer.resolve();
  CHECK(outer.readPixels().width == 32);
}

TEST_CASE("A scene without anything to show is still drawn") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  const Scene empty;
  const View view = makeView(Camera{}, {32.0, 32.0, 1.0});
  const Image image = pictureOf(empty, frameOf(empty, restPose(empty), 0.0), view, SceneStyle{});
  CHECK(colorAt(image, 16, 2).r < 80);
}
