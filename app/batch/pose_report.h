#pragma once

#include <vector>

#include "app/document.h"
#include "core/gltf/json/json_document.h"

namespace stretch::app {

/// Adds to a verb's report what became of adjustments and holds of a clip: "controllers", each with its keys
/// and where it was asked to be and came to, and "holds", each with how far it falls short; to "warnings"
/// what missed its place and which limbs and things flip.
void addPoseReport(const Document& document, int clip, const std::vector<rig::Adjustment>& adjustments,
                   gltf::Json& report);

/// Prints it as lines of text, but for the warnings.
void printPoseReport(const gltf::Json& report);

} // namespace stretch::app
