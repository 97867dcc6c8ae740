// A heavy character with few triangles, for pictures of it in motion.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/heavy_scene.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/picture_baseline.h"
#include "ui/render/scene/thinned_meshes.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

constexpr std::uint32_t around = 200;
constexpr std::uint32_t upwards = 100;

/// A ball of radius 1 with a seam of the texture at x > 0, z = 0; what is above its middle follows joint 1,
/// what is below joint 0.
Primitive ball() {
  Primitive made;
  made.material = 3;
  made.morphTargets.resize(1);
  for (std::uint32_t row = 0; row <= upwards; ++row) {
    for (std::uint32_t column = 0; column <= around; ++column) {
      const float across = static_cast<float>(column) / around;
      const float height = static_cast<float>(row) / upwards;
      const float turn = 2.0F * glm::pi<float>() * across;
      const float tilt = glm::pi<float>() * (height - 0.5F);
      const glm::vec3 place(std::cos(tilt) * std::cos(turn), std::sin(tilt), std::cos(tilt) * std::sin(turn));
      made.positions.push_back(place);
      made.normals.push_back(place);
      made.texCoords.emplace_back(across, height);
      made.colors.emplace_back(across, height, 0.0F, 1.0F);
      made.morphTargets[0].positions.push_back(0.1F * place);
      VertexInfluences influences;
      influences.joints[1] = place.y > 0.0F ? 1 : 0;
      influences.joints[0] = 7;
      influences.weights[0] = 0.25F;
      influences.weights[1] = 0.75F;
      made.influences.push_back(influences);
    }
  }
  for (std::uint32_t row = 0; row < upwards; ++row) {
    for (std::uint32_t column = 0; column < around; ++column) {
      const std::uint32_t first = row * (around + 1) + column;
      for (const std::uint32_t corner :
           {first, first + around + 1, first + 1, first + 1, first + around + 1, first + around + 2}) {
        made.indices.push_back(corner);
      }
    }
  }
  return made;
}

std::vector<Mesh> meshesOf(std::vector<Primitive> primitives) {
  Mesh mesh;
  mesh.name = "ball";
  mesh.morphWeights = {0.5F};
  mesh.primitives = std::move(primitives);
  return {mesh};
}

Primitive moved(Primitive primitive, float size, const glm::vec3& by) {
  for (glm::vec3& place : primitive.positions) {
    place = size * place + by;
  }
  return primitive;
}

} // namespace

TEST_CASE("A ball of forty thousand triangles keeps its shape with four thousand") {
  const Primitive source = ball();
  const std::vector<Mesh> thinned = thinnedMeshes(meshesOf({source}), 4000);
  REQUIRE(thinned.size() == 1);
  CHECK(thinned[0].name == "ball");
  CHECK(thinned[0].morphWeights == std::vector<float>{0.5F});
  REQUIRE(thinned[0].primitives.size() == 1);
  const Primitive& primitive = thinned[0].primitives[0];
  CHECK(primitive.material == 3);
  CHECK(triangleCount(thinned) > 2000);
  CHECK(triangleCount(thinned) < 8000);
  REQUIRE(primitive.positions.size() == primitive.influences.size());
  REQUIRE(primitive.positions.size() == primitive.normals.size());
  REQUIRE(primitive.positions.size() == primitive.texCoords.size());
  REQUIRE(primitive.positions.size() == primitive.colors.size());
  REQUIRE(primitive.morphTargets.size() == 1);
  REQUIRE(primitive.positions.size() == primitive.morphTargets[0].positions.size());
  CHECK(primitive.morphTargets[0].normals.empty());
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    const glm::vec3& place = primitive.positions[i];
    CHECK(glm::length(place) == Approx(1.0));
    CHECK(primitive.normals[i] == place);
    CHECK(glm::distance(primitive.morphTargets[0].positions[i], 0.1F * place) < 1e-6F);
    CHECK(primitive.influences[i].joints[1] == (place.y > 0.0F ? 1 : 0));
    CHECK(primitive.colors[i].x == primitive.texCoords[i].x);
  }
  double longest = 0.0;
  for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
    for (std::size_t side = 0; side < 3; ++side) {
      REQUIRE(primitive.indices[i + side] < primitive.positions.size());
      const std::uint32_t a = primitive.indices[i + side];
      const std::uint32_t b = primitive.indices[i + (side + 1) % 3];
      CHECK(primitive.positions[a] != primitive.positions[b]);
      longest = std::max(longest,
                         static_cast<double>(glm::distance(primitive.positions[a], primitive.positions[b])));
      CHECK(std::abs(primitive.texCoords[a].x - primitive.texCoords[b].x) < 0.4F); // Not across the seam.
    }
  }
  CHECK(longest < 0.3);
}

TEST_CASE("Vertices at one place that follow two bones stay apart when they are thinned") {
  Primitive both = ball();
  const Primitive other = ball();
  const auto first = static_cast<std::uint32_t>(both.positions.size());
  both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
  both.normals.insert(both.normals.end(), other.normals.begin(), other.normals.end());
  both.texCoords.insert(both.texCoords.end(), other.texCoords.begin(), other.texCoords.end());
  both.colors.insert(both.colors.end(), other.colors.begin(), other.colors.end());
  both.morphTargets.clear();
  for (VertexInfluences influences : other.influences) {
    influences.joints[1] = 9;
    both.influences.push_back(influences);
  }
  for (const std::uint32_t corner : other.indices) {
    both.indices.push_back(first + corner);
  }
  const Primitive thin = thinnedMeshes(meshesOf({both}), 8000)[0].primitives[0];
  const auto ofSecond = std::ranges::count_if(
      thin.influences, [](const VertexInfluences& influences) { return influences.joints[1] == 9; });
  const auto all = static_cast<double>(thin.influences.size());
  CHECK(static_cast<double>(ofSecond) == Approx(0.5 * all).epsilon(0.1));
}

TEST_CASE("A thinned mesh keeps what its morphs do to places and normals") {
  Primitive source = ball();
  for (const glm::vec3& normal : source.normals) {
    source.morphTargets[0].normals.push_back(-0.5F * normal);
  }
  const Mesh thin = thinnedMeshes(meshesOf({source}), 4000)[0];
  CHECK(thin.name == "ball");
  CHECK(thin.morphWeights == std::vector<float>{0.5F});
  const Primitive& made = thin.primitives[0];
  REQUIRE(made.morphTargets.size() == 1);
  REQUIRE(made.morphTargets[0].positions.size() == made.positions.size());
  REQUIRE(made.morphTargets[0].normals.size() == made.positions.size());
  for (std::size_t i = 0; i < made.positions.size(); ++i) {
    CHECK(made.morphTargets[0].positions[i] == 0.1F * made.positions[i]);
    CHECK(made.morphTargets[0].normals[i] == -0.5F * made.normals[i]);
  }
}

TEST_CASE("A ball that is thinned has no hole") {
  const std::vector<Mesh> thinned = thinnedMeshes(meshesOf({ball()}), 3000);
  const Primitive& primitive = thinned[0].primitives[0];
  using Place = std::array<float, 3>;
  std::multiset<std::pair<Place, Place>> sides;
  const auto placeOf = [&](std::size_t corner) {
    const glm::vec3& place = primitive.positions[primitive.indices[corner]];
    return Place{place.x, place.y, place.z};
  };
  for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
    for (std::size_t side = 0; side < 3; ++side) {
      sides.emplace(placeOf(i + side), placeOf(i + (side + 1) % 3));
    }
  }
  std::size_t open = 0;
  for (const auto& [from, to] : sides) {
    open += sides.count({from, to}) == sides.count({to, from}) ? 0 : 1;
  }
  CHECK(open == 0);
}

TEST_CASE(
    "Each part keeps its share of the triangles, whatever its size, and small meshes stay as they are") {
  const std::vector<Mesh> meshes = meshesOf({ball(), moved(ball(), 0.01F, {5.0F, 0.0F, 0.0F})});
  const std::vector<Mesh> thinned = thinnedMeshes(meshes, 8000);
  const auto triangles = [](const Primitive& primitive) {
    return static_cast<double>(primitive.indices.size()) / 3.0;
  };
  CHECK(triangles(thinned[0].primitives[1]) == Approx(triangles(thinned[0].primitives[0])).epsilon(0.3));
  const std::vector<Mesh> same = thinnedMeshes(meshes, triangleCount(meshes));
  CHECK(same[0].primitives[0].indices == meshes[0].primitives[0].indices);
  CHECK(same[0].primitives[1].positions == meshes[0].primitives[1].positions);
}

TEST_CASE("Meshes without triangles, without area and with places that are no numbers can be thinned") {
  Primitive flat = ball();
  std::ranges::fill(flat.positions, glm::vec3(1.0F));
  Primitive broken = ball();
  broken.positions[0].x = std::nanf("");
  broken.positions[1].x = 1e30F;
  Primitive none;
  const std::vector<Mesh> thinned = thinnedMeshes(meshesOf({ball(), flat, broken, none}), 1000);
  REQUIRE(thinned[0].primitives.size() == 4);
  for (const Primitive& primitive : thinned[0].primitives) {
    for (const std::uint32_t index : primitive.indices) {
      CHECK(index < primitive.positions.size());
    }
  }
  CHECK(thinned[0].primitives[3].positions.empty());
}

TEST_CASE("A heavy character is drawn with few triangles while it moves and whole where it rests") {
  test::GuiPainter painter;
  app::Document document = test::PanelDriver::bundledCharacter();
  document.scene = std::make_shared<const Scene>(test::withTriangles(*document.scene, 60'000));
  test::GuiStage stage(painter, ThemeKind::dark, 480.0F, 320.0F);
  stage.open.open(document);
  const DrawnPicture& drawn = painter.viewportGpu().picture;
  const auto isWhole = [&] { return drawn.contentKey == drawn.wantedKey; };
  const auto rest = [&] {
    for (int i = 0; i < 8; ++i) { // Four frames of a sixtieth of a second each.
      stage.showViewport();
    }
  };
  stage.showViewport();
  REQUIRE(painter.viewportGpu().renderer.secondsUnthinned() > 0.0);
  CHECK_FALSE(isWhole());
  const Image first = stage.picture();
  rest();
  CHECK(isWhole());
  const Image whole = stage.picture();
  const test::PictureDifference difference = test::differenceBetween(first, whole);
  CHECK(difference.mean > 0.0);
  CHECK(difference.mean < 1.0);
  stage.open.character()->view().frame = 12.0;
  stage.showViewport();
  CHECK_FALSE(isWhole());
  CHECK(test::differenceBetween(whole, stage.picture()).mean > difference.mean); // It follows at once.
  rest();
  CHECK(isWhole());
  stage.open.open(test::PanelDriver::bundledCharacter());
  stage.showViewport();
  CHECK(painter.viewportGpu().renderer.secondsUnthinned() == 0.0);
  CHECK(isWhole());
}
