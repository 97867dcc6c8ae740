#include <cmath>
#include <fstream>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/math/rotation.h"
#include "rig/trail/exaggeration.h"

namespace {

using namespace stretch;
using namespace stretch::rig;

Vec3 point(const nlohmann::json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

nlohmann::json workedCases() {
  std::ifstream file(STRETCH_SOURCE_DIR "/tests/rig/trail/exaggeration_vectors.json");
  REQUIRE(file.good());
  return nlohmann::json::parse(file)["cases"];
}

Ease easeOf(const nlohmann::json& input, const char* key, double defaultValue) {
  return input.contains(key) ? Ease{input[key][0].get<double>(), input[key][1].get<double>()}
                             : Ease{0.0, defaultValue};
}

TipProblem problemOf(const nlohmann::json& input) {
  TipProblem problem;
  for (const auto& p : input["points"]) {
    problem.points.push_back(point(p));
  }
  problem.basePosition = point(input["p0"]);
  problem.scale = input["scale"].get<double>();
  problem.pivot = input.value("pivot", "start") == "end" ? Pivot::end : Pivot::start;
  problem.pull = false;
  if (input.contains("axes")) {
    const auto axes = input["axes"].get<std::string>();
    for (std::size_t i = 0; i < 3; ++i) {
      problem.axes[i] = axes.find("xyz"[i]) != std::string::npos;
    }
  }
  const Vec3 tip = problem.pivot == Pivot::start ? problem.points.back() : problem.points.front();
  problem.limbLength =
      input.contains("length") ? input["length"].get<double>() : glm::length(tip - problem.basePosition);
  return problem;
}

std::vector<double> evenTimes(std::size_t count) {
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i) {
    times[i] = static_cast<double>(i) / 24.0;
  }
  return times;
}

// A limb of length 1 along x, whose end came from `way` before its tip.
TipProblem limbWhoseEndCame(const Vec3& way, double scale) {
  TipProblem problem;
  problem.points = {Vec3(1, 0, 0) - way, Vec3(1, 0, 0)};
  problem.limbLength = 1.0;
  problem.scale = scale;
  return problem;
}

double degreesTurned(const TipProblem& problem) {
  return angleBetween(problem.points.back(), solveTip(problem).tip) * 180.0 / pi;
}

} // namespace

TEST_CASE("the specification's worked cases come out to 1e-6") {
  for (const nlohmann::json& worked : workedCases()) {
    CAPTURE(worked["name"].get<std::string>());
    const nlohmann::json& input = worked["input"];
    const nlohmann::json& expect = worked["expect"];
    const TipProblem problem = problemOf(input);
    const TipSolution solution = solveTip(problem);
    CHECK(glm::length(solution.tip - point(expect["tip"])) < 1e-6);
    CHECK(solution.moved == expect["moved"].get<bool>());
    CHECK(solution.reached() == expect["reached"].get<bool>());
    REQUIRE(solution.trailScale.has_value() != expect["trail_scale"].is_null());
    if (solution.trailScale) {
      CHECK(*solution.trailScale == Approx(expect["trail_scale"].get<double>()).margin(1e-6));
    }
    const std::vector<double> ratios =
        pathRatios(problem.points, evenTimes(problem.points.size()), problem.pivot);
    const Remap remap(input.value("remap", "spline") == "linear" ? RemapKind::linear : RemapKind::spline,
                      easeOf(input, "ease_in", 0.1), easeOf(input, "ease_out", 0.9));
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
      CAPTURE(i);
      CHECK(ratios[i] == Approx(expect["ratios"][i].get<double>()).margin(1e-6));
      const double weight = remap.at(ratios[i]);
      CHECK(weight == Approx(expect["weights"][i].get<double>()).margin(1e-6));
      const double blend = input.value("blend", 2.0);
      const Vec3 original = problem.points[i];
      const Vec3 followed =
          original + 0.5 * blend * weight * (exaggeratePoint(solution, original) - original);
      CHECK(glm::length(followed - point(expect["points"][i])) < 1e-6);
    }
  }
}

TEST_CASE("what the line cannot reach is pulled to the wanted length") {
  TipProblem problem;
  problem.points = {Vec3(1, -1, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)};
  problem.limbLength = std::sqrt(2.0);
  problem.scale = 0.5;
  const TipSolution pulled = solveTip(problem);
  CHECK(pulled.reached());
  CHECK(pulled.outcome == TipOutcome::pulled);
  CHECK(glm::length(pulled.tip) == Approx(std::sqrt(2.0) / 2));

  problem.pull = false;
  const TipSolution left = solveTip(problem);
  CHECK_FALSE(left.reached());
  CHECK(left.outcome == TipOutcome::closest);
  CHECK(left.reachedLength == Approx(1.0));
  CHECK(left.wantedLength == Approx(std::sqrt(2.0) / 2));
}

TEST_CASE("the pull moves along the active axes only") {
  TipProblem problem;
  problem.points = {Vec3(1, -1, 0), Vec3(1, 1, 0)};
  problem.limbLength = std::sqrt(2.0);
  problem.scale = 0.5;
  problem.axes = {false, true, true};
  const TipSolution solution = solveTip(problem);
  CHECK(solution.tip.x == 1.0);
  CHECK_FALSE(solution.reached());
}

TEST_CASE("a limb is turned at its tip as far as its limit lets it, and is as long as wanted") {
  const Vec3 across(0.0, 0.8, 0.6);
  TipProblem problem = limbWhoseEndCame(across, 2.0);
  CHECK(degreesTurned(problem) == Approx(60.0)); // an arc of a strike: the line across it meets twice the
                                                 // length
  for (const double degrees : {0.0, 10.0, 25.0, 59.0}) {
    CAPTURE(degrees);
    problem.turnLimitRadians = degrees * pi / 180.0;
    const TipSolution solution = solveTip(problem);
    CHECK(degreesTurned(problem) == Approx(degrees).margin(1e-6));
    CHECK(solution.reached());
    CHECK(solution.outcome == TipOutcome::pulled);
    CHECK(glm::length(solution.tip) == Approx(2.0));
    CHECK(glm::dot(solution.tip, across) >= 0.0);
  }
  problem.turnLimitRadians = 61.0 * pi / 180.0;
  CHECK(degreesTurned(problem) == Approx(60.0));
  CHECK(solveTip(problem).outcome == TipOutcome::reached);
}

TEST_CASE("a limb that is drawn back past its base is not turned over, once it has a limit") {
  for (const double aside : {0.0, 0.01, 0.3, 0.6}) {
    CAPTURE(aside);
    TipProblem problem = limbWhoseEndCame(Vec3(-std::cos(aside), std::sin(aside), 0.0), 2.0);
    CHECK(degreesTurned(problem) > 100.0);
    problem.turnLimitRadians = 25.0 * pi / 180.0;
    CHECK(degreesTurned(problem) == Approx(25.0 * std::sin(aside)).margin(1e-6));
    CHECK(glm::length(solveTip(problem).tip) == Approx(2.0));
  }
}

TEST_CASE("a limb on one line with its walk is lengthened whatever its limit, to a number") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 limb(any(random), any(random), any(random));
    TipProblem problem;
    problem.points = {0.3 * limb, limb};
    problem.limbLength = glm::length(limb);
    problem.scale = 1.7;
    problem.turnLimitRadians = 0.0;
    REQUIRE(glm::length(solveTip(problem).tip - 1.7 * limb) < 1e-6);
  }
}

TEST_CASE("with an axis off a limb whose turn is limited gets no farther than the limit, and says so") {
  TipProblem problem;
  problem.points = {Vec3(-0.4, -1.0, 0.0), Vec3(0.1, -1.0, 0.0)}; // a leg that steps along the ground
  problem.limbLength = glm::length(problem.points.back());
  problem.axes = {true, false, true};
  problem.turnLimitRadians = 25.0 * pi / 180.0;
  problem.scale = 2.0;
  const TipSolution solution = solveTip(problem);
  CHECK(solution.outcome == TipOutcome::closest);
  CHECK_FALSE(solution.reached());
  CHECK(degreesTurned(problem) == Approx(25.0));
  CHECK(solution.tip.y == -1.0);
  problem.scale = 1.05;
  CHECK(solveTip(problem).reached());
}

TEST_CASE("a turn limit that is let go of step by step snaps nowhere") {
  TipProblem problem = limbWhoseEndCame(Vec3(-std::cos(0.4), std::sin(0.4), 0.0), 2.0);
  double before = 0.0;
  for (double degrees = 0.0; degrees <= 180.0; degrees += 0.5) {
    problem.turnLimitRadians = degrees * pi / 180.0;
    const double turned = degreesTurned(problem);
    CHECK(std::abs(turned - before) < 4.0);
    before = turned;
  }
  CHECK(before > 100.0);
}

TEST_CASE("a limb that gets shorter is turned no farther than its limit either") {
  TipProblem problem = limbWhoseEndCame(Vec3(0.6, 0.8, 0.0), 0.85);
  const double freely = degreesTurned(problem);
  CHECK(freely > 5.0);
  problem.turnLimitRadians = 5.0 * pi / 180.0;
  CHECK(degreesTurned(problem) <= 5.0 + 1e-9);
  CHECK(glm::length(solveTip(problem).tip) == Approx(0.85));
  problem.pull = false;
  CHECK(solveTip(problem).outcome == TipOutcome::closest);
}

TEST_CASE("a limb that does not move has nothing to scale") {
  TipProblem problem;
  problem.points = {Vec3(1, 0, 0), Vec3(1, 0, 0)};
  problem.limbLength = 1.0;
  problem.scale = 2.0;
  const TipSolution solution = solveTip(problem);
  CHECK(solution.outcome == TipOutcome::nothingToScale);
  CHECK(solution.tip == Vec3(1, 0, 0));
}

TEST_CASE("a path too long to be measured goes by time") {
  const std::vector<double> ratios =
      pathRatios({Vec3(0.0), Vec3(1e300, 0, 0), Vec3(0.0)}, {0.0, 0.5, 1.0}, Pivot::start);
  CHECK(ratios == std::vector<double>{0.0, 0.5, 1.0});
}

TEST_CASE("a planted foot has nothing to scale, whatever it trembles") {
  TipProblem problem;
  problem.points = {Vec3(0.0), Vec3(1e-4, 0.0, 0.0), Vec3(0.2e-4, 0.0, 0.0), Vec3(1e-4, 0.0, 0.0)};
  problem.basePosition = Vec3(0.0, 1.0, 0.0);
  problem.limbLength = 1.0;
  problem.scale = 2.0;
  CHECK(solveTip(problem).outcome == TipOutcome::nothingToScale);
  problem.points = {Vec3(0.0), Vec3(1e-4, 0.0, 0.0)};
  problem.between = {Vec3(0.0, 1.2e-4, 0.0)};
  CHECK(solveTip(problem).outcome == TipOutcome::nothingToScale);
}

TEST_CASE("a small way that goes somewhere is scaled, down to a millionth of the limb") {
  TipProblem problem;
  problem.basePosition = Vec3(0.0, 1.0, 0.0);
  problem.limbLength = 1.0;
  problem.scale = 2.0;
  for (const double way : {1e-3, 1e-5, 2e-6}) {
    problem.points = {Vec3(0.0), Vec3(0.5 * way, 0.0, 0.0), Vec3(way, 0.0, 0.0)};
    const TipSolution solution = solveTip(problem);
    CHECK(solution.outcome == TipOutcome::reached);
    CHECK(glm::length(solution.tip - problem.basePosition) == Approx(2.0));
  }
  problem.points = {Vec3(0.0), Vec3(5e-7, 0.0, 0.0)};
  CHECK(solveTip(problem).outcome == TipOutcome::nothingToScale);
}

TEST_CASE("a foot that stands still at its keys only is moved, not scaled by hundreds") {
  TipProblem problem;
  problem.points = {Vec3(0.0), Vec3(1e-3, 0.0, 0.0), Vec3(2e-3, 0.0, 0.0)};
  problem.basePosition = Vec3(0.0, 1.0, 0.0);
  problem.limbLength = 1.0;
  problem.scale = 2.0;
  CHECK(solveTip(problem).trailScale.value_or(0.0) > 500.0);
  problem.between = {Vec3(0.0, 0.01, 0.0), Vec3(0.01, 0.0, 0.0)};
  const TipSolution solution = solveTip(problem);
  CHECK(solution.moved);
  CHECK_FALSE(solution.trailScale);
  CHECK(glm::length(solution.tip - problem.basePosition) == Approx(2.0));
}

TEST_CASE("what is no number has no weight") {
  for (const RemapKind kind : {RemapKind::spline, RemapKind::linear}) {
    CHECK(Remap(kind, {0.0, 0.1}, {0.0, 0.9}).at(std::nan("")) == 0.0);
  }
}

TEST_CASE("the remap is monotone and stays between 0 and 1 for every ease") {
  for (const double in : {0.0, 0.2, 0.6, 0.95}) {
    for (const double out : {0.0, 0.3, 0.9}) {
      const Remap remap(RemapKind::spline, {in, 0.1}, {out, 0.9});
      double before = 0.0;
      for (int i = 0; i <= 100; ++i) {
        const double w = remap.at(i / 100.0);
        CHECK(w >= before - 1e-12);
        CHECK(w <= 1.0 + 1e-12);
        before = w;
      }
      CHECK(remap.at(0.0) == 0.0);
      CHECK(remap.at(1.0) == Approx(1.0));
    }
  }
}

TEST_CASE("each ease bends its own end of the remap, with and without the other") {
  for (const RemapKind kind : {RemapKind::spline, RemapKind::linear}) {
    for (const double other : {0.0, 0.4}) {
      const Remap eased(kind, {0.3, 0.1}, {other, 0.9});
      CHECK(eased.at(0.3) == Approx(0.1));
      const Remap easedOut(kind, {other, 0.1}, {0.2, 0.7});
      CHECK(easedOut.at(0.8) == Approx(0.7));
    }
    const Remap none(kind, {0.0, 0.1}, {0.0, 0.9});
    for (const double ratio : {0.0, 0.25, 0.5, 0.9, 1.0}) {
      const double smooth = ratio * ratio * (3.0 - 2.0 * ratio); // the spline leaves and arrives level
      CHECK(none.at(ratio) == Approx(kind == RemapKind::spline ? smooth : ratio));
    }
  }
}

TEST_CASE("a line that misses the wanted length is pulled there, with an axis off along the others alone") {
  TipProblem problem = limbWhoseEndCame(Vec3(0, -1, 0), 0.5); // across the limb: no walk makes it shorter
  const TipSolution whole = solveTip(problem);
  CHECK(whole.outcome == TipOutcome::pulled);
  CHECK(glm::length(whole.tip - Vec3(0.5, 0, 0)) < 1e-12);
  CHECK(glm::length(whole.pull - Vec3(-0.5, 0, 0)) < 1e-12);
  problem.axes = {true, true, false};
  const TipSolution flat = solveTip(problem);
  CHECK(flat.outcome == TipOutcome::pulled);
  CHECK(glm::length(flat.tip - Vec3(0.5, 0, 0)) < 1e-12);
  problem.axes = {false, true, true}; // the pull would go along x
  const TipSolution across = solveTip(problem);
  CHECK(across.outcome == TipOutcome::pulled);
  CHECK(glm::length(across.tip - Vec3(1, 0, 0)) < 1e-12);
  CHECK_FALSE(across.reached());
  problem.axes = {true, true, true};
  problem.pull = false;
  const TipSolution left = solveTip(problem);
  CHECK(left.outcome == TipOutcome::closest);
  CHECK(glm::length(left.tip - Vec3(1, 0, 0)) < 1e-12);
}
