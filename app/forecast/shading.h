#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "core/math/bounds.h"

namespace stretch::app {

/// Shading of a clip of a file, as the forecast needs it.
struct ClipLooks {
  int clip = -1;
  Bounds box = {};       ///< Bounds of all drawn vertices, over the frames looked at.
  std::size_t moved = 0; ///< Vertices on joints that scale unequally, or below those, at the frame below;
                         ///< without those whose normals the file does not have: programs compute their own.
  std::size_t wronglyShaded = 0; ///< Those of them that by the plain matrix are, more than 20 degrees off.
  double frame = 0.0;            ///< Frame with the most of them.
  double worstDegrees = 0.0;     ///< At any frame.
  std::string limb = {};         ///< The limb with the most of them; empty: none of the limbs.

  [[nodiscard]] double share() const {
    return moved == 0 ? 0.0 : static_cast<double>(wronglyShaded) / static_cast<double>(moved);
  }
};

/// `document`: the file as it stands. Looks at every frame of a short clip, and at fewer of long clips of
/// large characters.
[[nodiscard]] ClipLooks clipLooks(const Document& document, int clip);

/// The box of what is drawn at rest.
[[nodiscard]] Bounds restBox(const Document& document);

/// The limb that a node is of: a joint, its end, or what hangs on them. Empty: none.
[[nodiscard]] std::string limbOfNode(const Document& document, NodeIndex node);

} // namespace stretch::app
