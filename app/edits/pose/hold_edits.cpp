#include "app/edits/pose/hold_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "rig/motion/solve_holds.h"

namespace stretch::app {

namespace {

constexpr double holdRounding = 1e-3;

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// A file's work may stand on a clip that was cut since.
double lastFrameOf(const Document& document, int clip, Entry entry) {
  if (entry == Entry::file) {
    return std::numeric_limits<double>::infinity();
  }
  const Clip& shown = clipOf(document, clip);
  return std::max(0.0, std::ceil(shown.endSeconds * shown.framesPerSecond - holdRounding));
}

Status checkClip(const Document& document, int clip) {
  if (document.clips == nullptr || clip < 0 || at(clip) >= document.clips->size()) {
    return Error{"the file has no such clip", fmt::format("clip {}", clip), "open a file with an animation"};
  }
  return Success{};
}

Status checkFrame(const Document& document, int clip, double frame, const std::string& who, Entry entry) {
  const double last = lastFrameOf(document, clip, entry);
  if (!(frame >= -holdRounding && frame <= last + holdRounding && std::isfinite(frame))) {
    return Error{fmt::format("frame {:g} lies outside the clip, which has the frames 0 to {:g}", frame, last),
                 who, "give a frame of the clip"};
  }
  return Success{};
}

Status checkTime(const Document& document, int clip, const rig::HoldTime& time, const std::string& who,
                 Entry entry) {
  constexpr double longest = 1e6; // frames
  const Vec2& range = time.rangeFrames;
  const Vec2& blend = time.blendFrames;
  if (!std::isfinite(range.x + range.y + blend.x + blend.y)) {
    return Error{"a number of its range is not finite", who, "give frames"};
  }
  if (range.x > range.y) {
    return Error{"its range ends before it starts", who, "give the first frame first"};
  }
  if (blend.x < 0.0 || blend.y < 0.0 || std::max(blend.x, blend.y) > longest) {
    return Error{"its blend is not a number of frames", who, "give two numbers of frames, 0 or more"};
  }
  const double last = lastFrameOf(document, clip, entry);
  if (range.x > last + holdRounding || range.y < -holdRounding) {
    return Error{fmt::format("its range lies outside the clip, which has the frames 0 to {:g}", last), who,
                 "give frames of the clip"};
  }
  return Success{};
}

// "give one of: front-left-leg, ...": what can be held.
std::string limbsToHold(const Document& document) {
  std::string names;
  for (const rig::Limb& limb : document.body.limbs) {
    if (hasHandOrFoot(limb)) {
      names += (names.empty() ? "" : ", ") + limb.id;
    }
  }
  return names.empty() ? "it has no arm and no leg" : "give one of: " + names;
}

Status checkLimb(const Document& document, const std::string& id) {
  const rig::Limb* const limb = findLimb(document, id);
  if (limb == nullptr || !hasHandOrFoot(*limb)) {
    return Error{"the character has no hand or foot of a limb '" + id + "'", id, limbsToHold(document)};
  }
  return Success{};
}

Status checkStretch(double stretch, const std::string& who) {
  return stretch >= 0.0 && stretch <= 1.0 ? Status(Success{})
                                          : Error{"its stretch is out of range", who, "give 0 to 1"};
}

Status checkPlace(const Document& document, const rig::HeldPlace& place, const std::string& who) {
  constexpr double farthest = 1000.0; // heights of the character
  const Quat& turn = place.orientation;
  const double length = glm::length(Vec4(turn.x, turn.y, turn.z, turn.w));
  if (!isFinite(place.position) || !std::isfinite(length) || !(length > 0.5 && length < 2.0)) {
    return Error{"its place is not finite, or its orientation no unit quaternion", who, "give numbers"};
  }
  if (glm::length(place.position) > farthest * document.body.height) {
    return Error{"its place is out of proportion", who,
                 "give one within a thousand heights of the character from the origin"};
  }
  return Success{};
}

Status firstError(std::initializer_list<Status> all) {
  const Status* const found = std::ranges::find_if(all, [](const Status& one) { return !one.ok(); });
  return found == all.end() ? Status(Success{}) : *found;
}

Status checkHold(const Document& document, const rig::Pin& pin, Entry entry) {
  if (Status clip = checkClip(document, pin.clip); !clip) {
    return clip;
  }
  return firstError({checkLimb(document, pin.limb), checkTime(document, pin.clip, pin.time, pin.limb, entry),
                     checkFrame(document, pin.clip, pin.atFrame, pin.limb, entry),
                     checkStretch(pin.stretch, pin.limb),
                     pin.place ? checkPlace(document, *pin.place, pin.limb) : Status(Success{})});
}

Status checkHold(const Document& document, const rig::Grip& grip, Entry entry) {
  if (Status clip = checkClip(document, grip.clip); !clip) {
    return clip;
  }
  if (grip.follower == grip.leader) {
    return Error{"it follows itself", grip.follower, "name another limb as its leader"};
  }
  return firstError({checkLimb(document, grip.follower), checkLimb(document, grip.leader),
                     checkTime(document, grip.clip, grip.time, grip.follower, entry),
                     checkStretch(grip.stretch, grip.follower),
                     grip.relationFrame
                         ? checkFrame(document, grip.clip, *grip.relationFrame, grip.follower, entry)
                         : Status(Success{})});
}

bool isLimbJoint(const Document& document, NodeIndex node) {
  return std::ranges::any_of(document.body.limbs, [&](const rig::Limb& limb) {
    return limb.endNode == node || std::ranges::find(limb.joints, node) != limb.joints.end();
  });
}

Status checkNode(const Document& document, const rig::Prop& prop) {
  const Scene& scene = *document.scene;
  const NodeIndex node = rig::propNode(scene, prop.node);
  if (!node.exists()) {
    return Error{"the file has no such node", prop.node, "give a node by its name or '#index'"};
  }
  if (scene.nodes[at(node)].skin >= 0) {
    return Error{"holds a skinned mesh, which its joints move and not the node", prop.node,
                 "give a node of a thing that a hand can hold"};
  }
  const bool carriesBody =
      isLimbJoint(document, node) || node == document.body.hips ||
      std::ranges::any_of(prop.hands, [&](const rig::PropHand& hand) {
        const rig::Limb* const limb = findLimb(document, hand.limb);
        return limb != nullptr &&
               isAncestorOrSelf(scene, node, limb->endNode.exists() ? limb->endNode : limb->joints.back());
      });
  if (carriesBody) {
    return Error{"is part of the body, or carries the hand that is to hold it", prop.node,
                 "give a node of a thing that a hand can hold"};
  }
  return Success{};
}

Status checkHands(const Document& document, const rig::Prop& prop) {
  if (prop.hands.empty()) {
    return Error{"no hand holds it", prop.node, R"(give "hands", such as {"right-arm": [...]})"};
  }
  for (const rig::PropHand& hand : prop.hands) {
    if (Status limb = checkLimb(document, hand.limb); !limb) {
      return limb;
    }
    if (std::ranges::count(prop.hands, hand.limb, &rig::PropHand::limb) > 1 || hand.keys.empty()) {
      return Error{"the hand is named twice, or has no keys", prop.node + "." + hand.limb,
                   R"(give each hand one list, such as [{"frame": 0, "value": 1}])"};
    }
    for (std::size_t i = 0; i < hand.keys.size(); ++i) {
      const rig::OffsetKey& key = hand.keys[i];
      if (!(key.value >= 0.0 && key.value <= 1.0) || !std::isfinite(key.frame + key.valueSlope)) {
        return Error{fmt::format("the value at frame {:g} is out of range", key.frame),
                     prop.node + "." + hand.limb, "give 0 to 1"};
      }
      if (i > 0 && key.frame - hand.keys[i - 1].frame < holdRounding) {
        return Error{fmt::format("two keys stand at frame {:g}", key.frame), prop.node + "." + hand.limb,
                     "leave one of them out"};
      }
    }
  }
  return Success{};
}

Status checkBinding(const Document& document, const rig::Prop& prop, Entry entry) {
  constexpr double mostTurns = 100.0;
  constexpr double farthest = 1000.0; // heights of the character
  const bool isUsable = isFinite(prop.move) && isFinite(prop.turn) &&
                        glm::length(prop.move) <= farthest * document.body.height &&
                        glm::length(prop.turn) <= mostTurns * 2.0 * pi;
  if (!isUsable) {
    return Error{"the offset at its binding is out of proportion", prop.node,
                 "move by at most a thousand heights of the character"};
  }
  return prop.boundFrame ? checkFrame(document, prop.clip, *prop.boundFrame, prop.node, entry)
                         : Status(Success{});
}

Status checkHold(const Document& document, const rig::Prop& prop, Entry entry) {
  if (Status clip = checkClip(document, prop.clip); !clip) {
    return clip;
  }
  return firstError(
      {checkNode(document, prop), checkHands(document, prop), checkBinding(document, prop, entry),
       checkStretch(prop.stretch, prop.node),
       prop.time ? checkTime(document, prop.clip, *prop.time, prop.node, entry) : Status(Success{})});
}

Vec2 rangeOf(const rig::Pin& pin) {
  return pin.time.rangeFrames;
}
Vec2 rangeOf(const rig::Grip& grip) {
  return grip.time.rangeFrames;
}
Vec2 rangeOf(const rig::Prop& prop) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  return prop.time ? prop.time->rangeFrames : Vec2(-endless, endless);
}

const std::string& heldBy(const rig::Pin& pin) {
  return pin.limb;
}
const std::string& heldBy(const rig::Grip& grip) {
  return grip.follower;
}
const std::string& heldBy(const rig::Prop& prop) {
  return prop.node;
}

template <typename Hold>
bool holdTogether(const Hold& a, const Hold& b) {
  const Vec2 first = rangeOf(a);
  const Vec2 second = rangeOf(b);
  return heldBy(a) == heldBy(b) && a.clip == b.clip && first.x <= second.y && second.x <= first.y;
}

template <typename Hold>
Status placeAll(const Document& document, const std::vector<Hold>& wanted, Entry entry,
                std::vector<Hold>& list) {
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (Status fits = checkHold(document, wanted[i], entry); !fits) {
      return fits;
    }
    for (std::size_t other = 0; other < i; ++other) {
      if (holdTogether(wanted[other], wanted[i])) {
        return Error{"is held twice at the same time", heldBy(wanted[i]), "give each a range of its own"};
      }
    }
  }
  for (const Hold& hold : wanted) {
    std::erase_if(list, [&](const Hold& old) { return holdTogether(old, hold); });
  }
  list.insert(list.end(), wanted.begin(), wanted.end());
  return Success{};
}

bool actTogether(const rig::Grip& a, const rig::Grip& b) {
  const Vec2 first = rig::touchedFrames(a.time);
  const Vec2 second = rig::touchedFrames(b.time);
  return a.clip == b.clip && first.x <= second.y && second.x <= first.y;
}

// From leader to leader among the grips that act at a time with this one.
Status checkCircles(const rig::Holds& holds) {
  for (const rig::Grip& grip : holds.grips) {
    std::vector<std::string> led{grip.follower};
    for (std::size_t i = 0; i < led.size(); ++i) {
      for (const rig::Grip& other : holds.grips) {
        const bool follows = other.leader == led[i] && actTogether(grip, other);
        if (follows && other.follower == grip.follower) {
          return Error{"grips lead in a circle: " + grip.follower + " follows " + grip.leader +
                           ", which follows it",
                       grip.follower, "take one of them away, or give them other ranges"};
        }
        if (follows && std::ranges::find(led, other.follower) == led.end()) {
          led.push_back(other.follower);
        }
      }
    }
  }
  return Success{};
}

template <typename Hold>
std::vector<Hold> heldInClip(const std::vector<Hold>& all, int clip) {
  std::vector<Hold> some;
  std::ranges::copy_if(all, std::back_inserter(some), [&](const Hold& hold) { return hold.clip == clip; });
  return some;
}

template <typename Hold>
void removeAt(std::vector<Hold>& list, std::size_t index) {
  if (index < list.size()) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
  }
}

// The hold that was added last goes to the place of the one that it stands for.
template <typename Hold>
void bringTo(std::vector<Hold>& list, std::size_t index) {
  if (index < list.size()) {
    std::rotate(list.begin() + static_cast<std::ptrdiff_t>(index), list.end() - 1, list.end());
  }
}

} // namespace

Result<Document> placeHolds(const Document& document, const rig::Holds& wanted, Entry entry) {
  Document changed = document;
  for (const Status& placed : {placeAll(document, wanted.pins, entry, changed.holds.pins),
                               placeAll(document, wanted.grips, entry, changed.holds.grips),
                               placeAll(document, wanted.props, entry, changed.holds.props)}) {
    if (!placed) {
      return placed.error();
    }
  }
  const Status circles = checkCircles(changed.holds);
  return circles ? Result<Document>(std::move(changed)) : Result<Document>(circles.error());
}

Document removeHold(const Document& document, const HoldPlace& place) {
  Document changed = document;
  switch (place.kind) {
  case rig::HoldKind::pin:
    removeAt(changed.holds.pins, place.index);
    break;
  case rig::HoldKind::grip:
    removeAt(changed.holds.grips, place.index);
    break;
  case rig::HoldKind::prop:
    removeAt(changed.holds.props, place.index);
    break;
  }
  return changed;
}

Result<Document> changeHold(const Document& document, const HoldPlace& place, const rig::Holds& value) {
  Result<Document> changed = placeHolds(removeHold(document, place), value, Entry::hand);
  if (changed) {
    bringTo(changed->holds.pins, place.kind == rig::HoldKind::pin ? place.index : changed->holds.pins.size());
    bringTo(changed->holds.grips,
            place.kind == rig::HoldKind::grip ? place.index : changed->holds.grips.size());
    bringTo(changed->holds.props,
            place.kind == rig::HoldKind::prop ? place.index : changed->holds.props.size());
  }
  return changed;
}

rig::Holds holdsOfClip(const rig::Holds& holds, int clip) {
  return {heldInClip(holds.pins, clip), heldInClip(holds.grips, clip), heldInClip(holds.props, clip)};
}

} // namespace stretch::app
