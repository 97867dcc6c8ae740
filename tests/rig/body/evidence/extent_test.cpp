// How large a character is: by the meshes that are its body, and by how it stands.
#include "rig/body/evidence/height.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig::body;
using namespace stretch::test;

namespace {

/// A root with a rigid box of this size about a place.
NodeIndex addSlab(Scene& scene, const Vec3& middle, const Vec3& size) {
  const NodeIndex node = addNode(scene, "slab", NodeIndex::none, middle);
  Primitive slab;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5, (i & 4) != 0 ? 0.5 : -0.5);
    slab.positions.emplace_back(size * corner);
  }
  scene.nodes[at(node)].mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back({"slab", {slab}, {}});
  return node;
}

CharacterExtent extentAtRest(const Scene& scene, NodeIndex hips, const Vec3& up) {
  return characterExtent(scene, placeBindPose(scene), {hips, {}, up}, frameOf(scene, restPose(scene), 0.0));
}

} // namespace

TEST_CASE("A body that leans more than 35 degrees is as tall as it is long, and half as high at least") {
  Scene scene;
  const NodeIndex hips = addSlab(scene, Vec3(0.0), Vec3(0.3, 0.2, 2.0));
  const auto leaning = [&](double degrees) {
    const double angle = degrees * pi / 180.0;
    return extentAtRest(scene, hips, 0.7 * Vec3(0.0, std::cos(angle), std::sin(angle)));
  };
  for (const double degrees : {0.0, 34.0, 146.0, 180.0, -34.0}) {
    CAPTURE(degrees);
    CHECK(leaning(degrees).stature == Approx(0.2));
    CHECK(leaning(degrees).height == Approx(0.2));
    CHECK(leaning(degrees).largest == Approx(2.0));
  }
  for (const double degrees : {36.0, 90.0, 144.0, -90.0}) {
    CAPTURE(degrees);
    CHECK(leaning(degrees).stature == Approx(2.0));
    CHECK(leaning(degrees).height == Approx(1.0));
    CHECK(leaning(degrees).largest == Approx(2.0));
  }
  CHECK(extentAtRest(scene, hips, Vec3(0.0)).stature == Approx(0.2)); // Nobody knows how it stands.
}

TEST_CASE("A body that is flat is as tall as it is wide") {
  Scene scene;
  const NodeIndex hips = addSlab(scene, Vec3(0.0), Vec3(2.0, 0.0, 1.0));
  const CharacterExtent flat = extentAtRest(scene, hips, Vec3(0.0, 1.0, 0.0));
  CHECK(flat.stature == Approx(2.0));
  CHECK(flat.height == Approx(1.0));
}

TEST_CASE(
    "What hangs beside a body of rigid meshes is none of it, where it is known which tree is the body") {
  Scene scene;
  const NodeIndex hips = addSlab(scene, Vec3(0.0), Vec3(0.4, 2.0, 0.4));
  addSlab(scene, Vec3(0.0, 5.0, 0.0), Vec3(0.1)); // a lamp
  const Vec3 up(0.0, 1.0, 0.0);
  const CharacterExtent body = extentAtRest(scene, hips, up);
  CHECK(body.height == Approx(2.0));
  CHECK(body.stature == Approx(2.0));
  CHECK(body.largest == Approx(2.0));
  const CharacterExtent all = extentAtRest(scene, NodeIndex::none, up);
  CHECK(all.height == Approx(6.05));
  CHECK(all.stature == Approx(6.05));
}

TEST_CASE("A vertex that is no number makes a body no larger") {
  Scene scene;
  const NodeIndex hips = addSlab(scene, Vec3(0.0), Vec3(0.4, 2.0, 0.4));
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    scene.meshes.front().primitives.front().positions.emplace_back(0.0F, wrong, 0.0F);
  }
  const CharacterExtent body = extentAtRest(scene, hips, Vec3(0.0, 1.0, 0.0));
  CHECK(body.height == Approx(2.0));
  CHECK(body.largest == Approx(2.0));
}

TEST_CASE("Without a mesh the joints tell how large a character is, and without both it is of size one") {
  Scene scene;
  const NodeIndex hips = addNode(scene, "hips", NodeIndex::none, Vec3(0.0, 1.0, 0.0));
  const Vec3 up(0.0, 1.0, 0.0);
  CHECK(extentAtRest(scene, hips, up).height == 1.0);
  CHECK(extentAtRest(scene, hips, up).largest == 1.0);
  addNode(scene, "head", hips, Vec3(0.0, 0.7, 0.0));
  addNode(scene, "hand", hips, Vec3(0.8, 0.2, 0.0));
  CHECK(extentAtRest(scene, hips, up).height == Approx(0.7));
  CHECK(extentAtRest(scene, hips, up).stature == Approx(0.7));
  CHECK(extentAtRest(scene, hips, up).largest == Approx(0.8));
}
