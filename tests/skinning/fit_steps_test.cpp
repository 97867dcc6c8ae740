// The least-squares steps of a fit, on bones and vertices by chance: sums against sums that are written out,
// what is fitted against the slopes of its error.
#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "skinning/fit/sequence_state.h"
#include "skinning/fit/solve_bones.h"
#include "skinning/fit/solve_chain.h"
#include "skinning/fit/split_part.h"
#include "tests/support/skinning/fit_states.h"

using namespace stretch;
using namespace stretch::skinning;
using fit::BoneMatrix;
using fit::FitState;

namespace {

Eigen::Vector4d withOne(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z(), 1.0};
}

double weightIn(const FitState& state, std::size_t vertex, std::size_t bone) {
  double weight = 0.0;
  for (std::size_t i = 0; i < Influences::capacity; ++i) {
    weight += state.influences[vertex].bones[i] == bone
                  ? static_cast<double>(state.influences[vertex].weights[i])
                  : 0.0;
  }
  return weight;
}

Eigen::Matrix3d turnAbout(Eigen::Index axis, double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

/// Slope of a function of one number at 0.
template <typename Function>
double slopeOf(Function&& f) {
  constexpr double step = 1e-4;
  return (f(step) - f(-step)) / (2.0 * step);
}

std::vector<Eigen::Vector3d> unscaled(const FitState& state) {
  std::vector<Eigen::Vector3d> scales(state.matrices.size());
  std::ranges::fill(scales, Eigen::Vector3d(Eigen::Vector3d::Ones()));
  return scales;
}

} // namespace

TEST_CASE("The error of a vertex is its squared distance over all frames, that of all the root of its mean") {
  std::mt19937 chance(31);
  for (const std::size_t vertices : {1U, 63U, 130U}) {
    const FitState state = test::stateByChance(chance, 4, 5, vertices, 0.1);
    const std::vector<double> errors = fit::vertexErrors(state);
    REQUIRE(errors.size() == vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      CHECK(errors[v] == Approx(test::errorByHand(state, v)).epsilon(1e-4));
    }
    CHECK(fit::rootMeanSquare(state) ==
          Approx(std::sqrt(test::errorByHand(state) / static_cast<double>(5 * vertices))).epsilon(1e-4));
  }
}

TEST_CASE("Sums over vertices that bones need are those that are written out") {
  std::mt19937 chance(32);
  const FitState state = test::stateByChance(chance, 4, 3, 40, 0.1);
  const fit::BindMoments bind(state);
  const fit::ObservedMoments observed(state);
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 4; ++b) {
      Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
      for (std::size_t v = 0; v < 40; ++v) {
        sum += weightIn(state, v, a) * weightIn(state, v, b) * withOne(state.bind[v]) *
               withOne(state.bind[v]).transpose();
      }
      const auto& list = bind.neighbours(a);
      const auto found = std::ranges::find(list, b, &fit::BindMoments::Neighbour::bone);
      if (a == b) {
        CHECK((bind.own(a) - sum).norm() < 1e-9);
        CHECK(found == list.end());
      } else {
        CHECK((found == list.end() ? sum.norm() : (found->product - sum).norm()) < 1e-9);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      BoneMatrix sum = BoneMatrix::Zero();
      for (std::size_t v = 0; v < 40; ++v) {
        sum += weightIn(state, v, a) * test::observedAt(state, k, v) * withOne(state.bind[v]).transpose();
      }
      CHECK((observed.at(k)[a] - sum).norm() < 1e-6);
    }
  }
}

TEST_CASE("Bones that are fitted lower the error, until no turn and no shift of one lowers it more") {
  std::mt19937 chance(33);
  FitState state = test::stateByChance(chance, 3, 4, 60, 0.05);
  for (BoneMatrix& matrix : state.matrices) {
    matrix = BoneMatrix::Identity();
  }
  std::vector<Eigen::Vector3d> scales = unscaled(state);
  double before = test::errorByHand(state);
  for (int sweep = 0; sweep < 60; ++sweep) {
    fit::fitBones(state, scales, fit::StretchFit::fixed, sweep % 2 + 1);
    const double now = test::errorByHand(state);
    CHECK(now <= before * (1.0 + 1e-7));
    before = now;
  }
  fit::fitBones(state, scales, fit::StretchFit::fixed, 2000);
  for (std::size_t i = 0; i < state.matrices.size(); ++i) {
    CHECK((state.matrices[i].leftCols<3>() * state.matrices[i].leftCols<3>().transpose() -
           Eigen::Matrix3d::Identity())
              .norm() < 1e-9);
    CHECK(state.matrices[i].leftCols<3>().determinant() > 0.0);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const BoneMatrix fitted = state.matrices[i];
      const double turning = slopeOf([&](double angle) {
        state.matrices[i] = fitted;
        state.matrices[i].leftCols<3>() = turnAbout(axis, angle) * fitted.leftCols<3>();
        return test::errorByHand(state);
      });
      const double shifting = slopeOf([&](double way) {
        state.matrices[i] = fitted;
        state.matrices[i](axis, 3) += way;
        return test::errorByHand(state);
      });
      state.matrices[i] = fitted;
      CHECK(std::abs(turning) < 1e-4);
      CHECK(std::abs(shifting) < 1e-4);
    }
  }
}

TEST_CASE("Bones that may stretch are found again with their scales along their own axes") {
  std::mt19937 chance(34);
  FitState state = test::stateByChance(chance, 2, 4, 60, 0.0);
  std::vector<Eigen::Vector3d> made;
  for (std::size_t i = 0; i < state.matrices.size(); ++i) {
    const auto number = static_cast<double>(i);
    made.emplace_back(1.0 + 0.1 * number, 0.9 - 0.05 * number, 1.2);
    const Eigen::Matrix3d& axes = state.axes[i % 2];
    state.matrices[i].leftCols<3>() *= axes * made.back().asDiagonal() * axes.transpose();
  }
  for (std::size_t v = 0; v < 60; ++v) {
    state.influences[v] = {};
    state.influences[v].bones[0] = static_cast<std::uint16_t>(v % 2);
    state.influences[v].weights[0] = 1.0F;
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector3d place = state.matrix(k, v % 2) * withOne(state.bind[v]);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        state.observed(4 * axis + static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(v)) =
            static_cast<float>(place(axis));
      }
    }
  }
  const std::vector<BoneMatrix> wanted = state.matrices;
  std::ranges::fill(state.matrices, BoneMatrix(BoneMatrix::Identity()));
  std::vector<Eigen::Vector3d> scales = unscaled(state);
  fit::fitBones(state, scales, fit::StretchFit::free, 400);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK((state.matrices[i] - wanted[i]).norm() < 1e-3);
    CHECK((scales[i] - made[i]).norm() < 1e-3);
  }
  // Nothing stretches past the most that is allowed.
  state.largestScale = 1.1;
  fit::fitBones(state, scales, fit::StretchFit::free, 4);
  for (const Eigen::Vector3d& scale : scales) {
    CHECK(scale.maxCoeff() <= 1.1 + 1e-12);
    CHECK(scale.minCoeff() >= 1.0 / 1.1 - 1e-12);
  }
  CHECK(std::ranges::any_of(scales,
                            [](const Eigen::Vector3d& scale) { return scale.maxCoeff() > 1.1 - 1e-9; }));
}

TEST_CASE("The axes of a bone are turned to where it stretches, with what it stretches by") {
  std::mt19937 chance(35);
  FitState state = test::stateByChance(chance, 2, 6, 80, 0.0);
  const std::vector<Eigen::Matrix3d> wanted{turnAbout(2, 0.7) * turnAbout(0, 0.4), turnAbout(1, -1.0)};
  for (std::size_t v = 0; v < 80; ++v) {
    state.influences[v] = {};
    state.influences[v].bones[0] = static_cast<std::uint16_t>(v % 2);
    state.influences[v].weights[0] = 1.0F;
  }
  std::vector<Eigen::Vector3d> made;
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t b = 0; b < 2; ++b) {
      made.emplace_back(1.5 + 0.1 * static_cast<double>(k), 1.2, 0.95);
      state.matrix(k, b).leftCols<3>() *= wanted[b] * made.back().asDiagonal() * wanted[b].transpose();
    }
  }
  for (std::size_t v = 0; v < 80; ++v) {
    for (std::size_t k = 0; k < 6; ++k) {
      const Eigen::Vector3d place = state.matrix(k, v % 2) * withOne(state.bind[v]);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        state.observed(6 * axis + static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(v)) =
            static_cast<float>(place(axis));
      }
    }
  }
  std::vector<Eigen::Vector3d> scales = unscaled(state);
  fit::turnAxes(state, scales);
  for (std::size_t b = 0; b < 2; ++b) {
    CHECK(state.axes[b].determinant() == Approx(1.0));
    // The axis of the largest change comes last, that of the least first.
    CHECK(std::abs(state.axes[b].col(2).dot(wanted[b].col(0))) > 0.999);
    CHECK(std::abs(state.axes[b].col(1).dot(wanted[b].col(1))) > 0.999);
    CHECK(std::abs(state.axes[b].col(0).dot(wanted[b].col(2))) > 0.999);
    for (std::size_t k = 0; k < 6; ++k) {
      const Eigen::Vector3d& scale = scales[2 * k + b];
      CHECK(scale(2) == Approx(made[2 * k + b](0)).epsilon(0.01));
      CHECK(scale(1) == Approx(made[2 * k + b](1)).epsilon(0.01));
      CHECK(scale(0) == Approx(made[2 * k + b](2)).epsilon(0.01));
    }
  }
  state.largestScale = 1.3;
  fit::turnAxes(state, scales);
  for (const Eigen::Vector3d& scale : scales) {
    CHECK(scale.maxCoeff() == Approx(1.3));
  }
}

namespace {

fit::Chain chainOf(const FitState& state, std::mt19937& chance, double hold) {
  fit::Chain chain;
  chain.hold = hold;
  for (std::size_t b = 0; b <= state.boneCount; ++b) {
    chain.pivots.emplace_back(-0.5 + 0.3 * static_cast<double>(b), 0.05 * static_cast<double>(b), 0.0);
  }
  for (std::size_t i = 0; i < state.matrices.size(); ++i) {
    Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();
    stretch(0, 0) = 1.1;
    stretch(0, 1) = stretch(1, 0) = 0.02 * static_cast<double>(chance() % 4);
    chain.stretches.push_back(stretch);
    chain.rotations.push_back(turnAbout(static_cast<Eigen::Index>(i % 3), 0.05));
  }
  for (std::size_t k = 0; k < state.frameCount; ++k) {
    chain.roots.emplace_back(-0.4, 0.1, 0.02 * static_cast<double>(k));
  }
  return chain;
}

/// The matrices of a row of bones, one after the other.
void layOut(const fit::Chain& chain, FitState& state) {
  for (std::size_t k = 0; k < state.frameCount; ++k) {
    Eigen::Vector3d place = chain.roots[k];
    for (std::size_t b = 0; b < state.boneCount; ++b) {
      const std::size_t i = k * state.boneCount + b;
      const Eigen::Matrix3d linear = chain.rotations[i] * chain.stretches[i];
      state.matrices[i].leftCols<3>() = linear;
      state.matrices[i].col(3) = place - linear * chain.pivots[b];
      place += linear * (chain.pivots[b + 1] - chain.pivots[b]);
    }
  }
}

/// The squared error, and half the squared way from the rotations of the start, times how each bone resists
/// being turned: the spread of what it moves about its pivot, weights squared.
double heldError(const FitState& state, const fit::Chain& chain, const fit::Chain& start) {
  double sum = test::errorByHand(state);
  for (std::size_t i = 0; i < chain.rotations.size(); ++i) {
    const std::size_t b = i % state.boneCount;
    double resists = 0.0;
    for (std::size_t v = 0; v < state.vertexCount(); ++v) {
      const double weight = weightIn(state, v, b);
      resists += weight * weight * (state.bind[v] - chain.pivots[b]).squaredNorm();
    }
    sum += 0.5 * chain.hold * resists * (chain.rotations[i] - start.rotations[i]).squaredNorm();
  }
  return sum;
}

} // namespace

TEST_CASE("A row of bones that is fitted hangs together, and no turn and no shift lowers its error more") {
  for (const double hold : {0.0, 0.5, 3.0}) {
    std::mt19937 chance(36);
    FitState state = test::stateByChance(chance, 3, 3, 50, 0.05);
    const fit::Chain start = chainOf(state, chance, hold);
    fit::Chain chain = start;
    layOut(chain, state);
    const double before = heldError(state, chain, start);
    fit::fitChain(state, chain, 60);
    FitState again = state;
    layOut(chain, again);
    for (std::size_t i = 0; i < state.matrices.size(); ++i) {
      CHECK((again.matrices[i] - state.matrices[i]).norm() < 1e-9);
      CHECK((chain.rotations[i] * chain.rotations[i].transpose() - Eigen::Matrix3d::Identity()).norm() <
            1e-9);
    }
    CHECK(heldError(state, chain, start) < before);
    const auto errorOf = [&](const fit::Chain& tried) {
      layOut(tried, again);
      return heldError(again, tried, start);
    };
    CAPTURE(hold);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < chain.rotations.size(); ++i) {
        CHECK(std::abs(slopeOf([&](double angle) {
                fit::Chain tried = chain;
                tried.rotations[i] = turnAbout(axis, angle) * chain.rotations[i];
                return errorOf(tried);
              })) < 1e-3);
      }
      for (std::size_t k = 0; k < state.frameCount; ++k) {
        CHECK(std::abs(slopeOf([&](double way) {
                fit::Chain tried = chain;
                tried.roots[k](axis) += way;
                return errorOf(tried);
              })) < 1e-3);
      }
    }
  }
}

TEST_CASE("A row of bones that is not held is found again where its mesh was moved by it") {
  std::mt19937 chance(37);
  FitState state = test::stateByChance(chance, 4, 3, 80, 0.0);
  fit::Chain made = chainOf(state, chance, 0.0);
  for (std::size_t i = 0; i < made.rotations.size(); ++i) {
    made.rotations[i] = turnAbout(static_cast<Eigen::Index>((i + 1) % 3), 0.1 * static_cast<double>(i % 5));
  }
  layOut(made, state);
  for (std::size_t v = 0; v < 80; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      Eigen::Vector3d place = Eigen::Vector3d::Zero();
      for (std::size_t b = 0; b < 4; ++b) {
        place += weightIn(state, v, b) * (state.matrix(k, b) * withOne(state.bind[v]));
      }
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        state.observed(3 * axis + static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(v)) =
            static_cast<float>(place(axis));
      }
    }
  }
  fit::Chain chain = made;
  std::ranges::fill(chain.rotations, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  std::ranges::fill(chain.roots, Eigen::Vector3d(-0.5, 0.0, 0.0));
  fit::fitChain(state, chain, 60);
  for (std::size_t i = 0; i < made.rotations.size(); ++i) {
    CHECK((chain.rotations[i] - made.rotations[i]).norm() < 1e-5);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK((chain.roots[k] - made.roots[k]).norm() < 1e-5);
  }
}
