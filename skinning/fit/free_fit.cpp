#include "skinning/fit/free_fit.h"

#include <algorithm>
#include <utility>

#include "skinning/fit/solve_bones.h"
#include "skinning/fit/split_part.h"

namespace stretch::skinning::fit {
namespace {

constexpr double exact = 1e-6;       // Of the diagonal: files hold no more.
constexpr int priceOfFineRounds = 4; // In rounds, and in what they have to gain, once the error is fine.
constexpr int roundsToTurn = 3;      // Axes are turned after so many.
constexpr int sweeps = 3;

/// Bones as much farther as they went in the last round, more and more boldly.
std::vector<BoneMatrix> movedOn(const std::vector<BoneMatrix>& now, const std::vector<BoneMatrix>& before,
                                int roundsOnTheWay) {
  const double share = roundsOnTheWay / (roundsOnTheWay + 3.0);
  std::vector<BoneMatrix> moved = now;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] += share * (now[i] - before[i]);
  }
  return moved;
}

} // namespace

FreeFit::FreeFit(FitState state, std::vector<Eigen::Vector3d> scales, const FitSettings& settings)
    : state_(std::move(state)), scales_(std::move(scales)), settings_(settings) {
  fitBonesOnce();
}

void FreeFit::fitBonesOnce() {
  fitBones(state_, scales_, settings_.fitStretch ? StretchFit::free : StretchFit::fixed, sweeps);
  error_ = rootMeanSquare(state_);
}

/// Weights for bones as they are shown, then bones from where they are.
void FreeFit::round(int number, bool ahead, const std::vector<BoneMatrix>& shown) {
  constexpr int everywhere = 3; // Of so many rounds one looks at all candidates.
  constexpr int lastTurn = 15;
  if (settings_.fitWeights) {
    const std::vector<BoneMatrix> fitted = std::exchange(state_.matrices, shown);
    solveWeights(state_, std::max(settings_.candidates, 2 * settings_.influences), settings_.influences,
                 ahead && number % everywhere != 0 ? WeightSearch::own : WeightSearch::everywhere);
    state_.matrices = fitted;
  }
  const bool turn = turning_ && number % roundsToTurn == roundsToTurn - 1 && number < lastTurn;
  if (turn) {
    turnAxes(state_, scales_);
  }
  const double before = error_;
  fitBonesOnce();
  turning_ = turning_ && !(turn && error_ > before);
}

bool FreeFit::settle(int rounds, double leastGain, const Proceed& proceed) {
  Reached best = reached();
  std::vector<BoneMatrix> before = state_.matrices;
  int onTheWay = 0;
  int idle = 0;
  int spent = 0;
  bool goesOn = true;
  turning_ = settings_.bonesMove && settings_.fitStretch;
  for (int number = 0;
       spent < rounds && (idle < 2 || (turning_ && number < roundsToTurn)) && best.error > exact && goesOn;
       ++number) {
    const int price = best.error > fineError ? 1 : priceOfFineRounds;
    const bool ahead = onTheWay > 0;
    const std::vector<BoneMatrix> now = state_.matrices;
    round(number, ahead, ahead ? movedOn(now, before, onTheWay) : now);
    before = now;
    idle = error_ <= best.error * (1.0 - price * leastGain) ? 0 : idle + 1;
    if (error_ < best.error) {
      best = reached();
      ++onTheWay;
    } else {
      goBackTo(best);
      onTheWay = 0;
    }
    spent += price;
    goesOn = !proceed || proceed(std::min(1.0, static_cast<double>(spent) / rounds));
  }
  goBackTo(best);
  return goesOn;
}

void FreeFit::giveTo(std::size_t bone, const std::vector<std::size_t>& vertices) {
  MotionCluster part;
  part.vertices = vertices;
  FitState alone = partInTwo(state_, part, {});
  settleParts(alone, 0);
  for (std::size_t k = 0; k < state_.frameCount; ++k) {
    state_.matrix(k, bone) = alone.matrix(k, 0);
    scales_[k * state_.boneCount + bone] = alone.matrix(k, 0).leftCols<3>().colwise().norm().transpose();
  }
  state_.axes[bone] = Eigen::Matrix3d::Identity();
  solveWeights(state_, settings_.candidates, settings_.influences);
  fitBonesOnce();
}

Reached FreeFit::reached() const {
  return {state_.influences, state_.matrices, state_.axes, scales_, error_};
}

void FreeFit::goBackTo(const Reached& reached) {
  state_.influences = reached.influences;
  state_.matrices = reached.matrices;
  state_.axes = reached.axes;
  scales_ = reached.scales;
  error_ = reached.error;
}

} // namespace stretch::skinning::fit
