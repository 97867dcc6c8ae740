#pragma once

#include <string>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/limb.h"
#include "rig/reach/body_outline.h"
#include "rig/reach/limb_topology.h"

namespace stretch::rig {

/// Strains of a limb with weight at one time.
struct WeightSample {
  double timeSeconds = 0.0;
  /// One for each bone: K - I in the space of the bone's joint, symmetric; zero where nothing gives way. What
  /// it does across the bone need not be the same in all directions.
  std::vector<Mat3> strains;
  double planted = 0.0; ///< 0..1: how much the limb stands on its end and carries the body.
  double kept = 0.0;    ///< 0..1: how much the end keeps its place; 1 wherever it touches the ground.
};

/// How one limb gives way over a clip: linear between the samples, held before and after them.
struct LimbWeight {
  std::string limb;                  ///< Limb::id.
  std::vector<WeightSample> samples; ///< Ascending in time.
  double startSeconds = 0.0;         ///< Outside of the range nothing happens.
  double endSeconds = 0.0;
  double fadeInSeconds = 0.0; ///< Inside the range, at its start and at its end.
  double fadeOutSeconds = 0.0;
};

/// The weight of a limb, ready for evaluation. Without samples: a leg that only keeps its foot in place.
struct SolvedWeight {
  LimbWeight weight;
  Limb limb;
  LimbTopology topology;
  std::vector<NodeIndex> ends; ///< Parts of the hand or foot that have a mesh (BodyOutline).
};

/// The weight at one time, its fades applied; no strains where nothing happens.
[[nodiscard]] WeightSample weightAt(const LimbWeight& weight, double timeSeconds);

/// Lets the limbs of a frame, its trails applied, give way. Each bone is stretched by its K (on top of a
/// trail's: both have the bone as an axis), what hangs on it moves with it, hands and feet keep orientation
/// and size. The hips go up or down along +Y by what the legs that stand lost on average, and everything that
/// hangs on them follows, a leg in the air too: it keeps its bend. A foot that touches the ground keeps its
/// place: its knee bends as far as the leg is bent already, and the leg is turned and scaled as a whole for
/// the rest. Nothing gets lower than the lowest point of the
/// body was: in the air the hips rise instead, a hand is held up. Zero strains change nothing at all.
void applyWeight(const Scene& scene, const std::vector<SolvedWeight>& weights, NodeIndex hips,
                 const BodyOutline& outline, FrameState& frame);

/// Brings the end of a limb that gave way, or whose base did, back to a place: one of two bones bends as far
/// as it is bent already, and is turned and scaled as a whole for the rest.
void bendBack(const Scene& scene, const Limb& limb, const LimbTopology& topology, const Vec3& target,
              FrameState& frame);

} // namespace stretch::rig
