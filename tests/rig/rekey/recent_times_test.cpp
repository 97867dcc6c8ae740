#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/rekey/exact_motion.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

/// Values that count how often they were made.
struct Maker {
  explicit Maker(std::size_t capacity) : recent(capacity) {}

  /// Whether the value of a time had to be made.
  bool makes(double time) {
    const int before = made;
    const double value = recent.of(time, [&] {
      ++made;
      return 10.0 * time;
    });
    CHECK(value == 10.0 * time);
    return made > before;
  }

  RecentTimes<double> recent;
  int made = 0;
};

std::vector<double> countTo(int last) {
  std::vector<double> times;
  for (int i = 0; i <= last; ++i) {
    times.push_back(i);
  }
  return times;
}

} // namespace

TEST_CASE("as many times as are to be remembered are made once, whatever their order") {
  Maker maker(3);
  CHECK(maker.makes(2.0));
  CHECK(maker.makes(1.0));
  CHECK(maker.makes(3.0));
  for (const double time : {1.0, 2.0, 3.0, 1.0}) {
    CHECK_FALSE(maker.makes(time));
  }
}

TEST_CASE(
    "a time is remembered until twice as many others were asked for, or as many after it was asked again") {
  Maker maker(2);
  CHECK(maker.makes(1.0));
  CHECK(maker.makes(2.0));
  CHECK(maker.makes(3.0)); // 1 and 2 are of the generation before.
  CHECK_FALSE(maker.makes(1.0));
  CHECK(maker.makes(4.0)); // 3 and 1 are.
  CHECK_FALSE(maker.makes(1.0));
  CHECK(maker.makes(2.0));
  CHECK(maker.makes(3.0)); // Forgotten with 4, which came after 1.
}

TEST_CASE("a value stays where it is until as many other times were asked for") {
  RecentTimes<double> recent(3);
  const double& first = recent.of(1.0, [] { return 11.0; });
  for (const double time : {2.0, 3.0, 4.0}) {
    static_cast<void>(recent.of(time, [&] { return time; }));
  }
  CHECK(first == 11.0);
  CHECK(&recent.of(1.0, [] { return 0.0; }) == &first);
}

TEST_CASE("makers of keys stop at every 64th of all their times, each counted once, and at the end") {
  CHECK(stopsAmong({}) == std::vector<double>{INFINITY});
  CHECK(stopsAmong(countTo(63)) == std::vector<double>{INFINITY});
  CHECK(stopsAmong(countTo(64)) == std::vector<double>{64.0, INFINITY});
  CHECK(stopsAmong(countTo(128)) == std::vector<double>{64.0, 128.0, INFINITY});
  std::vector<double> twice = countTo(100); // In no order, and each of two makers has it.
  const std::vector<double> others = countTo(70);
  twice.insert(twice.begin(), others.rbegin(), others.rend());
  CHECK(stopsAmong(twice) == std::vector<double>{64.0, INFINITY});
}
