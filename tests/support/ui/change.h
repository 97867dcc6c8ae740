#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/session.h"
#include "ui/panels/state/ui_state.h"
#include "ui/widgets/item_registry.h"

namespace stretch::test {

/// Everything that a step of the user could change, as lines: each with how often it is there.
using Lines = std::map<std::string, int>;

/// The work that files would keep, without the limbs, and what is looked at: clip, playhead, selection,
/// ranges and picked keys.
void addSession(Lines& lines, const app::Session& session);
/// What settings remember of the view, and answers that dialogs gave.
void addView(Lines& lines, const ui::UiState& ui);
/// Widgets that are drawn, and which of them are off.
void addWidgets(Lines& lines, const ui::ItemRegistry& items);

/// What is there after a step and was not before ("+"), and what is gone ("-"); of many, the first `most` and
/// how many more.
[[nodiscard]] std::string changeText(const Lines& before, const Lines& after, int most);

} // namespace stretch::test
