#include "app/evaluate/clip_moments.h"

#include <algorithm>

#include <fmt/core.h>

#include "rig/motion/solve.h"

namespace stretch::app {

std::vector<rig::Moment> momentsOf(const Document& document, int clip) {
  return rig::momentsOf(*document.scene, clipOf(document, clip), document.body, document.chains);
}

Vec2 defaultRange(Document& document, int clip, const rig::Limb& limb) {
  const std::vector<rig::Moment> moments = momentsOf(document, clip);
  const auto own = std::ranges::find(moments, limb.id, &rig::Moment::limb);
  if (own != moments.end()) {
    return {own->startFrame, own->endFrame};
  }
  const Vec2 range = rig::defaultRange(*document.scene, clipOf(document, clip), limb);
  document.warnings.push_back(fmt::format(
      "{} makes no stroke in the clip {}: it is taken from frame {:g} to {:g}, where its end is farthest "
      "from where it began; give a range",
      limb.id, clipOf(document, clip).name, range.x, range.y));
  return range;
}

} // namespace stretch::app
