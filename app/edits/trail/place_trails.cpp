#include "app/edits/trail/place_trails.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/things/checks.h"

namespace stretch::app {

const rig::Trail* overlappingTrail(const Document& document, const std::string& limbId, int clip,
                                   double startFrame, double endFrame, int exceptTrailId) {
  const auto found =
      std::find_if(document.trails.begin(), document.trails.end(), [&](const rig::Trail& trail) {
        return trail.id != exceptTrailId && trail.limb == limbId && trail.clip == clip &&
               trail.settings.startFrame < endFrame && startFrame < trail.settings.endFrame;
      });
  return found == document.trails.end() ? nullptr : &*found;
}

Status checkTrailSettings(const Document& document, const rig::Trail& trail) {
  if (Status alone = checkValues(trail); !alone) {
    return alone;
  }
  const rig::Trail* const other = overlappingTrail(
      document, trail.limb, trail.clip, trail.settings.startFrame, trail.settings.endFrame, trail.id);
  if (other != nullptr) {
    return Error{"two trails of one limb may not overlap in time: there is one from " +
                     fmt::format("{:g} to {:g}", other->settings.startFrame, other->settings.endFrame),
                 trail.limb, "change the range, or edit that trail"};
  }
  return Success{};
}

Result<PlacedTrails> placeTrails(const Document& document, std::span<const rig::Trail> wanted, Entry entry) {
  return placeOf<rig::Trail>(document, {wanted.begin(), wanted.end()}, entry);
}

} // namespace stretch::app
