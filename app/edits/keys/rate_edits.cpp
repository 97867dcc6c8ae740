#include "app/edits/keys/rate_edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/things/time_map.h"
#include "core/base/check.h"

namespace stretch::app {

namespace {

constexpr double sameRate = 1e-6; ///< Frames per second.

void setRate(Document& document, int clip, double framesPerSecond) {
  std::vector<Clip> clips = *document.clips;
  clips[static_cast<std::size_t>(clip)].framesPerSecond = framesPerSecond;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
}

} // namespace

double ownRate(const Document& document, int clip) {
  const auto chosen =
      std::ranges::find_if(document.rates, [&](const ClipRate& rate) { return rate.clip == clip; });
  return chosen == document.rates.end() ? clipOf(document, clip).framesPerSecond : chosen->own;
}

Document workAtRate(const Document& document, int clip, double framesPerSecond) {
  check(framesPerSecond > 0.0, "a rate is above 0");
  const double own = ownRate(document, clip);
  const double factor = framesPerSecond / clipOf(document, clip).framesPerSecond;
  Document changed = document;
  setRate(changed, clip, framesPerSecond);
  std::erase_if(changed.rates, [&](const ClipRate& rate) { return rate.clip == clip; });
  if (std::abs(framesPerSecond - own) > sameRate) {
    changed.rates.push_back({clip, framesPerSecond, own});
  }
  eachList(changed, [&](auto& list) {
    for (auto& thing : list) {
      thing = thing.clip == clip ? mapped(std::move(thing), TimeMap{.factor = factor}) : std::move(thing);
    }
  });
  for (Reference& reference : changed.references) {
    reference = reference.clip == clip ? mapped(reference, TimeMap{.factor = factor}) : reference;
  }
  return changed;
}

void setFramesPerSecond(Document& document, double framesPerSecond) {
  for (int clip = 0; clip < static_cast<int>(document.clips->size()); ++clip) {
    document = workAtRate(document, clip, framesPerSecond);
  }
}

void countInChosenRates(Document& document) {
  for (ClipRate& rate : document.rates) {
    rate.own = clipOf(document, rate.clip).framesPerSecond;
    setRate(document, rate.clip, rate.framesPerSecond);
  }
}

} // namespace stretch::app
