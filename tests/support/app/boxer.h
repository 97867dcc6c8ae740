#pragma once

#include "app/document.h"

namespace stretch::test {

/// A small character in code: hips, two arms of three joints along +-X and a punch of the left arm. 30 frames
/// a second, frames 0 to 20, keys of the left arm at 0, 5, 10 and 20; the right arm rests. Limbs "left-arm",
/// "right-arm", "spine".
[[nodiscard]] app::Document boxer();

} // namespace stretch::test
