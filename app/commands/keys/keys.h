#pragma once

#include <string>

#include "app/edits/keys/key_edits.h"
#include "app/session.h"

namespace stretch::app {

// Keys that commands of graph and dope sheet act on.

/// Picks keys of the viewed clip; `add`: beside those that are picked.
void pickKeys(Session& session, const KeySelection& selection, bool add);

/// The picked keys; none where others of another clip are.
[[nodiscard]] const KeySelection& pickedKeys(const Session& session);
[[nodiscard]] bool hasPickedKeys(const Session& session);

/// One undo step: "Move 3 keys of left hand" for the verb "Move".
[[nodiscard]] Status editKeys(Session& session, Result<EditedKeys> edited, const std::string& verb);

/// Joints of the selected limbs, or of the selected controllers and their limbs, and with none selected every
/// joint: the rows of their keys.
[[nodiscard]] std::vector<KeyRow> rowsOfSelection(const Session& session);

} // namespace stretch::app
