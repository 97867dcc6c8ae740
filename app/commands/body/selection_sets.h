#pragma once

#include "app/session.h"

namespace stretch::app {

/// Selects what a set holds and the character has; with `add` beside what is selected, where that is of the
/// same kind.
void selectSet(Session& session, const SelectionSet& set, bool add);

} // namespace stretch::app
