#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/mesh_sequence.h"
#include "rig/retarget/skeleton.h"

namespace stretch::app {

/// How near each hand of a character is to its trunk and head, and to the other hand, world units; nothing
/// where one of the two has no surface.
struct HandDistances {
  std::array<std::optional<double>, 2> toTrunk; ///< Left hand, right hand.
  std::optional<double> toOther;
};

/// How much of a character's forearms, hands, shins and feet is inside its trunk and head.
struct Inside {
  double share = 0.0;                ///< Part of their vertices.
  double deepest = 0.0;              ///< World units.
  std::optional<double> heldDeepest; ///< Depth of what the hands hold; nothing: they hold nothing.
};

/// The surface of a biped in parts, for what touches what. Vertices of large surfaces are looked at in even
/// steps: at most 600 of forearms to feet and of what is held, 150 of each hand.
class BodyTouch {
public:
  explicit BodyTouch(const rig::Skeleton& skeleton);

  /// Whether both trunk and limbs are shown at all.
  [[nodiscard]] bool hasSurface() const { return !trunk_.empty() && !limbVertices_.empty(); }

  [[nodiscard]] HandDistances handsAt(const FrameState& frame) const;
  [[nodiscard]] Inside insideAt(const FrameState& frame) const;

private:
  const Scene& scene_;
  std::vector<Triangle> trunk_; ///< With those that reach over to upper arms and thighs.
  std::vector<std::size_t> limbVertices_;
  std::vector<std::size_t> heldVertices_;
  std::array<std::vector<std::size_t>, 2> handVertices_;
  std::array<std::vector<Triangle>, 2> hands_;
};

} // namespace stretch::app
