#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "skinning/elastic/limb_elasticity.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A straight limb of two bones, 0.3 m each, hanging down from a base that moves as `base` says.
template <typename Base>
LimbMotion hanging(int frames, Base&& base) {
  LimbMotion motion;
  for (int k = 0; k < frames; ++k) {
    const Vec3 p = base(k / motion.framesPerSecond);
    motion.joints.push_back({p, p - Vec3(0.0, 0.3, 0.0), p - Vec3(0.0, 0.6, 0.0)});
  }
  return motion;
}

std::vector<LimbSegment> arm() {
  return limbSegments({0.3, 0.3}, {0.08, 0.08});
}

std::vector<std::vector<LimbStretch>> solve(const LimbMotion& motion, const LimbElasticity& settings = {}) {
  const auto result = limbElasticity(arm(), motion, settings);
  REQUIRE(result);
  return *result;
}

} // namespace

TEST_CASE("a still limb sags a little by its own weight and does not move") {
  const auto frames = solve(hanging(40, [](double) { return Vec3(0.0, 1.5, 0.0); }));
  const double mass = 1000.0 * 0.25 * pi * 0.08 * 0.08 * 0.3;
  const double area = 0.25 * pi * 0.08 * 0.08;
  CHECK(frames[0][0].factors.along == Approx(1.0 + 1.5 * mass * 9.81 / (3e5 * area)));
  CHECK(frames[0][1].factors.along == Approx(1.0 + 0.5 * mass * 9.81 / (3e5 * area)));
  CHECK(frames[0][0].factors.along > 1.0);
  CHECK(frames[0][0].factors.along < 1.05);
  for (const auto& frame : frames) {
    CHECK(frame[0].factors.along == Approx(frames[0][0].factors.along).epsilon(1e-12));
  }
}

TEST_CASE("free fall weighs nothing, with inertia off, gravity alone counts") {
  const auto falling = hanging(30, [](double t) { return Vec3(0.0, 10.0 - 0.5 * 9.81 * t * t, 0.0); });
  const auto weightless = solve(falling);
  CHECK(weightless[25][0].factors.along == Approx(1.0).margin(1e-3));
  LimbElasticity still;
  still.inertia = 0.0;
  CHECK(solve(falling, still)[25][0].factors.along > 1.005);
}

TEST_CASE("a swing stretches the limb outwards") {
  LimbMotion motion;
  const double radiansPerSecond = 12.0;
  for (int k = 0; k < 60; ++k) {
    const double angle = radiansPerSecond * k / motion.framesPerSecond;
    const Vec3 out(std::cos(angle), 0.0, std::sin(angle));
    motion.joints.push_back({Vec3(0.0), 0.3 * out, 0.6 * out});
  }
  LimbElasticity weightless;
  weightless.gravity = Vec3(0.0);
  const auto frames = solve(motion, weightless);
  CHECK(frames[30][0].factors.along > 1.02);
  CHECK(frames[30][0].factors.along > frames[30][1].factors.along);
  CHECK(frames[30][0].factors.along * frames[30][0].factors.withLoad * frames[30][0].factors.sideways ==
        Approx(1.0));
}

TEST_CASE("a landing squashes a planted limb and rings out") {
  // The body drops at 3 m/s and is caught within a tenth of a second.
  const auto height = [](double t) {
    const double landing = 0.5;
    const double braking = 0.1;
    if (t < landing) {
      return 1.0 + 3.0 * (landing - t);
    }
    const double s = std::min(t - landing, braking);
    return 1.0 - 3.0 * s + 15.0 * s * s;
  };
  LimbMotion motion = hanging(60, [&](double t) { return Vec3(0.0, height(t), 0.0); });
  motion.planted.assign(60, 1.0);
  motion.carriedMass.assign(60, 10.0);
  const auto frames = solve(motion);
  const double standing = frames[59][0].factors.along;
  double least = 1.0;
  for (const auto& frame : frames) {
    least = std::min(least, frame[0].factors.along);
  }
  CHECK(standing < 1.0);
  CHECK(least < standing - 0.05);
  CHECK(least >= 0.5);
  const double mass = 1000.0 * 0.25 * pi * 0.08 * 0.08 * 0.3;
  const double area = 0.25 * pi * 0.08 * 0.08;
  CHECK(standing == Approx(1.0 - (10.0 + 0.5 * mass) * 9.81 / (3e5 * area)).epsilon(0.01));
}

TEST_CASE("noise of a tenth of a millimetre does not shake the limb") {
  const auto frames = solve(hanging(60, [](double t) {
    return Vec3(0.0001 * std::sin(1000.0 * t), 1.5 + 0.0001 * std::cos(777.0 * t), 0.0);
  }));
  for (std::size_t k = 1; k < frames.size(); ++k) {
    CHECK(std::abs(frames[k][0].factors.along - frames[k - 1][0].factors.along) < 2e-3);
  }
}

TEST_CASE("amount 0 leaves the clip as it was, stiffer segments give less") {
  const auto motion = hanging(5, [](double) { return Vec3(0.0); });
  LimbElasticity off;
  off.amount = 0.0;
  CHECK(solve(motion, off)[3][0].factors.along == 1.0);
  CHECK(solve(motion, off)[3][0].factors.withLoad == 1.0);
  LimbElasticity ribs;
  ribs.moduli.ranges.push_back({0, 0, 3e6});
  CHECK(solve(motion, ribs)[3][0].factors.along - 1.0 ==
        Approx((solve(motion)[3][0].factors.along - 1.0) / 10.0));
  CHECK(solve(motion, ribs)[3][1].factors.along == Approx(solve(motion)[3][1].factors.along));
}

TEST_CASE("a limb across gravity is flattened along it and widens sideways") {
  LimbMotion motion;
  for (int k = 0; k < 5; ++k) {
    motion.joints.push_back({Vec3(0.0), Vec3(0.3, 0.0, 0.0), Vec3(0.6, 0.0, 0.0)});
  }
  LimbElasticity soft;
  soft.youngModulus = 2e4;
  const LimbStretch stretch = solve(motion, soft)[2][0];
  CHECK(std::abs(stretch.withLoad.y) == Approx(1.0));
  CHECK(stretch.factors.along == Approx(1.0));
  const double q = compressionFactor({0.3, 0.08, 1000.0 * arm()[0].volume, 2e4}, 9.81);
  CHECK(stretch.factors.withLoad == Approx(1.0 - q));
  CHECK(stretch.factors.sideways == Approx(1.0 / (1.0 - q)));
}

TEST_CASE("a foot is planted where it is slow and low, and fades over a few frames") {
  std::vector<Vec3> foot;
  for (int k = 0; k < 40; ++k) {
    const double lift = k > 10 && k < 30 ? 0.3 * std::sin(pi * (k - 10) / 20.0) : 0.0;
    foot.emplace_back(k > 10 && k < 30 ? 0.05 * (k - 10) : (k < 20 ? 0.0 : 1.0), lift, 0.0);
  }
  const auto weights = plantedWeights(foot, 30.0, 0.9, Vec3(0.0, 1.0, 0.0));
  CHECK(weights[3] == 1.0);
  CHECK(weights[20] == 0.0);
  CHECK(weights[37] == 1.0);
  bool fades = false;
  for (const double weight : weights) {
    fades = fades || (weight > 0.0 && weight < 1.0);
  }
  CHECK(fades);
}

TEST_CASE("the body's weight is shared by the limbs that stand") {
  const auto masses = sharedMass({{1.0, 1.0, 0.0}, {1.0, 0.0, 0.0}}, 60.0);
  CHECK(masses[0] == std::vector<double>{30.0, 60.0, 0.0});
  CHECK(masses[1] == std::vector<double>{30.0, 0.0, 0.0});
}

TEST_CASE("a motion that does not add up is refused with what is wrong with it and where") {
  LimbMotion motion = hanging(3, [](double) { return Vec3(0.0); });
  std::vector<LimbSegment> limb = arm();
  std::string wrong = "limb: the limb has no segments, no frames, or lists of different lengths";
  SECTION("a joint too few") {
    motion.joints[1].pop_back();
    wrong = "limb, frame 1: 3 finite joints are needed";
  }
  SECTION("a joint that is no number") {
    motion.joints[2][1].x = std::nan("");
    wrong = "limb, frame 2: 3 finite joints are needed";
  }
  SECTION("no frames") {
    motion.joints.clear();
  }
  SECTION("no segments") {
    limb.clear();
  }
  SECTION("no rate") {
    motion.framesPerSecond = 0.0;
  }
  SECTION("frames without a word on standing") {
    motion.planted = {1.0, 1.0};
  }
  SECTION("frames without a mass") {
    motion.carriedMass = {1.0, 1.0};
  }
  const auto refused = limbElasticity(limb, motion, {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().line().starts_with(wrong + ";"));
}

TEST_CASE("settings of a limb out of their range are refused by what they are") {
  const LimbMotion motion = hanging(3, [](double) { return Vec3(0.0); });
  LimbElasticity settings;
  std::string wrong = "elastic: inertia and amount lie in 0..1, damping is not negative";
  SECTION("amount") {
    settings.amount = GENERATE(2.0, -0.1);
  }
  SECTION("inertia") {
    settings.inertia = GENERATE(1.1, -0.1);
  }
  SECTION("damping") {
    settings.damping = GENERATE(-0.1, 101.0);
  }
  SECTION("gravity") {
    settings.gravity.y = std::nan("");
  }
  SECTION("the material") {
    wrong = "elastic: Young's modulus, density and stiffness must be positive";
    SECTION("softness") {
      settings.youngModulus = GENERATE(0.0, -1.0, 1e31);
    }
    SECTION("density") {
      settings.density = GENERATE(-1.0, 1e31);
    }
    SECTION("stiffness") {
      settings.stiffness = GENERATE(0.0, 1e7);
    }
  }
  const auto refused = limbElasticity(arm(), motion, settings);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().line().starts_with(wrong + ";"));
}

TEST_CASE("a limb that is carried along evenly is as long as a still one, in its first and last frame too") {
  const auto still = solve(hanging(12, [](double) { return Vec3(0.0); }));
  const auto carried = solve(hanging(12, [](double t) { return Vec3(3.0 * t, 1.0 - 2.0 * t, 0.5 * t); }));
  for (std::size_t k = 0; k < carried.size(); ++k) {
    for (const std::size_t segment : {0U, 1U}) {
      CAPTURE(k, segment);
      CHECK(carried[k][segment].factors.along == Approx(still[k][segment].factors.along).epsilon(1e-9));
    }
  }
}

TEST_CASE("a standing limb is pressed by what it carries, by the segments above and half of the own one") {
  LimbMotion motion = hanging(6, [](double) { return Vec3(0.0); });
  motion.carriedMass.assign(6, 10.0);
  const double area = 0.25 * pi * 0.08 * 0.08;
  const double mass = 1000.0 * area * 0.3;
  for (const double planted : {0.0, 0.5, 1.0}) {
    for (const double amount : {0.5, 1.0}) {
      CAPTURE(planted, amount);
      motion.planted.assign(6, planted);
      LimbElasticity settings;
      settings.amount = amount;
      const std::vector<LimbStretch> middle = solve(motion, settings)[3];
      for (const std::size_t segment : {0U, 1U}) {
        const double above = static_cast<double>(segment) + 0.5; // in masses of a segment
        const double below = 2.0 - above;
        const double pulling = (1.0 - planted) * below * mass - planted * (10.0 + above * mass);
        CHECK(middle[segment].factors.along - 1.0 == Approx(amount * pulling * 9.81 / (3e5 * area)));
      }
    }
  }
}
