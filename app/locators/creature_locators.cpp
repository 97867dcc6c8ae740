#include "app/locators/creature_locators.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/ranges.h>
#include <glm/common.hpp>

#include "rig/plan/body_plan.h"
#include "skinning/locate/creature/creature_shape.h"
#include "skinning/locate/creature/joints_along.h"

namespace stretch::app {

namespace {

using skinning::CreaturePart;
using skinning::CreatureShape;

constexpr std::array parts =
    std::to_array<std::pair<rig::LimbKind, CreaturePart>>({{rig::LimbKind::leg, CreaturePart::leg},
                                                           {rig::LimbKind::arm, CreaturePart::arm},
                                                           {rig::LimbKind::wing, CreaturePart::wing},
                                                           {rig::LimbKind::feeler, CreaturePart::feeler},
                                                           {rig::LimbKind::spine, CreaturePart::spine},
                                                           {rig::LimbKind::neck, CreaturePart::neck},
                                                           {rig::LimbKind::tail, CreaturePart::tail}});

int rowsOf(const rig::LocatorPlan& plan) {
  return rig::planNamed(plan.id)->legs / 2;
}

const skinning::CreatureLimb* limbAt(const CreatureShape& shape, const rig::LimbPlace& place) {
  const int side = place.side == rig::LimbSide::left ? 1 : place.side == rig::LimbSide::right ? -1 : 0;
  const auto found = std::ranges::find_if(shape.limbs, [&](const skinning::CreatureLimb& limb) {
    return std::ranges::find(parts, std::pair{place.kind, limb.part}) != parts.end() && limb.side == side &&
           limb.row == place.row;
  });
  return found == shape.limbs.end() ? nullptr : &*found;
}

// The joints of a limb are one after the other in the plan.
FittedLocators placed(const CreatureShape& shape, const rig::LocatorPlan& plan) {
  FittedLocators result;
  result.locators.plan = plan.id;
  for (auto first = plan.joints.begin(); first != plan.joints.end();) {
    const auto end =
        std::find_if(first, plan.joints.end(), [&](const auto& joint) { return joint.limb != first->limb; });
    if (const skinning::CreatureLimb* const limb = limbAt(shape, first->limb)) {
      std::vector<double> along;
      std::transform(first, end, std::back_inserter(along), [](const auto& joint) { return joint.along; });
      const std::vector<Vec3> places = skinning::jointsAlong(limb->line, along);
      for (auto joint = first; joint != end; ++joint) {
        result.locators.list.push_back({.name = joint->name,
                                        .position = places[static_cast<std::size_t>(joint - first)],
                                        .confidence = limb->confidence});
      }
    }
    first = end;
  }
  result.locators = rig::alongBones(rig::inOrder(std::move(result.locators)));
  return result;
}

// Creatures stand as their scene says, or else as their shape does.
Result<CreatureShape> shapeOf(const MeshesInWorld& meshes, int rows, const skinning::Proceed& proceed,
                              bool (*isGood)(const CreatureShape&, int)) {
  for (const skinning::UpAxis up : {skinning::UpAxis::ofScene, skinning::UpAxis::anyOfScene}) {
    Result<CreatureShape> shape =
        skinning::shapeOfMesh(meshes.positions, meshes.triangles, rows, up, proceed);
    if (!shape || isGood(*shape, rows) || up == skinning::UpAxis::anyOfScene) {
      return shape;
    }
  }
  return Error{};
}

// A plan for so many legs, with a trunk that lies where they are two: else it is a biped's.
const rig::LocatorPlan* shownPlan(const CreatureShape& shape) {
  const auto& plans = rig::locatorPlans();
  const auto found = std::find_if(plans.begin() + 1, plans.end(), [&](const rig::LocatorPlan& plan) {
    return rowsOf(plan) == shape.legRows && (shape.legRows != 1 || shape.trunkLies);
  });
  return found == plans.end() ? nullptr : &*found;
}

} // namespace

Result<FittedLocators> ofCreature(const MeshesInWorld& meshes, const rig::LocatorPlan& plan,
                                  const skinning::Proceed& proceed) {
  const int rows = rowsOf(plan);
  const Result<CreatureShape> shape = shapeOf(
      meshes, rows, proceed, [](const CreatureShape& read, int wanted) { return read.legRows == wanted; });
  if (!shape) {
    return shape.error();
  }
  if (shape->legRows != rows) {
    return Error{fmt::format("the mesh shows {} of the {} pairs of legs of {}", shape->legRows, rows,
                             rig::planNamed(plan.id)->title),
                 "", skinning::byHand};
  }
  return placed(*shape, plan);
}

std::optional<FittedLocators> standingOnManyLegs(const MeshesInWorld& meshes,
                                                 const skinning::Proceed& proceed) {
  const Result<CreatureShape> shape =
      skinning::shapeOfMesh(meshes.positions, meshes.triangles, 0, skinning::UpAxis::ofScene, proceed);
  const rig::LocatorPlan* const plan = shape && shape->legRows > 1 ? shownPlan(*shape) : nullptr;
  return plan == nullptr ? std::nullopt : std::optional(placed(*shape, *plan));
}

Result<FittedLocators> ofShownPlan(const MeshesInWorld& meshes, const std::string& doubt,
                                   const skinning::Proceed& proceed) {
  const Result<CreatureShape> shape =
      shapeOf(meshes, 0, proceed, [](const CreatureShape& read, int) { return shownPlan(read) != nullptr; });
  if (!shape) {
    return shape.error();
  }
  if (const rig::LocatorPlan* const plan = shownPlan(*shape)) {
    return placed(*shape, *plan);
  }
  return Error{
      fmt::format("what kind of body this is does not show: no biped, as {}; nor another by its legs", doubt),
      "", fmt::format("choose its body: --plan with one of {}", fmt::join(rig::locatorPlanIds(), ", "))};
}

} // namespace stretch::app
