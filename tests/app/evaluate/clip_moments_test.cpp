#include "app/evaluate/clip_moments.h"

#include <catch2/catch.hpp>

#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A limb without a stroke is told the range that it is given, one with a stroke is not") {
  Document document = test::boxer();
  const Vec2 stroke = defaultRange(document, 0, *findLimb(document, "left-arm"));
  CHECK(document.warnings.empty());
  CHECK(stroke.y == 10.0);
  const Vec2 range = defaultRange(document, 0, *findLimb(document, "right-arm"));
  CHECK(range.y > range.x);
  REQUIRE(document.warnings.size() == 1);
  CHECK_THAT(document.warnings.front(),
             Catch::StartsWith("right-arm makes no stroke in the clip punch: it is taken from frame 0 to") &&
                 Catch::EndsWith("give a range"));
}
