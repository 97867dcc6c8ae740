#include "rig/motion/solve.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include "core/anim/frames.h"
#include "rig/adjust/solve_adjustments.h"
#include "rig/body/reading/detection.h"
#include "rig/motion/order.h"
#include "rig/motion/release_length.h"
#include "rig/motion/solve_steps.h"
#include "rig/motion/stop.h"
#include "rig/motion/trail_camera.h"

namespace stretch::rig {

namespace {

TrailSettings usable(TrailSettings settings, const Clip& clip) {
  const double lastFrame = std::max(0.0, endInFrames(clip));
  settings.startFrame = std::clamp(settings.startFrame, 0.0, lastFrame);
  settings.endFrame = std::clamp(settings.endFrame, settings.startFrame,
                                 std::min(lastFrame, settings.startFrame + longestFrames));
  settings.scale = std::max(settings.scale, smallestScale);
  std::erase_if(settings.spheres, [&](const SphereOffset& sphere) {
    return !isWithinFrames(settings.startFrame, settings.endFrame, sphere.frame);
  });
  return settings;
}

// The first trail of the motion before that is meant; null: none.
template <typename IsMeant>
const SolvedTrail* solvedBefore(const MotionInput& input, const IsMeant& isMeant) {
  if (input.previous == nullptr) {
    return nullptr;
  }
  const std::vector<SolvedTrail>& trails = input.previous->trails;
  const auto found = std::find_if(trails.begin(), trails.end(), isMeant);
  return found == trails.end() ? nullptr : &*found;
}

const SolvedTrail* sameTrailBefore(const MotionInput& input, const Trail& trail) {
  return solvedBefore(input, [&](const SolvedTrail& solved) { return solved.trail == trail; });
}

// Where the scene's bind pose has what trails move: looked for at most once for all of them.
class Places {
public:
  explicit Places(const MotionInput& input) : input_(input) {}

  const BindPlaces& get() {
    if (input_.body != nullptr) {
      return input_.body->places;
    }
    if (input_.places != nullptr) {
      return *input_.places;
    }
    std::call_once(once_, [&] { own_.emplace(bindPlaces(*input_.scene)); });
    return *own_;
  }

private:
  const MotionInput& input_;
  std::once_flag once_; // trails are solved side by side
  std::optional<BindPlaces> own_;
};

// Made before with a trail of the limb, or with the body, where that is there.
LimbTopology topologyOf(const MotionInput& input, const Limb& limb, Places& places) {
  if (const SolvedTrail* const before =
          solvedBefore(input, [&](const SolvedTrail& solved) { return solved.limb == limb; })) {
    return before->topology;
  }
  const AdjustedBody* const body = input.body.get();
  if (body == nullptr) {
    return limbTopology(*input.scene, limb, input.limbs, places.get());
  }
  for (const std::optional<AdjustedLimb>* const own : {&body->spine, &body->neck}) {
    if (*own && (*own)->limb == limb) {
      return (*own)->topology;
    }
  }
  const auto known =
      std::ranges::find_if(body->limbs, [&](const AdjustedLimb& adjusted) { return adjusted.limb == limb; });
  return known != body->limbs.end() ? known->topology
                                    : limbTopology(*input.scene, limb, input.limbs, body->places);
}

FrameTable::Extent framesToShare(const MotionInput& input, const SolvedAdjustments& adjustments,
                                 Places& places) {
  std::vector<NodeIndex> nodes = adjustments.nodes;
  std::vector<double> times;
  for (const Trail& trail : input.trails) {
    if (const Limb* const limb = limbOf(input, trail.limb)) {
      const std::vector<NodeIndex> read = pathNodes(input, *limb);
      const std::vector<NodeIndex> written = touchedNodes(*limb, topologyOf(input, *limb, places));
      const PathTimes own = pathTimes(input, *limb, pathKeyOf(limb->id, usable(trail.settings, *input.clip)));
      nodes.insert(nodes.end(), read.begin(), read.end());
      nodes.insert(nodes.end(), written.begin(), written.end());
      times.insert(times.end(), own.samples.begin(), own.samples.end());
      times.insert(times.end(), own.between.begin(), own.between.end());
    }
  }
  return FrameTable::extentOf(std::move(nodes), std::move(times));
}

// Adjustments move the whole character: its trails, which mostly look at the same times, share the frames.
void setFrames(const MotionInput& input, MotionState& motion, Places& places) {
  FrameTable::Extent extent = framesToShare(input, motion.adjustments, places);
  if (extent.timesSeconds.size() > FrameTable::most(*input.scene)) {
    return;
  }
  const std::shared_ptr<const FrameTable> before =
      input.sameClip == nullptr ? nullptr : input.sameClip->sourceFrames;
  motion.sourceFrames =
      before != nullptr && before->extent() == extent
          ? before
          : std::make_shared<const FrameTable>(*input.scene, *input.clip, std::move(extent));
  const MotionState* const previous = input.previous;
  motion.adjustedFrames = previous != nullptr && previous->sourceFrames == motion.sourceFrames
                              ? previous->adjustedFrames
                              : std::make_shared<const FrameTable>(*motion.sourceFrames, motion.adjustments);
}

OriginalPath originalPath(const MotionInput& input, const MotionState& motion, const Limb& limb,
                          const PathKey& key) {
  if (const SolvedTrail* const same =
          solvedBefore(input, [&](const SolvedTrail& before) { return before.pathKey == key; })) {
    return static_cast<const OriginalPath&>(*same);
  }
  FrameSource frames(*input.scene, *input.clip, motion.adjustments, pathNodes(input, limb),
                     motion.adjustedFrames.get());
  return samplePath(input, limb, key, frames);
}

// Around the range, as far as a way back may go: where the limb's end rests.
void setRests(const MotionInput& input, const MotionState& motion, const Limb& limb,
              const TrailSettings& used, OriginalPath& original) {
  constexpr double leastSeconds = 2.0;
  if (!used.stopAt || original.rests) {
    return;
  }
  const double fps = input.clip->framesPerSecond;
  const double around = std::max(leastSeconds, 2.0 * (used.endFrame - used.startFrame) / fps);
  FrameSource frames(*input.scene, *input.clip, motion.adjustments, pathNodes(input, limb),
                     motion.adjustedFrames.get());
  original.rests =
      restsIn(*input.clip, limb, {used.startFrame / fps - around, used.endFrame / fps + around}, frames);
}

// The camera that judges a trail, where it stands at the tip.
std::optional<CameraPlace> cameraOf(const MotionInput& input, const MotionState& motion, const Sight& sight,
                                    double tipSeconds, Places& places) {
  if (const SceneCamera* const camera = cameraNamed(*input.scene, sight.camera)) {
    FrameSource frames(*input.scene, *input.clip, motion.adjustments, {camera->node},
                       motion.adjustedFrames.get());
    return placeOfCamera(*camera, frames, tipSeconds);
  }
  if (isStandardView(sight.camera)) {
    return standardView(sight.camera,
                        facingInClip(*input.scene, *input.clip, input.hips, input.limbs, places.get()));
  }
  return sight.camera.empty() ? sight.view : std::nullopt;
}

SolvedTrail solveTrail(const MotionInput& input, const MotionState& motion, const Trail& trail,
                       const Limb& limb, Places& places) {
  if (const SolvedTrail* const same = sameTrailBefore(input, trail)) {
    return *same;
  }
  const TrailSettings used = usable(trail.settings, *input.clip);
  const double fps = input.clip->framesPerSecond;
  SolvedTrail solved;
  static_cast<OriginalPath&>(solved) = originalPath(input, motion, limb, pathKeyOf(limb.id, used));
  setRests(input, motion, limb, used, solved);
  solved.trail = trail;
  solved.limb = limb;
  solved.settings = used;
  solved.topology = topologyOf(input, limb, places);
  solved.active = trail.connected;
  solved.startSeconds = used.startFrame / fps;
  solved.endSeconds = used.endFrame / fps;
  solved.tipSeconds = used.pivot == Pivot::start ? solved.endSeconds : solved.startSeconds;
  solved.camera = cameraOf(input, motion, used.sight, solved.tipSeconds, places);
  solveTipOf(solved);
  explainTip(solved, fps);
  solved.remap = Remap(used.remap, used.easeIn, used.easeOut);
  setControlFrames(solved);
  solved.offsets = SphereOffsets(solved.controlFrames, used.spheres);
  setRelease(input, solved);
  return solved;
}

// Each looks at the clip alone, not at what the others make of it.
std::vector<SolvedTrail> solveAll(const MotionInput& input, const MotionState& motion, Places& places) {
  constexpr double worthWaking = 512.0; // frames of trails that are new, to have another thread help
  std::vector<std::pair<const Trail*, const Limb*>> found;
  std::size_t isNew = 0;
  double newFrames = 0.0;
  for (const Trail& trail : input.trails) {
    if (const Limb* const limb = limbOf(input, trail.limb)) {
      found.emplace_back(&trail, limb);
      if (sameTrailBefore(input, trail) == nullptr) {
        ++isNew;
        newFrames += trail.settings.endFrame - trail.settings.startFrame;
      }
    }
  }
  std::vector<SolvedTrail> solved(found.size());
  const auto solve = [&](std::size_t i) {
    solved[i] = solveTrail(input, motion, *found[i].first, *found[i].second, places);
  };
  if (isNew > 1 && newFrames > worthWaking) {
    tbb::parallel_for(std::size_t{0}, found.size(), solve);
  } else { // most drags
    for (std::size_t i = 0; i < found.size(); ++i) {
      solve(i);
    }
  }
  return solved;
}

void setWindow(SolvedTrail& solved, double fadeSeconds) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double release = solved.release.seconds();
  solved.windowStartSeconds = solved.startSeconds - (forwards ? fadeSeconds : release);
  solved.windowEndSeconds = solved.endSeconds + (forwards ? release : fadeSeconds);
}

} // namespace

const Limb* limbOf(const MotionInput& input, const std::string& id) {
  const auto found =
      std::find_if(input.limbs.begin(), input.limbs.end(), [&](const Limb& limb) { return limb.id == id; });
  return found != input.limbs.end() && !found->joints.empty() ? &*found : nullptr;
}

MotionState solveMotion(const MotionInput& input) {
  MotionState motion;
  Places places(input);
  motion.clip = input.clipIndex;
  motion.framesPerSecond = input.clip->framesPerSecond;
  motion.startSeconds = input.clip->startSeconds;
  motion.endSeconds = input.clip->endSeconds;
  motion.hips = input.hips;
  motion.loops = input.loops;
  if (!input.adjustments.empty()) {
    motion.adjustments =
        input.previous != nullptr
            ? input.previous->adjustments
            : solveAdjustments(
                  {{*input.scene, *input.clip, input.hips, input.limbs}, input.adjustments, input.body});
    setFrames(input, motion, places);
  }
  motion.trails = solveAll(input, motion, places);
  std::vector<ActingLimb> acting;
  for (const SolvedTrail& solved : motion.trails) {
    acting.push_back({&solved.limb, solved.startSeconds});
  }
  motion.trails = inOrder(std::move(motion.trails), actingOrder(*input.scene, acting));
  return motion;
}

void setRelease(const MotionInput& input, SolvedTrail& solved) {
  const ReleaseLength length = releaseLength(input, solved);
  solved.release = Release(length.seconds, solved.settings.overshoot,
                           solved.settings.lingerFrames / input.clip->framesPerSecond);
  solved.wantedReleaseSeconds = length.wantedSeconds;
  solved.calmReleaseSeconds = length.calmSeconds;
  setWindow(solved, pullsPivot(solved, input.clip->framesPerSecond) ? length.seconds : 0.0);
  solved.comesToRest = solved.settings.stopAt && comesToRest(solved);
}

} // namespace stretch::rig
