#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/math/rotation.h"
#include "tests/support/rig/families/family_rig.h"

namespace stretch::test {

/// 1 on the left, -1 on the right.
double signOf(const std::string& side);

/// A body that is drawn, and what becomes of it.
struct Draft {
  SyntheticBiped body;
  Row& row;
  std::map<std::string, WantedLimb> wanted{};
  std::vector<std::string> absent{};
  std::vector<std::pair<std::string, std::string>> moved{}; // joints that hang elsewhere once posed
  std::map<std::string, std::string> names{};               // of joints that a trait names like a limb's

  Vec3 at(const std::string& key) { return jointOf(body, key).position; }
  [[nodiscard]] bool has(const std::string& key) const {
    return std::ranges::find(body.joints, key, &SyntheticJoint::key) != body.joints.end();
  }
  void add(const std::string& key, const std::string& parent, const Vec3& place, bool movesMesh = true) {
    body.joints.push_back({key, parent, place, true, movesMesh});
  }
  /// A row of joints from a place, each `step` from the one before.
  void addRow(const std::string& stem, const std::string& side, const std::string& parent, Vec3 place,
              const Vec3& step, int count) {
    std::string above = parent;
    for (int i = 0; i < count; ++i) {
      const std::string key = fmt::format("{}{}{}", stem, i + 1, side);
      add(key, above, place);
      above = key;
      place += step;
    }
  }
  std::string chest() { return jointOf(body, has("clavicle.l") ? "clavicle.l" : "upperArm.l").parent; }
};

/// "left-arm".
std::string idOf(const std::string& side, const std::string& limb);

/// Turns joints of the body that it has.
struct Poser {
  Draft& draft;

  void turn(const std::string& key, const Vec3& axis, double degrees) const {
    if (draft.has(key)) {
      turnBelow(draft.body, key, axisAngle(axis, degrees * pi / 180.0));
    }
  }
  void arms(double down, double forward, double elbow) const {
    for (const std::string& side : bothSides) {
      const double sign = signOf(side);
      turn("foreArm" + side, Vec3(0, 1, 0), -sign * elbow);
      turn("upperArm" + side, Vec3(0, 1, 0), -sign * forward);
      turn("upperArm" + side, Vec3(0, 0, 1), -sign * down);
    }
  }
  void legs(double thigh, double shin, double foot) const {
    for (const std::string& side : bothSides) {
      turn("foot" + side, Vec3(1, 0, 0), foot);
      turn("shin" + side, Vec3(1, 0, 0), shin);
      turn("thigh" + side, Vec3(1, 0, 0), thigh);
    }
  }
};

BodyOptions drawOptions(Row& row);

/// Adds the limbs that a body with these options should be read with.
void wantLimbs(Draft& draft, const BodyOptions& options);

/// Gives the last joints meshes that reach as far as hands and feet do.
void giveFlesh(Draft& draft, const BodyOptions& options);

} // namespace stretch::test
