#pragma once

#include <span>
#include <string>
#include <vector>

#include "skinning/locate/creature/body_branches.h"

namespace stretch::skinning {

enum class CreaturePart { leg, arm, wing, feeler, spine, neck, tail };

/// The line that the bones of a limb follow, from its base to its tip.
struct CreatureLimb {
  CreaturePart part = CreaturePart::leg;
  int side = 0; ///< 1: on the body's left, -1: on its right, 0: in its middle.
  int row = 0;  ///< Row of a leg, from front to back: 1 is the first.
  std::vector<Vec3> line;
  double confidence = 0.8;
};

/// Limbs and stance that a mesh shows: in the body's own space (Upright::toBody), or in the scene's.
struct CreatureShape {
  std::vector<CreatureLimb> limbs;
  int legRows = 0;          ///< Pairs of legs that it stands on.
  bool trunkLies = false;   ///< The way from its legs to its head goes forward rather than up.
  bool trunkStands = false; ///< That way goes up. Neither: it is not clear.
};

/// Reads a body by its shape: which ends of it touch the ground in pairs, what lies before and behind them,
/// and what else reaches out on both sides. `legRows`: how many pairs of legs it has, the longest are taken;
/// 0: as many as stand.
[[nodiscard]] CreatureShape creatureShape(const StandingBody& body, int legRows);

/// Reads a mesh in the same way, in the scene's space. Error: what standingIn() refuses.
[[nodiscard]] Result<CreatureShape> shapeOfMesh(std::span<const Vec3> positions,
                                                const std::vector<Triangle>& triangles, int legRows,
                                                UpAxis up, const Proceed& proceed);

} // namespace stretch::skinning
