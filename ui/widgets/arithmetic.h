#pragma once

#include <optional>
#include <string_view>

namespace stretch::ui {

/// Reads what people type into a number field: "2.5", "2,5", "x2.5", "250 %" (as 250: the unit is the
/// caller's), sums with + - * / and brackets, and "+=0.5", "-=", "*=", "/=", which go on from the `current`
/// value. Empty when it is none of these, or no finite number comes out.
[[nodiscard]] std::optional<double> typedNumber(std::string_view text, double current);

} // namespace stretch::ui
