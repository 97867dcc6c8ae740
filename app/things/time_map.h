#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "app/things/thing.h"
#include "core/anim/frames.h"

namespace stretch::app {

/// Places of frames when a stretch of time takes another length, or all of it another count.
struct TimeMap {
  double first = -std::numeric_limits<double>::infinity(); ///< The stretch; nothing before it changes.
  double last = std::numeric_limits<double>::infinity();
  double factor = 1.0;    ///< Above 0: the frames of the stretch are so much farther apart.
  double stays = 0.0;     ///< The frame of the stretch that stays where it is.
  bool movesAfter = true; ///< Later frames move along; else each stays, but for what the stretch reaches.
  double rounding = 1e-6; ///< A frame that comes so near to a whole one is on it.

  /// Answers the new end of the stretch.
  [[nodiscard]] double newLast() const { return stays + (last - stays) * factor; }
  [[nodiscard]] bool isInside(double frame) const;
  [[nodiscard]] double rounded(double frame) const;
  /// Ascends with the frame. What stays after the stretch and is reached by it comes to its end.
  [[nodiscard]] double operator()(double frame) const;
  /// So many frames from this one on, or back from it where `length` is below 0, as many as they become.
  [[nodiscard]] double lengthFrom(double frame, double length) const;
  /// Whether a key gives way to the stretch: it stays after it and is reached by it.
  [[nodiscard]] bool givesWay(double frame) const;
  /// Whether what begins at this frame is left where it is, as long as nothing is brought upon it.
  [[nodiscard]] bool leaves(double frame) const;
};

/// The thing with all that it holds where the map puts it. Keys that give way or fall together with the one
/// before are gone; a prop's hand keeps one.
template <typename T>
[[nodiscard]] T mapped(T thing, const TimeMap& map);

/// A reference whose images and sound begin where the map puts their starts.
[[nodiscard]] inline Reference mapped(Reference reference, const TimeMap& map) {
  reference.images.startFrame = map(reference.images.startFrame);
  reference.sound.startFrame = map(reference.sound.startFrame);
  return reference;
}

/// The rest of a thing from a frame on; nothing where it ends by then, or has no key there.
template <typename T>
[[nodiscard]] std::optional<T> cutBefore(T thing, double frame);

/// A list of things with those of a clip that `isMeant` says in the map's time. What stays after the stretch
/// and is met by what the stretch brings begins where that ends; nothing is left of what ends before.
template <typename T, typename Meant>
[[nodiscard]] std::vector<T> mappedList(const std::vector<T>& list, const TimeMap& map, const Meant& isMeant);

namespace detail {

struct MapParts : IgnoredParts {
  explicit MapParts(const TimeMap& given) : map(given) {}

  void frame(double& frame) const { frame = map(frame); }
  void range(double& first, double& last) const {
    first = map(first);
    last = map(last);
  }
  void before(const double& frame, double& length) const { length = map.lengthFrom(frame, -length); }
  void after(const double& frame, double& length) const { length = map.lengthFrom(frame, length); }
  template <typename Slope>
  void slope(const double& frame, Slope& slope) const {
    slope /= map.isInside(frame) ? map.factor : 1.0;
  }
  template <typename Entries, typename Each>
  void list(Entries& entries, bool needsOne, const Each& each) const {
    const Entries all = entries;
    std::erase_if(entries, [&](const auto& entry) { return map.givesWay(frameOf(entry)); });
    std::for_each(entries.begin(), entries.end(), each);
    const auto joined = std::unique(entries.begin(), entries.end(), [](const auto& one, const auto& next) {
      return sameFrame(frameOf(one), frameOf(next));
    });
    entries.erase(joined, entries.end());
    if (needsOne && entries.empty() && !all.empty()) {
      entries.push_back(all.back());
    }
  }

  TimeMap map;
};

struct CutParts : IgnoredParts {
  explicit CutParts(double given) : from(given) {}

  void range(double& first, const double& /*last*/) const { first = std::max(first, from); }
  template <typename Entries, typename Each>
  void list(Entries& entries, bool needsOne, const Each& /*each*/) const {
    std::erase_if(entries, [&](const auto& entry) { return !needsOne && frameOf(entry) < from; });
  }

  double from;
};

/// Whether a thing acts on any frame and has what it needs for it.
template <typename T>
[[nodiscard]] bool isLeft(const T& thing) {
  const Vec2 span = spanOf(thing);
  if constexpr (isThing<T, rig::Adjustment>) {
    return span.x < span.y && !thing.keys.empty();
  }
  return span.x < span.y || (holdsAtItsEnds<T> && span.x == span.y);
}

/// The first frame at which a thing of this kind can begin after another one.
template <typename T>
[[nodiscard]] double firstAfter(const T& thing) {
  const double end = spanOf(thing).y;
  return holdsAtItsEnds<T> ? wholeFrameAtMost(end) + 1.0 : end;
}

} // namespace detail

template <typename T>
T mapped(T thing, const TimeMap& map) {
  detail::MapParts parts(map);
  visitParts(thing, parts);
  return thing;
}

template <typename T>
std::optional<T> cutBefore(T thing, double frame) {
  detail::CutParts parts(frame);
  visitParts(thing, parts);
  return detail::isLeft(thing) ? std::optional<T>(std::move(thing)) : std::nullopt;
}

template <typename T, typename Meant>
std::vector<T> mappedList(const std::vector<T>& list, const TimeMap& map, const Meant& isMeant) {
  std::vector<T> brought;
  for (const T& thing : list) {
    if (isMeant(thing) && !map.leaves(spanOf(thing).x)) {
      brought.push_back(mapped(thing, map));
    }
  }
  std::vector<T> all;
  auto next = brought.cbegin();
  for (const T& thing : list) {
    const bool isBrought = isMeant(thing) && !map.leaves(spanOf(thing).x);
    std::optional<T> left = isBrought ? *next++ : thing;
    for (const T& other : brought) {
      if (left && isMeant(thing) && !isBrought && meets(other, *left)) {
        left = cutBefore(*left, detail::firstAfter(other));
      }
    }
    if (left && (!isMeant(thing) || detail::isLeft(*left))) {
      all.push_back(std::move(*left));
    }
  }
  return all;
}

} // namespace stretch::app
