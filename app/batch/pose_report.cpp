#include "app/batch/pose_report.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/hold_report.h"
#include "app/evaluate/missed_places.h"
#include "app/evaluate/pops.h"
#include "app/evaluate/prop_flips.h"
#include "app/named.h"
#include "app/schema/schema_json.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "rig/adjust/apply_adjustments.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

using gltf::Json;

// Where the controller was asked to be at a frame and where it came to; nothing where it only turns.
std::optional<Json> placesAt(const Document& document, const rig::MotionState& motion,
                             const std::string& controller, double frame) {
  const Clip& clip = clipOf(document, motion.clip);
  FrameState state = rig::sampledFrame(*document.scene, clip, frame / clip.framesPerSecond);
  const std::vector<rig::AskedPlace> asked =
      rig::applyAdjustments(*document.scene, motion.adjustments, state);
  const auto own = std::ranges::find(asked, controller, &rig::AskedPlace::controller);
  if (own == asked.end()) {
    return std::nullopt;
  }
  const Vec3 reached = rig::controllerPlace(motion.adjustments, controller, state);
  return Json{{"frame", frame},
              {"asked", vectorToJson(own->place)},
              {"reached", vectorToJson(reached)},
              {"missed_by", glm::length(reached - own->place)}};
}

// How the ends were held, and which elbows and knees pop; what the document's own trails make of the body is
// in it.
void addMotionReports(const Document& document, int clip, Json& report) {
  const rig::MotionState motion = prepareMotion(document, clip);
  for (const LimbPop& pop : limbPops(document, motion)) {
    report["warnings"].push_back(popWarning(pop));
  }
  for (const PropFlip& flip : propFlips(document, motion)) {
    report["warnings"].push_back(flipWarning(flip));
  }
  for (const EndFlip& flip : endFlips(document, motion)) {
    report["warnings"].push_back(endFlipWarning(flip));
  }
  report["holds"] = Json::array();
  for (const HoldReport& hold : holdReports(document, motion)) {
    Json entry{{"hold", holdWord(hold.kind)},
               {"limb", hold.limb},
               {"reached", hold.framesFallShort.empty() && hold.framesOverridden.empty()},
               {"farthest", std::max(hold.farthest, hold.farthestOverridden)},
               {"falls_short_at", hold.framesFallShort}};
    if (!hold.framesOverridden.empty()) {
      entry["overridden_at"] = hold.framesOverridden;
    }
    if (hold.strength < 1.0) {
      entry["strength"] = hold.strength;
    }
    report["holds"].push_back(std::move(entry));
    for (const std::string& warning : {holdWarning(hold), overrideWarning(hold)}) {
      if (!warning.empty()) {
        report["warnings"].push_back(warning);
      }
    }
  }
}

// The joint that a controller turns; none where it is on no joint, or is an attribute.
NodeIndex turnedNode(const Document& document, const std::string& id) {
  const rig::ControllerList list = controllersOf(document);
  std::vector<rig::Controller> all = jointControllersOf(document);
  all.insert(all.end(), list.controllers.begin(), list.controllers.end());
  const auto own = std::ranges::find(all, id, &rig::Controller::id);
  return own == all.end() || !own->turns ? NodeIndex::none : own->node;
}

// Two rotations tell the angle between them but for its side and whole turns: where one of the angles that
// they may stand for is near what was asked for, it is that one; else the turn fell short, and is told as it
// is.
double likeAsked(double degrees, double askedDegrees) {
  constexpr double whole = 360.0;
  constexpr double near = 30.0;
  const double below = whole * std::floor(askedDegrees / whole);
  const double along = below + degrees;
  const double back = below + whole - degrees;
  const double nearest = std::abs(along - askedDegrees) <= std::abs(back - askedDegrees) ? along : back;
  return std::abs(nearest - askedDegrees) < near ? nearest : degrees;
}

// Degrees by which a key asks its controller to turn, and by which its joint turns more than without.
Json turnAt(const Document& document, const rig::MotionState& motion, const rig::Adjustment& adjustment,
            const rig::OffsetKey& key, NodeIndex node) {
  const Clip& clip = clipOf(document, motion.clip);
  rig::Adjustment unturned = adjustment;
  for (rig::OffsetKey& other : unturned.keys) {
    other.turn = other.turnSlope = Vec3(0.0);
  }
  rig::SolvedAdjustments without = motion.adjustments;
  without.curves[adjustment.controller] = {rig::OffsetCurve(unturned, 0.0, clip.framesPerSecond)};
  const auto rotationIn = [&](const rig::SolvedAdjustments& adjustments) {
    FrameState state = rig::sampledFrame(*document.scene, clip, key.frame / clip.framesPerSecond);
    rig::applyAdjustments(*document.scene, adjustments, state);
    return rotationOf(state.worlds[at(node)]);
  };
  constexpr double degrees = 180.0 / pi;
  const double asked = degrees * glm::length(key.turn);
  const double reached = degrees * angleBetween(rotationIn(without), rotationIn(motion.adjustments));
  return {{"asked_degrees", asked}, {"reached_degrees", likeAsked(reached, asked)}};
}

// What a key asks for and what it reached: the value of an attribute, or place and turn of a controller.
Json keyJson(const Document& document, const rig::MotionState& motion, const rig::Adjustment& adjustment,
             const rig::OffsetKey& key) {
  const rig::ControllerList list = controllersOf(document);
  if (const rig::Attribute* const attribute = list.attribute(adjustment.controller)) {
    return {{"frame", key.frame},
            {"asked", key.value},
            {"reached", std::clamp(key.value, attribute->minimum, attribute->maximum)}};
  }
  Json json =
      placesAt(document, motion, adjustment.controller, key.frame).value_or(Json{{"frame", key.frame}});
  const NodeIndex node = turnedNode(document, adjustment.controller);
  if (node.exists() && key.turn != Vec3(0.0)) {
    json["turn"] = turnAt(document, motion, adjustment, key, node);
  }
  return json;
}

void warnOfValue(const std::string& attribute, const Json& key, Json& warnings) {
  if (key["asked"] != key["reached"]) {
    warnings.push_back(fmt::format("{} is asked for {:g} at frame {:g}, and goes to {:g} at most", attribute,
                                   key["asked"].get<double>(), key["frame"].get<double>(),
                                   key["reached"].get<double>()));
  }
}

std::string placeText(const Json& place) {
  if (place.is_number()) {
    return fmt::format("{:g}", place.get<double>());
  }
  return fmt::format("{:.4f} {:.4f} {:.4f}", place[0].get<double>(), place[1].get<double>(),
                     place[2].get<double>());
}

void printHold(const Json& hold) {
  const double farthest = hold["farthest"].get<double>();
  std::string held = fmt::format("held, at most {:.4g} away", farthest);
  if (hold.contains("overridden_at")) {
    held = fmt::format("overridden, up to {:.4g} away", farthest);
  } else if (!hold["reached"].get<bool>()) {
    held = fmt::format("falls short by up to {:.4g}", farthest);
  } else if (hold.contains("strength")) {
    held = fmt::format("held by a strength of at most {:.4g}", hold["strength"].get<double>());
  }
  fmt::print("{} of {}: {}\n", hold["hold"].get<std::string>(), hold["limb"].get<std::string>(), held);
}

} // namespace

void addPoseReport(const Document& document, int clip, const std::vector<rig::Adjustment>& adjustments,
                   Json& report) {
  const rig::MotionState motion = prepareMotion(adjustedOnly(document), clip);
  report["controllers"] = Json::array();
  for (const rig::Adjustment& adjustment : adjustments) {
    Json keys = Json::array();
    for (const rig::OffsetKey& key : adjustment.keys) {
      keys.push_back(keyJson(document, motion, adjustment, key));
      const Json& told = keys.back();
      if (told.contains("asked") && !told.contains("missed_by")) {
        warnOfValue(adjustment.controller, told, report["warnings"]);
      }
    }
    report["controllers"].push_back({{"controller", adjustment.controller}, {"keys", std::move(keys)}});
  }
  for (const MissedPlace& missed : missedPlaces(document, motion)) {
    report["warnings"].push_back(missWarning(missed));
  }
  addMotionReports(document, clip, report);
}

void printPoseReport(const Json& report) {
  for (const Json& controller : report["controllers"]) {
    for (const Json& key : controller["keys"]) {
      std::string place =
          key.contains("asked")
              ? fmt::format("asked for {}, reached {}", placeText(key["asked"]), placeText(key["reached"]))
              : std::string(key.contains("turn") ? "" : "set");
      if (key.contains("turn")) {
        place += fmt::format("{}asked to turn {:.4g} degrees, turned {:.4g}", place.empty() ? "" : "; ",
                             key["turn"]["asked_degrees"].get<double>(),
                             key["turn"]["reached_degrees"].get<double>());
      }
      fmt::print("{}: frame {:g}: {}\n", controller["controller"].get<std::string>(),
                 key["frame"].get<double>(), place);
    }
  }
  for (const Json& hold : report["holds"]) {
    printHold(hold);
  }
}

} // namespace stretch::app
