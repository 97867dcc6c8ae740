#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/styles/style.h"

namespace stretch::app {

/// Gives each of the trails what the style says of its limb (docs/styles.md); range, space and spheres stay.
[[nodiscard]] Result<Document> applyStyle(const Document& document, const std::vector<int>& trailIds,
                                          const rig::Style& style);

/// Whether all of the trails are as the style has them.
[[nodiscard]] bool hasStyle(const Document& document, const std::vector<int>& trailIds,
                            const rig::Style& style);

/// The style that the exaggerated trails of a clip show, with the weight of the limb that has most of it. An
/// empty name becomes that of the clip. An error where the clip has none.
[[nodiscard]] Result<rig::Style> styleOfClip(const Document& document, int clip, const std::string& name);

} // namespace stretch::app
