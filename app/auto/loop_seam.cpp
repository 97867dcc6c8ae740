#include "app/auto/loop_seam.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"

namespace stretch::app {

namespace {

// A quarter of a frame, so that a short snap is seen, but no less than the rounding of keys needs to make no
// speed.
double seamSeconds(const ClipGround& ground) {
  constexpr double frames = 0.25;
  constexpr double least = 1.0 / 120.0;
  return std::max(frames / ground.framesPerSecond, least);
}

template <typename At>
LoopSeam seamBy(const ClipGround& ground, const At& frameAt) {
  const Clip& clip = clipOf(ground.document, ground.clip);
  const double step = seamSeconds(ground);
  const double start = std::min(0.0, clip.startSeconds);
  const auto placesAt = [&](double seconds) { return placesOf(ground.limbs, frameAt(seconds)); };
  return {placesAt(start), placesAt(start + step), placesAt(clip.endSeconds - step),
          placesAt(clip.endSeconds)};
}

} // namespace

LoopSeam seamOf(const ClipGround& ground, const Document& document, const rig::MotionState& motion) {
  return seamBy(ground, [&](double seconds) { return evaluate(document, motion, seconds); });
}

LoopSeam seamOfSource(const ClipGround& ground) {
  return seamBy(ground,
                [&](double seconds) { return evaluateOriginal(ground.document, ground.clip, seconds); });
}

bool closesWorse(const ClipGround& ground, const LoopSeam& now, const LoopSeam& source, std::size_t limb) {
  constexpr double seamMetres = 0.008; // of a person
  constexpr double seamSpeed = 0.04;   // of a person, m/s; keys add as much again, and more
  const double metre = ground.document.body.size / characterSizeMetres;
  for (std::size_t k = 0; k < now.first[limb].size(); ++k) {
    const auto gap = [&](const LoopSeam& seam) {
      return glm::length(seam.last[limb][k] - seam.first[limb][k]);
    };
    const auto turn = [&](const LoopSeam& seam) {
      return glm::length((seam.last[limb][k] - seam.beforeLast[limb][k]) -
                         (seam.afterFirst[limb][k] - seam.first[limb][k])) /
             seamSeconds(ground);
    };
    if (gap(now) - gap(source) > seamMetres * metre || turn(now) - turn(source) > seamSpeed * metre) {
      return true;
    }
  }
  return false;
}

} // namespace stretch::app
