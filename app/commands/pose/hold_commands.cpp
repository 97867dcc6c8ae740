#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/commands/pose/hold.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/pose/prop_file_edits.h"
#include "app/evaluate/planted_feet.h"
#include "core/anim/frames.h"
#include "rig/controllers/controller.h"
#include "rig/motion/solved_holds.h"

namespace stretch::app {

namespace {

constexpr Vec2 usualBlend(3.0, 3.0);

// The arms and legs whose hands and feet are meant: of the selected controllers, else the selected limbs.
std::vector<std::string> heldTargets(const Session& session) {
  std::vector<std::string> limbs;
  const rig::ControllerList list = controllersOf(session.document());
  for (const std::string& id : session.view().selection.controllers()) {
    const rig::Controller* const controller = list.controller(id);
    if (controller != nullptr && std::ranges::find(limbs, controller->limb) == limbs.end()) {
      limbs.push_back(controller->limb);
    }
  }
  if (session.view().selection.controllers().empty()) {
    limbs = targetLimbs(session);
  }
  std::erase_if(limbs, [&](const std::string& id) {
    const rig::Limb* const limb = findLimb(session.document(), id);
    return limb == nullptr || !hasHandOrFoot(*limb);
  });
  return limbs;
}

bool hasHeldTargets(const Session& session) {
  return clipNeeded().holds(session) && !heldTargets(session).empty();
}

Need heldTargetNeeded() {
  return {hasHeldTargets, "select an arm or a leg, a hand or a foot"};
}

bool hasClipAndLegs(const Session& session) {
  return clipNeeded().holds(session) &&
         std::ranges::any_of(session.document().body.limbs,
                             [](const rig::Limb& limb) { return isLeg(limb); });
}

// The frames that the timeline shows, where the playhead is in them. Else those that were set by hand; where
// none were, and a selected trail elsewhere is shown, those around the playhead in which the limb has none.
rig::HoldTime shownTime(const Session& session, const std::string& limbId) {
  const double frame = session.view().frame;
  const int clip = session.view().clip;
  const Vec2 whole(0.0, lastFrame(session.document(), clip));
  const Vec2 shown = shownRange(session);
  const bool isShown = shown.x <= frame && frame <= shown.y;
  std::optional<Vec2> range = isShown ? std::optional(shown) : session.rangeByHand();
  range = range ? range : freeRange(session.document(), limbId, clip, whole, frame);
  return {range.value_or(shown), usualBlend};
}

// At the place itself, not at the frame's: what is posed at that frame later leaves the pin where it is.
rig::Pin pinHere(Session& session, const std::string& limbId) {
  const double frame = session.view().frame;
  rig::Pin pin;
  pin.limb = limbId;
  pin.clip = session.view().clip;
  pin.time = shownTime(session, limbId);
  pin.atFrame = frame;
  pin.place = rig::endPlace(*findLimb(session.document(), limbId), session.frameAt(frame));
  return pin;
}

Status pinTargets(Session& session) {
  rig::Holds wanted;
  for (const std::string& limb : heldTargets(session)) {
    wanted.pins.push_back(pinHere(session, limb));
  }
  return finish(session, placeHolds(session.document(), wanted), "Pin");
}

Status pinPlantedFeet(Session& session) {
  const int clip = session.view().clip;
  const Vec2 whole(0.0, lastFrame(session.document(), clip));
  const Vec2 frames = session.rangeByHand().value_or(whole); // a selected trail's says nothing of feet
  const rig::Holds found = plantedFeet(session.document(), clip, frames);
  if (found.empty()) {
    return Error{"no foot stands in this range", "", "set another working range, or pin the foot by hand"};
  }
  return finish(session, placeHolds(session.document(), found), "Pin planted feet");
}

// The limb on the other side of the body; empty where there is none.
std::string otherHand(const Document& document, const std::string& limbId) {
  const rig::Limb* const limb = findLimb(document, limbId);
  const bool isPaired = limb != nullptr && hasHandOrFoot(*limb);
  const rig::Limb* const other = isPaired ? limbAt(document.body.limbs, mirrored(*limb)) : nullptr;
  return other != nullptr ? other->id : std::string();
}

// The grip of this clip by which the first target leads or follows in the shown range; where the list has it.
std::optional<std::size_t> presentGrip(const Session& session) {
  const std::vector<std::string> targets = heldTargets(session);
  const std::vector<rig::Grip>& grips = session.document().holds.grips;
  for (std::size_t i = 0; !targets.empty() && i < grips.size(); ++i) {
    const Vec2 range = grips[i].time.rangeFrames;
    const Vec2 wanted = shownTime(session, targets.front()).rangeFrames;
    const bool isMeant = grips[i].leader == targets.front() || grips[i].follower == targets.front();
    if (isMeant && grips[i].clip == session.view().clip && range.x <= wanted.y && wanted.x <= range.y) {
      return i;
    }
  }
  return std::nullopt;
}

bool hasGrip(const Session& session) {
  return hasHeldTargets(session) && presentGrip(session).has_value();
}

std::string matchLabel(const Session& session) {
  const std::vector<std::string> targets = heldTargets(session);
  const rig::Limb* const limb = targets.empty() ? nullptr : findLimb(session.document(), targets.front());
  return limb != nullptr && isLeg(*limb) ? "Match the other foot" : "Match the other hand";
}

Status matchOtherHand(Session& session) {
  if (const std::optional<std::size_t> present = presentGrip(session)) {
    return finish(session, removeHold(session.document(), {rig::HoldKind::grip, *present}),
                  "Let the other hand go");
  }
  const std::string leader = heldTargets(session).front();
  const std::string follower = otherHand(session.document(), leader);
  if (follower.empty()) {
    return Error{"there is no limb on the other side to follow it", leader, "select a limb that has one"};
  }
  rig::Holds wanted;
  wanted.grips.push_back({follower, leader, session.view().clip, shownTime(session, leader), {}, 1.0});
  return finish(session, placeHolds(session.document(), wanted), "Match the other hand");
}

// The arms whose hands are meant: of the selected controllers, else the selected limbs.
std::vector<std::string> selectedArms(const Session& session) {
  std::vector<std::string> arms = heldTargets(session);
  std::erase_if(arms, [&](const std::string& id) { return isLeg(*findLimb(session.document(), id)); });
  return arms;
}

bool hasTargetArms(const Session& session) {
  return clipNeeded().holds(session) && !selectedArms(session).empty();
}

rig::Prop propIn(const std::string& node, const std::vector<std::string>& arms, int clip,
                 std::optional<double> boundFrame) {
  rig::Prop prop;
  prop.node = node;
  prop.clip = clip;
  prop.boundFrame = boundFrame;
  for (const std::string& arm : arms) {
    rig::OffsetKey held;
    held.value = 1.0;
    prop.hands.push_back({arm, {held}});
  }
  return prop;
}

// What the clip itself moves is in the hands there as it should be, at each frame; what lies still is taken
// as it stands at the playhead.
std::optional<double> bindingOf(const Session& session, NodeIndex node) {
  const bool isMoved =
      std::ranges::any_of(clipOf(session.document(), session.view().clip).tracks,
                          [&](const CopyOnWrite<Track>& track) { return track->node == node; });
  return isMoved ? std::nullopt : std::optional(session.view().frame);
}

// The thing with a mesh that stands nearest to the hands and that they can hold.
std::optional<rig::Prop> nearestProp(Session& session) {
  const Document& document = session.document();
  const std::vector<std::string> arms = selectedArms(session);
  const FrameState& frame = session.frameAt(session.view().frame);
  const Vec3 hand = endPosition(*findLimb(document, arms.front()), frame);
  std::optional<rig::Prop> nearest;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < document.scene->nodes.size(); ++i) {
    const double distance = glm::length(positionOf(frame.worlds[i]) - hand);
    if (document.scene->nodes[i].mesh < 0 || distance >= best) {
      continue;
    }
    rig::Prop prop =
        propIn(fmt::format("#{}", i), arms, session.view().clip, bindingOf(session, NodeIndex(i)));
    rig::Holds wanted;
    wanted.props.push_back(prop);
    if (placeHolds(document, wanted)) {
      best = distance;
      nearest = std::move(prop);
    }
  }
  return nearest;
}

Status holdProp(Session& session) {
  std::optional<rig::Prop> prop = nearestProp(session);
  if (!prop) {
    return Error{"the file has nothing that a hand can hold", "",
                 "open a file with a thing of its own: a mesh on a node that is no part of the body"};
  }
  rig::Holds wanted;
  wanted.props.push_back(std::move(*prop));
  return finish(session, placeHolds(session.document(), wanted), "Hold the prop");
}

// Of the last key at the frame or before it, else of the first one.
double firmnessAt(const rig::PropHand& hand, double frame) {
  double value = hand.keys.empty() ? 0.0 : hand.keys.front().value;
  for (const rig::OffsetKey& key : hand.keys) {
    value = key.frame <= frame + frameTolerance ? key.value : value;
  }
  return value;
}

bool isHolding(const rig::Prop& prop, const rig::PropHand& hand, const ViewState& view) {
  const Vec2 touched = prop.time ? rig::touchedFrames(*prop.time) : Vec2(view.frame);
  return prop.clip == view.clip && touched.x <= view.frame && view.frame <= touched.y &&
         firmnessAt(hand, view.frame) > 0.0;
}

// What the hands hold at the playhead; places in the list of props.
std::vector<std::size_t> propsInHand(const Session& session) {
  std::vector<std::size_t> held;
  const std::vector<std::string> arms = selectedArms(session);
  const std::vector<rig::Prop>& props = session.document().holds.props;
  for (std::size_t i = 0; i < props.size(); ++i) {
    const bool isIn = std::ranges::any_of(props[i].hands, [&](const rig::PropHand& hand) {
      return std::ranges::find(arms, hand.limb) != arms.end() && isHolding(props[i], hand, session.view());
    });
    if (isIn) {
      held.push_back(i);
    }
  }
  return held;
}

bool hasPropInHand(const Session& session) {
  return hasTargetArms(session) && !propsInHand(session).empty();
}

// As firm as it is up to the frame, let go over the blend after it; later keys go.
void letGoAt(double frame, rig::PropHand& hand) {
  const double before = firmnessAt(hand, frame);
  std::erase_if(hand.keys, [&](const rig::OffsetKey& key) { return key.frame > frame - frameTolerance; });
  for (const auto& [at, value] : {std::pair(frame, before), std::pair(frame + usualBlend.y, 0.0)}) {
    rig::OffsetKey key;
    key.frame = at;
    key.value = value;
    hand.keys.push_back(key);
  }
}

Status letGo(Session& session) {
  const std::vector<std::string> arms = selectedArms(session);
  Result<Document> changed = session.document();
  for (const std::size_t i : propsInHand(session)) {
    rig::Prop prop = session.document().holds.props[i];
    for (rig::PropHand& hand : prop.hands) {
      if (std::ranges::find(arms, hand.limb) != arms.end() && isHolding(prop, hand, session.view())) {
        letGoAt(session.view().frame, hand);
      }
    }
    rig::Holds value;
    value.props.push_back(std::move(prop));
    changed = changed ? changeHold(*changed, {rig::HoldKind::prop, i}, value) : changed;
  }
  return finish(session, std::move(changed), "Let the prop go");
}

// Whether a hold of this clip is about one of the limbs.
bool concerns(const rig::Pin& pin, int clip, const std::vector<std::string>& limbs) {
  return pin.clip == clip && std::ranges::find(limbs, pin.limb) != limbs.end();
}
bool concerns(const rig::Grip& grip, int clip, const std::vector<std::string>& limbs) {
  return grip.clip == clip && (std::ranges::find(limbs, grip.follower) != limbs.end() ||
                               std::ranges::find(limbs, grip.leader) != limbs.end());
}
bool concerns(const rig::Prop& prop, int clip, const std::vector<std::string>& limbs) {
  return prop.clip == clip && std::ranges::any_of(prop.hands, [&](const rig::PropHand& hand) {
           return std::ranges::find(limbs, hand.limb) != limbs.end();
         });
}

rig::Holds withoutTargets(const Session& session) {
  rig::Holds holds = session.document().holds;
  const std::vector<std::string> limbs = heldTargets(session);
  const int clip = session.view().clip;
  std::erase_if(holds.pins, [&](const rig::Pin& pin) { return concerns(pin, clip, limbs); });
  std::erase_if(holds.grips, [&](const rig::Grip& grip) { return concerns(grip, clip, limbs); });
  std::erase_if(holds.props, [&](const rig::Prop& prop) { return concerns(prop, clip, limbs); });
  return holds;
}

bool targetsAreHeld(const Session& session) {
  return hasHeldTargets(session) && withoutTargets(session) != session.document().holds;
}

Status removeHolds(Session& session) {
  Document changed = session.document();
  changed.holds = withoutTargets(session);
  return finish(session, withoutUnheldFiles(changed), "Take holds away");
}

} // namespace

std::vector<std::string> handsForProp(const Session& session) {
  std::vector<std::string> hands = selectedArms(session);
  for (const char* arm : {"right-arm", "left-arm"}) {
    if (hands.empty() && findLimb(session.document(), arm) != nullptr) {
      hands.emplace_back(arm);
    }
  }
  return hasClip(session.document(), session.view().clip) ? hands : std::vector<std::string>{};
}

std::vector<DocumentCommand> holdCommands() {
  return {
      entry(command::holdPin, "Pin",
            "Keeps the selected hands and feet at the place that they have at the playhead, over the range "
            "that "
            "the timeline shows, or around the playhead where it is outside of that.",
            {"Shift+P"}, heldTargetNeeded(), pinTargets),
      entry(command::holdPinFeet, "Pin planted feet",
            "Finds where each foot stands, in the working range or the whole clip, and pins it there.",
            {"Alt+P"}, {hasClipAndLegs, "open a character with legs and a clip"}, pinPlantedFeet),
      ticked(
          labelled(
              entry(
                  command::holdMatch, "Match the other hand",
                  "Lets the other hand or foot keep its relation to the selected one over the range that the "
                  "timeline shows, or lets it go again.",
                  {"M"}, heldTargetNeeded(), matchOtherHand),
              matchLabel),
          hasGrip),
      entry(command::holdProp, "Hold the nearest prop",
            "Puts the nearest thing into the selected hand, or into both: what the clip moves as it is there "
            "at "
            "each frame, what lies still as it stands at the playhead.",
            {"Shift+H"}, {hasTargetArms, "select an arm or a hand"}, holdProp),
      entry(command::holdLetGo, "Let the prop go",
            "From the playhead on the selected hand lets go what it holds; another hand keeps it.", {"Alt+H"},
            {hasPropInHand, "select a hand that holds something"}, letGo),
      entry(command::holdRemove, "Take holds away",
            "Takes pins, grips and props of the selected limbs out of this clip.", {},
            {targetsAreHeld, "select a limb that is held"}, removeHolds),
  };
}

} // namespace stretch::app
