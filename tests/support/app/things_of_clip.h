#pragma once

#include "app/things/thing.h"

namespace stretch::test {

/// The boxer beside a node "Stick", with its punch twice: as clip 0 and as clip 1, frames 0 to 20.
[[nodiscard]] app::Document twoPunches();

/// One thing of each kind that stands in the time of a clip of `twoPunches`, offsets of a controller and of
/// an attribute. `amount`, 0 to 1, tells them from others.
[[nodiscard]] app::Things oneOfEach(int clip, double amount);

} // namespace stretch::test
