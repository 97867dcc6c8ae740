// How a body stands: which way is up, where its mirror plane is, on how much of two legs it stands.
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/rotation.h"
#include "skinning/locate/upright.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A figure of cubes, 40 high and 16 wide, 8 deep: two legs to a layer, a trunk, arms; all but the legs'
/// height is symmetrical about x = 8. Feet and a nose point to +z.
test::Shape figure(int legs, bool hasLeftArm = true) {
  return test::cubes({-10, 0, 0}, {26, 40, 14}, 1.0, [=](int x, int y, int z) {
    if (y < 0 || y >= 40 || z < 0) {
      return false;
    }
    const bool isDeep = z < 8 || (y < 3 && z < 12);
    const bool isLeg = (x >= 0 && x < 6) || (x >= 10 && x < 16);
    const bool isArm = y >= 28 && y < 32 && z >= 2 && z < 6 && x >= -8 && x < (hasLeftArm ? 24 : 16);
    return (isDeep && (y < legs ? isLeg : x >= 0 && x < 16)) || (isArm && y >= legs);
  });
}

using Move = std::function<Vec3(const Vec3&)>;

Vec3 unmoved(const Vec3& place) {
  return place;
}

std::vector<Vec3> placesAfter(const test::Shape& shape, const Move& move) {
  std::vector<Vec3> places;
  for (const glm::vec3& position : shape.positions) {
    places.push_back(move(Vec3(position)));
  }
  return places;
}

Upright uprightOf(const test::Shape& shape, const Move& move = unmoved, UpAxis up = UpAxis::anyOfScene) {
  const Result<Upright> upright = findUpright(placesAfter(shape, move), shape.triangles, up);
  REQUIRE(upright);
  return *upright;
}

/// What is told of a body is so in its own space: the ground at 0, the height 1, the depth halved.
void checkOwnSpace(const test::Shape& shape, const Move& move, const Upright& upright) {
  Bounds own;
  for (const Vec3& place : placesAfter(shape, move)) {
    own.add(upright.toBody(place));
    CHECK(glm::distance(upright.toScene(upright.toBody(place)), place) < 1e-6 * upright.height);
  }
  CHECK(own.low.y == Approx(0.0).margin(1e-9));
  CHECK(own.high.y == Approx(1.0));
  CHECK(own.low.z == Approx(-own.high.z));
  const Mat3& axes = upright.axes;
  CHECK(glm::distance(glm::cross(axes[0], axes[1]), axes[2]) < 1e-9);
  for (const std::size_t axis : {0U, 1U, 2U}) {
    CHECK(glm::length(axes[axis]) == Approx(1.0));
  }
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * 180.0 / pi;
}

} // namespace

TEST_CASE("A figure stands up, faces +Z and is mirrored in its middle, in any units anywhere", "[locators]") {
  const test::Shape shape = figure(20);
  for (const double unit : {1e-3, 1.0, 300.0}) {
    const Move move = [unit](const Vec3& place) { return unit * (place + Vec3(30.0, -7.0, 2.0)); };
    const Upright upright = uprightOf(shape, move);
    checkOwnSpace(shape, move, upright);
    CHECK(degreesBetween(upright.axes[0], {1, 0, 0}) < 0.5);
    CHECK(degreesBetween(upright.axes[1], {0, 1, 0}) < 1e-6);
    CHECK(upright.height == Approx(40.0 * unit));
    CHECK(upright.origin.x == Approx(38.0 * unit).margin(0.2 * unit));
    CHECK(upright.origin.y == Approx(-7.0 * unit));
    CHECK(upright.origin.z == Approx((2.0 + 6.0) * unit).margin(0.2 * unit));
    CHECK(upright.symmetry > 0.99);
    CHECK(upright.symmetry <= 1.0);
    CHECK(upright.legs == 1.0);
  }
}

TEST_CASE("A figure that is turned about its upright has its axes turned, to a degree", "[locators]") {
  const test::Shape shape = figure(20);
  for (const double degrees : {8.0, 47.0, -13.0, -88.0}) {
    const Quat turn = axisAngle(Vec3(0.0, 1.0, 0.0), degrees * pi / 180.0);
    const Move move = [turn](const Vec3& place) { return turn * (place - Vec3(8.0, 0.0, 4.0)); };
    const Upright upright = uprightOf(shape, move);
    INFO("turned by " << degrees);
    checkOwnSpace(shape, move, upright);
    CHECK(degreesBetween(upright.axes[2], turn * Vec3(0.0, 0.0, 1.0)) < 1.6);
    CHECK(std::abs(glm::dot(upright.origin, upright.axes[0])) < 0.5); // on the mirror plane
    CHECK(upright.symmetry > 0.93);
  }
}

TEST_CASE("Which way is up is found along each axis of a scene, and taken as given where told",
          "[locators]") {
  const test::Shape shape = figure(20);
  const std::vector<std::pair<Quat, Vec3>> ways{{axisAngle(Vec3(1, 0, 0), 0.5 * pi), {0, 0, 1}},
                                                {axisAngle(Vec3(1, 0, 0), -0.5 * pi), {0, 0, -1}},
                                                {axisAngle(Vec3(1, 0, 0), pi), {0, -1, 0}},
                                                {axisAngle(Vec3(0, 0, 1), -0.5 * pi), {1, 0, 0}},
                                                {axisAngle(Vec3(0, 0, 1), 0.5 * pi), {-1, 0, 0}}};
  for (const auto& [turn, up] : ways) {
    const Move move = [turn = turn](const Vec3& place) { return turn * place; };
    const Upright upright = uprightOf(shape, move);
    INFO("up is " << up.x << " " << up.y << " " << up.z);
    checkOwnSpace(shape, move, upright);
    CHECK(glm::distance(upright.axes[1], up) < 1e-9);
    CHECK(std::abs(glm::dot(upright.axes[0], turn * Vec3(1.0, 0.0, 0.0))) > 0.999);
    CHECK(upright.height == Approx(40.0));
    CHECK(upright.legs == 1.0);
    const Upright told = uprightOf(shape, move, UpAxis::ofScene);
    CHECK(told.axes[1] == Vec3(0.0, 1.0, 0.0));
    checkOwnSpace(shape, move, told);
  }
}

TEST_CASE("A body faces +Z of the scene where it may, else +Y, else +X", "[locators]") {
  const test::Shape shape = figure(20);
  const auto faces = [&](const Quat& turn) {
    return uprightOf(shape, [turn](const Vec3& place) { return turn * place; }).axes[2];
  };
  const Quat about = axisAngle(Vec3(0.0, 1.0, 0.0), pi);
  CHECK(faces(about).z > 0.99); // though its feet point backwards
  CHECK(faces(axisAngle(Vec3(0.0, 1.0, 0.0), -0.5 * pi)).x > 0.99);
  CHECK(faces(axisAngle(Vec3(0.0, 1.0, 0.0), 0.5 * pi)).x > 0.99);
  CHECK(faces(axisAngle(Vec3(1.0, 0.0, 0.0), 0.5 * pi)).y > 0.99);
  CHECK(faces(axisAngle(Vec3(1.0, 0.0, 0.0), -0.5 * pi)).y > 0.99);
}

TEST_CASE("Legs count by how much of the second to sixth fortieth of a body they are parted in",
          "[locators]") {
  double before = -0.1;
  for (const int legs : {0, 2, 3, 4, 5}) { // layers of the 40
    const Upright upright = uprightOf(figure(legs), unmoved, UpAxis::ofScene);
    INFO("legs of " << legs);
    CHECK(upright.legs == Approx(0.2 * std::clamp(legs - 1, 0, 5)).margin(0.201));
    CHECK(upright.legs >= before);
    CHECK(std::abs(upright.legs / 0.2 - std::round(upright.legs / 0.2)) < 1e-9);
    before = upright.legs;
  }
  CHECK(uprightOf(figure(0), unmoved, UpAxis::ofScene).legs == 0.0);
  CHECK(uprightOf(figure(8), unmoved, UpAxis::ofScene).legs == 1.0);
  CHECK(uprightOf(figure(3), unmoved, UpAxis::ofScene).legs > 0.1);
  CHECK(uprightOf(figure(3), unmoved, UpAxis::ofScene).legs < 0.7);
}

TEST_CASE("Heights of legs count by the body's own height, also where it is wider than high", "[locators]") {
  const test::Shape shape = figure(8);
  const Move flat = [](const Vec3& place) { return place * Vec3(1.0, 0.5, 1.0); };
  const Upright upright = uprightOf(shape, flat, UpAxis::ofScene);
  checkOwnSpace(shape, flat, upright);
  CHECK(upright.height == Approx(20.0));
  CHECK(upright.legs == 1.0);
}

TEST_CASE("What lacks its mirror image makes a body less symmetrical, by its share of cells", "[locators]") {
  const test::Shape whole = figure(20);
  const test::Shape oneArm = figure(20, false);
  CHECK(uprightOf(whole).symmetry > 0.99);
  const double cells = 20.0 * 96 + 12 * 48 + 20 * 128 + 8 * 16; // legs, feet, trunk and an arm
  CHECK(uprightOf(oneArm).symmetry == Approx(1.0 - 8.0 * 16 / cells).margin(0.02));
}

TEST_CASE("A mesh that has no places in numbers or no extent does not stand", "[locators]") {
  const test::Shape shape = figure(20);
  for (const double no :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<Vec3> places = placesAfter(shape, unmoved);
    places[7].z = no;
    const Result<Upright> upright = findUpright(places, shape.triangles);
    REQUIRE_FALSE(upright);
    CHECK(upright.error().what == "the mesh has places that are no numbers");
    std::vector<Triangle> without = shape.triangles;
    std::erase_if(without, [](const Triangle& one) { return std::ranges::count(one, 7U) > 0; });
    CHECK(findUpright(places, without).ok()); // what no triangle has does not count
  }
  CHECK_FALSE(findUpright({}, {}).ok());
  CHECK_FALSE(findUpright(std::vector<Vec3>(shape.positions.size(), Vec3(2.0)), shape.triangles).ok());
}
