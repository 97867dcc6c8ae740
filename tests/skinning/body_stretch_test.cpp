// The elastic model of a body whose motion is made by hand: each factor against its formula, parameters that
// are found again, and what is refused.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "skinning/compress/body_stretch.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

constexpr std::size_t bentSegments = 4;

/// A body along x, bent in z more and more, that turns about its own axis by `turn` in each frame.
BodyMotion bentBody(std::size_t frames, double turn) {
  BodyMotion body;
  for (std::size_t j = 0; j <= bentSegments; ++j) {
    body.skeleton.joints.emplace_back(0.5 * static_cast<double>(j), 0.0, 0.0);
  }
  body.skeleton.length = 2.0;
  body.widths = {0.1, 0.2, 0.25, 0.16};
  body.volumes = {0.001, 0.004, 0.006, 0.002};
  for (std::size_t k = 0; k < frames; ++k) {
    const double bend = 0.1 * static_cast<double>(k);
    const double length = 0.5 * (1.0 - 0.05 * bend);
    std::vector<Vec3> joints{Vec3(0.0)};
    for (std::size_t s = 0; s < bentSegments; ++s) {
      const double angle = bend * static_cast<double>(s);
      joints.push_back(joints.back() + length * Vec3(std::cos(angle), 0.0, std::sin(angle)));
      const Quat roll = glm::angleAxis(turn * static_cast<double>(k), Vec3(1.0, 0.0, 0.0));
      body.segments.push_back({glm::angleAxis(-angle, Vec3(0.0, 1.0, 0.0)) * roll, Mat3(1.0)});
    }
    body.joints.push_back(joints);
  }
  return body;
}

/// What pulls across a segment in a frame, seen from its bind pose, whose axis is x.
Vec3 acrossOf(const BodyMotion& body, const Vec3& gravity, std::size_t frame, std::size_t segment) {
  Vec3 seen = glm::inverse(glm::mat3_cast(body.motion(frame, segment).rotation)) * gravity;
  seen.x = 0.0;
  return seen;
}

BodyStretchSettings givenAll() {
  BodyStretchSettings settings;
  settings.gravity = Vec3(0.5, -9.0, 2.0);
  settings.metresPerUnit = 0.5;
  settings.mass = 3.0;
  settings.youngModulus = 4000.0;
  settings.gravityVolume = 0.6;
  settings.muscleVolume = 0.3;
  settings.lengthModel = LengthModel::line;
  return settings;
}

/// Eq. 6: q = m g pi / (2 E l w), all in metres.
double compressionOf(const BodyMotion& body, const BodyStretchSettings& settings, std::size_t segment,
                     double acceleration) {
  const double mass = *settings.mass * body.volumes[segment] / 0.013;
  const double length = 0.5 * settings.metresPerUnit;
  const double width = body.widths[segment] * settings.metresPerUnit;
  const double modulus = settings.moduli.at(segment, *settings.youngModulus);
  return std::min(0.5, mass * acceleration * pi / (2.0 * modulus * length * width));
}

double totalBend(std::size_t frame) {
  return 0.1 * static_cast<double>(frame) * static_cast<double>(bentSegments - 1);
}

void checkFactors(const BodyMotion& body, const BodyStretchSettings& settings, const BodyStretch& stretch) {
  const std::size_t frames = body.joints.size();
  for (std::size_t k = 0; k < frames; ++k) {
    const double shortened = 1.0 - 0.05 * 0.1 * static_cast<double>(k);
    CHECK(stretch.measured[k].curvatureRadians == Approx(totalBend(k)).margin(1e-9));
    CHECK(stretch.measured[k].length == Approx(2.0 * shortened));
    for (std::size_t s = 0; s < bentSegments; ++s) {
      CAPTURE(k, s);
      const double q = compressionOf(body, settings, s, glm::length(acrossOf(body, settings.gravity, k, s)));
      const double across = std::pow(shortened, -0.5 * *settings.muscleVolume);
      const StretchFactors& factors = stretch.factors[k * bentSegments + s];
      CHECK(factors.along == Approx(shortened));
      CHECK(factors.withLoad == Approx((1.0 - q) * across));
      CHECK(factors.sideways == Approx(std::pow(1.0 - q, -*settings.gravityVolume) * across));
    }
  }
}

} // namespace

TEST_CASE("With all given, each segment is pressed by its own load, mass and width, in every frame") {
  const BodyMotion body = bentBody(9, 0.9); // the load turns around it
  BodyStretchSettings settings = givenAll();
  settings.moduli.ranges = {{2, 2, 9000.0}};
  const Result<BodyStretch> stretch = stretchOfBody(body, settings);
  REQUIRE(stretch);
  REQUIRE(stretch->factors.size() == 9 * bentSegments);
  CHECK(stretch->loadTurns);
  CHECK(stretch->mass == 3.0);
  CHECK(stretch->youngModulus == Approx(4000.0));
  CHECK_FALSE(stretch->modulusFitted);
  CHECK(stretch->gravityVolume == 0.6);
  CHECK(stretch->muscleVolume == 0.3);
  CHECK(stretch->restLength == Approx(2.0));
  checkFactors(body, settings, *stretch);
  for (std::size_t s = 0; s < bentSegments; ++s) {
    double mean = 0.0;
    for (std::size_t k = 0; k < 9; ++k) {
      mean += compressionOf(body, settings, s, glm::length(acrossOf(body, settings.gravity, k, s))) / 9.0;
    }
    CHECK(stretch->compressions[s] == Approx(mean));
  }
}

TEST_CASE("A load that hardly changes presses each segment by its mean over the fitted frames") {
  BodyMotion body = bentBody(6, 0.0);
  for (std::size_t k = 0; k < 6; ++k) { // a little more across from frame to frame
    for (std::size_t s = 0; s < bentSegments; ++s) {
      body.segments[k * bentSegments + s].rotation =
          glm::angleAxis(0.01 * static_cast<double>(k), Vec3(0, 0, 1));
    }
  }
  BodyStretchSettings settings = givenAll();
  settings.gravity = Vec3(0.3, -9.0, 0.0);
  settings.firstFittedFrame = 2;
  const Result<BodyStretch> stretch = stretchOfBody(body, settings);
  REQUIRE(stretch);
  CHECK_FALSE(stretch->loadTurns);
  for (std::size_t s = 0; s < bentSegments; ++s) {
    double mean = 0.0;
    for (std::size_t k = 2; k < 6; ++k) {
      mean += compressionOf(body, settings, s, glm::length(acrossOf(body, settings.gravity, k, s))) / 4.0;
    }
    CHECK(stretch->compressions[s] == Approx(mean));
    for (std::size_t k = 0; k < 6; ++k) {
      const StretchFactors& factors = stretch->factors[k * bentSegments + s];
      const double across = std::pow(factors.along, -0.15);
      CHECK(factors.withLoad == Approx((1.0 - mean) * across));
    }
  }
}

TEST_CASE(
    "The load of a body is what gravity does across its segments, its axis the other way than the mean") {
  const Vec3 gravity(3.0, -8.0, 1.0);
  for (const double turn : {0.0, 0.1, 0.35, 0.9}) {
    const BodyMotion body = bentBody(9, turn);
    const BodyStretch load = loadOfBody(body, gravity);
    bool turns = false;
    std::vector<Vec3> axes;
    for (std::size_t s = 0; s < bentSegments; ++s) {
      Vec3 sum(0.0);
      double size = 0.0;
      for (std::size_t k = 0; k < 9; ++k) {
        sum += acrossOf(body, gravity, k, s);
        size += glm::length(acrossOf(body, gravity, k, s));
      }
      turns = turns || glm::length(sum) < 0.9 * size;
      axes.push_back(-glm::normalize(sum));
    }
    INFO("turns by " << turn);
    CHECK(load.loadTurns == turns);
    REQUIRE(load.loadAxes.size() == bentSegments);
    for (std::size_t i = 0; i < load.loadDirections.size(); ++i) {
      const std::size_t s = i % bentSegments;
      CHECK(glm::distance(load.loadAxes[s], axes[s]) < 1e-9);
      const Vec3 now = -glm::normalize(acrossOf(body, gravity, i / bentSegments, s));
      CHECK(glm::distance(load.loadDirections[i], turns ? now : axes[s]) < 1e-9);
    }
  }
  CHECK(loadOfBody(bentBody(9, 0.9), gravity).loadTurns);
  CHECK_FALSE(loadOfBody(bentBody(9, 0.1), gravity).loadTurns);
}

TEST_CASE("Without gravity a body has axes across it all the same, and is not pressed") {
  const BodyMotion body = bentBody(5, 0.4);
  const BodyStretch load = loadOfBody(body, Vec3(0.0));
  CHECK_FALSE(load.loadTurns);
  for (const Vec3& axis : load.loadAxes) {
    CHECK(glm::length(axis) == Approx(1.0));
    CHECK(axis.x == Approx(0.0).margin(1e-12));
  }
  BodyStretchSettings settings = givenAll();
  settings.gravity = Vec3(0.0);
  settings.youngModulus.reset();
  const Result<BodyStretch> stretch = stretchOfBody(body, settings);
  REQUIRE(stretch);
  CHECK(stretch->youngModulus == 0.0);
  for (const StretchFactors& factors : stretch->factors) {
    CHECK(factors.withLoad == Approx(factors.sideways));
  }
}

TEST_CASE("A body has water's mass by its volume and scale where none is given") {
  BodyStretchSettings settings = givenAll();
  settings.mass.reset();
  const Result<BodyStretch> stretch = stretchOfBody(bentBody(5, 0.0), settings);
  REQUIRE(stretch);
  CHECK(stretch->mass == Approx(1000.0 * 0.013 * 0.125));
}

namespace {

/// The body with the cross-sections that the model has for these settings.
BodyMotion asModelled(BodyMotion body, const BodyStretchSettings& settings) {
  const Result<BodyStretch> model = stretchOfBody(body, settings);
  REQUIRE(model);
  for (std::size_t i = 0; i < body.segments.size(); ++i) {
    const Vec3 down = model->loadDirections[i];
    const Vec3 side = glm::cross(Vec3(1.0, 0.0, 0.0), down);
    const StretchFactors& factors = model->factors[i];
    body.segments[i].stretch = factors.along * glm::outerProduct(Vec3(1, 0, 0), Vec3(1, 0, 0)) +
                               factors.withLoad * glm::outerProduct(down, down) +
                               factors.sideways * glm::outerProduct(side, side);
  }
  return body;
}

} // namespace

TEST_CASE("Parameters that are left open are found again from what they made, one at a time and together") {
  const BodyStretchSettings made = givenAll();
  for (const double turn : {0.0, 0.9}) {
    BodyMotion plain = bentBody(9, turn);
    for (std::size_t i = 0; turn == 0.0 && i < plain.segments.size(); ++i) {
      plain.segments[i].rotation = Quat(1.0, 0.0, 0.0, 0.0);
    }
    const BodyMotion body = asModelled(plain, made);
    for (int open = 1; open < 8; ++open) {
      BodyStretchSettings settings = made;
      if (open & 1) {
        settings.youngModulus.reset();
      }
      if (open & 2) {
        settings.gravityVolume.reset();
      }
      if (open & 4) {
        settings.muscleVolume.reset();
      }
      CAPTURE(turn, open);
      const Result<BodyStretch> stretch = stretchOfBody(body, settings);
      REQUIRE(stretch);
      CHECK(stretch->youngModulus == Approx(4000.0).epsilon(open == 7 ? 0.02 : 0.01));
      CHECK(stretch->modulusFitted == ((open & 1) != 0));
      // All three at once make up for each other a little.
      CHECK(stretch->gravityVolume == Approx(0.6).margin(open == 7 ? 0.02 : 0.01));
      CHECK(stretch->muscleVolume == Approx(0.3).margin(open == 7 ? 0.15 : 0.03));
    }
  }
}

TEST_CASE("Segments with a modulus of their own count in no fit of the body's, and frames before the first "
          "fitted one neither") {
  BodyStretchSettings made = givenAll();
  made.moduli.ranges = {{0, 1, 2500.0}};
  BodyMotion body = asModelled(bentBody(9, 0.9), made);
  for (std::size_t i = 0; i < 3 * bentSegments; ++i) {
    body.segments[i].stretch = Mat3(1.4); // while it settles
  }
  BodyStretchSettings settings = made;
  settings.youngModulus.reset();
  settings.firstFittedFrame = 3;
  const Result<BodyStretch> stretch = stretchOfBody(body, settings);
  REQUIRE(stretch);
  CHECK(stretch->youngModulus == Approx(4000.0).epsilon(0.01));
  settings.moduli.youngModulus = 5000.0; // of the body: it is given so, too
  const Result<BodyStretch> given = stretchOfBody(body, settings);
  REQUIRE(given);
  CHECK(given->youngModulus == Approx(5000.0));
  CHECK_FALSE(given->modulusFitted);
}

TEST_CASE("A body is no shorter than half and no longer than twice its length at rest") {
  for (const double change : {-0.9, 3.0}) {
    BodyMotion body = bentBody(6, 0.0);
    for (std::size_t k = 1; k < 6; ++k) {
      for (Vec3& joint : body.joints[k]) {
        joint *= 1.0 + change * static_cast<double>(k) / 5.0;
      }
    }
    const Result<BodyStretch> stretch = stretchOfBody(body, givenAll());
    REQUIRE(stretch);
    CHECK(stretch->factors.front().along == 1.0); // the first frame is as it is
    CHECK(stretch->factors.back().along == (change < 0.0 ? 0.5 : 2.0));
  }
}

TEST_CASE("Where gravity presses past small deformations, and where length is no matter of curvature, that "
          "is told") {
  BodyStretchSettings settings = givenAll();
  settings.youngModulus = 600.0;
  const Result<BodyStretch> soft = stretchOfBody(bentBody(9, 0.9), settings);
  REQUIRE(soft);
  REQUIRE(soft->warnings.size() == 1);
  const double most = [&] {
    double q = 0.0;
    const BodyMotion body = bentBody(9, 0.9);
    for (std::size_t i = 0; i < 9 * bentSegments; ++i) {
      q = std::max(q, compressionOf(
                          body, settings, i % bentSegments,
                          glm::length(acrossOf(body, settings.gravity, i / bentSegments, i % bentSegments))));
    }
    return q;
  }();
  std::string told = std::to_string(std::round(100.0 * most) / 100.0);
  told.resize(4);
  CHECK(soft->warnings[0] == "gravity compresses a segment by " + told +
                                 ": past 0.2 the model's small deformations no longer hold");
  settings.youngModulus = 60000.0;
  CHECK(stretchOfBody(bentBody(9, 0.9), settings)->warnings.empty());
  const Result<BodyStretch> few = stretchOfBody(bentBody(3, 0.9), settings);
  REQUIRE(few);
  REQUIRE(few->warnings.size() == 1);
  CHECK(few->warnings[0] == few->length.remark);
}

TEST_CASE("Moduli, masses and scales that are no positive numbers are refused, small ones are not") {
  const BodyMotion body = bentBody(5, 0.0);
  const auto answerOf = [&](double modulus, double mass, double scale) {
    BodyStretchSettings settings = givenAll();
    settings.youngModulus = modulus;
    settings.mass = mass;
    settings.metresPerUnit = scale;
    const Result<BodyStretch> stretch = stretchOfBody(body, settings);
    return stretch ? std::string() : stretch.error().line();
  };
  CHECK(answerOf(0.01, 0.01, 0.01).empty());
  CHECK(answerOf(1e9, 1e5, 100.0).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double no : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    const std::string told = "Young's modulus, mass and scale must be positive numbers; leave them out to "
                             "have them fitted";
    CHECK(answerOf(no, 1.0, 1.0) == told);
    CHECK(answerOf(1.0, no, 1.0) == told);
    if (!std::isinf(no)) {
      CHECK(answerOf(1.0, 1.0, no) == told);
    }
  }
}
