#include "app/edits/trail/trail_edits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/edits/trail/place_trails.h"
#include "app/standing_floor.h"
#include "app/things/time_map.h"

namespace stretch::app {

namespace {

template <typename Change>
Result<Document> changeTrail(const Document& document, int trailId, Change&& change) {
  Document changed = document;
  rig::Trail* trail = findTrail(changed, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  change(*trail);
  return changed;
}

/// Spheres that were set by hand go along when the whole range moves.
void moveSetSpheres(rig::Trail& trail, const rig::TrailSettings& settings) {
  const double shift = settings.startFrame - trail.settings.startFrame;
  if (std::abs(settings.endFrame - trail.settings.endFrame - shift) < 1e-9) {
    for (double& frame : trail.controlFrames) {
      frame += shift;
    }
  }
}

/// `settings` moved onto another trail's range.
rig::TrailSettings movedToRange(rig::TrailSettings settings, double startFrame, double endFrame) {
  const double shift = startFrame - settings.startFrame;
  std::vector<rig::SphereOffset> kept;
  for (rig::SphereOffset sphere : settings.spheres) {
    sphere.frame += shift;
    if (sphere.frame >= startFrame && sphere.frame <= endFrame) {
      kept.push_back(sphere);
    }
  }
  settings.spheres = std::move(kept);
  settings.startFrame = startFrame;
  settings.endFrame = endFrame;
  return settings;
}

/// A leg that stops at the ground under its tip does so where the tip is put, too.
void keepStopOnGround(const Document& document, const rig::Trail& before, rig::TrailSettings& settings) {
  const rig::Limb* const limb = findLimb(document, before.limb);
  const double from = rig::tipFrameOf(before.settings);
  const double to = rig::tipFrameOf(settings);
  if (limb == nullptr || !isLeg(*limb) || !settings.stopAt || settings.stopAt != before.settings.stopAt ||
      from == to || !std::isfinite(to)) {
    return;
  }
  if (settings.stopAt == floorForLeg(document, before.clip, *limb, from)) {
    settings.stopAt = floorForLeg(document, before.clip, *limb, to);
  }
}

} // namespace

Error missingTrail(int trailId) {
  return Error{"there is no such trail", "trail " + std::to_string(trailId), "select a trail"};
}

int freeColour(const Document& document, int clip) {
  std::array<int, dealtColours> uses{};
  for (const rig::Trail& trail : document.trails) {
    uses[static_cast<std::size_t>(trail.colour % dealtColours)] += trail.clip == clip ? 1 : 0;
  }
  const int turn = (document.nextTrailId - 1) % dealtColours;
  int best = turn;
  for (int i = 1; i < dealtColours; ++i) {
    const int next = (turn + i) % dealtColours;
    best = uses[static_cast<std::size_t>(next)] < uses[static_cast<std::size_t>(best)] ? next : best;
  }
  return best;
}

Result<CreatedTrail> createTrail(const Document& document, const NewTrail& wanted) {
  rig::Trail trail;
  trail.limb = wanted.limb;
  trail.clip = wanted.clip;
  trail.settings = wanted.settings;
  trail.exaggerated = wanted.exaggerated || wanted.connected;
  trail.connected = wanted.connected;
  trail.colour = freeColour(document, wanted.clip);
  Result<PlacedTrails> placed = placeTrails(document, {&trail, 1}, Entry::hand);
  return placed ? Result<CreatedTrail>(CreatedTrail{std::move(placed->document), placed->trailIds.front()})
                : Result<CreatedTrail>(placed.error());
}

Result<Document> setTrailSettings(const Document& document, int trailId, const rig::TrailSettings& settings) {
  const rig::Trail* trail = findTrail(document, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  rig::Trail wanted = *trail;
  wanted.settings = settings;
  keepStopOnGround(document, *trail, wanted.settings);
  if (const Status valid = checkTrailSettings(document, wanted); !valid) {
    return valid.error();
  }
  return changeTrail(document, trailId, [&](rig::Trail& changed) {
    changed.applied = changed.applied && changed.settings == wanted.settings;
    moveSetSpheres(changed, wanted.settings);
    changed.settings = wanted.settings;
  });
}

Result<Document> setConnected(const Document& document, int trailId, bool connected) {
  return changeTrail(document, trailId, [&](rig::Trail& trail) {
    trail.connected = connected;
    trail.applied = trail.applied && connected;
    trail.exaggerated = trail.exaggerated || connected;
  });
}

Result<Document> setFollow(const Document& document, int trailId, bool follow) {
  return changeTrail(document, trailId, [&](rig::Trail& trail) { trail.follow = follow; });
}

Result<Document> setBlend(const Document& document, int trailId, double blend) {
  const rig::Trail* trail = findTrail(document, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  rig::TrailSettings settings = trail->settings;
  settings.blend = std::clamp(blend, 0.0, 2.0);
  return setTrailSettings(document, trailId, settings);
}

Result<Document> setTrailDisplay(const Document& document, int trailId, const TrailDisplay& display) {
  return changeTrail(document, trailId, [&](rig::Trail& trail) {
    trail.colour = std::max(0, display.colour);
    trail.visible = display.visible;
    trail.pinned = display.pinned;
  });
}

Result<Document> applyTrail(const Document& document, int trailId) {
  return changeTrail(document, trailId, [](rig::Trail& trail) {
    trail.exaggerated = true;
    trail.connected = true;
    trail.applied = true;
  });
}

Result<Document> deleteTrail(const Document& document, int trailId) {
  if (findTrail(document, trailId) == nullptr) {
    return missingTrail(trailId);
  }
  Document changed = document;
  std::erase_if(changed.trails, [&](const rig::Trail& trail) { return trail.id == trailId; });
  return changed;
}

Document deleteTrailsOfLimb(const Document& document, const std::string& limbId, int clip) {
  Document changed = document;
  std::erase_if(changed.trails,
                [&](const rig::Trail& trail) { return trail.limb == limbId && trail.clip == clip; });
  return changed;
}

namespace {

/// The trail counted in the frames of another clip; as it is where its own is gone.
rig::Trail inFramesOf(const Document& document, const rig::Trail& trail, int clip) {
  const bool isThere = trail.clip >= 0 && at(trail.clip) < document.clips->size();
  const double factor =
      isThere ? clipOf(document, clip).framesPerSecond / clipOf(document, trail.clip).framesPerSecond : 1.0;
  return factor == 1.0 ? trail : mapped(trail, TimeMap{.factor = factor});
}

} // namespace

Result<CreatedTrail> pasteTrail(const Document& document, const rig::Trail& from, const std::string& limbId,
                                int clip) {
  const rig::Trail copied = inFramesOf(document, from, clip);
  const rig::Trail* present =
      overlappingTrail(document, limbId, clip, copied.settings.startFrame, copied.settings.endFrame);
  if (present == nullptr) {
    Result<CreatedTrail> created =
        createTrail(document, {limbId, clip, copied.settings, copied.exaggerated, copied.connected});
    if (created) {
      findTrail(created->document, created->trailId)->controlFrames = copied.controlFrames;
    }
    return created;
  }
  const int trailId = present->id;
  const rig::TrailSettings settings =
      movedToRange(copied.settings, present->settings.startFrame, present->settings.endFrame);
  Result<Document> changed = changeTrail(document, trailId, [&](rig::Trail& trail) {
    trail.settings = settings;
    trail.exaggerated = copied.exaggerated;
    trail.connected = copied.connected;
    trail.applied = false;
  });
  if (!changed) {
    return changed.error();
  }
  return CreatedTrail{std::move(changed).value(), trailId};
}

Document setLooping(const Document& document, int clip, bool loops) {
  Document changed = document;
  std::erase(changed.loopingClips, clip);
  if (loops) {
    changed.loopingClips.push_back(clip);
    std::sort(changed.loopingClips.begin(), changed.loopingClips.end());
  }
  return changed;
}

} // namespace stretch::app
