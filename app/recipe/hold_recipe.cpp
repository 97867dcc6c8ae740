#include "app/recipe/recipe_parts.h"

#include <glm/geometric.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/schema/hold_json.h"
#include "core/math/rotation.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/solved_holds.h"

namespace stretch::app {

namespace {

using gltf::Json;

double lengthOfLimb(const Document& document, const std::string& id) {
  const rig::Limb* const limb = findLimb(document, id);
  return limb != nullptr ? limb->restLength : 1.0;
}

// Where the adjusted clip has the limb at the pin's frame, a pin stands there in another clip, and of another
// body, too.
rig::Pin followingItsFrame(const Document& document, const rig::MotionState& motion, rig::Pin pin) {
  const rig::Limb* const limb = findLimb(document, pin.limb);
  if (!pin.place || limb == nullptr) {
    return pin;
  }
  constexpr double unseen = 1e-6; // of the height
  const FrameState adjusted = rig::adjustedFrame(*document.scene, clipOf(document, pin.clip), motion,
                                                 pin.atFrame / motion.framesPerSecond);
  const rig::HeldPlace there = rig::endPlace(*limb, adjusted);
  if (glm::length(pin.place->position - there.position) <= unseen * document.body.height &&
      angleBetween(pin.place->orientation, there.orientation) <= unseen) {
    pin.place.reset();
  }
  return pin;
}

// A prop that names a file has its node once the file is added (addPropFiles).
Result<rig::Prop> propOfRecipe(Json entry, const AdjustmentUnits& units) {
  if (!entry.is_object() || !entry.contains("file")) {
    return propFromJson(entry, units, {});
  }
  if (!entry["file"].is_string() || entry.contains("node")) {
    return Error{"is not a path, or a node is given as well", "file", "give the path of a file, or a node"};
  }
  if (!entry.contains("bound_at")) {
    entry["bound_at"] = 0;
  }
  if (entry["bound_at"] == "source") {
    return Error{"a thing of a file of its own does not move in the clip", "bound_at", "give a frame"};
  }
  entry["node"] = entry["file"];
  return propFromJson(entry, units, {"file", "place"});
}

} // namespace

double lengthOfBody(const Document& document) {
  const rig::ControllerList list = controllersOf(document);
  const rig::Controller* const body = list.controller("body");
  return body != nullptr ? body->length : 1.0;
}

Result<rig::Holds> holdsFromRecipe(const Json& recipe, const RecipeGround& ground) {
  rig::Holds holds;
  Status read = readList(recipe, "pins", ground, holds.pins, [&](const Json& entry) {
    const std::string limb = entry.is_object() && entry.contains("limb") && entry["limb"].is_string()
                                 ? entry["limb"].get<std::string>()
                                 : std::string();
    return pinFromJson(entry, unitsOf(lengthOfLimb(ground.document, limb), ground.inMetres), {});
  });
  if (read) {
    read = readList(recipe, "grips", ground, holds.grips,
                    [&](const Json& entry) { return gripFromJson(entry, {}); });
  }
  if (read) {
    const AdjustmentUnits units = unitsOf(lengthOfBody(ground.document), ground.inMetres);
    read = readList(recipe, "props", ground, holds.props,
                    [&](const Json& entry) { return propOfRecipe(entry, units); });
  }
  if (!read) {
    return read.error();
  }
  const auto onClip = [&](auto& list) {
    for (auto& hold : list) {
      hold.clip = ground.clip;
    }
  };
  onClip(holds.pins);
  onClip(holds.grips);
  onClip(holds.props);
  return holds;
}

void addHoldsToRecipe(const Document& document, int clip, Json& recipe) {
  const rig::Holds holds = holdsOfClip(document.holds, clip);
  const rig::MotionState motion = holds.pins.empty() ? rig::MotionState() : prepareMotion(document, clip);
  for (const rig::Pin& pin : holds.pins) {
    recipe["pins"].push_back(pinToJson(followingItsFrame(document, motion, pin),
                                       unitsOf(lengthOfLimb(document, pin.limb), false)));
  }
  for (const rig::Grip& grip : holds.grips) {
    recipe["grips"].push_back(gripToJson(grip));
  }
  for (const rig::Prop& prop : holds.props) {
    Json entry = propToJson(prop, unitsOf(lengthOfBody(document), false));
    recipe["props"].push_back(withFileOfProp(document, prop, std::move(entry)));
  }
}

} // namespace stretch::app
