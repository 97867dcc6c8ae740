// Which rate of a clip counts: that which is noted in the file, or that which its keys tell.
#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;

TEST_CASE("A clip has the rate that is noted in its extras, where that is one from 1 to 1000") {
  constexpr double toldByKeys = 24.0; // at 0, 0.5 and 1 second
  const auto rateWith = [](const Json& noted) {
    test::GlbBuilder glb = test::armBuilder();
    glb.json["animations"][0]["extras"]["stretch_engine"]["frames_per_second"] = noted;
    return test::loaded(glb).clips.at(0).framesPerSecond;
  };
  for (const double rate : {1.0, 12.5, 240.0, 1000.0}) {
    CHECK(rateWith(rate) == rate);
  }
  for (const Json& none : {Json(0.99), Json(1000.5), Json(-30.0), Json(0), Json("30"), Json(nullptr)}) {
    CAPTURE(none.dump());
    CHECK(rateWith(none) == toldByKeys);
  }
}
