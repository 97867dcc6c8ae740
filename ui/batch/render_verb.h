#pragma once

#include "app/batch/verb.h"

namespace stretch::ui {

/// `render`: pictures of a file without a display.
[[nodiscard]] app::Verb renderVerb();

} // namespace stretch::ui
