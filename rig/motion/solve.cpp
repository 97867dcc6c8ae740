#include "rig/motion/solve.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "rig/body/detection.h"
#include "rig/motion/order.h"
#include "rig/motion/release_length.h"
#include "rig/motion/solve_adjustments.h"
#include "rig/motion/solve_steps.h"

namespace stretch::rig {

namespace {

TrailSettings usable(TrailSettings settings, const Clip& clip) {
  const double lastFrame = std::max(0.0, clip.endSeconds * clip.framesPerSecond);
  settings.startFrame = std::clamp(settings.startFrame, 0.0, lastFrame);
  settings.endFrame = std::clamp(settings.endFrame, settings.startFrame,
                                 std::min(lastFrame, settings.startFrame + longestFrames));
  settings.scale = std::max(settings.scale, smallestScale);
  return settings;
}

const SolvedTrail* solvedBefore(const MotionInput& input, const Trail& trail) {
  if (input.previous == nullptr) {
    return nullptr;
  }
  const std::vector<SolvedTrail>& trails = input.previous->trails;
  const auto found = std::find_if(trails.begin(), trails.end(), [&](const SolvedTrail& solved) {
    return solved.trail.id == trail.id && solved.trail.limb == trail.limb && solved.trail.clip == trail.clip;
  });
  return found == trails.end() ? nullptr : &*found;
}

// Whether the settings, as used, ask for the same original path.
bool samePath(const TrailSettings& a, const TrailSettings& b) {
  return a.startFrame == b.startFrame && a.endFrame == b.endFrame && a.pivot == b.pivot &&
         a.space == b.space && (a.space != TrailSpace::view || a.viewAxes == b.viewAxes);
}

// What the paths of all trails are sampled from. Adjustments move the whole character: its trails, which
// mostly ask for the same times, share the samples.
class PathSampler {
public:
  PathSampler(const MotionInput& input, const SolvedAdjustments& adjustments)
      : input_(input), adjustments_(adjustments) {}

  void sample(SolvedTrail& solved, const std::vector<double>& keyTimes) {
    if (adjustments_.empty()) {
      SharedSampler own(*input_.scene, *input_.clip, adjustments_, pathNodes(input_, solved.limb));
      samplePath(input_, own, solved, keyTimes);
      return;
    }
    if (!shared_) {
      shared_.emplace(*input_.scene, *input_.clip, adjustments_, nodesOfAll());
    }
    samplePath(input_, *shared_, solved, keyTimes);
  }

private:
  [[nodiscard]] std::vector<NodeIndex> nodesOfAll() const {
    std::vector<NodeIndex> nodes;
    for (const Trail& trail : input_.trails) {
      if (const Limb* const limb = limbOf(input_, trail.limb)) {
        const std::vector<NodeIndex> own = pathNodes(input_, *limb);
        nodes.insert(nodes.end(), own.begin(), own.end());
      }
    }
    return nodes;
  }

  const MotionInput& input_;
  const SolvedAdjustments& adjustments_;
  std::optional<SharedSampler> shared_;
};

// Made before with the body, where that is there.
LimbTopology topologyOf(const MotionInput& input, const Limb& limb) {
  const AdjustedBody* const body = input.body.get();
  if (body == nullptr) {
    return limbTopology(*input.scene, limb, input.limbs, bindPlaces(*input.scene));
  }
  const auto known = std::find_if(body->limbs.begin(), body->limbs.end(),
                                  [&](const AdjustedLimb& adjusted) { return adjusted.limb == limb; });
  return known != body->limbs.end() ? known->topology
                                    : limbTopology(*input.scene, limb, input.limbs, body->places);
}

SolvedTrail solveTrail(const MotionInput& input, PathSampler& sampler, const Trail& trail, const Limb& limb) {
  const SolvedTrail* before = solvedBefore(input, trail);
  if (before != nullptr && before->trail == trail) {
    return *before;
  }
  SolvedTrail solved;
  solved.trail = trail;
  solved.limb = limb;
  solved.settings = usable(trail.settings, *input.clip);
  solved.topology = before != nullptr ? before->topology : topologyOf(input, limb);
  solved.active = trail.connected;
  const double fps = input.clip->framesPerSecond;
  solved.startSeconds = solved.settings.startFrame / fps;
  solved.endSeconds = solved.settings.endFrame / fps;
  solved.tipSeconds = solved.settings.pivot == Pivot::start ? solved.endSeconds : solved.startSeconds;
  std::vector<NodeIndex> keyed = limb.joints;
  if (limb.endNode.exists()) {
    keyed.push_back(limb.endNode);
  }
  const std::vector<double> keyTimes = keyTimesOf(*input.clip, keyed, solved.startSeconds, solved.endSeconds);
  if (before != nullptr && samePath(before->settings, solved.settings)) {
    solved.path = before->path;
    solved.bend = before->bend;
  } else {
    before = nullptr;
    sampler.sample(solved, keyTimes);
  }
  solveTipOf(solved);
  explainTip(solved, fps);
  solved.remap = Remap(solved.settings.remap, solved.settings.easeIn, solved.settings.easeOut);
  setControlFrames(input, solved, keyTimes, before);
  solved.offsets = SphereOffsets(solved.controlFrames, solved.settings.spheres);
  setRelease(input, solved, keyed);
  return solved;
}

void setWindow(SolvedTrail& solved, double fadeSeconds) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double release = solved.release.seconds();
  solved.windowStartSeconds = solved.startSeconds - (forwards ? fadeSeconds : release);
  solved.windowEndSeconds = solved.endSeconds + (forwards ? release : fadeSeconds);
}

bool pullsPivot(const SolvedTrail& solved, double framesPerSecond) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double pivotSeconds = forwards ? solved.startSeconds : solved.endSeconds;
  return glm::length(solved.offsets.at(pivotSeconds * framesPerSecond)) > 0.0;
}

} // namespace

const Limb* limbOf(const MotionInput& input, const std::string& id) {
  const auto found =
      std::find_if(input.limbs.begin(), input.limbs.end(), [&](const Limb& limb) { return limb.id == id; });
  return found != input.limbs.end() && !found->joints.empty() ? &*found : nullptr;
}

MotionState solveMotion(const MotionInput& input) {
  MotionState motion;
  motion.clip = input.clipIndex;
  motion.framesPerSecond = input.clip->framesPerSecond;
  motion.startSeconds = input.clip->startSeconds;
  motion.endSeconds = input.clip->endSeconds;
  motion.hips = input.hips;
  motion.loops = input.loops;
  motion.adjustments =
      input.previous != nullptr
          ? input.previous->adjustments
          : solveAdjustments(
                {{*input.scene, *input.clip, input.hips, input.limbs}, input.adjustments, input.body});
  PathSampler sampler(input, motion.adjustments);
  for (const Trail& trail : input.trails) {
    if (const Limb* const limb = limbOf(input, trail.limb)) {
      motion.trails.push_back(solveTrail(input, sampler, trail, *limb));
    }
  }
  std::vector<ActingLimb> acting;
  for (const SolvedTrail& solved : motion.trails) {
    acting.push_back({&solved.limb, solved.startSeconds});
  }
  motion.trails = inOrder(std::move(motion.trails), actingOrder(*input.scene, acting));
  return motion;
}

void setRelease(const MotionInput& input, SolvedTrail& solved, const std::vector<NodeIndex>& nodes) {
  const ReleaseLength length = releaseLength(input, solved, nodes);
  solved.release = Release(length.seconds, solved.settings.overshoot);
  solved.wantedReleaseSeconds = length.wantedSeconds;
  solved.calmReleaseSeconds = length.calmSeconds;
  setWindow(solved, pullsPivot(solved, input.clip->framesPerSecond) ? length.seconds : 0.0);
}

} // namespace stretch::rig
