// Where a limb ends: at its palms, at the far end of its mesh, or where a leg meets the ground.
#include "rig/body/reading/limb_end.h"

#include <optional>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/rig/joint_views.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::rig::body;

namespace {

/// A wrist at (1, 1, 0) with joints below it.
struct Wrist {
  BodyView view;
  int joint = test::addJoint(view, NodeIndex(0), -1, Vec3(1.0, 1.0, 0.0));

  int add(const Vec3& fromWrist) {
    return test::addJoint(view, NodeIndex(static_cast<std::size_t>(view.count())), joint,
                          view.at(joint) + fromWrist);
  }
  NameEvidence& name(int child) { return view.names[static_cast<std::size_t>(child)]; }
  std::vector<Vec3>& points() { return view.points[static_cast<std::size_t>(joint)]; }
  [[nodiscard]] std::optional<EstimatedEnd> end() const { return estimateEnd(view, joint); }
};

/// Three joints side by side.
Wrist fannedWrist() {
  Wrist wrist;
  for (const double aside : {-0.03, 0.0, 0.06}) {
    wrist.add(Vec3(0.1, 0.0, aside));
  }
  return wrist;
}

/// A leg of these points, each a joint below the one before.
struct StandingLeg {
  BodyView view;
  Extremity row;

  explicit StandingLeg(const std::vector<Vec3>& points) {
    row.points = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      row.path.push_back(test::addJoint(view, NodeIndex(i), static_cast<int>(i) - 1, points[i]));
    }
  }
  [[nodiscard]] std::size_t end(double floor = 0.0) const {
    return endOfLeg(view, row, Vec3(0.0, 1.0, 0.0), floor);
  }
};

double farFrom(const std::optional<EstimatedEnd>& end, const Vec3& place) {
  REQUIRE(end);
  return glm::distance(end->position, place);
}

} // namespace

TEST_CASE("Three joints below a wrist are a hand, or two palms, but gear, twists and parts of a bone do not "
          "count") {
  const Wrist three = fannedWrist();
  CHECK(isFan(three.view, three.joint));
  Wrist two;
  two.add(Vec3(0.1, 0.0, -0.03));
  two.add(Vec3(0.1, 0.0, 0.03));
  CHECK_FALSE(isFan(two.view, two.joint));
  two.name(1).palm = true;
  CHECK_FALSE(isFan(two.view, two.joint));
  two.name(2).palm = true;
  CHECK(isFan(two.view, two.joint));
  Wrist armed = fannedWrist();
  armed.name(2).accessory = true;
  CHECK_FALSE(isFan(armed.view, armed.joint));
  Wrist twisted = fannedWrist();
  twisted.name(2).twist = true;
  CHECK_FALSE(isFan(twisted.view, twisted.joint));
  two.name(1).palm = false;
  two.add(0.5 * Vec3(0.1, 0.0, 0.03)); // half-way to one of them
  CHECK_FALSE(isFan(two.view, two.joint));
  two.add(Vec3(0.1, 0.04, 0.03));
  CHECK(isFan(two.view, two.joint));
}

TEST_CASE("An arm without a hand ends in the middle of its palms, else of what fans out, else of its mesh") {
  Wrist wrist;
  CHECK_FALSE(wrist.end());
  wrist.points() = {Vec3(1.1, 1.0, 0.0), Vec3(1.3, 1.0, 0.1), Vec3(1.3, 1.0, -0.1)};
  CHECK(farFrom(wrist.end(), Vec3(1.3, 1.0, 0.0)) < 1e-9);
  CHECK_FALSE(wrist.end()->fromPalms);
  wrist.add(Vec3(0.1, 0.0, -0.03));
  wrist.add(Vec3(0.1, 0.0, 0.03));
  CHECK_FALSE(wrist.end()->fromPalms);
  wrist.add(Vec3(0.1, 0.0, 0.06));
  CHECK(farFrom(wrist.end(), Vec3(1.1, 1.0, 0.02)) < 1e-9);
  CHECK(wrist.end()->fromPalms);
  wrist.name(1).palm = wrist.name(2).palm = true;
  CHECK(farFrom(wrist.end(), Vec3(1.1, 1.0, 0.0)) < 1e-9);
  Wrist ball;
  ball.points() = {Vec3(1.2, 1.0, 0.0), Vec3(0.8, 1.0, 0.0)}; // as far before the wrist as behind it
  CHECK_FALSE(ball.end());
}

TEST_CASE("A leg ends at its first joint near the ground below its knee, and what follows are toes") {
  const StandingLeg leg({{0, 1.0, 0}, {0, 0.5, 0}, {0, 0.09, 0}, {0, 0.02, 0.03}, {0, 0.02, 0.2}});
  CHECK(leg.end() == 2);
  CHECK(leg.end(-0.05) == 3); // 0.14 above a floor of a leg of 1.05, and 0.07
  const StandingLeg raised({{0, 3.0, 0}, {0, 2.5, 0}, {0, 2.2, 0}, {0, 2.05, 0.05}, {0, 2.0, 0.2}});
  CHECK(raised.end(2.0) == 3);
  const StandingLeg squat({{0, 1.0, 0}, {0, 0.05, 0.2}, {0, 0.05, 0.3}, {0, 0.05, 0.4}});
  CHECK(squat.end() == 2); // A knee is no foot, however low it is.
}

TEST_CASE("A leg on a thick sole ends where what follows goes along the ground") {
  const StandingLeg along({{0, 1.0, 0}, {0, 0.6, 0}, {0, 0.2, 0}, {0, 0.18, 0.2}, {0, 0.17, 0.3}});
  CHECK(along.end() == 2);
  const StandingLeg onTip({{0, 1.0, 0}, {0, 0.6, 0}, {0, 0.2, 0}, {0, 0.04, 0.05}, {0, 0.0, 0.1}});
  CHECK(onTip.end() == 3);
  const StandingLeg hanging({{0, 1.0, 0}, {0, 0.6, 0}, {0, 0.3, 0}, {0, 0.28, 0.2}, {0, 0.15, 0.3}});
  CHECK(hanging.end() == 4); // The toes go on down.
}

TEST_CASE("A leg ends at a foot that hangs elsewhere in the file, and below a knee whose mesh stands") {
  StandingLeg elsewhere({{0, 1.0, 0}, {0, 0.5, 0}, {0, 0.4, 0}, {0, 0.3, 0}});
  CHECK(elsewhere.end() == 3);
  elsewhere.view.isDetached[1] = true;
  CHECK(elsewhere.end() == 1);
  StandingLeg stump({{0, 1.0, 0}, {0, 0.5, 0}});
  CHECK(stump.end() == 1);
  stump.view.points[1] = {Vec3(0.0, 0.12, 0.0)};
  CHECK(stump.end() == 1);
  stump.view.points[1] = {Vec3(0.0, 0.12, 0.0), Vec3(0.0, 0.08, 0.0)};
  CHECK(stump.end() == 2);
  stump.row.points.emplace_back(0.0, 0.4, 0.0); // a tip
  CHECK(stump.end() == 2);
  StandingLeg low({{0, 1.0, 0}, {0, 0.29, 0}});
  low.view.points[1] = {Vec3(0.0, 0.0, 0.0)};
  CHECK(low.end() == 1); // An ankle.
}
