#pragma once

#include <string>

#include "app/document.h"

namespace stretch::app {

/// Says what an edit did to pins, grips and props, with frames: "left leg 0 to 9 and 14 to 20, right leg 5 to
/// 15"; what it took the place of is told beside it; of more than three ranges of one limb the first two and
/// how many more. Empty where they are the same.
[[nodiscard]] std::string holdChangeText(const Document& before, const Document& after);

} // namespace stretch::app
