#pragma once

#include <vector>

#include "core/math/types.h"

namespace stretch::skinning {

/// Places on a line where straight bones between them follow it best, near the given parts of its length (0
/// to 1, ascending): at its bends where it has some, else at those parts. The first and the last are exact.
[[nodiscard]] std::vector<Vec3> jointsAlong(const std::vector<Vec3>& line, const std::vector<double>& parts);

/// The line as `count` places at equal distances along it.
[[nodiscard]] std::vector<Vec3> evenly(const std::vector<Vec3>& line, std::size_t count);

} // namespace stretch::skinning
