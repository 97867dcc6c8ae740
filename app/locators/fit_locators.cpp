#include "app/locators/fit_locators.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/common.hpp>

#include "app/locators/build_rig.h"
#include "app/locators/creature_locators.h"
#include "core/anim/sampling.h"
#include "core/scene/morphs.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"
#include "skinning/linear_blend_skinning.h"
#include "skinning/locate/fit_biped.h"

namespace stretch::app {

namespace {

constexpr double unsureBelow = 0.5;
constexpr double guess = 0.2;
constexpr const char* biped = "biped";

FittedLocators ofBiped(skinning::FittedBiped fitted) {
  FittedLocators result;
  for (const skinning::FittedJoint& joint : fitted.joints) {
    result.locators.list.push_back(
        {.name = joint.name, .position = joint.position, .confidence = joint.confidence});
  }
  result.locators = rig::alongBones(rig::inOrder(std::move(result.locators)));
  result.warnings = std::move(fitted.warnings);
  return result;
}

// Collects locators at the joints of limbs.
class LimbLocators {
public:
  explicit LimbLocators(const Document& document)
      : document_(document), worlds_(rig::bindPoseWorlds(*document.scene)) {}

  void add(const std::string& name, const Vec3& place, double confidence) {
    locators_.list.push_back({.name = name, .position = place, .confidence = confidence});
  }
  void addNode(const std::string& name, NodeIndex node) {
    if (node.exists()) {
      add(name, positionOf(worlds_[at(node)]), 1.0);
    }
  }
  // An arm or a leg: base, middle, end. One of a single bone gets its middle halfway.
  void addLimb(const std::string& id, const std::array<std::string, 3>& names) {
    if (const rig::Limb* const limb = findLimb(document_, id)) {
      const std::vector<Vec3> points = rig::limbPoints(*limb, worlds_);
      const bool isBent = points.size() > 2;
      add(names[0], points.front(), limb->confidence);
      add(names[1], isBent ? points[1] : glm::mix(points.front(), points.back(), 0.5),
          isBent ? limb->confidence : guess);
      add(names[2], points.back(), limb->endNode.exists() ? limb->confidence : guess);
    }
  }
  void addTrunk() {
    addNode("hips", document_.body.hips);
    if (const rig::Limb* const spine = findLimb(document_, "spine")) {
      const std::array<std::string, 3> names{"spine", "chest", "upperChest"};
      const std::size_t count = std::min(spine->joints.size(), names.size());
      for (std::size_t i = 0; i < count; ++i) {
        if (spine->joints[i] != document_.body.hips) {
          addNode(names[i], spine->joints[i]);
        }
      }
    }
    if (const rig::Limb* const neck = findLimb(document_, "neck")) {
      addNode("neck", neck->joints.front());
    }
    addNode("head", document_.body.head);
  }
  // What the plan needs and the skeleton lacks, between what there is.
  void complete() {
    const double height = document_.body.height;
    const auto placeOf = [&](const char* name, const Vec3& otherwise) {
      const rig::Locator* const locator = rig::findLocator(locators_, name);
      return locator == nullptr ? otherwise : locator->position;
    };
    const Vec3 hips = placeOf("hips", 0.5 * (placeOf("leftUpperLeg", {}) + placeOf("rightUpperLeg", {})));
    const Vec3 shoulders = 0.5 * (placeOf("leftUpperArm", {}) + placeOf("rightUpperArm", {}));
    for (const auto& [name, place] :
         {std::pair{"hips", hips}, std::pair{"spine", glm::mix(hips, shoulders, 0.2)},
          std::pair{"head", shoulders + Vec3(0.0, 0.08 * height, 0.0)}}) {
      if (rig::findLocator(locators_, name) == nullptr) {
        add(name, place, guess);
      }
    }
  }
  [[nodiscard]] rig::Locators made() const { return rig::alongBones(rig::inOrder(locators_)); }

private:
  const Document& document_;
  std::vector<Mat4> worlds_;
  rig::Locators locators_;
};

// Joints that have the names of locators say themselves where these belong, and how they are turned.
rig::Locators ofNamedJoints(const Scene& scene, const rig::LocatorPlan& plan) {
  const std::vector<Mat4> worlds = rig::bindPoseWorlds(scene);
  rig::Locators locators{plan.id, {}};
  for (const NodeIndex joint : skinJoints(scene)) {
    const std::string& name = scene.nodes[at(joint)].name;
    if (rig::findJoint(plan, name) != nullptr && rig::findLocator(locators, name) == nullptr) {
      const Transform place = toTransform(worlds[at(joint)]);
      locators.list.push_back({name, place.translation, glm::normalize(place.rotation), 1.0});
    }
  }
  locators = rig::inOrder(std::move(locators));
  const bool areAll = !locators.empty() && rig::missingLocators(locators).empty() &&
                      !jointsOfLocators(scene, locators).empty();
  return areAll ? locators : rig::Locators();
}

FittedLocators ofLimbs(const Document& document) {
  LimbLocators locators(document);
  for (const std::string side : {"left", "right"}) {
    locators.addLimb(side + "-arm", {side + "UpperArm", side + "LowerArm", side + "Hand"});
    locators.addLimb(side + "-leg", {side + "UpperLeg", side + "LowerLeg", side + "Foot"});
  }
  locators.addTrunk();
  locators.complete();
  return FittedLocators{locators.made(), true, {}};
}

} // namespace

MeshesInWorld meshesAtRest(const Scene& scene) {
  const std::vector<Mat4> worlds = worldMatrices(scene, restPose(scene));
  MeshesInWorld meshes;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    const Node& holder = scene.nodes[at(node)];
    const Mesh& mesh = scene.meshes[at(holder.mesh)];
    for (const Primitive& primitive : mesh.primitives) {
      const auto first = static_cast<std::uint32_t>(meshes.positions.size());
      for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        meshes.positions.push_back(
            transformPoint(worlds[at(node)], morphedPlace(mesh, primitive, holder.morphWeights, v)));
      }
      for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        meshes.triangles.push_back({first + primitive.indices[i], first + primitive.indices[i + 1],
                                    first + primitive.indices[i + 2]});
      }
    }
  }
  return meshes;
}

Result<FittedLocators> fitLocators(const Document& document, const std::string& plan,
                                   const skinning::Proceed& proceed) {
  const rig::LocatorPlan* const own = rig::locatorPlan(document.body.plan);
  if (rig::Locators named = own == nullptr ? rig::Locators() : ofNamedJoints(*document.scene, *own);
      !named.empty()) {
    return FittedLocators{std::move(named), true, {}};
  }
  if (document.body.isBiped) {
    return ofLimbs(document);
  }
  if (!document.scene->skins.empty()) {
    return Error{"the file has a skeleton in which no biped is found", "",
                 "it has joints already: bind at those (--keep-joints), or give a mesh without a skeleton"};
  }
  const MeshesInWorld meshes = meshesAtRest(*document.scene);
  if (!plan.empty() && plan != biped) {
    return ofCreature(meshes, *rig::locatorPlan(plan), proceed);
  }
  Result<skinning::FittedBiped> fitted = skinning::fitBiped(meshes.positions, meshes.triangles, proceed);
  if (plan.empty() && fitted && !fitted->standsInScene) {
    if (std::optional<FittedLocators> creature = standingOnManyLegs(meshes, proceed)) {
      return std::move(*creature);
    }
  }
  if (plan.empty() && (!fitted || !fitted->doubt.empty())) {
    return ofShownPlan(meshes, fitted ? fitted->doubt : fitted.error().what, proceed);
  }
  return fitted ? Result<FittedLocators>(ofBiped(std::move(*fitted))) : fitted.error();
}

std::vector<std::string> unsureLocators(const rig::Locators& locators) {
  std::vector<std::string> unsure;
  for (const rig::Locator& locator : locators.list) {
    if (locator.confidence < unsureBelow) {
      unsure.push_back(locator.name);
    }
  }
  return unsure;
}

} // namespace stretch::app
