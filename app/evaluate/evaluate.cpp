#include "app/evaluate/evaluate.h"

#include <algorithm>

namespace stretch::app {

namespace {

std::vector<rig::Trail> trailsOf(const Document& document, int clip) {
  std::vector<rig::Trail> trails;
  std::copy_if(document.trails.begin(), document.trails.end(), std::back_inserter(trails),
               [&](const rig::Trail& trail) { return trail.clip == clip; });
  return trails;
}

bool loops(const Document& document, int clip) {
  return std::find(document.loopingClips.begin(), document.loopingClips.end(), clip) !=
         document.loopingClips.end();
}

// A file without a clip shows the character at rest.
const Clip& clipOrStill(const Document& document, int clip, const Clip& still) {
  return clip >= 0 && static_cast<std::size_t>(clip) < document.clips->size() ? clipOf(document, clip)
                                                                              : still;
}

rig::MotionInput inputOf(const Document& document, int clip, const Clip& still) {
  rig::MotionInput input;
  input.scene = document.scene.get();
  input.clip = &clipOrStill(document, clip, still);
  input.clipIndex = clip;
  input.biped = &document.biped;
  input.limbs = allLimbs(document);
  input.trails = trailsOf(document, clip);
  input.loops = loops(document, clip);
  return input;
}

// The trails alone.
rig::MotionState solvedTrails(const Document& document, int clip, const rig::MotionState* previous) {
  const Clip still;
  rig::MotionInput input = inputOf(document, clip, still);
  input.previous = previous;
  return rig::solveMotion(input);
}

std::vector<WeightedLimb> weightsOf(const Document& document, int clip) {
  std::vector<WeightedLimb> weights;
  std::copy_if(document.weights.begin(), document.weights.end(), std::back_inserter(weights),
               [&](const WeightedLimb& entry) { return entry.clip == clip; });
  return weights;
}

bool sameLimbs(const std::vector<WeightedLimb>& a, const std::vector<WeightedLimb>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const WeightedLimb& x, const WeightedLimb& y) { return x.limb == y.limb; });
}

// The trails that the paths of one of a motion's trails come from, its own included.
std::vector<rig::Trail> originsOf(const Document& document, const rig::MotionState& motion,
                                  const rig::SolvedTrail& solved) {
  std::vector<rig::Trail> origins{solved.trail};
  for (const rig::SolvedTrail& other : motion.trails) {
    if (rig::shapesPath(*document.scene, other, solved)) {
      origins.push_back(other.trail);
    }
  }
  return origins;
}

/// Paths made before, for a motion on the same ground.
struct EarlierPaths {
  const rig::MotionState* motion = nullptr;
  const std::vector<TrailPaths>* paths = nullptr;
};

// Null where the trail, or one that moves it, is another now.
const TrailPaths* stillTrue(const Document& document, const EarlierPaths& earlier,
                            const rig::MotionState& motion, const rig::SolvedTrail& solved) {
  if (earlier.motion == nullptr) {
    return nullptr;
  }
  const std::vector<rig::SolvedTrail>& before = earlier.motion->trails;
  const auto same = std::find_if(before.begin(), before.end(),
                                 [&](const rig::SolvedTrail& old) { return old.trail == solved.trail; });
  if (same == before.end() ||
      originsOf(document, *earlier.motion, *same) != originsOf(document, motion, solved)) {
    return nullptr;
  }
  return &(*earlier.paths)[static_cast<std::size_t>(same - before.begin())];
}

std::vector<TrailPaths> pathsOf(const Document& document, const rig::MotionState& motion,
                                std::size_t samplesPerFrame, const EarlierPaths& earlier) {
  const Clip& clip = clipOf(document, motion.clip);
  std::vector<TrailPaths> paths(motion.trails.size());
  std::vector<rig::PathRequest> requests;
  std::vector<rig::DrawnTrail*> answers;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const rig::SolvedTrail& solved = motion.trails[i];
    if (const TrailPaths* kept = stillTrue(document, earlier, motion, solved)) {
      paths[i] = *kept;
      continue;
    }
    requests.push_back({&solved, rig::drawnFrames(clip, solved, samplesPerFrame)});
    answers.push_back(&paths[i].drawn);
    requests.push_back({&solved, solved.controlFrames});
    answers.push_back(&paths[i].spheres);
  }
  std::vector<rig::DrawnTrail> drawn = rig::pathsAt(*document.scene, clip, motion, requests);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    *answers[i] = std::move(drawn[i]);
  }
  return paths;
}

} // namespace

rig::MotionState prepareMotion(const Document& document, int clip) {
  rig::MotionState motion = solvedTrails(document, clip, nullptr);
  if (hasWeight(document, clip)) {
    const Clip still;
    LimbSizes sizes;
    WeightMotion weight = weightMotion(document, sampleClip(document, motion), clip, sizes);
    rig::setWeight(inputOf(document, clip, still), std::move(weight.weights), motion);
  }
  return motion;
}

std::vector<WeightReport> weightReports(const Document& document, int clip) {
  if (!hasWeight(document, clip)) {
    return {};
  }
  LimbSizes sizes;
  const rig::MotionState motion = solvedTrails(document, clip, nullptr);
  return weightMotion(document, sampleClip(document, motion), clip, sizes).reports;
}

FrameState evaluate(const Document& document, const rig::MotionState& motion, double timeSeconds) {
  const Clip still;
  return rig::evaluateMotion(*document.scene, clipOrStill(document, motion.clip, still), motion, timeSeconds);
}

FrameState evaluateOriginal(const Document& document, int clip, double timeSeconds) {
  const Clip still;
  return frameOf(*document.scene,
                 samplePose(*document.scene, clipOrStill(document, clip, still), timeSeconds), timeSeconds);
}

std::vector<TrailPaths> trailPaths(const Document& document, const rig::MotionState& motion,
                                   std::size_t samplesPerFrame) {
  return pathsOf(document, motion, samplesPerFrame, {});
}

EvaluationCache::Ground EvaluationCache::groundOf(const Document& document, int clip) {
  return {document.scene,      document.clips,     clip,
          document.biped.hips, allLimbs(document), document.loopingClips};
}

std::shared_ptr<const rig::MotionState> EvaluationCache::motion(const Document& document, int clip) {
  Ground ground = groundOf(document, clip);
  std::vector<rig::Trail> trails = trailsOf(document, clip);
  std::vector<WeightedLimb> weights = weightsOf(document, clip);
  const bool sameGround = motion_ != nullptr && ground == ground_;
  const bool sameTrails = sameGround && trails == trails_;
  if (!sameTrails || weights != weights_) {
    const rig::MotionState* previous = sameGround ? motion_.get() : nullptr;
    rig::MotionState motion = sameTrails ? *motion_ : solvedTrails(document, clip, previous);
    if (!sameTrails || !sameLimbs(weights, weights_)) {
      sampled_.reset();
    }
    giveWay(document, clip, motion);
    motion_ = std::make_shared<const rig::MotionState>(std::move(motion));
    ground_ = std::move(ground);
    trails_ = std::move(trails);
    weights_ = std::move(weights);
  }
  return motion_;
}

void EvaluationCache::giveWay(const Document& document, int clip, rig::MotionState& motion) {
  motion.weights.clear();
  weightReports_.clear();
  if (!hasWeight(document, clip)) {
    return;
  }
  if (!sampled_) {
    sampled_ = sampleClip(document, motion);
  }
  const Clip still;
  WeightMotion weight = weightMotion(document, *sampled_, clip, sizes_);
  rig::setWeight(inputOf(document, clip, still), std::move(weight.weights), motion);
  weightReports_ = std::move(weight.reports);
}

const std::vector<WeightReport>& EvaluationCache::weightReports(const Document& document, int clip) {
  static_cast<void>(motion(document, clip));
  return weightReports_;
}

const std::vector<TrailPaths>& EvaluationCache::paths(const Document& document, int clip,
                                                      std::size_t samplesPerFrame) {
  static_cast<void>(motion(document, clip));
  if (pathsMotion_ != motion_ || pathsSamplesPerFrame_ != samplesPerFrame) {
    const bool sameGround = pathsMotion_ != nullptr && pathsGround_ == ground_;
    const bool usable = sameGround && pathsSamplesPerFrame_ == samplesPerFrame;
    paths_ = pathsOf(document, *motion_, samplesPerFrame,
                     usable ? EarlierPaths{pathsMotion_.get(), &paths_} : EarlierPaths{});
    pathsMotion_ = motion_;
    pathsGround_ = ground_;
    pathsSamplesPerFrame_ = samplesPerFrame;
  }
  return paths_;
}

const FrameState& EvaluationCache::frame(const Document& document, int clip, double timeSeconds) {
  static_cast<void>(motion(document, clip));
  if (frameMotion_ != motion_ || frameSeconds_ != timeSeconds) {
    frame_ = evaluate(document, *motion_, timeSeconds);
    frameMotion_ = motion_;
    frameSeconds_ = timeSeconds;
  }
  return frame_;
}

const FrameState& EvaluationCache::original(const Document& document, int clip, double timeSeconds) {
  if (originalScene_ != document.scene || originalClips_ != document.clips || originalClip_ != clip ||
      originalSeconds_ != timeSeconds) {
    original_ = evaluateOriginal(document, clip, timeSeconds);
    originalScene_ = document.scene;
    originalClips_ = document.clips;
    originalClip_ = clip;
    originalSeconds_ = timeSeconds;
  }
  return original_;
}

} // namespace stretch::app
