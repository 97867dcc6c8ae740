#include "rig/rekey/keyed_part.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "rig/limb.h"
#include "rig/motion/release_length.h"

namespace stretch::rig {

namespace {

Window windowOf(const MotionState& motion, double start, double end) {
  Window window{asKeyTime(std::max(start, 0.0)), asKeyTime(std::min(end, motion.endSeconds)), false, false};
  window.endSeconds = std::max(window.endSeconds, window.startSeconds);
  return window;
}

// Of the two keys at a border where the motion jumps the inner one is not beyond it, so that whoever asks
// for the border's very time, in whatever precision, is inside.
void keepBordersInside(double start, double end, Window& window) {
  if (window.jumpsBefore) {
    window.startSeconds = std::min(window.startSeconds, keyTimeAtMost(start));
  }
  if (window.jumpsAfter) {
    window.endSeconds = std::max(window.endSeconds, keyTimeAtLeast(end));
  }
}

void addWrapped(const MotionState& motion, const SolvedTrail& trail, std::vector<Window>& windows) {
  const double turn = motion.endSeconds - motion.startSeconds;
  if (motion.loops && trail.windowEndSeconds > motion.endSeconds) {
    windows.push_back(windowOf(motion, motion.startSeconds, trail.windowEndSeconds - turn));
  }
  if (motion.loops && trail.windowStartSeconds < firstSeconds(motion, trail)) {
    windows.push_back(windowOf(motion, trail.windowStartSeconds + turn, motion.endSeconds));
  }
}

double boneLength(const Limb& limb) {
  return limb.restLength / static_cast<double>(limb.joints.size());
}

Window windowOf(const MotionState& motion, const LimbWeight& weight) {
  Window window = windowOf(motion, weight.startSeconds, weight.endSeconds);
  window.jumpsBefore = weight.fadeInSeconds <= 0.0 && window.startSeconds > sameKey;
  window.jumpsAfter = weight.fadeOutSeconds <= 0.0 && window.endSeconds < motion.endSeconds - sameKey;
  keepBordersInside(weight.startSeconds, weight.endSeconds, window);
  return window;
}

// Windows that touch become one, and keep what they do at its ends.
void addWindow(const Window& window, std::vector<Window>& windows) {
  if (windows.empty() || window.startSeconds > windows.back().endSeconds) {
    windows.push_back(window);
    return;
  }
  extend(windows.back(), window);
}

void joinWindows(std::vector<Window>& windows) {
  std::sort(windows.begin(), windows.end(),
            [](const Window& a, const Window& b) { return a.startSeconds < b.startSeconds; });
  std::vector<Window> joined;
  for (const Window& window : windows) {
    addWindow(window, joined);
  }
  windows = std::move(joined);
}

// A leg moves the hips, and with them the other leg: each is keyed wherever one of them is.
KeyedPart weightPart(const MotionState& motion, std::size_t place) {
  const SolvedWeight& solved = motion.weights[place];
  KeyedPart part{touchedNodes(solved.limb, solved.topology), boneLength(solved.limb), {}, {}};
  for (std::size_t i = 0; i < motion.weights.size(); ++i) {
    const SolvedWeight& other = motion.weights[i];
    const bool counts = i == place || (isLeg(other.limb) && isLeg(solved.limb));
    if (counts && !other.weight.samples.empty()) {
      part.windows.push_back(windowOf(motion, other.weight));
    }
  }
  if (isLeg(solved.limb) && motion.hips.exists()) {
    part.nodes.push_back(motion.hips);
  }
  joinWindows(part.windows);
  return part;
}

void addKeys(const OffsetCurve& curve, KeyedPart& part) {
  for (const double jump : curve.jumpSeconds()) {
    part.jumps.push_back({keyTimeAtMost(jump), besideJump(jump, -1.0)});
  }
  for (const double key : curve.keySeconds()) {
    part.keySeconds.push_back(asKeyTime(key));
  }
}

void addBorderJumps(const Window& window, KeyedPart& part) {
  if (window.jumpsBefore) {
    part.jumps.push_back({window.startSeconds, besideJump(window.startSeconds, -1.0)});
  }
  if (window.jumpsAfter) {
    part.jumps.push_back({window.endSeconds, besideJump(window.endSeconds, 1.0)});
  }
}

void addTrail(const MotionState& motion, const SolvedTrail& trail, KeyedPart& part) {
  const double first = firstSeconds(motion, trail);
  Window own = windowOf(motion, std::max(trail.windowStartSeconds, first), trail.windowEndSeconds);
  const bool noRelease = !(trail.release.seconds() > 0.0);
  const bool forwards = trail.settings.pivot == Pivot::start;
  const bool jumpsAtPivot = noRelease && pullsPivot(trail, motion.framesPerSecond);
  own.jumpsAfter = (forwards ? noRelease : jumpsAtPivot) && own.endSeconds < motion.endSeconds - sameKey;
  own.jumpsBefore = (forwards ? jumpsAtPivot : noRelease) && own.startSeconds > first + sameKey;
  keepBordersInside(trail.windowStartSeconds, trail.windowEndSeconds, own);
  addBorderJumps(own, part);
  part.windows.push_back(own);
  addWrapped(motion, trail, part.windows);
}

KeyedPart trailPart(const MotionState& motion, std::size_t place) {
  const SolvedTrail& trail = motion.trails[place];
  KeyedPart part{touchedNodes(trail.limb, trail.topology),
                 boneLength(trail.limb),
                 {},
                 {asKeyTime(trail.startSeconds), asKeyTime(trail.endSeconds)}};
  addTrail(motion, trail, part);
  // A limb that stays in the world works against whatever carries it, wherever that moves.
  for (std::size_t i = 0; trail.settings.stayInWorld && i < place; ++i) {
    addTrail(motion, motion.trails[i], part);
  }
  joinWindows(part.windows);
  return part;
}

KeyedPart adjustmentPart(const MotionState& motion, const AdjustedPart& adjusted) {
  KeyedPart part{adjusted.nodes, adjusted.boneLength, {}, {}};
  for (const auto& [id, curves] : motion.adjustments.curves) {
    const bool concerns = std::find(adjusted.ids.begin(), adjusted.ids.end(), id) != adjusted.ids.end();
    for (const OffsetCurve& curve : concerns ? curves : std::vector<OffsetCurve>{}) {
      if (curve.startSeconds() > motion.endSeconds || curve.endSeconds() < 0.0) {
        continue;
      }
      Window window = windowOf(motion, curve.startSeconds(), curve.endSeconds());
      window.jumpsBefore = curve.jumpsAtStart() && window.startSeconds > sameKey;
      window.jumpsAfter = curve.jumpsAtEnd() && window.endSeconds < motion.endSeconds - sameKey;
      keepBordersInside(curve.startSeconds(), curve.endSeconds(), window);
      addKeys(curve, part);
      addBorderJumps(window, part);
      part.windows.push_back(window);
    }
  }
  joinWindows(part.windows);
  return part;
}

// Where a hold acts: it comes and goes by itself, or jumps where it has no blend.
void addHoldAt(const MotionState& motion, const HoldSpan& span, double shift, KeyedPart& part) {
  const double start = span.startSeconds + shift;
  const double end = span.endSeconds + shift;
  if (start - span.blendInSeconds > motion.endSeconds || end + span.blendOutSeconds < 0.0) {
    return;
  }
  Window window = windowOf(motion, start - span.blendInSeconds, end + span.blendOutSeconds);
  window.jumpsBefore = span.blendInSeconds <= 0.0 && window.startSeconds > sameKey;
  window.jumpsAfter = span.blendOutSeconds <= 0.0 && window.endSeconds < motion.endSeconds - sameKey;
  keepBordersInside(start, end, window);
  for (const double border : {start, end}) {
    if (border > 0.0 && border < motion.endSeconds) {
      part.keySeconds.push_back(asKeyTime(border));
    }
  }
  addBorderJumps(window, part);
  part.windows.push_back(window);
}

void addHold(const MotionState& motion, const HoldSpan& span, KeyedPart& part) {
  for (int turn = -1; turn <= 1; ++turn) {
    if (span.actsInTurn(turn)) {
      addHoldAt(motion, span, turn * span.turnSeconds, part);
    }
  }
}

void addProp(const MotionState& motion, const SolvedProp& prop, KeyedPart& part) {
  addHold(motion, prop.span, part);
  for (const SolvedPropHand& hand : prop.hands) {
    addKeys(hand.firmness, part);
  }
}

KeyedPart heldLimbPart(const MotionState& motion, std::size_t limb) {
  const ReachingLimb& reaching = motion.holds.limbs[limb];
  KeyedPart part{touchedNodes(reaching.limb, reaching.topology), boneLength(reaching.limb), {}, {}};
  for (const std::optional<SolvedPin>& pin : motion.holds.pins) {
    if (pin && pin->limb == limb) {
      addHold(motion, pin->span, part);
    }
  }
  for (const std::optional<SolvedGrip>& grip : motion.holds.grips) {
    if (grip && grip->limb == limb) {
      addHold(motion, grip->span, part);
    }
  }
  for (const std::optional<SolvedProp>& prop : motion.holds.props) {
    if (prop && std::ranges::find(prop->hands, limb, &SolvedPropHand::limb) != prop->hands.end()) {
      addProp(motion, *prop, part);
    }
  }
  joinWindows(part.windows);
  return part;
}

KeyedPart propPart(const MotionState& motion, const SolvedProp& prop) {
  KeyedPart part{{prop.node}, 0.0, {}, {}};
  addProp(motion, prop, part);
  joinWindows(part.windows);
  return part;
}

void addHoldParts(const MotionState& motion, std::vector<KeyedPart>& parts) {
  std::vector<KeyedPart> held;
  for (std::size_t i = 0; i < motion.holds.limbs.size(); ++i) {
    held.push_back(heldLimbPart(motion, i));
  }
  for (const std::optional<SolvedProp>& prop : motion.holds.props) {
    if (prop) {
      held.push_back(propPart(motion, *prop));
    }
  }
  std::ranges::copy_if(held, std::back_inserter(parts),
                       [](const KeyedPart& part) { return !part.windows.empty(); });
}

} // namespace

void extend(Window& window, const Window& by) {
  window.jumpsBefore = window.jumpsBefore || (by.startSeconds == window.startSeconds && by.jumpsBefore);
  if (by.endSeconds >= window.endSeconds) {
    window.jumpsAfter = by.jumpsAfter || (by.endSeconds == window.endSeconds && window.jumpsAfter);
    window.endSeconds = by.endSeconds;
  }
}

double besideJump(double borderSeconds, double direction) {
  constexpr double aside = 4e-7;
  return asKeyTime(borderSeconds + direction * aside * std::max(1.0, std::abs(borderSeconds)));
}

std::vector<KeyedPart> keyedParts(const MotionState& motion) {
  std::vector<KeyedPart> parts;
  for (const AdjustedPart& adjusted : motion.adjustments.parts) {
    if (KeyedPart part = adjustmentPart(motion, adjusted); !part.windows.empty()) {
      parts.push_back(std::move(part));
    }
  }
  for (std::size_t i = 0; i < motion.trails.size(); ++i) {
    if (motion.trails[i].active) {
      parts.push_back(trailPart(motion, i));
    }
  }
  addHoldParts(motion, parts);
  for (std::size_t i = 0; i < motion.weights.size(); ++i) {
    parts.push_back(weightPart(motion, i));
  }
  return parts;
}

} // namespace stretch::rig
