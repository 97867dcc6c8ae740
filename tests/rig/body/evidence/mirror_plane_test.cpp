// The plane that mirrors a body onto itself, and the ways from joint to joint.
#include "rig/body/evidence/symmetry.h"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/joint_views.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::rig::body;

namespace {

/// Hips, a spine and two legs, turned about the hips and moved there.
struct TwoLegged {
  BodyView view;
  int hips = 0;
  int chest = 0;
  std::vector<int> left;
  std::vector<int> right;

  explicit TwoLegged(const Quat& turn = Quat(1.0, 0.0, 0.0, 0.0), const Vec3& place = Vec3(0.0)) {
    const auto add = [&](int parent, const Vec3& fromHips) {
      const NodeIndex node(static_cast<std::size_t>(view.count()));
      return test::addJoint(view, node, parent, place + turn * fromHips);
    };
    hips = add(-1, Vec3(0.0));
    chest = add(hips, Vec3(0.0, 0.5, 0.0));
    for (const double side : {0.1, -0.1}) {
      std::vector<int>& leg = side > 0.0 ? left : right;
      leg.push_back(add(hips, Vec3(side, -0.05, 0.0)));
      leg.push_back(add(leg.back(), Vec3(side, -0.5, 0.05)));
      leg.push_back(add(leg.back(), Vec3(side, -0.95, 0.0)));
    }
  }
};

Quat turnAboutHips(const Vec3& axis, double degrees) {
  return axisAngle(axis, degrees * pi / 180.0);
}

} // namespace

TEST_CASE("A body is mirrored by the plane between its legs, wherever it stands") {
  const TwoLegged body(Quat(1.0, 0.0, 0.0, 0.0), Vec3(0.3, 1.0, -2.0));
  const MirrorPlane plane = findMirrorPlane(body.view);
  CHECK(std::abs(plane.normal.x) == Approx(1.0));
  CHECK(plane.lateral(body.view.at(body.hips)) == Approx(0.0).margin(1e-9));
  CHECK(plane.lateral(body.view.at(body.left[1])) * plane.normal.x == Approx(0.1));
  for (std::size_t i = 0; i < body.left.size(); ++i) {
    CHECK(glm::distance(plane.mirrored(body.view.at(body.left[i])), body.view.at(body.right[i])) < 1e-9);
  }
}

TEST_CASE("A body that is turned by less than eight degrees faces along an axis, and one by more does not") {
  const Vec3 up(0.0, 1.0, 0.0);
  const auto across = [&](double degrees) {
    return findMirrorPlane(TwoLegged(turnAboutHips(up, degrees)).view).normal;
  };
  for (const double degrees : {0.0, 7.5, -7.5}) {
    CAPTURE(degrees);
    CHECK(glm::distance(across(degrees), Vec3(1.0, 0.0, 0.0)) < 1e-12);
  }
  for (const double degrees : {82.5, 97.5}) {
    CAPTURE(degrees);
    CHECK(std::abs(across(degrees).z) == Approx(1.0).epsilon(1e-12));
  }
  for (const double degrees : {9.0, -30.0, 81.0}) {
    CAPTURE(degrees);
    const Vec3 sideways = turnAboutHips(up, degrees) * Vec3(1.0, 0.0, 0.0);
    CHECK(std::abs(glm::dot(across(degrees), sideways)) == Approx(1.0));
  }
}

TEST_CASE("A body without pairs lies along the plane that mirrors it") {
  const auto rowAlong = [](const Vec3& way) {
    BodyView row;
    for (int i = 0; i < 5; ++i) {
      test::addJoint(row, NodeIndex(static_cast<std::size_t>(i)), i - 1,
                     Vec3(0.2, 0.1, -0.3) + static_cast<double>(i) * way);
    }
    return findMirrorPlane(row);
  };
  const MirrorPlane alongX = rowAlong(Vec3(0.3, 0.0, 0.0));
  CHECK(alongX.normal == Vec3(0.0, 0.0, 1.0));
  CHECK(alongX.offset == Approx(-0.3));
  const MirrorPlane alongZ = rowAlong(Vec3(0.0, 0.0, 0.3));
  CHECK(alongZ.normal == Vec3(1.0, 0.0, 0.0));
  CHECK(alongZ.offset == Approx(0.2));
  CHECK(rowAlong(Vec3(0.3, 0.0, 0.16)).normal == Vec3(1.0, 0.0, 0.0)); // It goes across as well.
  CHECK(rowAlong(Vec3(0.3, 0.16, 0.0)).normal == Vec3(1.0, 0.0, 0.0)); // It stands as well.
  CHECK(rowAlong(Vec3(0.3, 0.14, 0.14)).normal == Vec3(0.0, 0.0, 1.0));
}

TEST_CASE("Joints know what is above them, where their ways meet, and the way between two of them") {
  TwoLegged body;
  const int foot = body.left[2];
  const int alone = test::addJoint(body.view, NodeIndex(9), -1, Vec3(1.0));
  CHECK(body.view.isAboveOrSelf(body.hips, foot));
  CHECK(body.view.isAboveOrSelf(foot, foot));
  CHECK_FALSE(body.view.isAboveOrSelf(foot, body.hips));
  CHECK_FALSE(body.view.isAboveOrSelf(body.chest, foot));
  CHECK(body.view.commonAncestor(foot, body.right[1]) == body.hips);
  CHECK(body.view.commonAncestor(foot, body.left[0]) == body.left[0]);
  CHECK(body.view.commonAncestor(body.left[0], foot) == body.left[0]);
  CHECK(body.view.commonAncestor(foot, alone) == -1);
  CHECK(body.view.path(body.hips, foot) == std::vector<int>{body.hips, body.left[0], body.left[1], foot});
  CHECK(body.view.path(foot, foot) == std::vector<int>{foot});
  CHECK(body.view.path(body.chest, foot).empty());
}
