#pragma once

#include <filesystem>

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// Beside the list of a file dialog: what the chosen file holds, before it is opened. An empty path: how to
/// choose one.
void fileFacts(PanelContext& context, const std::filesystem::path& path);

} // namespace stretch::ui
