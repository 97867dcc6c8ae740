#include "app/commands/table/past_end.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "app/commands/table/selection.h"
#include "app/edits/keys/key_row.h"
#include "app/things/thing.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

template <typename T>
std::string titleOf(const Document& document, const T& thing) {
  if constexpr (isThing<T, rig::Trail>) {
    return trailTitle(document, thing);
  } else if constexpr (isThing<T, rig::Adjustment>) {
    return controllerTitle(document, thing.controller);
  } else if constexpr (isThing<T, rig::Prop>) {
    return thing.node;
  } else {
    return limbTitle(document, subjectOf(thing));
  }
}

// The range, or the frames that are named where the whole clip is meant; nothing where none is.
template <typename T>
std::optional<Vec2> framesOf(const T& thing) {
  const Vec2 span = spanOf(thing);
  const std::vector<double> named = framesNamedBy(thing);
  if (std::isfinite(span.y)) {
    return span;
  }
  const auto [first, last] = std::ranges::minmax_element(named);
  return named.empty() ? std::nullopt : std::optional(Vec2(*first, *last));
}

} // namespace

std::vector<std::string> standingPastEnd(const Document& document, int clip) {
  const Clip& shown = clipOf(document, clip);
  const double last = endInFrames(shown);
  std::vector<std::string> past;
  eachList(document, [&](const auto& list) {
    for (const auto& thing : list) {
      const std::optional<Vec2> frames = framesOf(thing);
      if (thing.clip == clip && frames && frames->y > last + frameTolerance) {
        past.push_back(fmt::format("{} of {} ({:g} to {:g})",
                                   kindTitle<std::remove_cvref_t<decltype(thing)>>(),
                                   titleOf(document, thing), frames->x, frames->y));
      }
    }
  });
  return past;
}

} // namespace stretch::app
