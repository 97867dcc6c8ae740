#include "app/auto/held_things.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/edits/pose/hold_edits.h"
#include "app/evaluate/evaluate.h"
#include "core/math/transform.h"

namespace stretch::app {

namespace {

constexpr double mostSlip = 0.06;    // of an arm: so far a thing in a hand gets from it from frame to frame,
constexpr double mostDrift = 0.2;    // and since it was taken; it may turn in the hand
constexpr double farthestHold = 1.2; // of an arm: from the hand to the middle of a thing that it holds
constexpr double leastSwing = 0.3;   // of an arm: a hand that rests beside a thing holds nothing
constexpr double shortestHold = 3.0; // frames

/// How far a thing is from a hand, and where the hand is.
struct InHand {
  double distance = 0.0;
  Vec3 hand{0.0};
};

std::vector<InHand> seenFromHand(const std::vector<FrameState>& frames, const rig::Limb& arm,
                                 NodeIndex thing) {
  std::vector<InHand> seen;
  for (const FrameState& frame : frames) {
    const Vec3 hand = positionOf(frame.worlds[at(arm.endNode)]);
    seen.push_back({glm::length(positionOf(frame.worlds[at(thing)]) - hand), hand});
  }
  return seen;
}

/// Frames over which the hand holds the thing.
std::vector<Vec2> holdsIn(const std::vector<InHand>& seen, double arm) {
  std::vector<Vec2> holds;
  for (std::size_t first = 0; first < seen.size(); ++first) {
    std::size_t last = first;
    double way = 0.0;
    const auto differsBy = [&](std::size_t a, std::size_t b) {
      return std::abs(seen[a].distance - seen[b].distance);
    };
    while (seen[first].distance < farthestHold * arm && last + 1 < seen.size() &&
           differsBy(last, last + 1) < mostSlip * arm && differsBy(first, last + 1) < mostDrift * arm) {
      ++last;
      way = std::max(way, glm::length(seen[last].hand - seen[first].hand));
    }
    if (static_cast<double>(last - first) >= shortestHold && way > leastSwing * arm) {
      const auto begin = static_cast<double>(first);
      if (!holds.empty() && begin <= holds.back().y + rig::firmnessFadeFrames) {
        holds.back().y = static_cast<double>(last); // it slipped, and was not let go of
      } else {
        holds.emplace_back(begin, static_cast<double>(last));
      }
      first = last;
    }
  }
  return holds;
}

rig::OffsetKey firmness(double frame, double value) {
  rig::OffsetKey key;
  key.frame = frame;
  key.value = value;
  return key;
}

/// Firm while the hand holds the thing, and let go of in between and at the end.
rig::PropHand handOf(const std::string& arm, const std::vector<Vec2>& holds, double lastFrame) {
  rig::PropHand hand{arm, {}};
  if (holds.front().x > 0.0) {
    hand.keys.push_back(firmness(0.0, 0.0));
  }
  for (const Vec2& hold : holds) {
    hand.keys.push_back(firmness(hold.x, 1.0));
    if (hold.y < lastFrame) {
      hand.keys.push_back(firmness(hold.y, 1.0));
      hand.keys.push_back(firmness(std::min(hold.y + rig::firmnessFadeFrames, lastFrame), 0.0));
    }
  }
  return hand;
}

// Whether a node keeps its place on its parent, however that turns.
bool keepsPlace(const std::vector<FrameState>& frames, NodeIndex node, NodeIndex parent, double height) {
  constexpr double still = 1e-3; // of the height
  const auto placeIn = [&](const FrameState& frame) {
    return Vec3(glm::inverse(frame.worlds[at(parent)]) * Vec4(positionOf(frame.worlds[at(node)]), 1.0));
  };
  const double unit = glm::length(Vec3(frames.front().worlds[at(parent)][0]));
  return std::ranges::all_of(frames, [&](const FrameState& frame) {
    return glm::distance(placeIn(frame), placeIn(frames.front())) * unit < still * height;
  });
}

// Whether the body wears the thing, as a helmet or a cape: it hangs firmly on a joint that no arm carries. A
// hand that stays as far from it for a while does not hold it.
bool isWorn(const ClipGround& ground, const std::vector<FrameState>& frames, NodeIndex thing) {
  const Scene& scene = *ground.document.scene;
  const auto isOfBody = [&](NodeIndex node) {
    return node == ground.document.body.hips || std::ranges::any_of(ground.limbs, [&](const auto& limb) {
             return node == limb.endNode || std::ranges::find(limb.joints, node) != limb.joints.end();
           });
  };
  NodeIndex node = thing;
  while (!isOfBody(node)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    if (!parent.exists() || !keepsPlace(frames, node, parent, ground.document.body.height)) {
      return false;
    }
    node = parent;
  }
  return std::ranges::none_of(ground.limbs, [&](const rig::Limb& limb) {
    return isArm(limb) && isAncestorOrSelf(scene, limb.joints.front(), node);
  });
}

bool isHeldIn(const std::vector<Vec2>& holds, const rig::TrailSettings& settings) {
  return std::ranges::any_of(holds, [&](const Vec2& hold) {
    return hold.x <= settings.startFrame + 1.0 && hold.y >= settings.endFrame - 1.0;
  });
}

std::optional<rig::Prop> propOf(const ClipGround& ground, const AutoPlan& plan,
                                const std::vector<FrameState>& frames, NodeIndex thing) {
  rig::Prop prop;
  prop.node = fmt::format("#{}", at(thing));
  prop.clip = ground.clip;
  prop.boundFrame = std::nullopt;
  bool isSwung = false;
  for (const rig::Limb& arm : ground.limbs) {
    if (!isArm(arm) || !arm.endNode.exists()) {
      continue;
    }
    const std::vector<Vec2> holds = holdsIn(seenFromHand(frames, arm, thing), arm.restLength);
    if (!holds.empty()) {
      prop.hands.push_back(handOf(arm.id, holds, ground.lastFrame));
      isSwung = isSwung || std::ranges::any_of(plan.trails, [&](const PlannedTrail& planned) {
                  return planned.trail.limb == arm.id && isHeldIn(holds, planned.trail.settings);
                });
    }
  }
  rig::Holds wanted;
  wanted.props.push_back(prop);
  return isSwung && placeHolds(ground.document, wanted) ? std::optional(prop) : std::nullopt;
}

} // namespace

std::vector<rig::Prop> propsFor(const ClipGround& ground, const AutoPlan& plan) {
  const Scene& scene = *ground.document.scene;
  std::vector<rig::Prop> props;
  std::vector<FrameState> frames; // of a character that holds nothing none are needed
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].mesh < 0 || scene.nodes[i].skin >= 0) {
      continue;
    }
    for (auto frame = static_cast<double>(frames.size()); frame <= ground.lastFrame; frame += 1.0) {
      frames.push_back(evaluateOriginal(ground.document, ground.clip, frame / ground.framesPerSecond));
    }
    if (isWorn(ground, frames, NodeIndex(i))) {
      continue;
    }
    if (std::optional<rig::Prop> prop = propOf(ground, plan, frames, NodeIndex(i))) {
      props.push_back(std::move(*prop));
    }
  }
  return props;
}

bool isHeldBy(const rig::Prop& prop, const std::string& arm) {
  return std::ranges::find(prop.hands, arm, &rig::PropHand::limb) != prop.hands.end();
}

bool isHeldBy(const rig::Prop& prop, const std::string& arm, double frame) {
  constexpr double half = 0.5;
  const auto hand = std::ranges::find(prop.hands, arm, &rig::PropHand::limb);
  if (hand == prop.hands.end()) {
    return false;
  }
  const auto next =
      std::ranges::find_if(hand->keys, [&](const rig::OffsetKey& key) { return key.frame > frame; });
  if (next == hand->keys.begin()) {
    return false;
  }
  const auto key = std::prev(next);
  const bool fades = next != hand->keys.end() && next->value < half && key->frame < frame;
  return key->value > half && !fades;
}

bool areOnProp(const AutoPlan& plan, const std::string& arm, const std::string& other, double frame) {
  return std::ranges::any_of(plan.holds.props, [&](const rig::Prop& prop) {
    return isHeldBy(prop, arm, frame) && isHeldBy(prop, other, frame);
  });
}

} // namespace stretch::app
