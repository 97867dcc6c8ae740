#include "skinning/export/key_bound.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/gltf/import.h"
#include "skinning/export/read_back.h"
#include "skinning/fit/joint_tree.h"
#include "skinning/metrics.h"

namespace stretch::skinning {
namespace {

/// The frames that a reader makes of a clip of ours.
MeshSequence framesOf(const gltf::Source& source, std::size_t frames, double framesPerSecond) {
  gltf::Problems problems;
  const Scene scene = gltf::importScene(source, problems);
  const std::vector<Clip> clips = gltf::importClips(source, scene, problems);
  check(!problems.hasErrors(), "what this program writes, it can read");
  return framesShown(scene, clips, frames, framesPerSecond);
}

std::vector<std::size_t> childrenFirst(const SkinnedSequence& sequence) {
  std::vector<std::size_t> order;
  if (sequence.chained) {
    for (std::size_t b = 0; b < sequence.bones.size(); ++b) {
      order.push_back(b);
    }
  } else {
    order = orderOfTree(sequence.bones);
  }
  std::ranges::reverse(order);
  return order;
}

} // namespace

std::vector<BoneReach> reachesOf(const SkinnedSequence& sequence) {
  std::vector<BoneReach> reaches(sequence.bones.size());
  for (std::size_t v = 0; v < sequence.influences.size(); ++v) {
    const Influences& influences = sequence.influences[v];
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      if (influences.weights[i] > 0.0F) {
        double& reach = reaches[influences.bones[i]].scaled;
        const Vec3 away = Vec3(sequence.bindPositions[v]) - sequence.bones[influences.bones[i]].pivot;
        reach = std::max(reach, glm::length(away));
      }
    }
  }
  for (BoneReach& reach : reaches) {
    reach.turned = reach.scaled;
  }
  for (const std::size_t b : childrenFirst(sequence)) {
    const int parent = sequence.chained ? static_cast<int>(b) - 1 : sequence.bones[b].parent;
    if (parent >= 0) {
      const auto above = static_cast<std::size_t>(parent);
      const double away = glm::length(sequence.bones[b].pivot - sequence.bones[above].pivot);
      reaches[above].turned = std::max(reaches[above].turned, away + reaches[b].turned);
    }
  }
  return reaches;
}

KeyBound findKeyBound(const SkinnedSequence& sequence, double tolerancePercent,
                      const EncodeWithBound& encode) {
  SkinnedSequence bare = sequence;
  bare.surface = nullptr;
  const double size = boxDiagonal(bare.bindPositions);
  const std::size_t frames = bare.frameCount();
  const MeshSequence whole = framesOf(encode(bare, 0.0), frames, bare.framesPerSecond);
  constexpr int trials = 7;
  constexpr double closeEnough = 0.85;
  KeyBound best;
  double bound = 0.01 * tolerancePercent * size;
  for (int trial = 0; trial < trials && bound > 0.0; ++trial) {
    const MeshSequence reduced = framesOf(encode(bare, bound), frames, bare.framesPerSecond);
    const double percent = distancesOf(whole, reduced).largestPercent;
    const bool holds = percent <= tolerancePercent;
    if (holds && bound > best.bound) {
      best = {bound, percent};
    }
    if (holds && percent >= closeEnough * tolerancePercent) {
      break;
    }
    bound *= holds ? std::min(3.0, 0.93 * tolerancePercent / std::max(percent, 1e-12))
                   : 0.93 * tolerancePercent / percent;
  }
  return best;
}

} // namespace stretch::skinning
