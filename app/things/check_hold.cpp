#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/things/checks.h"
#include "core/anim/frames.h"
#include "rig/motion/solve_holds.h"

namespace stretch::app {

namespace {

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <typename Hold>
bool isPastEnd(const Ground& ground, const Hold& hold, double frame) {
  return frame > lastFrameFor(ground, hold.clip) + frameTolerance && !stoodAt(ground.before, hold, frame);
}

template <typename Hold>
Status checkFrame(const Ground& ground, const Hold& hold, double frame) {
  if (!(frame >= -frameTolerance && std::isfinite(frame)) || isPastEnd(ground, hold, frame)) {
    return outsideClip(fmt::format("frame {:g}", frame), lastFrameFor(ground, hold.clip), subjectOf(hold));
  }
  return Success{};
}

template <typename Hold>
Status checkTime(const Ground& ground, const Hold& hold, const rig::HoldTime& time) {
  const std::string& who = subjectOf(hold);
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
  if (isPastEnd(ground, hold, range.x) || isPastEnd(ground, hold, range.y) || range.y < -frameTolerance) {
    return outsideClip(fmt::format("its range {:g} to {:g}", range.x, range.y),
                       lastFrameFor(ground, hold.clip), who);
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

Status checkHoldingLimb(const Document& document, const std::string& id) {
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
    if (Status limb = checkHoldingLimb(document, hand.limb); !limb) {
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
      if (i > 0 && key.frame - hand.keys[i - 1].frame < frameTolerance) {
        return Error{fmt::format("two keys stand at frame {:g}", key.frame), prop.node + "." + hand.limb,
                     "leave one of them out"};
      }
    }
  }
  return Success{};
}

Status checkBinding(const Ground& ground, const rig::Prop& prop) {
  constexpr double mostTurns = 100.0;
  constexpr double farthest = 1000.0; // heights of the character
  const bool isUsable = isFinite(prop.move) && isFinite(prop.turn) &&
                        glm::length(prop.move) <= farthest * ground.document.body.height &&
                        glm::length(prop.turn) <= mostTurns * 2.0 * pi;
  if (!isUsable) {
    return Error{"the offset at its binding is out of proportion", prop.node,
                 "move by at most a thousand heights of the character"};
  }
  return prop.boundFrame ? checkFrame(ground, prop, *prop.boundFrame) : Status(Success{});
}

bool actTogether(const rig::Grip& a, const rig::Grip& b) {
  const Vec2 first = rig::touchedFrames(a.time);
  const Vec2 second = rig::touchedFrames(b.time);
  return a.clip == b.clip && first.x <= second.y && second.x <= first.y;
}

} // namespace

Status checkAlone(const Ground& ground, const rig::Pin& pin) {
  const Document& document = ground.document;
  if (Status clip = checkClip(document, pin.clip); !clip) {
    return clip;
  }
  return firstError({checkHoldingLimb(document, pin.limb), checkTime(ground, pin, pin.time),
                     checkFrame(ground, pin, pin.atFrame), checkStretch(pin.stretch, pin.limb),
                     pin.place ? checkPlace(document, *pin.place, pin.limb) : Status(Success{})});
}

Status checkAlone(const Ground& ground, const rig::Grip& grip) {
  const Document& document = ground.document;
  if (Status clip = checkClip(document, grip.clip); !clip) {
    return clip;
  }
  if (grip.follower == grip.leader) {
    return Error{"it follows itself", grip.follower, "name another limb as its leader"};
  }
  return firstError({checkHoldingLimb(document, grip.follower), checkHoldingLimb(document, grip.leader),
                     checkTime(ground, grip, grip.time), checkStretch(grip.stretch, grip.follower),
                     grip.relationFrame ? checkFrame(ground, grip, *grip.relationFrame) : Status(Success{})});
}

Status checkAlone(const Ground& ground, const rig::Prop& prop) {
  const Document& document = ground.document;
  if (Status clip = checkClip(document, prop.clip); !clip) {
    return clip;
  }
  return firstError({checkNode(document, prop), checkHands(document, prop), checkBinding(ground, prop),
                     checkStretch(prop.stretch, prop.node),
                     prop.time ? checkTime(ground, prop, *prop.time) : Status(Success{})});
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

} // namespace stretch::app
