#pragma once

#include <string>

#include "app/document.h"

namespace stretch::app {

/// A name as it is kept: what was typed without the white space around it, and not longer than 80 bytes.
[[nodiscard]] std::string keptName(const std::string& typed);

/// Gives a trail a name of its own; white space around it is dropped, and an empty one takes it away.
[[nodiscard]] Result<Document> renameTrail(const Document& document, int trailId, const std::string& name);

/// Renames the group that a trail belongs to; refused for a trail that stands alone.
[[nodiscard]] Result<Document> renameGroup(const Document& document, int trailId, const std::string& name);

} // namespace stretch::app
