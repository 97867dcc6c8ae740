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
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr int drawn = 40;  // of each family
constexpr int wholes = 12; // of each program
constexpr int inAction = 120;

bool isOneOf(const std::string& key, const std::string& alternatives) {
  return ("|" + alternatives + "|").find("|" + key + "|") != std::string::npos;
}

bool isRight(const BuiltBiped& built, const Limb& limb, const WantedLimb& wanted) {
  const std::string end = keyOf(built, limb.endNode);
  const bool goesThrough = wanted.through.empty() || std::ranges::any_of(limb.joints, [&](NodeIndex joint) {
                             return keyOf(built, joint) == wanted.through;
                           });
  return isOneOf(keyOf(built, limb.joints.front()), wanted.first) && goesThrough && isOneOf(end, wanted.end);
}

struct Judged {
  bool right = true;
  bool told = false; ///< Each thing that is wrong has a confidence below a half, or is missing with a
                     ///< warning.
  std::string what;
};

/// Of limbs by tenths of confidence.
struct Calibration {
  std::array<int, 3> right{};
  std::array<int, 3> all{};
  void add(double confidence, bool isRight) {
    const std::size_t band = confidence >= 0.8 ? 0 : confidence >= 0.5 ? 1 : 2;
    ++all[band];
    right[band] += isRight ? 1 : 0;
  }
};

Judged judge(const FamilyRig& rig, Calibration& limbs) {
  const BuiltBiped built = build(rig.body);
  const Body read = detectBody(built.scene);
  Judged judged;
  judged.told = true;
  const auto wrong = [&](const std::string& what, bool isTold) {
    judged.right = false;
    judged.told = judged.told && isTold;
    judged.what += "\n      " + what;
  };
  const bool plan = isOneOf(read.plan, rig.plan);
  if (!plan) {
    wrong(fmt::format("read as {} ({:.2f})", read.plan, read.planConfidence), read.planConfidence < 0.5);
  }
  for (const Limb& limb : read.limbs) {
    const auto wanted = rig.wanted.find(limb.id);
    const bool isWanted = wanted != rig.wanted.end();
    const bool isAbsent = std::ranges::find(rig.absent, limb.id) != rig.absent.end();
    if (isWanted || isAbsent || !plan) {
      const bool isGood = plan && isWanted && isRight(built, limb, wanted->second);
      limbs.add(limb.confidence, isGood);
      if (!isGood && plan) {
        wrong(fmt::format("{} {:.2f}: {}", limb.id, limb.confidence, describe(built, read, limb)),
              limb.confidence < 0.5);
      }
    }
  }
  for (const auto& [id, limb] : rig.wanted) {
    if (plan && std::ranges::find(read.limbs, id, &Limb::id) == read.limbs.end()) {
      const bool isTold = std::ranges::any_of(read.warnings, [&, &name = id](const std::string& warning) {
        return warning.find(name) != std::string::npos;
      });
      wrong("no " + id, isTold);
    }
  }
  return judged;
}

std::string familiesTable(const std::vector<FamilyRig>& rigs, Calibration& limbs, std::string* details) {
  struct Count {
    int all = 0;
    int right = 0;
    int untold = 0;
  };
  std::vector<std::pair<std::string, Count>> families;
  for (const FamilyRig& rig : rigs) {
    if (families.empty() || families.back().first != rig.family) {
      families.emplace_back(rig.family, Count{});
    }
    Count& count = families.back().second;
    const Judged judged = judge(rig, limbs);
    ++count.all;
    count.right += judged.right ? 1 : 0;
    count.untold += judged.right || judged.told ? 0 : 1;
    if (!judged.right && details != nullptr) {
      *details +=
          fmt::format("  {}{} [{}]{}\n", judged.told ? "(told) " : "", rig.family, rig.title, judged.what);
    }
  }
  std::string text;
  for (const auto& [family, count] : families) {
    text += fmt::format("{}: {} of {} right, {} wrong without a word\n", family, count.right, count.all,
                        count.untold);
  }
  return text;
}

/// Drawn rigs of whose trunk a third of the bones are not listed in the skin.
std::vector<FamilyRig> rigsWithUnlistedBones(int each) {
  Row row(78);
  std::vector<FamilyRig> rigs = wholeBipeds(each);
  std::ranges::move(bipedFamilies(each), std::back_inserter(rigs));
  std::ranges::move(beastFamilies(each), std::back_inserter(rigs));
  for (FamilyRig& rig : rigs) {
    for (SyntheticJoint& joint : rig.body.joints) {
      const bool isOfTrunk = std::ranges::any_of(
          std::array{"hips", "spine", "chest", "neck", "clavicle", "scapula", "thorax", "body"},
          [&](const char* stem) { return joint.key.starts_with(stem); });
      if (isOfTrunk && row.once(3)) {
        joint.isJoint = joint.movesMesh = false;
        rig.title += " without " + joint.key;
      }
    }
  }
  return rigs;
}

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

TEST_CASE(
    "Bones that no skin lists, since no vertex follows them, are read or doubted as often as was counted") {
  constexpr int each = 10; // of each family
  Calibration limbs;
  const std::string difference =
      differenceFromRecord("unlisted-bones", familiesTable(rigsWithUnlistedBones(each), limbs, nullptr));
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
  text += familiesTable(rigsWithUnlistedBones(each), limbs, &details);
  for (std::size_t band = 0; band < limbs.all.size(); ++band) {
    text += fmt::format("confidence band {}: {} of {}\n", band, limbs.right[band], limbs.all[band]);
  }
  std::puts((details + text).c_str());
}
