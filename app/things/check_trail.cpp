#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "app/schema/trail_schema.h"
#include "app/schema/weight_schema.h"
#include "app/things/checks.h"
#include "core/anim/frames.h"
#include "core/gltf/json/json.h"
#include "rig/motion/trail_camera.h"

namespace stretch::app {

namespace {

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

Status checkCamera(const Ground& ground, const rig::Trail& trail) {
  const rig::Sight& sight = trail.settings.sight;
  std::string cameras;
  for (const SceneCamera& camera : ground.document.scene->cameras) {
    cameras += "'" + camera.name + "', ";
  }
  const std::string remedy = "name one: " + cameras + "front, side, top or three-quarter";
  if (sight.asSeen && !sight.hasCamera()) {
    return Error{"the scale counts as seen, by no camera", trail.limb, remedy};
  }
  if (sight.turnDegrees > 0.0 && !sight.hasCamera() && ground.entry != Entry::file) {
    return Error{"the path is turned to the view, of no camera", trail.limb, remedy};
  }
  const bool isKnown = sight.camera.empty() || rig::isStandardView(sight.camera) ||
                       cameraNamed(*ground.document.scene, sight.camera) != nullptr;
  return isKnown || ground.entry == Entry::file // another program may have taken it out
             ? Status(Success{})
             : Status(Error{"there is no camera '" + sight.camera + "'", trail.limb, remedy});
}

} // namespace

Status checkValues(const rig::Trail& trail) {
  const rig::TrailSettings& settings = trail.settings;
  if (!hasFiniteShapes(settings)) {
    return Error{"a setting of the trail is not a number", trail.limb, "give a number"};
  }
  if (Status values = checkSettings(trailSchema(), settings); !values) {
    return values;
  }
  if (settings.endFrame <= settings.startFrame) {
    return Error{fmt::format("the range {:g} to {:g} has no length", settings.startFrame, settings.endFrame),
                 trail.limb, "set its end after its start"};
  }
  return Success{};
}

Status checkAlone(const Ground& ground, const rig::Trail& trail) {
  if (Status known = checkLimbAndClip(ground.document, trail.limb, trail.clip); !known) {
    return known;
  }
  if (Status values = checkValues(trail); !values) {
    return values;
  }
  if (Status camera = checkCamera(ground, trail); !camera) {
    return camera;
  }
  const rig::TrailSettings& settings = trail.settings;
  if (Status eases = checkEases(settings.easeIn, settings.easeOut); !eases && ground.entry != Entry::file) {
    return eases; // an older file may hold others, and is not to lose its trail
  }
  const double last = lastFrame(clipOf(ground.document, trail.clip));
  const bool isOutside = settings.startFrame >= last || settings.endFrame <= 0.0;
  return isOutside && ground.entry != Entry::file
             ? Status(
                   outsideClip(fmt::format("the range {:g} to {:g}", settings.startFrame, settings.endFrame),
                               last, trail.limb))
             : Status(Success{});
}

Status checkAlone(const Ground& ground, const WeightedLimb& weight) {
  if (Status known = checkLimbAndClip(ground.document, weight.limb, weight.clip); !known) {
    return known;
  }
  if (Status values = checkSettings(weightSchema(), weight.settings); !values) {
    return values;
  }
  const std::optional<Vec2>& range = weight.settings.rangeFrames;
  return !range || range->x < range->y
             ? Status(Success{})
             : Status(Error{"the range has no length", "range", "set its end after its start"});
}

Status checkClip(const Document& document, int clip) {
  if (document.clips == nullptr || clip < 0 || at(clip) >= document.clips->size()) {
    return Error{"the file has no such clip", fmt::format("clip {}", clip), "open a file with an animation"};
  }
  return Success{};
}

Status checkLimbAndClip(const Document& document, const std::string& limbId, int clip) {
  if (findLimb(document, limbId) == nullptr) {
    return Error{"the character has no such limb", limbId,
                 "pick a limb that was found, or any chain by its joints"};
  }
  return checkClip(document, clip);
}

double lastFrameFor(const Ground& ground, int clip) {
  const Clip& shown = clipOf(ground.document, clip);
  return ground.entry == Entry::file ? std::numeric_limits<double>::infinity()
                                     : std::max(0.0, wholeFrameAtLeast(endInFrames(shown)));
}

Error outsideClip(const std::string& what, double lastFrame, const std::string& who) {
  return {fmt::format("{} lies outside the clip, which has the frames 0 to {:g}", what, lastFrame), who,
          "give frames of the clip"};
}

} // namespace stretch::app
