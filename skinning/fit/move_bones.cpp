#include <algorithm>

#include "skinning/fit/free_fit.h"
#include "skinning/fit/split_part.h"

namespace stretch::skinning::fit {
namespace {

/// A bone that others could stand in for, and the part that would be taken in two with it.
struct BoneMove {
  std::size_t bone = 0;
  std::size_t part = 0;
  double promise = 0.0; ///< What the part is off, less what is lost without the bone: the most to gain.
};

/// Moves that could gain something, the most promising first.
std::vector<BoneMove> movesOf(const std::vector<MotionCluster>& parts, const std::vector<double>& losses) {
  std::vector<BoneMove> moves;
  for (std::size_t bone = 0; bone < losses.size(); ++bone) {
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const double promise = parts[part].error - losses[bone];
      if (bone != part) {
        moves.push_back({bone, part, promise});
      }
    }
  }
  std::ranges::stable_sort(moves, [](const BoneMove& a, const BoneMove& b) { return a.promise > b.promise; });
  return moves;
}

/// The first move that lowers the error is kept; false when none of those that were tried does. Counts the
/// trials down.
bool moveOne(FreeFit& fit, int& trials) {
  constexpr std::size_t mostInARow = 4;
  constexpr int rounds = 6;
  constexpr int moreRounds = 12;
  constexpr double nearly = 1.02;
  constexpr double roundGain = 1e-2;
  constexpr double leastGain = 2e-3;
  constexpr std::size_t smallest = 8;
  const Reached before = fit.reached();
  const std::vector<double> errors = vertexErrors(fit.state());
  const std::vector<MotionCluster> parts = partsOf(fit.state(), errors);
  const std::vector<BoneMove> moves =
      movesOf(parts, lossesWithout(fit.state(), fit.settings().candidates, fit.settings().influences));
  for (std::size_t i = 0; i < std::min(moves.size(), mostInARow) && trials > 0; ++i) {
    const MotionCluster& part = parts[moves[i].part];
    const std::vector<std::size_t> half =
        part.vertices.size() < smallest ? std::vector<std::size_t>{} : bestHalf(fit.state(), part, errors);
    if (half.empty()) {
      continue;
    }
    --trials;
    fit.giveTo(moves[i].bone, half);
    fit.settle(rounds, roundGain);
    if (fit.error() < before.error * nearly) {
      fit.settle(moreRounds, leastGain);
    }
    if (fit.error() < before.error * (1.0 - leastGain)) {
      return true;
    }
    fit.goBackTo(before);
  }
  return false;
}

} // namespace

bool moveBones(FreeFit& fit, const Proceed& proceed) {
  constexpr int most = 20;
  int trials = most;
  bool goesOn = true;
  while (trials > 0 && fit.error() > fineError && goesOn && moveOne(fit, trials)) {
    goesOn = !proceed || proceed(1.0 - static_cast<double>(trials) / most);
  }
  return goesOn;
}

} // namespace stretch::skinning::fit
