#pragma once

#include "app/document.h"

namespace stretch::test {

/// Gives a character a left leg of three joints without keys, "left-leg": straight down from its
/// hips, half a unit to each joint, so that it stands all the time on a foot one unit below them.
void addStandingLeg(app::Document& document);

} // namespace stretch::test
