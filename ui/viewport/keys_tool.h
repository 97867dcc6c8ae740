#pragma once

#include "ui/viewport/tools.h"

namespace stretch::ui {

/// Previews what the tool's modal says, from the document at its beginning.
Status previewKeys(app::Session& session, const KeysTool& tool);

} // namespace stretch::ui
