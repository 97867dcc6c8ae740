#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "ui/render/view/view_cube.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

const Viewport square{100.0, 100.0, 1.0};

ViewCube cubeFrom(ViewDirection direction, double facing = 0.0) {
  return {makeView(lookFrom({}, direction, facing), square), facing};
}

using Side = std::array<int, 3>;

Side sideAt(const ViewCube& cube, const Vec2& place) {
  const std::optional<CubePart> part = cube.partAt(place);
  return part ? part->side : Side{9, 9, 9};
}

constexpr Side beside{9, 9, 9};

} // namespace

TEST_CASE("Seen from the front the cube shows its front face, with edges and corners around its middle") {
  const double facing = GENERATE(0.0, 0.5 * pi, pi);
  const ViewCube cube = cubeFrom(ViewDirection::front, facing);
  CHECK(sideAt(cube, {0.0, 0.0}) == Side{0, 0, 1});
  CHECK(sideAt(cube, {0.54, -0.54}) == Side{0, 0, 1});
  CHECK(sideAt(cube, {0.56, 0.0}) == Side{1, 0, 1});
  CHECK(sideAt(cube, {-0.56, 0.0}) == Side{-1, 0, 1});
  CHECK(sideAt(cube, {0.0, 0.56}) == Side{0, 1, 1});
  CHECK(sideAt(cube, {0.0, -0.56}) == Side{0, -1, 1});
  CHECK(sideAt(cube, {0.99, 0.99}) == Side{1, 1, 1});
  CHECK(sideAt(cube, {-0.99, -0.99}) == Side{-1, -1, 1});
  CHECK(sideAt(cube, {1.01, 0.0}) == beside);
  CHECK(sideAt(cube, {0.0, -1.01}) == beside);
}

TEST_CASE("From each standard view the face of its name lies in the middle") {
  CHECK(sideAt(cubeFrom(ViewDirection::back), {0.0, 0.0}) == Side{0, 0, -1});
  CHECK(sideAt(cubeFrom(ViewDirection::side), {0.0, 0.0}) == Side{1, 0, 0});
  CHECK(sideAt(cubeFrom(ViewDirection::otherSide), {0.0, 0.0}) == Side{-1, 0, 0});
  CHECK(sideAt(cubeFrom(ViewDirection::top), {0.0, 0.0}) == Side{0, 1, 0});
  CHECK(sideAt(cubeFrom(ViewDirection::back), {0.9, 0.0}) == Side{-1, 0, -1});
}

TEST_CASE("A view from a corner shows three faces, and the corner in the middle") {
  const Camera camera = lookingAt({}, {Side{1, 1, 1}}, 0.0);
  const ViewCube cube(makeView(camera, square), 0.0);
  CHECK(sideAt(cube, {0.0, 0.0}) == Side{1, 1, 1});
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(cube.towardsViewer(axis, 1) == Approx(1.0 / std::sqrt(3.0)).margin(0.02));
    CHECK(cube.towardsViewer(axis, -1) == Approx(-cube.towardsViewer(axis, 1)));
    Vec3 middle(0.0);
    middle[axis] = 1.0;
    Side face{0, 0, 0};
    face[static_cast<std::size_t>(axis)] = 1;
    CHECK(sideAt(cube, cube.seenAt(middle)) == face);
  }
}

TEST_CASE("Whatever part is looked at lies in the middle of the cube afterwards, and the target stays") {
  const double facing = GENERATE(0.0, 0.5 * pi, -0.5 * pi);
  Camera before;
  before.target = Vec3(1.0, 2.0, 3.0);
  before.distance = 7.0;
  int parts = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) {
          continue;
        }
        const CubePart part{Side{x, y, z}};
        const Camera camera = lookingAt(before, part, facing);
        CHECK(ViewCube(makeView(camera, square), facing).partAt({0.0, 0.0}) == part);
        CHECK(camera.target == before.target);
        CHECK(camera.distance == before.distance);
        CHECK((camera.projection == ProjectionKind::orthographic) == (x * x + y * y + z * z == 1));
        ++parts;
      }
    }
  }
  CHECK(parts == 26);
}

TEST_CASE("The faces of the standard views are looked at as those views look") {
  const double facing = 0.5 * pi;
  const std::pair<Side, ViewDirection> named[]{{Side{0, 0, 1}, ViewDirection::front},
                                               {Side{0, 0, -1}, ViewDirection::back},
                                               {Side{1, 0, 0}, ViewDirection::side},
                                               {Side{-1, 0, 0}, ViewDirection::otherSide},
                                               {Side{0, 1, 0}, ViewDirection::top}};
  for (const auto& [side, direction] : named) {
    const View wanted = makeView(lookFrom({}, direction, facing), square);
    const View view = makeView(lookingAt({}, {side}, facing), square);
    CHECK(glm::length(viewRight(view) - viewRight(wanted)) < 1e-12);
    CHECK(glm::length(view.forward - wanted.forward) < 1e-12);
  }
}
