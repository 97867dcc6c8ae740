#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/support/recorded.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/families/family_rig.h"
#include "tests/support/rig/families/family_table.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr int drawn = 40;  // of each family
constexpr int wholes = 12; // of each program
constexpr int inAction = 120;

} // namespace

TEST_CASE("Drawn rigs of every family are read as a person reads them, as often as was counted") {
  Calibration limbs;
  std::string text = familiesTable(bipedFamilies(drawn), limbs, nullptr);
  text += familiesTable(bipedsInAction(inAction), limbs, nullptr);
  text += familiesTable(beastFamilies(drawn), limbs, nullptr);
  text += familiesTable(rareBeasts(drawn), limbs, nullptr);
  text += familiesTable(wholeBipeds(wholes), limbs, nullptr);
  const std::array bands{"0.8 and more", "0.5 to 0.8", "under 0.5"};
  for (std::size_t band = 0; band < bands.size(); ++band) {
    text += fmt::format("limbs with a confidence of {}: {} of {} right\n", bands[band], limbs.right[band],
                        limbs.all[band]);
  }
  CHECK(limbs.right[0] >= 0.98 * limbs.all[0]);
  CHECK(limbs.right[0] + limbs.right[1] >= 0.9 * (limbs.all[0] + limbs.all[1]));
  CHECK(limbs.right[1] >= 0.9 * limbs.all[1]);
  const std::string difference = differenceFromRecord("families-of-rigs", text);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE(
    "Drawn beasts whose bind pose is a moment of an action are read or doubted as often as was counted") {
  constexpr int moved = 20; // of each family
  std::vector<FamilyRig> rigs = beastFamilies(moved);
  std::ranges::move(rareBeasts(moved), std::back_inserter(rigs));
  Row row(77);
  for (FamilyRig& rig : rigs) {
    moveEachJoint(rig.body, 15.0, row);
  }
  Calibration limbs;
  const std::string difference =
      differenceFromRecord("beasts-in-action", familiesTable(rigs, limbs, nullptr));
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("What is read wrongly of drawn rigs, for looking at", "[.drawn]") {
  std::string details;
  Calibration limbs;
  const char* const number = std::getenv("EACH");
  const int each = number == nullptr ? drawn : std::atoi(number);
  std::string text = familiesTable(bipedFamilies(each), limbs, &details);
  text += familiesTable(bipedsInAction(each), limbs, &details);
  text += familiesTable(wholeBipeds(each), limbs, &details);
  text += familiesTable(beastFamilies(each), limbs, &details);
  text += familiesTable(rareBeasts(each), limbs, &details);
  for (std::size_t band = 0; band < limbs.all.size(); ++band) {
    text += fmt::format("confidence band {}: {} of {}\n", band, limbs.right[band], limbs.all[band]);
  }
  std::puts((details + text).c_str());
}
