#include "tests/support/skinning/fit_states.h"

#include <Eigen/Geometry>

namespace stretch::test {

namespace {

using namespace skinning;
using fit::BoneMatrix;
using fit::FitState;

Eigen::Vector3d anywhere(std::mt19937& chance, double reach) {
  std::uniform_real_distribution<double> number(-reach, reach);
  return {number(chance), number(chance), number(chance)};
}

Eigen::Matrix3d turned(std::mt19937& chance, double most) {
  return Eigen::AngleAxisd(most, anywhere(chance, 1.0).normalized()).toRotationMatrix();
}

Influences hangingOn(std::mt19937& chance, std::size_t bones, std::size_t vertex) {
  Influences row;
  const std::size_t count = std::min<std::size_t>(1 + vertex % 3, bones);
  float left = 1.0F;
  for (std::size_t i = 0; i < count; ++i) {
    row.bones[i] = static_cast<std::uint16_t>((vertex + i) % bones);
    row.weights[i] = i + 1 == count ? left : left * (0.4F + 0.02F * static_cast<float>(chance() % 10));
    left -= row.weights[i];
  }
  return row;
}

Eigen::Vector3d placedByHand(const FitState& state, std::size_t frame, std::size_t vertex) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  const Influences& row = state.influences[vertex];
  for (std::size_t i = 0; i < Influences::capacity; ++i) {
    const BoneMatrix& matrix = state.matrix(frame, row.bones[i]);
    const Eigen::Vector3d carried = matrix.leftCols<3>() * state.bind[vertex] + matrix.col(3);
    place += static_cast<double>(row.weights[i]) * carried;
  }
  return place;
}

} // namespace

FitState stateByChance(std::mt19937& chance, std::size_t bones, std::size_t frames, std::size_t vertices,
                       double off) {
  FitState state;
  state.frameCount = frames;
  state.boneCount = bones;
  for (std::size_t v = 0; v < vertices; ++v) {
    state.bind.push_back(anywhere(chance, 0.5));
    state.influences.push_back(hangingOn(chance, bones, v));
  }
  for (std::size_t b = 0; b < bones; ++b) {
    state.axes.push_back(turned(chance, 0.3 * static_cast<double>(b)));
  }
  for (std::size_t k = 0; k < frames; ++k) {
    for (std::size_t b = 0; b < bones; ++b) {
      BoneMatrix matrix;
      matrix.leftCols<3>() = turned(chance, 0.3);
      matrix.col(3) = anywhere(chance, 0.2);
      state.matrices.push_back(matrix);
    }
  }
  const auto rows = static_cast<Eigen::Index>(frames);
  state.observed.resize(3 * rows, static_cast<Eigen::Index>(vertices));
  for (std::size_t k = 0; k < frames; ++k) {
    for (std::size_t v = 0; v < vertices; ++v) {
      const Eigen::Vector3d place = placedByHand(state, k, v) + anywhere(chance, off);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        state.observed(axis * rows + static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(v)) =
            static_cast<float>(place(axis));
      }
    }
  }
  return state;
}

Eigen::Vector3d observedAt(const FitState& state, std::size_t frame, std::size_t vertex) {
  const auto rows = static_cast<Eigen::Index>(state.frameCount);
  const auto k = static_cast<Eigen::Index>(frame);
  const auto v = static_cast<Eigen::Index>(vertex);
  return Eigen::Vector3f(state.observed(k, v), state.observed(rows + k, v), state.observed(2 * rows + k, v))
      .cast<double>();
}

double errorByHand(const FitState& state, std::size_t vertex) {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.frameCount; ++k) {
    sum += (placedByHand(state, k, vertex) - observedAt(state, k, vertex)).squaredNorm();
  }
  return sum;
}

double errorByHand(const FitState& state) {
  double sum = 0.0;
  for (std::size_t v = 0; v < state.vertexCount(); ++v) {
    sum += errorByHand(state, v);
  }
  return sum;
}

} // namespace stretch::test
