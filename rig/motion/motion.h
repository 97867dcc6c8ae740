#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rig/adjust/solved_adjustments.h"
#include "rig/limb.h"
#include "rig/motion/solved_holds.h"
#include "rig/reach/bend_normal.h"
#include "rig/reach/body_outline.h"
#include "rig/reach/limb_topology.h"
#include "rig/reach/limb_weight.h"
#include "rig/trail/exaggeration.h"
#include "rig/trail/limb_path.h"
#include "rig/trail/release.h"
#include "rig/trail/sphere_offsets.h"
#include "rig/trail/trail.h"

namespace stretch::rig {

class FrameTable;

/// All of a trail that its original path is made from: on one ground (scene, clip, hips, limbs, adjustments)
/// two trails with one key have one path. Sampling sees nothing else of a trail, so that no setting can be
/// forgotten here.
struct PathKey {
  std::string limb;        ///< Limb::id.
  double startFrame = 0.0; ///< The range, within the clip.
  double endFrame = 0.0;
  Pivot pivot = Pivot::start;
  TrailSpace space = TrailSpace::world;
  Mat3 axes{1.0}; ///< LimbPath::axes.

  friend bool operator==(const PathKey&, const PathKey&) = default;
};

/// A span in which a limb's end keeps its place.
struct Rest {
  double startSeconds = 0.0;
  double endSeconds = 0.0;
  Vec3 place{0.0}; ///< World.
};

/// Times that a path has by its range and by the keys of its limb's joints, whatever moves it then. Seconds.
struct PathTimes {
  std::vector<double> samples; ///< sampleTimes.
  std::vector<double> between; ///< timesBetween.
  std::vector<double> keys;    ///< Times of the keys within the range.
  KeySpacing spacing;
  std::optional<double> nextKeySeconds; ///< secondsToNextKey.
};

/// A trail's original path and all that follows from it alone.
struct OriginalPath {
  PathKey pathKey;
  LimbPath path; ///< Over the range, in world space and in the trail's space.
  BendNormal bend;
  PathTimes times;
  std::vector<double> chosenFrames;       ///< chooseControlFrames.
  std::optional<std::vector<Rest>> rests; ///< restsIn around the range, once a trail on it has a stop.
};

/// One trail of a clip, solved: everything that drawing and evaluating it at any time needs.
struct SolvedTrail : OriginalPath {
  Trail trail;
  TrailSettings settings; ///< Settings in use: range clamped to the clip, scale to its limits.
  Limb limb;
  LimbTopology topology;
  TipSolution tip;                   ///< In the trail's space.
  std::optional<CameraPlace> camera; ///< The camera that judges it, at the tip's time; world space.
  Remap remap{RemapKind::spline, {}, {}};
  SphereOffsets offsets;
  Release release;
  double wantedReleaseSeconds = 0.0; ///< The release where the clip had room for it.
  double calmReleaseSeconds = 0.0;   ///< A shorter one takes the limb back faster than it came.
  double startSeconds = 0.0;         ///< The range.
  double endSeconds = 0.0;
  double tipSeconds = 0.0;
  double windowStartSeconds = 0.0; ///< Range, release and fade: outside nothing moves.
  double windowEndSeconds = 0.0;
  std::vector<double> controlFrames; ///< Frames of the control spheres.
  bool comesToRest = false;          ///< At its stop, on the way back: rig::comesToRest.
  bool active = false;               ///< The character follows it.
  std::vector<std::string> warnings; ///< "not reachable: the limb gets to x of y", ...
};

/// All adjustments and trails of a clip, these in the order in which they act: from the root outwards
/// (order.h). Which of them is meant is said by its place in `trails`.
struct MotionState {
  int clip = -1;
  double framesPerSecond = 30.0;
  double startSeconds = 0.0; ///< Start of the clip: where a release wraps from and to when it loops.
  double endSeconds = 0.0;
  bool loops = false;
  NodeIndex hips;                ///< Node from which the space "root" is measured.
  SolvedAdjustments adjustments; ///< Adjustments of the clip, before any trail.
  /// The clip where its trails look at it, as it is and adjusted; null where nothing is adjusted.
  std::shared_ptr<const FrameTable> sourceFrames;
  std::shared_ptr<const FrameTable> adjustedFrames;
  std::vector<SolvedTrail> trails;
  SolvedHolds holds;                 ///< On top of the trails (setHolds).
  std::vector<SolvedWeight> weights; ///< From the root outwards, on top of the holds (setWeight).
  BodyOutline outline;               ///< Empty without weights.
};

/// Place in MotionState::trails of the trail with this id; empty when it is not there.
[[nodiscard]] std::optional<std::size_t> placeOfTrail(const MotionState& motion, int trailId);

} // namespace stretch::rig
