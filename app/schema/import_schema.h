#pragma once

#include "app/schema/import_settings.h"
#include "app/schema/schema.h"

namespace stretch::app {

/// The settings of clips that come in from other files.
[[nodiscard]] const Schema<ImportSettings>& importSchema();

} // namespace stretch::app
