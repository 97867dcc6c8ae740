#include "app/auto/moment_weights.h"

#include <algorithm>

#include "app/auto/planned_trail.h"

namespace stretch::app {

namespace {

constexpr double leastStep = 0.25; // of the strongest leg's: a leg that does less hardly goes along

const rig::Limb* limbOf(const std::vector<rig::Limb>& limbs, const rig::Moment& moment) {
  const auto found = std::ranges::find(limbs, moment.limb, &rig::Limb::id);
  return found == limbs.end() ? nullptr : &*found;
}

} // namespace

MomentWeights::MomentWeights(const Document& document, const std::vector<const rig::Moment*>& counted)
    : limbs_(allLimbs(document)) {
  for (const rig::Moment* const moment : counted) {
    if (isStepOfGait(*moment)) {
      double& strongestStep = steps_[moment->limb];
      strongestStep = std::max(strongestStep, moment->strength);
      gait_ = std::max(gait_, moment->strength);
    }
  }
  for (const rig::Moment* const moment : counted) {
    countIn(*moment);
  }
}

double MomentWeights::of(const rig::Moment& moment) const {
  const auto own = steps_.find(moment.limb);
  if (isStepOfGait(moment) && own != steps_.end() && moment.strength >= own->second &&
      moment.strength >= leastStep * gait_) {
    return std::max(gait_, moment.strength);
  }
  const rig::Limb* const limb = limbOf(limbs_, moment);
  return moment.strength * fullStrength / (limb == nullptr ? fullStrength : fullStrengthOf(*limb));
}

double MomentWeights::strongestBeside(const rig::Moment& moment) const {
  const bool isInFlight = isLedByBeats_ && strongestAct_ > 0.0 && moment.kind == rig::MomentKind::stroke;
  return isInFlight ? std::max(strongestAct_, of(moment)) : strongest_;
}

bool MomentWeights::isStepOfGait(const rig::Moment& moment) const {
  const rig::Limb* const limb = limbOf(limbs_, moment);
  return limb != nullptr && moment.kind == rig::MomentKind::cycle && isLeg(*limb);
}

void MomentWeights::countIn(const rig::Moment& moment) {
  const rig::Limb* const limb = limbOf(limbs_, moment);
  strongest_ = std::max(strongest_, of(moment));
  if (limb != nullptr && isAct(*limb, moment)) {
    strongestAct_ = std::max(strongestAct_, of(moment));
  }
  if (moment.strength > fastest_) {
    fastest_ = moment.strength;
    isLedByBeats_ = limb != nullptr && isBeat(*limb, moment);
  }
}

} // namespace stretch::app
