#include "app/locators/locator_edits.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <glm/geometric.hpp>

#include "app/locators/build_rig.h"
#include "app/locators/fit_locators.h"
#include "core/math/rotation.h"
#include "skinning/locate/middle_of_mesh.h"

namespace stretch::app {

namespace {

// Across the body, from its right to its left.
Vec3 acrossOf(const rig::Locators& locators) {
  Vec3 across(0.0);
  for (const rig::Locator& locator : locators.list) {
    const rig::Locator* const other = rig::findLocator(locators, rig::mirroredLocator(locator.name));
    if (rig::sideOfLocator(locator.name) == rig::BodySide::left && other != nullptr) {
      across += locator.position - other->position;
    }
  }
  return glm::length(across) > 0.0 ? glm::normalize(across) : Vec3(1.0, 0.0, 0.0);
}

Vec3 mirrored(const Vec3& vector, const Vec3& across) {
  return vector - 2.0 * glm::dot(vector, across) * across;
}

using Change = std::function<void(rig::Locator&, const Vec3&)>;

// Makes a change to each locator and its mirror image to the counterparts.
Document changed(const Document& document, const std::vector<std::string>& names, const Vec3& vector,
                 bool mirror, bool turns, const Change& change) {
  const Vec3 across = acrossOf(document.locators);
  Document next = document;
  // The mirror image of a turn turns the other way round.
  const Vec3 opposite = turns ? -mirrored(vector, across) : mirrored(vector, across);
  for (const std::string& name : names) {
    rig::Locator* const locator = rig::findLocator(next.locators, name);
    if (locator == nullptr) {
      continue;
    }
    const bool isMiddle = rig::sideOfLocator(name) == rig::BodySide::centre;
    change(*locator, mirror && isMiddle ? 0.5 * (vector + opposite) : vector);
    const std::string counterpart = rig::mirroredLocator(name);
    rig::Locator* const other = rig::findLocator(next.locators, counterpart);
    if (mirror && !isMiddle && other != nullptr && std::ranges::find(names, counterpart) == names.end()) {
      change(*other, opposite);
    }
  }
  return next;
}

} // namespace

bool showsLocators(const Document& document, bool evenAtJoints) {
  return !document.locators.empty() && (evenAtJoints || !isRigBuilt(document) || areLocatorsMoved(document));
}

Document moveLocators(const Document& document, const std::vector<std::string>& names, const Vec3& change,
                      bool mirror) {
  Document moved = changed(document, names, change, mirror, false, [](rig::Locator& locator, const Vec3& by) {
    locator.position += by;
    locator.confidence = 1.0;
  });
  moved.locators = rig::turnedWithBones(document.locators, std::move(moved.locators));
  return moved;
}

Document turnLocators(const Document& document, const std::vector<std::string>& names,
                      const Vec3& rotationVector, bool mirror) {
  return changed(document, names, rotationVector, mirror, true, [](rig::Locator& locator, const Vec3& by) {
    const double angle = glm::length(by);
    if (angle > 0.0) {
      locator.orientation = glm::normalize(axisAngle(by / angle, angle) * locator.orientation);
    }
  });
}

Document snapLocators(const Document& document, const std::vector<std::string>& names, bool mirror) {
  const MeshesInWorld meshes = meshesAtRest(*document.scene);
  Document snapped = document;
  for (const std::string& name : names) {
    const rig::Locator* const locator = rig::findLocator(snapped.locators, name);
    if (locator != nullptr) {
      const Vec3 along = locator->orientation * Vec3(0.0, 1.0, 0.0);
      const Vec3 middle =
          skinning::middleOfMesh(meshes.positions, meshes.triangles, locator->position, along);
      if (middle != locator->position) {
        snapped = moveLocators(snapped, {name}, middle - locator->position, mirror);
      }
    }
  }
  return snapped;
}

} // namespace stretch::app
