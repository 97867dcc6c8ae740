#pragma once

#include <string>

#include "ui/panels/context/setting_rows.h"

namespace stretch::ui {

/// A text field for a number or a vector. Empty text stands for the default, which `hint` says (empty: its
/// value and unit); so does text that the setting does not take, and a line below says what it takes.
[[nodiscard]] RowEdit typedControl(PanelContext& context, const std::string& id,
                                   const app::SettingFacts& setting, const gltf::Json& value,
                                   const std::string& hint);

} // namespace stretch::ui
