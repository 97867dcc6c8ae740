#pragma once

#include "app/document.h"

namespace stretch::app {

/// A pin for every stretch of time within these frames in which a foot stands, at the place where it stands
/// in the middle of it (docs/holds.md, Planted feet). As the adjusted clip has the feet, whatever trails make
/// of them. The clip must be there.
[[nodiscard]] rig::Holds plantedFeet(const Document& document, int clip, const Vec2& frames);

} // namespace stretch::app
