#pragma once

#include "app/document.h"
#include "core/base/result.h"
#include "rig/body/locators.h"

namespace stretch::app {

/// The document with joints made at the locators, appended to its file as nodes: what the file has is not
/// changed, no vertex follows them yet (docs/from_a_mesh.md). Its limbs are those that are found on them. The
/// locators stay with the document. Error, one line: a locator that the plan needs is missing, or the
/// character has limbs already.
[[nodiscard]] Result<Document> withRigAt(const Document& document, const rig::Locators& locators);

/// The document whose limbs go by the joints that are nearest to locators that were moved; no joint is made.
/// Locators where the limbs are leave them alone. Error: joints that are no chain, which it names.
[[nodiscard]] Result<Document> withLimbsAt(const Document& document, const rig::Locators& locators);

} // namespace stretch::app
