#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/named.h"
#include "app/things/place.h"

namespace stretch::app {

/// Adjustments through the door (app/things/place.h). An adjustment names a controller or an attribute that
/// the character has; its keys stand inside its range and ask only for what the controller can do.
[[nodiscard]] Result<Document> placeAdjustments(const Document& document,
                                                std::span<const rig::Adjustment> wanted,
                                                Entry entry = Entry::request);

/// Takes every adjustment of a controller or an attribute in a clip away.
[[nodiscard]] Document removeAdjustments(const Document& document, const std::string& controller, int clip);

} // namespace stretch::app
