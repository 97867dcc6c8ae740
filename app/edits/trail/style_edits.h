#pragma once

#include <array>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// How far a cartoon stretches its limbs, as lengths over the rest (docs/exaggeration.md, How far
/// cartoons go).
struct Style {
  const char* name;
  double arm;
  double torso; ///< Value for spine and neck.
  double leg;
};

[[nodiscard]] const std::array<Style, 6>& styles();

/// The scale that a style gives to a limb; a chain of the user's is taken for an arm.
[[nodiscard]] double scaleOf(const Style& style, rig::LimbKind kind);

/// Gives each of the trails the scale of its limb.
[[nodiscard]] Result<Document> applyStyle(const Document& document, const std::vector<int>& trailIds,
                                          const Style& style);

/// Whether all of the trails have the scales of the style.
[[nodiscard]] bool hasStyle(const Document& document, const std::vector<int>& trailIds, const Style& style);

} // namespace stretch::app
