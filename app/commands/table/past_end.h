#pragma once

#include <string>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// Lists what ends past the end of a clip, such as after keys were taken from its end: "trail of left arm (20
/// to 30)". It is kept, and acts as far as the clip goes.
[[nodiscard]] std::vector<std::string> standingPastEnd(const Document& document, int clip);

} // namespace stretch::app
