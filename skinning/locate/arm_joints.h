#pragma once

#include <optional>

#include "skinning/locate/arm_line.h"
#include "skinning/locate/placed.h"

namespace stretch::skinning {

struct ArmJoints {
  Placed shoulder;
  Placed elbow;
  Placed wrist;
};

/// Both arms; nothing where the mesh shows none.
struct ArmPair {
  std::optional<ArmJoints> right; ///< The side of -X.
  std::optional<ArmJoints> left;
};

[[nodiscard]] ArmPair armPair(const StandingBody& body, const LegLines& legs);

/// The mirror image, less sure.
[[nodiscard]] ArmJoints mirroredArm(const ArmJoints& arm);

/// A hanging arm by the proportions of a person whose shoulders are at this height. `side`: 1 for +X.
[[nodiscard]] ArmJoints guessedArm(double shoulderHeight, double side);

} // namespace stretch::skinning
