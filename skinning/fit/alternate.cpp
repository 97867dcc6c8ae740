#include "skinning/fit/alternate.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <glm/geometric.hpp>

#include "skinning/fit/free_fit.h"
#include "skinning/fit/sequence_state.h"
#include "skinning/fit/solve_bones.h"
#include "skinning/fit/solve_chain.h"

namespace stretch::skinning {
namespace {

using fit::FitState;
using fit::MeshFrame;
using fit::toEigen;
using fit::toQuat;

fit::Chain makeChain(const SkinnedSequence& skinned, const MeshFrame& frame) {
  fit::Chain chain;
  const std::size_t bones = skinned.bones.size();
  for (const SkinBone& bone : skinned.bones) {
    chain.pivots.push_back(frame.in(bone.pivot));
  }
  chain.pivots.push_back(frame.in(skinned.bones.back().end));
  for (std::size_t i = 0; i < skinned.poses.size(); ++i) {
    chain.stretches.push_back(fit::stretchMatrix(skinned.poses[i]));
    chain.rotations.push_back(toEigen(skinned.poses[i].rotation));
    if (i % bones == 0) {
      chain.roots.push_back(frame.in(skinned.poses[i].position));
    }
  }
  return chain;
}

void writeChainedPoses(const FitState& state, const fit::Chain& chain, const MeshFrame& frame,
                       SkinnedSequence& skinned) {
  for (std::size_t i = 0; i < skinned.poses.size(); ++i) {
    const SkinBone& bone = skinned.bones[i % state.boneCount];
    skinned.poses[i].rotation = toQuat(chain.rotations[i]);
    skinned.poses[i].position =
        frame.out(state.matrices[i].leftCols<3>() * frame.in(bone.pivot) + state.matrices[i].col(3));
  }
}

} // namespace

namespace {

/// A share of what is told of the whole.
Proceed shareOf(const Proceed& proceed, double from, double to) {
  return [&proceed, from, to](double share) { return !proceed || proceed(from + (to - from) * share); };
}

/// Rounds; then bones that are placed badly elsewhere, and rounds again.
void settleAndMove(fit::FreeFit& free, const Proceed& proceed) {
  const FitSettings& settings = free.settings();
  if (!settings.bonesMove) {
    free.settle(settings.rounds, settings.leastGain, proceed);
    return;
  }
  constexpr double roughly = 5e-3;
  if (free.settle(settings.rounds, roughly, shareOf(proceed, 0.0, 0.3)) &&
      fit::moveBones(free, shareOf(proceed, 0.3, 0.7))) {
    free.settle(settings.rounds, settings.leastGain, shareOf(proceed, 0.7, 1.0));
  }
}

} // namespace

void fitFreeBones(const MeshSequence& sequence, SkinnedSequence& skinned, const FitSettings& settings,
                  const Proceed& proceed) {
  constexpr int sweepsForPosesAlone = 12;
  const MeshFrame frame = fit::frameOf(skinned.bindPositions);
  const std::size_t first = std::min(settings.firstWeightFrame, sequence.frameCount() - 1);
  if (settings.fitWeights) {
    FitState start = fit::makeState(sequence, skinned, frame, first);
    start.largestScale = settings.largestScale;
    auto scales = fit::scalesOf(skinned, first, start.matrices.size());
    fit::FreeFit free(std::move(start), std::move(scales), settings);
    settleAndMove(free, proceed);
    skinned.influences = free.state().influences;
    for (std::size_t b = 0; b < skinned.bones.size() && settings.bonesMove; ++b) {
      skinned.bones[b].axes = toQuat(free.state().axes[b]);
    }
    if (first == 0) {
      fit::writeFreePoses(free.state(), free.scales(), frame, skinned);
      fit::alignHemispheres(skinned);
      return;
    }
  }
  FitState state = fit::makeState(sequence, skinned, frame, 0);
  state.largestScale = settings.largestScale;
  auto scales = fit::scalesOf(skinned, 0, state.matrices.size());
  fit::fitBones(state, scales, settings.fitStretch ? fit::StretchFit::free : fit::StretchFit::fixed,
                sweepsForPosesAlone);
  fit::writeFreePoses(state, scales, frame, skinned);
  fit::alignHemispheres(skinned);
}

void fitChainedBones(const MeshSequence& sequence, SkinnedSequence& skinned, RowHold hold) {
  constexpr int steps = 12;
  constexpr double loose = 0.5;
  constexpr double firm = 128.0; // A row that is an eighth too long turns a tenth more than the body.
  const MeshFrame frame = fit::frameOf(skinned.bindPositions);
  FitState state = fit::makeState(sequence, skinned, frame, 0);
  fit::Chain chain = makeChain(skinned, frame);
  chain.hold = hold == RowHold::firm ? firm : loose;
  fit::fitChain(state, chain, steps);
  writeChainedPoses(state, chain, frame, skinned);
  fit::alignHemispheres(skinned);
}

} // namespace stretch::skinning
