#pragma once

#include <string>

#include "app/document.h"
#include "app/selection.h"

namespace stretch::app {

/// Returns what the character has of a set, by the set's name.
[[nodiscard]] SelectionSet presentIn(const Document& document, const SelectionSet& set);

/// Returns the set of which the character has just what is selected, in any order; null where there is none.
[[nodiscard]] const SelectionSet* setOfSelection(const Document& document, const Selection& selection);

/// Keeps the selected limbs or controllers as a set of this name, which is not empty; with a number behind it
/// where a set has that name. An error where nothing is selected, and where a set holds just that.
[[nodiscard]] Result<Document> keepSelectionSet(const Document& document, const Selection& selection,
                                                const std::string& name);

/// Gives a set another name, as keptName has it. An error where there is no such set, or another one has the
/// new name; empty names too.
[[nodiscard]] Result<Document> renameSelectionSet(const Document& document, const std::string& name,
                                                  const std::string& newName);

/// The document without the set of this name.
[[nodiscard]] Document removeSelectionSet(Document document, const std::string& name);

} // namespace stretch::app
