#include "app/evaluate/stopped.h"

#include <optional>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "rig/motion/paths.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The boxer's punch, twice as long, with a plane in its way so far beyond a place; none where it is not
/// given.
Document stoppedPunch(const Vec3& place, const Vec3& way, std::optional<double> beyond) {
  Document document = test::boxer();
  rig::Trail trail;
  trail.id = 1;
  trail.limb = "left-arm";
  trail.settings.startFrame = 0.0;
  trail.settings.endFrame = 10.0;
  trail.settings.scale = 2.0;
  if (beyond) {
    trail.settings.stopAt = rig::StopPlane{place + *beyond * way, way};
  }
  trail.exaggerated = true;
  trail.connected = true;
  document.trails = {trail};
  return document;
}

rig::DrawnTrail punchOf(const Document& document) {
  const rig::MotionState motion = prepareMotion(document, 0);
  return rig::pathsAt(*document.scene, clipOf(document, 0), motion, 0, {10.0});
}

} // namespace

TEST_CASE("A stop that the tip but touches, by what rounding may make of it, is not in its way") {
  const Document free = stoppedPunch({}, {}, std::nullopt);
  const rig::DrawnTrail punch = punchOf(free);
  const Vec3 tip = punch.exaggerated.front();
  const Vec3 along = glm::normalize(tip - punch.original.front());
  const auto keptBack = [&](double beyond) {
    return glm::length(punchOf(stoppedPunch(tip, along, beyond)).exaggerated.front() - tip);
  };
  const auto isStopped = [&](double beyond) {
    const Document document = stoppedPunch(tip, along, beyond);
    const rig::MotionState motion = prepareMotion(document, 0);
    return isStoppedAtTip(document, motion, motion.trails.front());
  };
  const double unit = findLimb(free, "left-arm")->restLength;
  double in = -0.2 * unit;
  double out = unit;
  REQUIRE(keptBack(in) > 1e-3 * unit);
  REQUIRE(keptBack(out) == 0.0);
  CHECK(isStopped(in));
  CHECK_FALSE(isStopped(out));
  while (keptBack(in) > 1e-6 * unit) { // to where it is only just touched
    const double middle = 0.5 * (in + out);
    (keptBack(middle) > 0.0 ? in : out) = middle;
  }
  REQUIRE(keptBack(in) > 0.0);
  CHECK_FALSE(isStopped(in));
}
