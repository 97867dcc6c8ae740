#include "rig/trail/release.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

using namespace stretch::rig;

TEST_CASE("a release decays from all to nothing without a jump or a kink") {
  const Release release(0.4, 0.0);
  CHECK(release.at(0.0) == 1.0);
  CHECK(release.at(0.4) == 0.0);
  CHECK(release.at(1.0) == 0.0);
  double before = 1.0;
  for (double t = 0.001; t < 0.4; t += 0.001) {
    const double now = release.at(t);
    CHECK(now < before);
    CHECK(before - now < 0.005);
    before = now;
  }
  CHECK(1.0 - release.at(1e-4) < 1e-6);
  CHECK(release.at(0.4 - 1e-4) < 1e-6);
}

TEST_CASE("a release without length ends at the tip") {
  const Release release(0.0, 0.5);
  CHECK(release.at(0.0) == 1.0);
  CHECK(release.at(1e-9) == 0.0);
  CHECK(Release(-1.0, 0.0).seconds() == 0.0);
}

TEST_CASE("the release swings past the original by the overshoot and settles") {
  for (const double overshoot : {0.05, 0.2, 0.5, 1.0}) {
    const Release release(1.0, overshoot);
    double lowest = 1.0;
    for (int i = 0; i <= 1000; ++i) {
      lowest = std::min(lowest, release.at(i / 1000.0));
    }
    CAPTURE(overshoot);
    CHECK(lowest == Approx(-overshoot).epsilon(1e-3));
    CHECK(release.at(0.0) == 1.0);
    CHECK(std::abs(release.at(1.0 - 1e-9)) < 1e-6);
  }
}

TEST_CASE("no overshoot never swings past the original") {
  const Release release(1.0, 0.0);
  for (int i = 0; i <= 1000; ++i) {
    CHECK(release.at(i / 1000.0) >= 0.0);
  }
}

TEST_CASE("a release that lingers keeps all of the offset, then decays over what is left") {
  const Release release(0.5, 0.2, 0.1);
  const Release after(0.4, 0.2);
  CHECK(release.seconds() == 0.5);
  CHECK(release.at(0.1) == 1.0);
  for (const double t : {0.01, 0.1, 0.2, 0.39}) {
    CHECK(release.at(0.1 + t) == Approx(after.at(t)));
  }
  CHECK(release.at(0.5) == 0.0);
}

TEST_CASE("a release lingers no longer than it lasts") {
  const Release release(0.5, 0.0, 2.0);
  CHECK(release.at(0.5) == 1.0);
  CHECK(release.at(0.5 + 1e-9) == 0.0);
  CHECK(Release(0.5, 0.0, -1.0).at(0.25) == Approx(0.5));
}

TEST_CASE("a release swings past the original by no more than the whole way") {
  for (int i = 0; i <= 20; ++i) {
    CHECK(Release(1.0, 3.0).at(i / 20.0) == Release(1.0, 1.0).at(i / 20.0));
  }
}
