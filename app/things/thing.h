#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "app/document.h"
#include "core/anim/frames.h"

namespace stretch::app {

// Everything that stands in the time of a clip beside its keys. What is told of each kind here (its subject,
// its span, the one visitor over all that it holds) is all that retiming, other rates, labels, memory, the
// checks and the door (place.h) know of it.

/// Things by kind: of a clip, of a recipe, of a request. A document has the same lists.
struct Things {
  std::vector<rig::Trail> trails;
  std::vector<rig::Adjustment> adjustments;
  rig::Holds holds;
  std::vector<WeightedLimb> weights; ///< Limbs with weight.
};

template <typename T, typename Of>
inline constexpr bool isThing = std::is_same_v<std::remove_const_t<T>, Of>;

/// Shows every list of things that a document, a recipe or `Things` holds to `visit`.
template <typename Holder, typename Visit>
void eachList(Holder& holder, const Visit& visit) {
  visit(holder.trails);
  visit(holder.adjustments);
  visit(holder.holds.pins);
  visit(holder.holds.grips);
  visit(holder.holds.props);
  visit(holder.weights);
}

/// The list of one kind of thing.
template <typename T, typename Holder>
[[nodiscard]] auto& listOf(Holder& holder) {
  if constexpr (isThing<T, rig::Trail>) {
    return holder.trails;
  } else if constexpr (isThing<T, rig::Adjustment>) {
    return holder.adjustments;
  } else if constexpr (isThing<T, rig::Pin>) {
    return holder.holds.pins;
  } else if constexpr (isThing<T, rig::Grip>) {
    return holder.holds.grips;
  } else if constexpr (isThing<T, rig::Prop>) {
    return holder.holds.props;
  } else {
    return holder.weights;
  }
}

/// "trail", "offsets", "pin", "grip", "prop", "weight": what a kind of thing is called in messages.
template <typename T>
[[nodiscard]] const char* kindTitle() {
  return isThing<T, rig::Trail>        ? "trail"
         : isThing<T, rig::Adjustment> ? "offsets"
         : isThing<T, rig::Pin>        ? "pin"
         : isThing<T, rig::Grip>       ? "grip"
         : isThing<T, rig::Prop>       ? "prop"
                                       : "weight";
}

/// The limb, controller, attribute or node that a thing acts on: no two things of one kind and subject share
/// a time of a clip.
template <typename T>
[[nodiscard]] const std::string& subjectOf(const T& thing) {
  if constexpr (isThing<T, rig::Adjustment>) {
    return thing.controller;
  } else if constexpr (isThing<T, rig::Grip>) {
    return thing.follower;
  } else if constexpr (isThing<T, rig::Prop>) {
    return thing.node;
  } else {
    return thing.limb;
  }
}

/// Shows all that a thing holds to a visitor, each part once:
/// - `range(first, last)`: the frames over which it acts, for a thing that has a range;
/// - `frame(frame)`: a single frame that it names;
/// - `before(frame, length)` and `after(frame, length)`: frames that it takes to come or to go there;
/// - `slope(frame, slope)`: a change for each frame, of a number or a vector, at that frame;
/// - `list(entries, needsOne, each)`: entries that stand at a frame each (in `.frame`, or being it); `each`
///   shows the parts of one, its frame last;
/// - `rest(values)`: a text or a list that has nothing to do with time.
/// Slopes and lengths are shown before the frame that they stand at.
template <typename T, typename Visitor>
void visitParts(T& thing, Visitor& visitor);

namespace detail {

template <typename Keys, typename Visitor>
void visitKeys(Keys& keys, bool needsOne, Visitor& visitor) {
  visitor.list(keys, needsOne, [&](auto& key) {
    visitor.slope(key.frame, key.moveSlope);
    visitor.slope(key.frame, key.turnSlope);
    visitor.slope(key.frame, key.valueSlope);
    visitor.frame(key.frame);
  });
}

template <typename Time, typename Visitor>
void visitTime(Time& time, Visitor& visitor) {
  visitor.before(time.rangeFrames.x, time.blendFrames.x);
  visitor.after(time.rangeFrames.y, time.blendFrames.y);
  visitor.range(time.rangeFrames.x, time.rangeFrames.y);
}

template <typename T, typename Visitor>
void visitTrail(T& trail, Visitor& visitor) {
  auto& settings = trail.settings;
  visitor.list(settings.spheres, false, [&](auto& sphere) {
    if (sphere.tangent) {
      visitor.slope(sphere.frame, *sphere.tangent);
    }
    visitor.frame(sphere.frame);
  });
  visitor.list(trail.controlFrames, false, [&](auto& frame) { visitor.frame(frame); });
  const auto visitWayBack = [&](auto& frames) {
    if (settings.pivot == rig::Pivot::start) {
      visitor.after(settings.endFrame, frames);
    } else {
      visitor.before(settings.startFrame, frames);
    }
  };
  visitWayBack(settings.lingerFrames);
  if (settings.releaseFrames) {
    visitWayBack(*settings.releaseFrames);
  }
  visitor.range(settings.startFrame, settings.endFrame);
  visitor.rest(trail.limb);
  visitor.rest(trail.name);
  visitor.rest(trail.groupName);
}

template <typename T, typename Visitor>
void visitProp(T& prop, Visitor& visitor) {
  for (auto& hand : prop.hands) {
    visitKeys(hand.keys, true, visitor);
    visitor.rest(hand.limb);
  }
  if (prop.boundFrame) {
    visitor.frame(*prop.boundFrame);
  }
  if (prop.time) {
    visitTime(*prop.time, visitor);
  }
  visitor.rest(prop.hands);
}

} // namespace detail

template <typename T, typename Visitor>
void visitParts(T& thing, Visitor& visitor) {
  if constexpr (isThing<T, rig::Trail>) {
    detail::visitTrail(thing, visitor);
    return;
  } else if constexpr (isThing<T, rig::Adjustment>) {
    detail::visitKeys(thing.keys, false, visitor);
    if (thing.rangeFrames) {
      visitor.range(thing.rangeFrames->x, thing.rangeFrames->y);
    }
  } else if constexpr (isThing<T, rig::Pin>) {
    visitor.frame(thing.atFrame);
    detail::visitTime(thing.time, visitor);
  } else if constexpr (isThing<T, rig::Grip>) {
    if (thing.relationFrame) {
      visitor.frame(*thing.relationFrame);
    }
    detail::visitTime(thing.time, visitor);
    visitor.rest(thing.leader);
  } else if constexpr (isThing<T, rig::Prop>) {
    detail::visitProp(thing, visitor);
  } else {
    if (thing.settings.rangeFrames) {
      visitor.range(thing.settings.rangeFrames->x, thing.settings.rangeFrames->y);
    }
    visitor.rest(thing.settings.moduli);
  }
  visitor.rest(subjectOf(thing));
}

/// A visitor that looks at nothing: those that look at some parts of a thing take the others from it.
struct IgnoredParts {
  template <typename Number>
  void range(Number& /*first*/, Number& /*last*/) {}
  template <typename Number>
  void frame(Number& /*frame*/) {}
  template <typename Number>
  void before(Number& /*frame*/, Number& /*length*/) {}
  template <typename Number>
  void after(Number& /*frame*/, Number& /*length*/) {}
  template <typename Number, typename Slope>
  void slope(Number& /*frame*/, Slope& /*slope*/) {}
  template <typename Values>
  void rest(Values& /*values*/) {}
};

/// The frame that an entry of a list stands at.
template <typename Entry>
[[nodiscard]] double frameOf(const Entry& entry) {
  if constexpr (std::is_same_v<Entry, double>) {
    return entry;
  } else {
    return entry.frame;
  }
}

namespace detail {

struct SpanOfParts : IgnoredParts {
  Vec2 frames{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  void range(const double& first, const double& last) { frames = {first, last}; }
  template <typename Entries, typename Each>
  void list(Entries& /*entries*/, bool /*needsOne*/, const Each& /*each*/) {}
};

struct NamedFrames : IgnoredParts {
  std::vector<double> frames;
  void range(const double& first, const double& last) { frames.insert(frames.end(), {first, last}); }
  void frame(const double& frame) { frames.push_back(frame); }
  template <typename Entries, typename Each>
  void list(Entries& entries, bool /*needsOne*/, const Each& each) {
    std::for_each(entries.begin(), entries.end(), each);
  }
};

} // namespace detail

/// First and last frame over which a thing acts, blends and release beside it left out. Without a range of
/// its own it acts on the whole clip: from minus infinity to infinity.
template <typename T>
[[nodiscard]] Vec2 spanOf(const T& thing) {
  detail::SpanOfParts span;
  visitParts(thing, span);
  return span.frames;
}

/// Every frame that a thing names: its range, keys, spheres, single frames.
template <typename T>
[[nodiscard]] std::vector<double> framesNamedBy(const T& thing) {
  detail::NamedFrames named;
  visitParts(thing, named);
  return named.frames;
}

/// Whether a thing acts at both ends of its range, so that the next one of its subject cannot begin there.
template <typename T>
inline constexpr bool holdsAtItsEnds = isThing<T, rig::Pin> || isThing<T, rig::Grip> || isThing<T, rig::Prop>;

/// Whether two things of one kind have a subject, a clip and a time in common. A limb has one weight in a
/// clip.
template <typename T>
[[nodiscard]] bool meets(const T& a, const T& b) {
  if (subjectOf(a) != subjectOf(b) || a.clip != b.clip) {
    return false;
  }
  const Vec2 first = spanOf(a);
  const Vec2 second = spanOf(b);
  return isThing<T, WeightedLimb> || (holdsAtItsEnds<T> ? first.x <= second.y && second.x <= first.y
                                                        : first.x < second.y && second.x < first.y);
}

/// Whether the document has a thing of this kind, subject and clip that names the frame: what was there when
/// a clip became shorter may stay past its end.
template <typename T>
[[nodiscard]] bool stoodAt(const Document& document, const T& thing, double frame) {
  return std::ranges::any_of(listOf<T>(document), [&](const T& old) {
    return old.clip == thing.clip && subjectOf(old) == subjectOf(thing) &&
           std::ranges::any_of(framesNamedBy(old), [&](double named) { return sameFrame(named, frame); });
  });
}

} // namespace stretch::app
