// Eases that together take the whole path: refused by hand and by request, kept where a file holds them.
#include <vector>

#include <catch2/catch.hpp>

#include "app/things/place.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Things withEases(const rig::Ease& easeIn, const rig::Ease& easeOut) {
  Things things;
  things.trails = test::withNewTrail(test::boxer(), {}).trails;
  things.trails.front().settings.easeIn = easeIn;
  things.trails.front().settings.easeOut = easeOut;
  return things;
}

} // namespace

TEST_CASE("Eases that make a jump are refused to whoever asks, and cost no trail of an older file") {
  const Document document = test::boxer();
  for (const Things& things : {withEases({0.6, 0.1}, {0.4, 0.9}), withEases({0.6, 0.6}, {0.0, 0.9}),
                               withEases({0.0, 0.1}, {0.2, 0.4})}) {
    CHECK_FALSE(place(document, things, Entry::request));
    CHECK_FALSE(place(document, things, Entry::hand));
    const Result<Placed> kept = place(document, things, Entry::file);
    REQUIRE(kept);
    CHECK(kept->document.trails.size() == 1);
  }
  CHECK(place(document, withEases({0.6, 0.5}, {0.39, 0.5}), Entry::request));
}
