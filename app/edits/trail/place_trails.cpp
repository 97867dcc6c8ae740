#include "app/edits/trail/place_trails.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "app/edits/trail/group_edits.h"
#include "app/schema/trail_schema.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

std::string framesText(const rig::TrailSettings& settings) {
  return fmt::format("{:g} to {:g}", settings.startFrame, settings.endFrame);
}

bool overlapInTime(const rig::Trail& trail, double startFrame, double endFrame) {
  return trail.settings.startFrame < endFrame && startFrame < trail.settings.endFrame;
}

bool hasFiniteShapes(const rig::TrailSettings& settings) {
  const auto isFinite = [](const Vec3& v) { return std::isfinite(v.x + v.y + v.z); };
  const bool spheres =
      std::all_of(settings.spheres.begin(), settings.spheres.end(), [&](const rig::SphereOffset& sphere) {
        return std::isfinite(sphere.frame) && isFinite(sphere.offset) &&
               (!sphere.tangent || isFinite(*sphere.tangent));
      });
  return spheres && std::isfinite(settings.startFrame) && std::isfinite(settings.endFrame) &&
         (!settings.stopAt || (isFinite(settings.stopAt->point) && isFinite(settings.stopAt->normal)));
}

/// Values and range by themselves, without the trails around.
Status checkAlone(const rig::Trail& trail) {
  if (!hasFiniteShapes(trail.settings)) {
    return Error{"a setting of the trail is not a number", trail.limb, "give a number"};
  }
  if (Status values = checkSettings(trailSchema(), trail.settings); !values) {
    return values;
  }
  if (trail.settings.endFrame <= trail.settings.startFrame) {
    return Error{"the range " + framesText(trail.settings) + " has no length", trail.limb,
                 "set its end after its start"};
  }
  return Success{};
}

Status checkInsideClip(const Document& document, const rig::Trail& trail) {
  const Clip& clip = clipOf(document, trail.clip);
  const double last = std::round(clip.endSeconds * clip.framesPerSecond);
  if (trail.settings.startFrame >= last || trail.settings.endFrame <= 0.0) {
    return Error{fmt::format("the range {} lies outside the clip, which has the frames 0 to {:g}",
                             framesText(trail.settings), last),
                 trail.limb, "give frames of the clip"};
  }
  return Success{};
}

Status checkNew(const Document& document, const rig::Trail& trail, Entry entry) {
  if (Status known = checkLimbAndClip(document, trail.limb, trail.clip); !known) {
    return known;
  }
  if (Status alone = checkAlone(trail); !alone) {
    return alone;
  }
  return entry == Entry::file ? Status(Success{}) : checkInsideClip(document, trail);
}

} // namespace

const rig::Trail* overlappingTrail(const Document& document, const std::string& limbId, int clip,
                                   double startFrame, double endFrame, int exceptTrailId) {
  const auto found =
      std::find_if(document.trails.begin(), document.trails.end(), [&](const rig::Trail& trail) {
        return trail.id != exceptTrailId && trail.limb == limbId && trail.clip == clip &&
               overlapInTime(trail, startFrame, endFrame);
      });
  return found == document.trails.end() ? nullptr : &*found;
}

Status checkLimbAndClip(const Document& document, const std::string& limbId, int clip) {
  if (findLimb(document, limbId) == nullptr) {
    return Error{"the character has no such limb", limbId,
                 "pick a limb that was found, or any chain by its joints"};
  }
  if (document.clips == nullptr || clip < 0 || clip >= static_cast<int>(document.clips->size())) {
    return Error{"the file has no such clip", fmt::format("clip {}", clip), "open a file with an animation"};
  }
  return Success{};
}

Status checkTrailSettings(const Document& document, const rig::Trail& trail) {
  if (Status alone = checkAlone(trail); !alone) {
    return alone;
  }
  const rig::Trail* const other = overlappingTrail(
      document, trail.limb, trail.clip, trail.settings.startFrame, trail.settings.endFrame, trail.id);
  if (other != nullptr) {
    return Error{"two trails of one limb may not overlap in time: there is one from " +
                     framesText(other->settings),
                 trail.limb, "change the range, or edit that trail"};
  }
  return Success{};
}

Result<PlacedTrails> placeTrails(const Document& document, std::span<const rig::Trail> wanted, Entry entry) {
  PlacedTrails placed{document, {}};
  std::vector<rig::Trail>& trails = placed.document.trails;
  const auto isNew = [&](int id) {
    return std::find(placed.trailIds.begin(), placed.trailIds.end(), id) != placed.trailIds.end();
  };
  for (rig::Trail trail : wanted) {
    if (const Status fits = checkNew(document, trail, entry); !fits) {
      return fits.error();
    }
    if (entry == Entry::request) {
      std::erase_if(trails, [&](const rig::Trail& old) {
        return !isNew(old.id) && old.limb == trail.limb && old.clip == trail.clip &&
               overlapInTime(old, trail.settings.startFrame, trail.settings.endFrame);
      });
    }
    trail.id = trail.id > 0 ? trail.id : placed.document.nextTrailId;
    if (const Status alone = checkTrailSettings(placed.document, trail); !alone) {
      return alone.error();
    }
    placed.document.nextTrailId = std::max(placed.document.nextTrailId, trail.id + 1);
    placed.trailIds.push_back(trail.id);
    trails.push_back(std::move(trail));
  }
  return placed;
}

} // namespace stretch::app
