#include "app/edits/trail_edits.h"

#include <algorithm>
#include <cmath>

namespace stretch::app {

namespace {

constexpr int paletteSize = 5; ///< Colours that are dealt to new trails in turn.

bool isFinite(const rig::TrailSettings& settings) {
  const double numbers[] = {
      settings.startFrame,     settings.endFrame,      settings.scale,
      settings.easeIn.percent, settings.easeIn.value,  settings.easeOut.percent,
      settings.easeOut.value,  settings.stretchSwitch, settings.volume,
      settings.overshoot,      settings.blend,         settings.releaseFrames.value_or(0.0)};
  const bool plain =
      std::all_of(std::begin(numbers), std::end(numbers), [](double n) { return std::isfinite(n); });
  return plain &&
         std::all_of(settings.spheres.begin(), settings.spheres.end(), [](const rig::SphereOffset& sphere) {
           return std::isfinite(sphere.frame + sphere.offset.x + sphere.offset.y + sphere.offset.z);
         });
}

std::string rangeText(const rig::TrailSettings& settings) {
  const auto whole = [](double frame) { return std::to_string(static_cast<long>(std::lround(frame))); };
  return whole(settings.startFrame) + " to " + whole(settings.endFrame);
}

/// What speaks against these settings for a trail of this limb, or success.
Status validate(const Document& document, const std::string& limbId, int clip,
                const rig::TrailSettings& settings, int trailId) {
  if (!isFinite(settings)) {
    return Error{"a setting of the trail is not a number", limbId, "type a number"};
  }
  if (settings.endFrame <= settings.startFrame) {
    return Error{"the range has no length", limbId, "set its end after its start"};
  }
  const rig::Trail* other =
      overlappingTrail(document, limbId, clip, settings.startFrame, settings.endFrame, trailId);
  if (other != nullptr) {
    return Error{"two on one limb may not overlap in time: there is a trail from " +
                     rangeText(other->settings),
                 limbId, "change the range, or edit that trail"};
  }
  return Success{};
}

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

} // namespace

Error missingTrail(int trailId) {
  return Error{"there is no such trail", "trail " + std::to_string(trailId), "select a trail"};
}

const rig::Trail* overlappingTrail(const Document& document, const std::string& limbId, int clip,
                                   double startFrame, double endFrame, int exceptTrailId) {
  for (const rig::Trail& trail : document.trails) {
    const bool sameTime = trail.settings.startFrame < endFrame && startFrame < trail.settings.endFrame;
    if (trail.id != exceptTrailId && trail.limb == limbId && trail.clip == clip && sameTime) {
      return &trail;
    }
  }
  return nullptr;
}

Status checkLimbAndClip(const Document& document, const std::string& limbId, int clip) {
  if (findLimb(document, limbId) == nullptr) {
    return Error{"the character has no such limb", limbId,
                 "pick a limb that was found, or any chain by its joints"};
  }
  if (document.clips == nullptr || clip < 0 || clip >= static_cast<int>(document.clips->size())) {
    return Error{"the file has no such clip", "clip " + std::to_string(clip),
                 "open a file with an animation"};
  }
  return Success{};
}

Result<CreatedTrail> createTrail(const Document& document, const NewTrail& wanted) {
  if (const Status known = checkLimbAndClip(document, wanted.limb, wanted.clip); !known) {
    return known.error();
  }
  if (const Status valid = validate(document, wanted.limb, wanted.clip, wanted.settings, 0); !valid) {
    return valid.error();
  }
  CreatedTrail created{document, document.nextTrailId};
  rig::Trail trail;
  trail.id = created.document.nextTrailId++;
  trail.limb = wanted.limb;
  trail.clip = wanted.clip;
  trail.settings = wanted.settings;
  trail.exaggerated = wanted.exaggerated || wanted.connected;
  trail.connected = wanted.connected;
  trail.colour = (trail.id - 1) % paletteSize;
  created.document.trails.push_back(std::move(trail));
  return created;
}

Result<Document> setTrailSettings(const Document& document, int trailId, const rig::TrailSettings& settings) {
  const rig::Trail* trail = findTrail(document, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  if (const Status valid = validate(document, trail->limb, trail->clip, settings, trailId); !valid) {
    return valid.error();
  }
  return changeTrail(document, trailId, [&](rig::Trail& changed) { changed.settings = settings; });
}

Result<Document> setExaggerated(const Document& document, int trailId, bool exaggerated) {
  return changeTrail(document, trailId, [&](rig::Trail& trail) {
    trail.exaggerated = exaggerated;
    trail.connected = trail.connected && exaggerated;
  });
}

Result<Document> setConnected(const Document& document, int trailId, bool connected) {
  return changeTrail(document, trailId, [&](rig::Trail& trail) {
    trail.connected = connected;
    trail.exaggerated = trail.exaggerated || connected;
  });
}

Result<Document> setFollow(const Document& document, int trailId, bool follow) {
  return changeTrail(document, trailId, [&](rig::Trail& trail) { trail.follow = follow; });
}

Result<Document> setBlend(const Document& document, int trailId, double blend) {
  return changeTrail(document, trailId,
                     [&](rig::Trail& trail) { trail.settings.blend = std::clamp(blend, 0.0, 2.0); });
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
    trail.applied = trail.settings;
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

Result<CreatedTrail> pasteTrail(const Document& document, const rig::Trail& copied, const std::string& limbId,
                                int clip) {
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
