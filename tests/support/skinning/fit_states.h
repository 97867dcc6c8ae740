#pragma once

#include <random>

#include "skinning/fit/fit_state.h"

namespace stretch::test {

/// Bones that turn, move and stretch by chance, and vertices that each hang on one to three of them; what is
/// observed is where they are, each `off` by chance.
[[nodiscard]] skinning::fit::FitState stateByChance(std::mt19937& chance, std::size_t bones,
                                                    std::size_t frames, std::size_t vertices, double off);

/// Squared distance of one vertex to where its bones put it, over all frames, written out.
[[nodiscard]] double errorByHand(const skinning::fit::FitState& state, std::size_t vertex);

/// That of all of them.
[[nodiscard]] double errorByHand(const skinning::fit::FitState& state);

[[nodiscard]] Eigen::Vector3d observedAt(const skinning::fit::FitState& state, std::size_t frame,
                                         std::size_t vertex);

} // namespace stretch::test
