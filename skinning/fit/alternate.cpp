#include "skinning/fit/alternate.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <glm/geometric.hpp>

#include "skinning/fit/sequence_state.h"
#include "skinning/fit/solve_bones.h"
#include "skinning/fit/solve_chain.h"

namespace stretch::skinning {
namespace {

using fit::FitState;
using fit::MeshFrame;
using fit::toEigen;
using fit::toQuat;

/// Rounds of `bones` and weights until the error settles.
template <typename FitBones>
void alternate(FitState& state, const FitSettings& settings, const Proceed& proceed, FitBones&& bones) {
  bones();
  double before = fit::rootMeanSquare(state);
  int idle = 0;
  constexpr double exact = 1e-7; // Of the diagonal: what single precision tells apart.
  for (int round = 0; round < settings.rounds && idle < 2 && before > exact; ++round) {
    if (settings.fitWeights) {
      fit::solveWeights(state, std::max(settings.candidates, 2 * settings.influences), settings.influences);
    }
    bones();
    const double error = fit::rootMeanSquare(state);
    idle = error > before * (1.0 - settings.leastGain) ? idle + 1 : 0;
    before = error;
    if (proceed && !proceed(static_cast<double>(round + 1) / settings.rounds)) {
      return;
    }
  }
}

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

void fitFreeBones(const MeshSequence& sequence, SkinnedSequence& skinned, const FitSettings& settings,
                  const Proceed& proceed) {
  constexpr int sweeps = 3;
  constexpr int sweepsForPosesAlone = 12;
  const MeshFrame frame = fit::frameOf(skinned.bindPositions);
  const auto stretch = settings.fitStretch ? fit::StretchFit::free : fit::StretchFit::fixed;
  const std::size_t first = std::min(settings.firstWeightFrame, sequence.frameCount() - 1);
  if (settings.fitWeights) {
    FitState state = fit::makeState(sequence, skinned, frame, first);
    state.largestScale = settings.largestScale;
    auto scales = fit::scalesOf(skinned, first, state.matrices.size());
    alternate(state, settings, proceed, [&] { fit::fitBones(state, scales, stretch, sweeps); });
    skinned.influences = state.influences;
    if (first == 0) {
      fit::writeFreePoses(state, scales, frame, skinned);
      fit::alignHemispheres(skinned);
      return;
    }
  }
  FitState state = fit::makeState(sequence, skinned, frame, 0);
  state.largestScale = settings.largestScale;
  auto scales = fit::scalesOf(skinned, 0, state.matrices.size());
  fit::fitBones(state, scales, stretch, sweepsForPosesAlone);
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
