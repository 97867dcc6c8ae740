#pragma once

#include <string>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// Gives a limb weight in a clip, or changes it. Errors: no such limb or clip, numbers that are not finite, a
/// range without length.
[[nodiscard]] Result<Document> setWeight(const Document& document, const WeightedLimb& wanted);

/// Takes the weight of a limb in a clip away; the clip is then as it was without it.
[[nodiscard]] Document removeWeight(const Document& document, const std::string& limb, int clip);

/// Turns the weight of limbs on or off in a clip; limbs that have none get what is usual for them
/// (starting_settings.h) when it is on.
[[nodiscard]] Result<Document> switchWeight(const Document& document, const std::vector<std::string>& limbs,
                                            int clip, bool on);

} // namespace stretch::app
