#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "core/anim/frame_state.h"
#include "tests/support/ui/render_scenes.h"
#include "ui/render/picking/surface_picking.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// A triangle that hangs on two joints, seen from the front: its corners at (-1, 0), (1, 0), (0, 2).
struct Flag {
  Flag() {
    const auto joints = static_cast<int>(scene.nodes.size());
    for (int i = 0; i < 2; ++i) {
      scene.nodes.emplace_back();
      scene.nodes.back().name = i == 0 ? "pole" : "cloth";
    }
    pole = NodeIndex(joints);
    cloth = NodeIndex(joints + 1);
    Skin skin;
    skin.joints = {pole, cloth};
    skin.inverseBind = {Mat4(1.0), Mat4(1.0)};
    scene.skins.push_back(skin);
    while (scene.nodes[at(holder)].mesh < 0) {
      holder = NodeIndex(holder.value + 1);
    }
    scene.nodes[at(holder)].skin = 0;
    primitive().influences.resize(primitive().positions.size());
  }
  Primitive& primitive() { return scene.meshes[at(scene.nodes[at(holder)].mesh)].primitives.front(); }
  void follow(std::size_t vertex, int place, int joint, float weight) {
    VertexInfluences& influences = primitive().influences[vertex];
    influences.joints[static_cast<std::size_t>(place)] = static_cast<std::uint16_t>(joint);
    influences.weights[static_cast<std::size_t>(place)] = weight;
  }
  /// Joint by joint what carries the place in the middle of the triangle.
  std::map<int, double> carriers() {
    Camera camera;
    camera.target = Vec3(0.0, 2.0 / 3.0, 0.0);
    camera.distance = 10.0;
    camera.projection = ProjectionKind::orthographic;
    const View view = makeView(camera, {400.0, 400.0, 1.0});
    PosedSurface surface{{holder}, {}};
    for (const glm::vec3& position : primitive().positions) {
      surface.positions.emplace_back(position);
    }
    const auto hit = pickSurface(view, scene, surface, {200.0, 200.0});
    REQUIRE(hit);
    std::map<int, double> found;
    for (const SurfaceShare& share : hit->shares) {
      found[share.node.value] += share.weight;
    }
    return found;
  }

  Scene scene = test::triangleScene();
  NodeIndex holder{0};
  NodeIndex pole;
  NodeIndex cloth;
};

} // namespace

TEST_CASE("What carries a place of the surface are the joints of its corners, each by its part of them") {
  Flag flag;
  flag.follow(0, 0, 0, 1.0F);
  flag.follow(1, 0, 1, 1.0F);
  flag.follow(2, 0, 0, 0.5F);
  flag.follow(2, VertexInfluences::capacity - 1, 1, 0.5F);
  const std::map<int, double> found = flag.carriers();
  REQUIRE(found.size() == 2);
  CHECK(found.at(flag.pole.value) == Approx(0.5).margin(1e-3));
  CHECK(found.at(flag.cloth.value) == Approx(0.5).margin(1e-3));
}

TEST_CASE("A joint that the skin does not have carries nothing, and one without weight neither") {
  Flag flag;
  const int lost = GENERATE(2, 3, 5000);
  flag.follow(0, 0, 0, 1.0F);
  flag.follow(0, 1, 1, 0.0F);
  flag.follow(1, 0, lost, 1.0F);
  flag.follow(2, 0, lost, 1.0F);
  const std::map<int, double> found = flag.carriers();
  REQUIRE(found.size() == 1);
  CHECK(found.at(flag.pole.value) == Approx(1.0 / 3.0).margin(1e-3));
}

TEST_CASE("Where no joint carries a place, its mesh does: by weights that are lost, and without any skin") {
  Flag flag;
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    flag.follow(vertex, 0, 7, 1.0F);
  }
  CHECK(flag.carriers() == std::map<int, double>{{flag.holder.value, 1.0}});
  flag.scene.nodes[at(flag.holder)].skin = -1;
  flag.follow(0, 0, 0, 1.0F);
  CHECK(flag.carriers() == std::map<int, double>{{flag.holder.value, 1.0}});
  flag.scene.nodes[at(flag.holder)].skin = 0;
  flag.primitive().influences.clear();
  CHECK(flag.carriers() == std::map<int, double>{{flag.holder.value, 1.0}});
}
