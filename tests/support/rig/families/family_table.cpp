#include "tests/support/rig/families/family_table.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "tests/support/rig/described_limbs.h"

namespace stretch::test {

using namespace stretch::rig;

namespace {

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

} // namespace

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

} // namespace stretch::test
