#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/files/saved_work.h"
#include "app/recipe/recipe.h"
#include "app/things/place.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using test::oneOfEach;
using test::twoPunches;

namespace {

Document with(const Document& document, const Things& things) {
  const Result<Placed> made = place(document, things, Entry::request);
  INFO(test::refusal(made));
  REQUIRE(made);
  return made->document;
}

Document fullOnBoth() {
  return with(with(twoPunches(), oneOfEach(0, 0.25)), oneOfEach(1, 0.75));
}

/// Of each list, how many things stand in the clip; every list is to have as many.
std::vector<std::size_t> countsOf(const Things& things, int clip) {
  std::vector<std::size_t> counts;
  eachList(things, [&](const auto& list) {
    counts.push_back(static_cast<std::size_t>(
        std::ranges::count_if(list, [&](const auto& thing) { return thing.clip == clip; })));
  });
  return counts;
}

Things thingsOf(const Document& document) {
  return {document.trails, document.adjustments, document.holds, document.weights};
}

const std::vector<std::size_t> eachOnce{1, 2, 1, 1, 1, 1};

} // namespace

TEST_CASE("A thing takes the place of none that stands at the same time in another clip") {
  const Document both = fullOnBoth();
  CHECK(countsOf(thingsOf(both), 0) == eachOnce);
  CHECK(countsOf(thingsOf(both), 1) == eachOnce);
  const Document again = with(both, oneOfEach(1, 0.5));
  CHECK(again.holds.pins[0] == oneOfEach(0, 0.25).holds.pins[0]);
  CHECK(again.holds.grips[0] == oneOfEach(0, 0.25).holds.grips[0]);
  CHECK(again.holds.props[0] == oneOfEach(0, 0.25).holds.props[0]);
  CHECK(again.adjustments[0] == oneOfEach(0, 0.25).adjustments[0]);
  CHECK(again.weights[0] == oneOfEach(0, 0.25).weights[0]);
  CHECK(countsOf(thingsOf(again), 1) == eachOnce);
}

TEST_CASE("What stands in the second clip comes back in the second clip of the saved work") {
  const Document both = fullOnBoth();
  Document restored = twoPunches();
  restored.scene = both.scene;
  restored.clips = both.clips;
  REQUIRE(restoreWork(workOf(both), restored));
  CHECK(restored.warnings.empty());
  CHECK(restored.trails == both.trails);
  CHECK(restored.adjustments == both.adjustments);
  CHECK(restored.holds == both.holds);
  CHECK(restored.weights == both.weights);
}

TEST_CASE("A recipe of one clip that is read for another is for that one, with all that it names") {
  const Document first = with(twoPunches(), oneOfEach(0, 0.25));
  Document other = twoPunches();
  const Result<Recipe> recipe = recipeFromJson(recipeToJson(first, 0), other, 1);
  INFO(test::refusal(recipe));
  REQUIRE(recipe);
  CHECK(countsOf(*recipe, 1) == eachOnce);
  CHECK(countsOf(*recipe, 0) == std::vector<std::size_t>(6, 0));
}

TEST_CASE("A recipe of the second clip names what stands there alone") {
  Document other = twoPunches();
  const Result<Recipe> recipe = recipeFromJson(recipeToJson(fullOnBoth(), 1), other);
  INFO(test::refusal(recipe));
  REQUIRE(recipe);
  CHECK(recipe->clip == 1);
  CHECK(countsOf(*recipe, 1) == eachOnce);
  CHECK(recipe->holds.pins[0].stretch == 0.75);
  CHECK(recipe->holds.grips[0].stretch == 0.75);
  CHECK(recipe->weights[0].settings.amount == 0.75);
}

TEST_CASE("A controller that is reset in one clip stays offset in another") {
  for (const int clip : {0, 1}) {
    const Document reset = removeAdjustments(fullOnBoth(), "hips", clip);
    REQUIRE(reset.adjustments.size() == 3);
    for (const rig::Adjustment& left : reset.adjustments) {
      CHECK((left.controller != "hips" || left.clip == 1 - clip));
    }
  }
}

TEST_CASE("Past the end of one clip nothing may stand because it stands there in another") {
  Things past = oneOfEach(0, 0.25);
  past.holds.pins[0].time.rangeFrames.y = 30.0;
  const Result<Placed> kept = place(twoPunches(), past, Entry::file);
  REQUIRE(kept);
  Things pin;
  pin.holds.pins = past.holds.pins;
  CHECK(place(kept->document, pin, Entry::request)); // it stands there already
  pin.holds.pins[0].clip = 1;
  CHECK_THAT(test::refusal(place(kept->document, pin, Entry::request)),
             Catch::StartsWith("right-arm: its range 3 to 30"));
}
