#include "app/evaluate/evaluation_input.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

#include "app/edits/pose/hold_edits.h"
#include "core/base/index.h"
#include "rig/motion/seam.h"

namespace stretch::app {

namespace {

template <typename T>
std::vector<T> ofClip(const std::vector<T>& all, int clip) {
  std::vector<T> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const T& one) { return one.clip == clip; });
  return some;
}

// The trails that the paths of one of a motion's trails come from, its own included.
std::vector<rig::Trail> originsOf(const Scene& scene, const rig::MotionState& motion, std::size_t trail) {
  std::vector<rig::Trail> origins{motion.trails[trail].trail};
  for (std::size_t other = 0; other < motion.trails.size(); ++other) {
    if (rig::shapesPath(scene, motion, other, trail)) {
      origins.push_back(motion.trails[other].trail);
    }
  }
  return origins;
}

// Null where the trail, or one that moves it, is another now, or holds act on its limb.
const TrailPaths* stillTrue(const Scene& scene, const EarlierPaths& earlier, const rig::MotionState& motion,
                            std::size_t trail) {
  if (earlier.motion == nullptr) {
    return nullptr;
  }
  const std::string& limb = motion.trails[trail].limb.id;
  if (rig::isHeldLimb(*earlier.motion, limb) || rig::isHeldLimb(motion, limb)) {
    return nullptr;
  }
  const auto before = rig::placeOfTrail(*earlier.motion, motion.trails[trail].trail.id);
  const bool same = before && originsOf(scene, *earlier.motion, *before) == originsOf(scene, motion, trail);
  return same ? &(*earlier.paths)[*before] : nullptr;
}

// Where the body stays where it is: on one that travels the next turn begins elsewhere.
bool isDrawnAcrossSeam(const EvaluationGround& ground) {
  const auto travel = ground.loops
                          ? rig::loopTravel(*ground.scene, clipOf(ground), ground.hips, ground.height)
                          : std::nullopt;
  return travel && glm::length(*travel) < 0.05 * ground.height;
}

} // namespace

EvaluationInput evaluationInput(const Document& document, int clip) {
  return {{document.scene, document.clips, clip, document.body.hips, document.body.height, document.body.size,
           allLimbs(document), isLooping(document, clip), ofClip(document.adjustments, clip)},
          ofClip(document.trails, clip),
          holdsOfClip(document.holds, clip),
          ofClip(document.weights, clip)};
}

const Clip& clipOrStill(const std::vector<Clip>& clips, int clip) {
  static const Clip still;
  return clip >= 0 && at(clip) < clips.size() ? clips[at(clip)] : still;
}

const Clip& clipOf(const EvaluationGround& ground) {
  return clipOrStill(*ground.clips, ground.clip);
}

rig::MotionInput motionInput(const EvaluationInput& input) {
  rig::MotionInput wanted;
  wanted.scene = input.ground.scene.get();
  wanted.clip = &clipOf(input.ground);
  wanted.clipIndex = input.ground.clip;
  wanted.hips = input.ground.hips;
  wanted.limbs = input.ground.limbs;
  wanted.trails = input.trails;
  wanted.loops = input.ground.loops;
  wanted.adjustments = input.ground.adjustments;
  wanted.holds = input.holds;
  return wanted;
}

WeightInput weightInput(const EvaluationInput& input) {
  const EvaluationGround& ground = input.ground;
  return {ground.scene, &clipOf(ground), ground.limbs, ground.size, ground.loops, input.weights};
}

std::vector<TrailPaths> drawPaths(const EvaluationGround& ground, const rig::MotionState& motion,
                                  std::size_t samplesPerFrame, const EarlierPaths& earlier) {
  const Clip& clip = clipOf(ground);
  const bool acrossSeam = isDrawnAcrossSeam(ground);
  std::vector<TrailPaths> paths(motion.trails.size());
  std::vector<rig::PathRequest> requests;
  std::vector<rig::DrawnTrail*> answers;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (const TrailPaths* const kept = stillTrue(*ground.scene, earlier, motion, i)) {
      paths[i] = *kept;
      continue;
    }
    requests.push_back({i, rig::drawnFrames(clip, motion.trails[i], samplesPerFrame, acrossSeam)});
    answers.push_back(&paths[i].drawn);
    requests.push_back({i, motion.trails[i].controlFrames});
    answers.push_back(&paths[i].spheres);
  }
  std::vector<rig::DrawnTrail> drawn = rig::pathsAt(*ground.scene, clip, motion, requests);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    *answers[i] = std::move(drawn[i]);
  }
  return paths;
}

} // namespace stretch::app
