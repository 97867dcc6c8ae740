#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/document.h"
#include "rig/moments/moments.h"

namespace stretch::app {

/// How much moments of a clip count beside each other, whatever kind of limb they are of.
class MomentWeights {
public:
  MomentWeights() = default;
  /// `counted`: those that can be done, or that are switched off, and that others count beside.
  MomentWeights(const Document& document, const std::vector<const rig::Moment*>& counted);

  /// Strength, in which what is full is the same for each kind of limb (fullStrength). Legs that step in turn
  /// do one thing: the strongest step of each counts as that of the leg that steps fastest.
  [[nodiscard]] double of(const rig::Moment& moment) const;

  /// The clip's strongest, beside which a moment counts. What a body does while its wings beat counts beside
  /// that, and not beside the beats.
  [[nodiscard]] double strongestBeside(const rig::Moment& moment) const;

  /// Strength of the moment that is strongest as it is, in reaches per second.
  [[nodiscard]] double fastest() const { return fastest_; }
  /// Whether that is a beat of a wing.
  [[nodiscard]] bool isLedByBeats() const { return isLedByBeats_; }

private:
  [[nodiscard]] bool isStepOfGait(const rig::Moment& moment) const;
  void countIn(const rig::Moment& moment);

  std::vector<rig::Limb> limbs_;
  std::map<std::string, double> steps_; // strength of each leg's strongest step in a gait
  double gait_ = 0.0;                   // of the strongest of all of them
  double fastest_ = 0.0;
  double strongest_ = 0.0;
  double strongestAct_ = 0.0;
  bool isLedByBeats_ = false;
};

} // namespace stretch::app
