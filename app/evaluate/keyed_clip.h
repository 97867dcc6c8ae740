#pragma once

#include "app/document.h"
#include "rig/rekey/rekey.h"

namespace stretch::app {

/// How closely saving keys what is seen (docs/exaggeration.md, What saving writes).
[[nodiscard]] rig::RekeyOptions keyingOptions(const Document& document);

/// The document with its adjustments and holds, those of its trails alone that were applied, and without
/// weight.
[[nodiscard]] Document appliedOnly(Document document);

} // namespace stretch::app
