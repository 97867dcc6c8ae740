#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/support/rig/families/family_rig.h"

namespace stretch::test {

struct Judged {
  bool right = true;
  bool told = false; ///< Each thing that is wrong has a confidence below a half, or is missing with a
                     ///< warning.
  std::string what;
};

/// Of limbs by tenths of confidence.
struct Calibration {
  std::array<int, 3> right{};
  std::array<int, 3> all{};
  void add(double confidence, bool isRight) {
    const std::size_t band = confidence >= 0.8 ? 0 : confidence >= 0.5 ? 1 : 2;
    ++all[band];
    right[band] += isRight ? 1 : 0;
  }
};

/// Holds what is read of a rig against what a person sees in it.
Judged judge(const FamilyRig& rig, Calibration& limbs);

/// A line for each family: how many of its rigs are right, and how many wrong without a word.
/// @param details takes what is wrong of each rig; none: it is not asked for.
std::string familiesTable(const std::vector<FamilyRig>& rigs, Calibration& limbs, std::string* details);

} // namespace stretch::test
