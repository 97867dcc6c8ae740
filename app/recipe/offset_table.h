#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document.h"
#include "core/base/result.h"
#include "rig/controllers/adjustment.h"

namespace stretch::app {

/// Offset keys as a table of rows, one key each (docs/recipes.md, A table of offset keys): JSON where the
/// file ends with ".json", else CSV. `units`: "limb_lengths" or "metres". Rows of one controller and one
/// range make one adjustment of the clip. Errors name the file and the row, counted as a spreadsheet counts.
[[nodiscard]] Result<std::vector<rig::Adjustment>>
loadOffsetTable(const std::filesystem::path& path, Document& document, int clip, const std::string& units);

} // namespace stretch::app
