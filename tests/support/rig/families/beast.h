#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "tests/support/rig/families/family_rig.h"

namespace stretch::test {

/// A made-up creature that grows by rows of joints.
struct Beast {
  std::string plan;
  SyntheticBiped body;
  std::map<std::string, WantedLimb> wanted;
  Row& row;

  void add(const std::string& key, const std::string& parent, const Vec3& place,
           const Vec3& flesh = Vec3(0.0)) {
    body.joints.push_back({key, parent, place, true, true, flesh});
  }
  // On both bothSides; "%" in the parent stands for the side.
  void both(const std::string& key, const std::string& parent, const Vec3& place,
            const Vec3& flesh = Vec3(0.0)) {
    for (const std::string& side : bothSides) {
      std::string above = parent;
      if (const std::size_t mark = above.find('%'); mark != std::string::npos) {
        above.replace(mark, 1, side);
      }
      const double sign = side == ".l" ? 1.0 : -1.0;
      add(key + side, above, {sign * place.x, place.y, place.z}, {sign * flesh.x, flesh.y, flesh.z});
    }
  }
  void rowOf(const std::string& stem, const std::string& parent, Vec3 place, const Vec3& step, int count) {
    std::string above = parent;
    for (int i = 0; i < count; ++i) {
      add(fmt::format("{}{}", stem, i + 1), above, place);
      above = fmt::format("{}{}", stem, i + 1);
      place += step;
    }
  }
  void rowsOfBoth(const std::string& stem, const std::string& parent, Vec3 place, const Vec3& step,
                  int count) {
    std::string above = parent;
    for (int i = 0; i < count; ++i) {
      both(fmt::format("{}{}", stem, i + 1), above, place);
      above = fmt::format("{}{}%", stem, i + 1);
      place += step;
    }
  }
  [[nodiscard]] bool has(const std::string& key) const {
    return std::ranges::find(body.joints, key, &SyntheticJoint::key) != body.joints.end();
  }
  void wantBoth(const std::string& id, const WantedLimb& limb) {
    for (const std::string& side : bothSides) {
      WantedLimb one = limb;
      for (std::string* const text : {&one.first, &one.through, &one.end}) {
        for (std::size_t mark = 0; (mark = text->find('%')) != std::string::npos;) {
          text->replace(mark, 1, side);
        }
      }
      std::string name = id;
      name.replace(name.find('%'), 1, side == ".l" ? "left" : "right");
      wanted[name] = one;
    }
  }
};

/// Trunk of a body that lies along Z: hips behind, spine, neck, head.
void addLyingTrunk(Beast& beast, double height, double length, int spine, int neck, double rise);
void addBirdLegs(Beast& beast, double height, double z);

/// Keys of the joints at which a leg may end, apart by "|".
[[nodiscard]] std::string ends(const std::string& stem);

[[nodiscard]] Beast quadruped(Row& row);
[[nodiscard]] Beast bird(Row& row);
[[nodiscard]] Beast fish(Row& row);
[[nodiscard]] Beast manyLegged(Row& row, int rows, bool flies);

/// A family of beasts, and what makes one of it.
struct BeastKind {
  const char* title;
  Beast (*make)(Row& row);
};

/// Beasts that are rarer, or named as programs name them.
[[nodiscard]] const std::vector<BeastKind>& rareKinds();

} // namespace stretch::test
