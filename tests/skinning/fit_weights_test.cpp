// Weights of vertices by least squares against the best of all sets of bones, and parts of a body that are
// taken in two.
#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "skinning/fit/fit_state.h"
#include "skinning/fit/sequence_state.h"
#include "skinning/fit/split_part.h"
#include "tests/support/skinning/fit_states.h"

using namespace stretch;
using namespace stretch::skinning;
using fit::BoneMatrix;
using fit::FitState;

namespace {

/// Products of how far off a vertex is under each bone alone.
Eigen::MatrixXd productsOf(const FitState& state, std::size_t vertex) {
  const auto bones = static_cast<Eigen::Index>(state.boneCount);
  Eigen::MatrixXd off(static_cast<Eigen::Index>(3 * state.frameCount), bones);
  for (std::size_t k = 0; k < state.frameCount; ++k) {
    for (Eigen::Index b = 0; b < bones; ++b) {
      const BoneMatrix& matrix = state.matrix(k, static_cast<std::size_t>(b));
      off.col(b).segment<3>(static_cast<Eigen::Index>(3 * k)) =
          matrix.leftCols<3>() * state.bind[vertex] + matrix.col(3) - test::observedAt(state, k, vertex);
    }
  }
  return off.transpose() * off;
}

/// The least squared error of all sets of at most `most` bones but one, each with its best weights.
double leastOf(const Eigen::MatrixXd& products, int most, int without = -1) {
  double least = 1e300;
  for (unsigned set = 1; set < 1U << static_cast<unsigned>(products.rows()); ++set) {
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index b = 0; b < products.rows(); ++b) {
      if ((set >> static_cast<unsigned>(b) & 1U) != 0) {
        chosen.push_back(b);
      }
    }
    const auto count = static_cast<Eigen::Index>(chosen.size());
    if (count > most || std::ranges::count(chosen, without) > 0) {
      continue;
    }
    Eigen::MatrixXd part(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < count; ++j) {
        part(i, j) = products(chosen[static_cast<std::size_t>(i)], chosen[static_cast<std::size_t>(j)]);
      }
    }
    Eigen::VectorXd weights = part.fullPivLu().solve(Eigen::VectorXd::Ones(count));
    weights /= weights.sum();
    if (weights.minCoeff() >= -1e-12) {
      least = std::min(least, weights.dot(part * weights));
    }
  }
  return least;
}

void checkRow(const Influences& row, int most) {
  double sum = 0.0;
  std::ptrdiff_t used = 0;
  for (std::size_t i = 0; i < Influences::capacity; ++i) {
    CHECK(row.weights[i] >= 0.0F);
    sum += static_cast<double>(row.weights[i]);
    used += row.weights[i] > 0.0F ? 1 : 0;
  }
  CHECK(sum == Approx(1.0).epsilon(1e-5));
  CHECK(used <= most);
}

} // namespace

TEST_CASE("With as many bones as there are, weights are the best of all, whatever a vertex hung on") {
  std::mt19937 chance(41);
  for (const double off : {0.02, 0.3}) {
    FitState state = test::stateByChance(chance, 5, 4, 40, off);
    for (std::size_t v = 0; v < 40; ++v) {
      state.influences[v] = {};
      state.influences[v].bones[0] = static_cast<std::uint16_t>(v % 5);
      state.influences[v].weights[0] = 1.0F;
    }
    fit::solveWeights(state, 5, 5);
    for (std::size_t v = 0; v < 40; ++v) {
      checkRow(state.influences[v], 5);
      CHECK(test::errorByHand(state, v) ==
            Approx(leastOf(productsOf(state, v), 5)).epsilon(1e-3).margin(1e-6));
    }
  }
}

TEST_CASE(
    "With fewer bones than there are, no vertex is followed worse than before, and most as well as can be") {
  std::mt19937 chance(42);
  for (const int most : {1, 2, 3}) {
    FitState state = test::stateByChance(chance, 6, 4, 60, 0.2);
    for (std::size_t v = 0; v < 60; ++v) {
      Influences row;
      for (std::size_t i = 0; i < static_cast<std::size_t>(most); ++i) {
        row.bones[i] = static_cast<std::uint16_t>((v + i) % 6);
        row.weights[i] = 1.0F / static_cast<float>(most);
      }
      state.influences[v] = row;
    }
    const FitState before = state;
    fit::solveWeights(state, most == 1 ? 1 : 6, most);
    std::size_t best = 0;
    for (std::size_t v = 0; v < 60; ++v) {
      checkRow(state.influences[v], most);
      const double error = test::errorByHand(state, v);
      CHECK(error <= test::errorByHand(before, v) * (1.0 + 1e-5) + 1e-7);
      best += error < 1.001 * leastOf(productsOf(state, v), most) + 1e-6 ? 1 : 0;
    }
    CAPTURE(most, best);
    CHECK(best >= (most == 1 ? 60U : 45U));
  }
}

TEST_CASE("Searched among its own bones alone, a vertex hangs on no other, with the best weights of these") {
  std::mt19937 chance(43);
  FitState state = test::stateByChance(chance, 5, 4, 40, 0.2);
  const FitState before = state;
  fit::solveWeights(state, 5, 4, fit::WeightSearch::own);
  for (std::size_t v = 0; v < 40; ++v) {
    checkRow(state.influences[v], 4);
    Eigen::MatrixXd products = productsOf(state, v);
    for (std::size_t b = 0; b < 5; ++b) {
      const Influences& row = before.influences[v];
      bool isOwn = false;
      for (std::size_t i = 0; i < Influences::capacity; ++i) {
        isOwn = isOwn || (row.bones[i] == b && row.weights[i] > 0.0F);
      }
      if (!isOwn) {
        products(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(b)) += 1e9; // never worth it
      }
    }
    CHECK(test::errorByHand(state, v) == Approx(leastOf(products, 4)).epsilon(1e-3).margin(1e-6));
  }
}

TEST_CASE("What is lost without a bone is what the others do worse, over all vertices") {
  std::mt19937 chance(44);
  const FitState state = test::stateByChance(chance, 4, 4, 50, 0.1);
  std::vector<double> wanted(4, 0.0);
  for (std::size_t v = 0; v < 50; ++v) {
    const Eigen::MatrixXd products = productsOf(state, v);
    for (int b = 0; b < 4; ++b) {
      wanted[static_cast<std::size_t>(b)] += leastOf(products, 4, b) - leastOf(products, 4);
    }
  }
  const std::vector<double> losses = fit::lossesWithout(state, 4, 4);
  REQUIRE(losses.size() == 4);
  for (std::size_t b = 0; b < 4; ++b) {
    CHECK(losses[b] == Approx(wanted[b]).epsilon(0.01));
  }
}

TEST_CASE("A part of a body is what hangs most on one bone, with its middle and its error") {
  std::mt19937 chance(45);
  const FitState state = test::stateByChance(chance, 4, 3, 30, 0.1);
  std::vector<double> errors;
  for (std::size_t v = 0; v < 30; ++v) {
    errors.push_back(0.5 + static_cast<double>(v));
  }
  const std::vector<fit::MotionCluster> parts = fit::partsOf(state, errors);
  REQUIRE(parts.size() == 4);
  for (std::size_t b = 0; b < 4; ++b) {
    std::vector<std::size_t> vertices;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double error = 0.0;
    for (std::size_t v = 0; v < 30; ++v) {
      const Influences& row = state.influences[v];
      const auto most = std::ranges::max_element(row.weights) - row.weights.begin();
      if (row.bones[static_cast<std::size_t>(most)] == b) {
        vertices.push_back(v);
        middle += state.bind[v];
        error += errors[v];
      }
    }
    CHECK(parts[b].vertices == vertices);
    CHECK(parts[b].error == Approx(error));
    CHECK((parts[b].centre * static_cast<double>(std::max<std::size_t>(1, vertices.size())) - middle).norm() <
          1e-9);
  }
  const fit::FitState part = fit::partInTwo(state, parts[1], {0, 2});
  REQUIRE(part.vertexCount() == parts[1].vertices.size());
  CHECK(part.boneCount == 2);
  CHECK(part.frameCount == 3);
  CHECK(part.matrices.size() == 6);
  for (std::size_t i = 0; i < part.vertexCount(); ++i) {
    CHECK(part.bind[i] == state.bind[parts[1].vertices[i]]);
    CHECK(part.influences[i].bones[0] == (i == 0 || i == 2 ? 1 : 0));
    CHECK(part.influences[i].weights[0] == 1.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(test::observedAt(part, k, i) == test::observedAt(state, k, parts[1].vertices[i]));
    }
  }
}

namespace {

/// One part of a row of vertices, those from `first` on shifted more and more in each frame.
FitState shiftedFrom(std::size_t vertices, std::size_t first) {
  FitState state;
  state.frameCount = 4;
  state.boneCount = 1;
  state.axes.assign(1, Eigen::Matrix3d::Identity());
  state.matrices.assign(4, BoneMatrix::Identity());
  state.observed.resize(12, static_cast<Eigen::Index>(vertices));
  for (std::size_t v = 0; v < vertices; ++v) {
    state.bind.emplace_back(0.02 * static_cast<double>(v), 0.01 * static_cast<double>(v % 3),
                            0.01 * static_cast<double>(v % 2));
    Influences row;
    row.weights[0] = 1.0F;
    state.influences.push_back(row);
    for (Eigen::Index k = 0; k < 4; ++k) {
      const double shift = v >= first ? 0.1 * static_cast<double>(k) : 0.0;
      const auto column = static_cast<Eigen::Index>(v);
      state.observed(k, column) = static_cast<float>(state.bind[v].x());
      state.observed(4 + k, column) = static_cast<float>(state.bind[v].y() + shift);
      state.observed(8 + k, column) = static_cast<float>(state.bind[v].z());
    }
  }
  return state;
}

std::vector<std::size_t> halfOf(FitState state) {
  fit::settleParts(state, 0);
  const std::vector<double> errors = fit::vertexErrors(state);
  return fit::bestHalf(state, fit::partsOf(state, errors)[0], errors);
}

} // namespace

TEST_CASE("Of a part the vertices that move by themselves go to a second bone, whether half of it or few") {
  for (const std::size_t first : {4U, 20U, 36U}) {
    std::vector<std::size_t> moving;
    for (std::size_t v = first; v < 40; ++v) {
      moving.push_back(v);
    }
    std::vector<std::size_t> resting;
    for (std::size_t v = 0; v < first; ++v) {
      resting.push_back(v);
    }
    const std::vector<std::size_t> half = halfOf(shiftedFrom(40, first));
    CAPTURE(first, half);
    CHECK((half == moving || half == resting));
  }
}

TEST_CASE("A part that would leave hardly a vertex is not taken in two") {
  CHECK(halfOf(shiftedFrom(7, 3)).empty());
  CHECK_FALSE(halfOf(shiftedFrom(8, 4)).empty());
}

TEST_CASE("A mesh is moved to its centre and made as large as one, there and back") {
  const std::vector<glm::vec3> places{{1, 2, 3}, {4, 2, 3}, {1, 6, 3}, {2, 2, 15}};
  const fit::MeshFrame frame = fit::frameOf(places);
  CHECK(glm::distance(frame.centre, Vec3(2.0, 3.0, 6.0)) < 1e-9);
  CHECK(frame.scale == Approx(13.0)); // the diagonal of 3, 4 and 12
  const Eigen::Vector3d in = frame.in(Vec3(15.0, 3.0, -7.0));
  CHECK((in - Eigen::Vector3d(1.0, 0.0, -1.0)).norm() < 1e-9);
  CHECK(glm::distance(frame.out(in), Vec3(15.0, 3.0, -7.0)) < 1e-9);
  CHECK(fit::frameOf({{1, 1, 1}, {1, 1, 1}}).scale == 1.0);
}
