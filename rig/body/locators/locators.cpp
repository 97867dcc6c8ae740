#include "rig/body/locators/locators.h"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"

namespace stretch::rig {

namespace {

constexpr std::string_view left = "left";
constexpr std::string_view right = "right";

// The bone of a joint goes to the next one of the same limb: up the trunk, down a limb.
bool goesOnTo(std::string_view joint, std::string_view child) {
  const bool isTrunk = sideOfLocator(child) == BodySide::centre;
  return isTrunk || sideOfLocator(joint) != BodySide::centre;
}

std::optional<Vec3> boneOf(const Locators& locators, const Locator& locator) {
  for (const Locator& child : locators.list) {
    if (parentLocator(locators, child.name) == locator.name && goesOnTo(locator.name, child.name)) {
      return child.position - locator.position;
    }
  }
  const Locator* const parent = findLocator(locators, parentLocator(locators, locator.name));
  return parent == nullptr ? std::nullopt : std::optional(locator.position - parent->position);
}

Vec3 positionOr(const Locators& locators, std::string_view name, const Vec3& otherwise) {
  const Locator* const locator = findLocator(locators, name);
  return locator == nullptr ? otherwise : locator->position;
}

const LocatorPlan& planOf(const Locators& locators) {
  const LocatorPlan* const plan = locatorPlan(locators.plan);
  return plan == nullptr ? locatorPlans().front() : *plan;
}

// Right-handed: +X left, +Y up, +Z forward, each of unit length.
Mat3 bodyAxes(const Locators& locators) {
  const LocatorPlan& plan = planOf(locators);
  const Vec3 along = positionOr(locators, "head", Vec3(0.0, 1.0, 0.0)) -
                     positionOr(locators, plan.joints.front().name, Vec3(0.0));
  Vec3 across(0.0);
  for (const std::string& joint : plan.across) {
    across += positionOr(locators, std::string(left).append(joint), Vec3(0.0)) -
              positionOr(locators, std::string(right).append(joint), Vec3(0.0));
  }
  const Vec3 third = plan.stands ? glm::cross(across, along) : glm::cross(along, across);
  if (!(glm::length(third) > 0.0)) {
    return Mat3(1.0);
  }
  const Vec3 y = glm::normalize(plan.stands ? along : third);
  const Vec3 z = glm::normalize(plan.stands ? third : along);
  return {glm::cross(y, z), y, z};
}

Quat turnAlong(const Vec3& bone, const Vec3& facing) {
  const Vec3 y = glm::normalize(bone);
  Vec3 z = facing - glm::dot(facing, y) * y;
  constexpr double leastAngle = 1e-3;
  z = glm::length(z) > leastAngle ? glm::normalize(z) : anyPerpendicular(y);
  return glm::normalize(glm::quat_cast(Mat3(glm::cross(y, z), y, z)));
}

} // namespace

const Locator* findLocator(const Locators& locators, std::string_view name) {
  const auto found = std::ranges::find(locators.list, name, &Locator::name);
  return found == locators.list.end() ? nullptr : &*found;
}

Locator* findLocator(Locators& locators, std::string_view name) {
  const auto found = std::ranges::find(locators.list, name, &Locator::name);
  return found == locators.list.end() ? nullptr : &*found;
}

std::string_view parentLocator(const Locators& locators, std::string_view name) {
  const LocatorPlan& plan = planOf(locators);
  const LocatorJoint* joint = findJoint(plan, name);
  while (joint != nullptr && !joint->parent.empty()) {
    joint = findJoint(plan, joint->parent);
    if (findLocator(locators, joint->name) != nullptr) {
      return joint->name;
    }
  }
  return {};
}

std::vector<std::string> missingLocators(const Locators& locators) {
  std::vector<std::string> missing;
  for (const LocatorJoint& joint : planOf(locators).joints) {
    if (joint.isNeeded && findLocator(locators, joint.name) == nullptr) {
      missing.push_back(joint.name);
    }
  }
  return missing;
}

BodySide sideOfLocator(std::string_view name) {
  return name.starts_with(left)    ? BodySide::left
         : name.starts_with(right) ? BodySide::right
                                   : BodySide::centre;
}

std::string mirroredLocator(std::string_view name) {
  switch (sideOfLocator(name)) {
  case BodySide::left:
    return std::string(right).append(name.substr(left.size()));
  case BodySide::right:
    return std::string(left).append(name.substr(right.size()));
  case BodySide::centre:
    break;
  }
  return std::string(name);
}

Locators inOrder(Locators locators) {
  const std::vector<LocatorJoint>& joints = planOf(locators).joints;
  std::ranges::stable_sort(locators.list, {}, [&](const Locator& locator) {
    return std::ranges::find(joints, locator.name, &LocatorJoint::name) - joints.begin();
  });
  return locators;
}

Locators alongBones(Locators locators) {
  const Mat3 axes = bodyAxes(locators);
  const LocatorPlan& plan = planOf(locators);
  for (Locator& locator : locators.list) {
    const std::optional<Vec3> bone = boneOf(locators, locator);
    if (bone && glm::length(*bone) > 0.0) {
      const LocatorJoint* const joint = findJoint(plan, locator.name);
      locator.orientation = turnAlong(*bone, joint != nullptr && joint->facesUp ? axes[1] : axes[2]);
    }
  }
  return locators;
}

Locators turnedWithBones(const Locators& before, Locators moved) {
  for (Locator& locator : moved.list) {
    const Locator* const old = findLocator(before, locator.name);
    const std::optional<Vec3> from = old == nullptr ? std::nullopt : boneOf(before, *old);
    const std::optional<Vec3> to = boneOf(moved, locator);
    if (from && to) {
      locator.orientation = glm::normalize(shortestArc(*from, *to) * locator.orientation);
    }
  }
  return moved;
}

} // namespace stretch::rig
