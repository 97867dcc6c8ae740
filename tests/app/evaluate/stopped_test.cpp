#include "app/evaluate/stopped.h"

#include <optional>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/paths.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/temporary_folder.h"

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

/// The bundled character below a node of this scale.
Document scaledBy(const test::TemporaryFolder& folder, const std::vector<double>& scale) {
  gltf::Source source = *test::openedFile(test::posedCharacter).source;
  gltf::Json& json = *source.json;
  json["nodes"].push_back({{"name", "squash"}, {"scale", scale}, {"children", json["scenes"][0]["nodes"]}});
  json["scenes"][0]["nodes"] = {json["nodes"].size() - 1};
  const std::filesystem::path file = folder / "squashed.glb";
  REQUIRE(gltf::save(source, file).ok());
  return test::openedFile(file.string());
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

TEST_CASE("A limb has the length that is asked of it in lengths of its tip's pose, or of itself at rest") {
  const Document document = test::boxer(); // whose arms are 0.6 long, whatever they do
  const rig::MotionState motion = prepareMotion(document, 0);
  rig::SolvedTrail solved;
  solved.limb = *findLimb(document, "left-arm");
  solved.tipSeconds = 0.2;
  solved.path.samples.resize(2);
  solved.path.samples.front().end = Vec3(0.3, 0.0, 0.0); // from its base
  solved.path.samples.back().end = Vec3(0.5, 0.0, 0.0);
  const auto hasIt = [&](double scale) {
    solved.settings.scale = scale;
    return hasWantedLength(document, motion, solved);
  };
  CHECK(hasIt(1.2));
  CHECK(hasIt(1.2 * (1.0 + 5e-5)));
  CHECK_FALSE(hasIt(1.2 * (1.0 + 2e-4)));
  CHECK_FALSE(hasIt(2.0));
  solved.settings.pivot = rig::Pivot::end; // the tip is the first sample then
  CHECK(hasIt(2.0));
  CHECK_FALSE(hasIt(1.2));
  solved.settings.reference = rig::Reference::rest;
  CHECK(hasIt(1.0));
  CHECK_FALSE(hasIt(2.0));
  solved.tip.outcome = rig::TipOutcome::nothingToScale;
  CHECK_FALSE(hasIt(1.0));
}

TEST_CASE("A limb that two trails pull at one time is shared, one whose trails are apart is not") {
  Document document = stoppedPunch({}, {}, std::nullopt);
  rig::Trail second = document.trails.front();
  second.id = 2;
  second.settings.pivot = rig::Pivot::end;
  second.settings.releaseFrames = 2.0;
  const bool areApart = GENERATE(false, true);
  second.settings.startFrame = areApart ? 14.0 : 10.0;
  second.settings.endFrame = 20.0;
  document.trails.front().settings.releaseFrames = 2.0;
  document.trails.push_back(second);
  const rig::MotionState motion = prepareMotion(document, 0);
  CHECK(hasWantedLength(document, motion, motion.trails.front()) == areApart);
  CHECK(keptFromLength(document, motion, motion.trails.front()) ==
        (areApart ? "" : "shared with another trail of the limb"));
}

TEST_CASE(
    "A trail names its blend, then its stretch switch, then a sphere at its tip, and nothing else of it") {
  rig::SolvedTrail solved;
  solved.settings.startFrame = 2.0;
  solved.settings.endFrame = 8.0;
  CHECK(keptBySettings(solved).empty());
  solved.settings.spheres = {{2.0, Vec3(0.1, 0.0, 0.0)}, {5.0, Vec3(0.1, 0.0, 0.0)}, {8.0, Vec3(0.0)}};
  CHECK(keptBySettings(solved).empty());
  solved.settings.pivot = rig::Pivot::end;
  CHECK(keptBySettings(solved) == "by the sphere at its tip");
  solved.settings.pivot = rig::Pivot::start;
  solved.settings.spheres.back() = {8.0004, Vec3(0.0, 0.0, 0.1)}; // on the same frame
  CHECK(keptBySettings(solved) == "by the sphere at its tip");
  solved.settings.stretchSwitch = 0.99;
  CHECK(keptBySettings(solved) == "by its stretch switch");
  solved.settings.blend = 1.99;
  CHECK(keptBySettings(solved) == "by its blend");
}

TEST_CASE("Below an uneven scale a limb is as long at the tip as is asked, and ends where its trail does") {
  const test::TemporaryFolder folder;
  const std::vector<double> scale = GENERATE(std::vector{1.0, 1.5, 1.0}, std::vector{1.5, 1.0, 1.0},
                                             std::vector{1.0, 1.0, 0.6}, std::vector{1.0, 1.05, 1.0});
  const std::string limb = GENERATE("right-leg", "left-arm");
  const bool isLeg = limb == "right-leg";
  const Document document = test::withNewTrail(
      scaledBy(folder, scale), {limb, isLeg ? 37.0 : 21.0, isLeg ? 44.0 : 27.0, isLeg ? 1.5 : 2.0});
  const rig::MotionState motion = prepareMotion(document, 0);
  const rig::SolvedTrail& solved = motion.trails.front();
  CHECK(hasWantedLength(document, motion, solved));
  const FrameState tip = evaluate(document, motion, solved.tipSeconds);
  CHECK(glm::distance(rig::endPosition(solved.limb, tip), solved.tip.tip) < 1e-4 * document.body.height);
}
