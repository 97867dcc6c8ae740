#include "app/weight/report.h"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::app;

namespace {

/// What is told of a clip of 30 frames per second whose bone has these factors, frame 0 first.
WeightReport reportOfBone(const std::vector<skinning::StretchFactors>& frames) {
  WeightReport report;
  report.limb = "left-arm";
  ReportWriter writer(report, 30.0);
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    const skinning::LimbStretch still{};
    skinning::LimbStretch bone;
    bone.factors = frames[frame];
    writer.add(static_cast<double>(frame) / 30.0, {still, bone});
  }
  writer.finish();
  return report;
}

/// A bone this many times as long that is flattened no more than that makes it.
skinning::StretchFactors lengthenedBone(double along) {
  return {along, 1.0 / std::sqrt(along), 1.0 / std::sqrt(along)};
}

skinning::StretchFactors flattenedBone(double withLoad) {
  return {1.0, withLoad, 1.0};
}

using Lines = std::vector<std::string>;

} // namespace

TEST_CASE("A limb that is flattened past what the model is made for is told where it is flattest") {
  CHECK(reportOfBone({flattenedBone(0.75), flattenedBone(0.7), flattenedBone(0.72)}).warnings ==
        Lines{"left-arm: flattened by 0.3 at frame 1; past 0.2 the model no longer holds: make it stiffer"});
  CHECK(reportOfBone({flattenedBone(1.0), flattenedBone(1.0), flattenedBone(0.5)}).warnings ==
        Lines{"left-arm: flattened by 0.5 at frame 2, which is the most allowed; past 0.2 the model no "
              "longer holds: make it stiffer"});
  const WeightReport little = reportOfBone({flattenedBone(1.0), flattenedBone(0.81)});
  CHECK(little.warnings.empty());
  CHECK_FALSE(little.held);
}

TEST_CASE("A bone that is stretched or shortened as far as it may be is told from its first frame on") {
  for (const double most : {2.0, 0.5}) {
    CAPTURE(most);
    const std::string line =
        "left-arm: the stretch along a bone is held at " + std::string(most > 1.0 ? "2" : "0.5") + " from ";
    const WeightReport later =
        reportOfBone({lengthenedBone(1.0), lengthenedBone(most), lengthenedBone(1.0), lengthenedBone(most)});
    CHECK(later.warnings == Lines{line + "frame 1 on: make it stiffer"});
    CHECK(later.held);
    CHECK(reportOfBone({lengthenedBone(most)}).warnings == Lines{line + "frame 0 on: make it stiffer"});
  }
  const WeightReport free = reportOfBone({lengthenedBone(1.99), lengthenedBone(0.51)});
  CHECK(free.warnings.empty());
  CHECK_FALSE(free.held);
}
