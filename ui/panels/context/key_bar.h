#pragma once

#include <functional>
#include <string>

#include "app/edits/keys/key_edits.h"
#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

using PickedChange = std::function<Result<app::EditedKeys>(const app::Document&, const app::KeySelection&)>;

/// One frame of a gesture on the picked keys, as they were when it began; they stay picked where they come to
/// stand. `verb` opens the name of the undo step.
void editPicked(PanelContext& context, const EditPhase& phase, const std::string& verb,
                const PickedChange& change);

/// Draws what can be done with the picked keys, in one row: their frame and value as numbers, tangents, and,
/// unless `keysAlone`, retiming.
void drawKeyBar(PanelContext& context, bool keysAlone);

/// Keeps in mind which keys are picked at this place of the history, and lets go of them when something else
/// has been selected: once a frame.
void followPicks(TimePanes& time, app::Session& session);

/// Picks what was picked when the document was last as it is now, where the same was selected: after undo and
/// redo.
void bringBackPicks(const TimePanes& time, app::Session& session);

void drawRetimeDialog(PanelContext& context);

} // namespace stretch::ui
