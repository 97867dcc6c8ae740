#pragma once

#include <cstddef>

#include "skinning/locate/standing_body.h"

namespace stretch::skinning {

/// How many ends a body has: head, hands, feet, tails. An end is what is farther from the middle, by the way
/// inside, than all around it, by at least a fifth of the farthest way.
[[nodiscard]] std::size_t endsOf(const StandingBody& body);

} // namespace stretch::skinning
