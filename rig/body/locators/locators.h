#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math/types.h"
#include "rig/body/locators/locator_plans.h"

namespace stretch::rig {

/// Place where one joint of a body plan is to stand, and its turn.
struct Locator {
  std::string name;   ///< Name of the joint: one of its plan (locator_plans.h).
  Vec3 position{0.0}; ///< World, in the pose that the mesh has without a skeleton.
  /// World. +Y along the bone, +Z where the body faces (alongBones); unit length.
  Quat orientation{1.0, 0.0, 0.0, 0.0};
  double confidence = 1.0; ///< 0..1: how sure the place is; 1 for what was set by hand.

  friend bool operator==(const Locator&, const Locator&) = default;
};

/// The locators of a body, parents before their children.
struct Locators {
  std::string plan = "biped";
  std::vector<Locator> list;

  [[nodiscard]] bool empty() const { return list.empty(); }
  friend bool operator==(const Locators&, const Locators&) = default;
};

/// Null when there is none of this name.
[[nodiscard]] const Locator* findLocator(const Locators& locators, std::string_view name);
[[nodiscard]] Locator* findLocator(Locators& locators, std::string_view name);

/// The nearest joint above that has a locator; empty for the topmost.
[[nodiscard]] std::string_view parentLocator(const Locators& locators, std::string_view name);

/// Names of the joints that the plan needs and that have no locator.
[[nodiscard]] std::vector<std::string> missingLocators(const Locators& locators);

enum class BodySide { centre, left, right };
[[nodiscard]] BodySide sideOfLocator(std::string_view name);

/// "leftHand" for "rightHand" and the other way round; the name itself where it has no side.
[[nodiscard]] std::string mirroredLocator(std::string_view name);

/// Puts the list into the order of the plan: parents before their children.
[[nodiscard]] Locators inOrder(Locators locators);

/// Turns every locator: +Y along its bone to the next joint (that of a last joint goes on as the bone before
/// it), +Z as nearly as may be to where the body faces, upwards where the plan says so, as on feet. +X of an
/// elbow or a knee is then the axis that it bends about. Bones without length keep the turn that they have.
[[nodiscard]] Locators alongBones(Locators locators);

/// Turns the named locator and the ones beside it with their bones, after it was moved from `before`: each
/// bone that begins or ends there takes its turn with it by the smallest rotation, so that a turn made by
/// hand stays.
[[nodiscard]] Locators turnedWithBones(const Locators& before, Locators moved);

} // namespace stretch::rig
