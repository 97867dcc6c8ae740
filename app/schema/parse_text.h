#pragma once

#include <string>

#include "core/base/result.h"
#include "core/math/types.h"

namespace stretch::app {

// Numbers as a person types them after an option. `where` names it in errors.

/// "-2.5e3" as a number; an error when `text` is anything but one finite number.
[[nodiscard]] Result<double> parseNumber(const std::string& text, const std::string& where);

/// Three numbers: "0,-9.81,0", "0, -9.81, 0" or "0 -9.81 0".
[[nodiscard]] Result<Vec3> parseVector(const std::string& text, const std::string& where);

/// "A:B": first and last frame, real numbers, A <= B.
[[nodiscard]] Result<Vec2> parseRange(const std::string& text, const std::string& where);

} // namespace stretch::app
