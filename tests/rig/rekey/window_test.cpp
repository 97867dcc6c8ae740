#include <catch2/catch.hpp>

#include "rig/rekey/keyed_part.h"

using namespace stretch::rig;

TEST_CASE("Of two windows that begin or end at one time the whole jumps there if one of them does") {
  for (const bool first : {false, true}) {
    for (const bool second : {false, true}) {
      CAPTURE(first, second);
      Window window{1.0, 2.0, first, first};
      extend(window, {1.0, 2.0, second, second});
      CHECK(window.jumpsBefore == (first || second));
      CHECK(window.jumpsAfter == (first || second));
      CHECK(window.startSeconds == 1.0);
      CHECK(window.endSeconds == 2.0);
    }
  }
}

TEST_CASE(
    "What begins or ends inside a window changes nothing at its ends, and what ends later gives it its end") {
  Window window{1.0, 2.0, false, true};
  extend(window, {1.25, 1.5, true, false});
  CHECK_FALSE(window.jumpsBefore);
  CHECK(window.jumpsAfter);
  CHECK(window.endSeconds == 2.0);
  extend(window, {1.5, 3.0, true, false});
  CHECK_FALSE(window.jumpsBefore);
  CHECK_FALSE(window.jumpsAfter);
  CHECK(window.endSeconds == 3.0);
  extend(window, {2.0, 4.0, false, true});
  CHECK(window.jumpsAfter);
  CHECK(window.endSeconds == 4.0);
}
