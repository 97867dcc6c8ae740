#include <catch2/catch.hpp>

#include <cmath>

#include "skinning/elastic/cylinder.h"
#include "skinning/elastic/moduli.h"

using namespace stretch;
using namespace stretch::skinning;

TEST_CASE("Eq. 6 with the measurements of Table 1 in SI units compresses a nematode by 0.011 %") {
  const Cylinder nematode{0.88e-3, 0.085e-3, 2e-9, 3770.0};
  CHECK(gravityDisplacement(nematode, 9.81) == Approx(9.2896e-9).epsilon(1e-4));
  CHECK(compressionFactor(nematode, 9.81) == Approx(1.0929e-4).epsilon(1e-4));
}

TEST_CASE("the paper's printed 12.3 % is Eq. 6 with a thousand times the mass and other lengths") {
  const Cylinder slipped{0.80e-3, 0.083e-3, 2e-6, 3770.0};
  CHECK(gravityDisplacement(slipped, 9.81) == Approx(1.02185e-5).epsilon(1e-4));
  CHECK(compressionFactor(slipped, 9.81) == Approx(0.12311).epsilon(1e-4));
}

TEST_CASE("the compression factor stays within a half, and is nothing without load, width or stiffness") {
  CHECK(compressionFactor({1.0, 1.0, 1e9, 1.0}, 9.81) == largestCompression);
  CHECK(compressionFactor({1.0, 1.0, 1.0, 1e5}, 0.0) == 0.0);
  CHECK(compressionFactor({1.0, 0.0, 1.0, 1e5}, 9.81) == 0.0);
  CHECK(compressionFactor({1.0, 1.0, 1.0, 0.0}, 9.81) == 0.0);
}

TEST_CASE("flattening keeps the volume: 1 - q with the load, 1 / (1 - q) sideways, 1 along") {
  const StretchFactors factors = combine(0.2, 1.0);
  CHECK(factors.along == 1.0);
  CHECK(factors.withLoad == Approx(0.8));
  CHECK(factors.sideways == Approx(1.25));
  CHECK(factors.along * factors.withLoad * factors.sideways == Approx(1.0));
}

TEST_CASE("a stretched segment thins so that its volume stays, or not, as asked") {
  const StretchFactors kept = combine(0.0, 1.44);
  CHECK(kept.withLoad == Approx(1.0 / 1.2));
  CHECK(kept.along * kept.withLoad * kept.sideways == Approx(1.0));
  const StretchFactors thick = combine(0.0, 1.44, 1.0, 0.0);
  CHECK(thick.withLoad == 1.0);
}

TEST_CASE("axial strain is force over stiffness and section, within a half and twice the length") {
  CHECK(axialScale(10.0, 1000.0, 0.2, 2.0) == Approx(1.1));
  CHECK(axialScale(-10.0, 1000.0, 0.2, 2.0) == Approx(0.9));
  CHECK(axialScale(1e9, 1000.0, 0.2, 2.0) == 2.0);
  CHECK(axialScale(-1e9, 1000.0, 0.2, 2.0) == 0.5);
  CHECK(axialScale(10.0, 0.0, 0.2, 2.0) == 1.0);
  CHECK(axialScale(10.0, 1000.0, 0.0, 2.0) == 1.0);
  CHECK(axialScale(10.0, 1000.0, 0.2, 0.0) == 1.0);
}

TEST_CASE("moduli by segment are read, later ranges win, mistakes are named") {
  const auto moduli = parseModuli(
      R"({"young": 100, "segments": [{"from": 0, "to": 4, "young": 200}, {"from": 3, "to": 3, "young": 300}]})");
  REQUIRE(moduli);
  CHECK(moduli->at(0, 1.0) == 200.0);
  CHECK(moduli->at(3, 1.0) == 300.0);
  CHECK(moduli->at(5, 1.0) == 100.0);
  CHECK(parseModuli("{}")->at(5, 7.0) == 7.0);
  CHECK(*parseModuli(moduliText(*moduli)) == *moduli);
  CHECK(*parseModuli(moduliText({})) == SegmentModuli{});
  for (const char* bad :
       {"[]", "{", R"({"youngs": 1})", R"({"young": -1})",
        R"({"segments": [{"from": 2, "to": 1, "young": 1}]})",
        R"({"segments": [{"from": 0, "to": 1, "young": 1, "x": 2}]})", R"({"segments": [3]})"}) {
    const auto refused = parseModuli(bad);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().line().find("moduli") != std::string::npos);
  }
  CHECK(parseModuli(R"({"youngs": 1})").error().what.find("youngs") != std::string::npos);
}
