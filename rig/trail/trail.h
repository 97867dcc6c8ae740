#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/math/types.h"
#include "core/scene/camera.h"

namespace stretch::rig {

/// The end of the range that stays where it is; the other one is the tip.
enum class Pivot { start, end };
/// Space in which exaggeration is computed (docs/exaggeration.md, Spaces). `view` uses the axes stored with
/// the trail.
enum class TrailSpace { world, root, base, view };
/// Length that the scale multiplies: the limb's length in the pose at the tip, or its rest length.
enum class Reference { pose, rest };
enum class RemapKind { spline, linear };
/// How the limb gets to its target: the bent shape grown and turned as one, or straightened first as IK does.
enum class Bend { keep, straighten };

/// One end of the transition's remap curve (docs/exaggeration.md, Remap and ease). percent 0 is off.
struct Ease {
  double percent = 0.0; ///< Fraction in [0, 1).
  double value = 0.0;   ///< Ease-in in [0, 0.5], ease-out in [0.5, 1].

  friend bool operator==(const Ease&, const Ease&) = default;
};

/// A control sphere that was pulled or turned: the path's offset at that frame (docs/exaggeration.md, Control
/// spheres).
struct SphereOffset {
  double frame = 0.0;
  Vec3 offset{0.0};                 ///< World units, along the axes of the trail's space.
  std::optional<Vec3> tangent = {}; ///< Slope of the offset there, the same units for each frame; empty: from
                                    ///< the neighbours.

  friend bool operator==(const SphereOffset&, const SphereOffset&) = default;
};

/// "Up to the second ledge and not past it" (docs/exaggeration.md, The target): the limb's end is not carried
/// past this plane.
struct StopPlane {
  Vec3 point{0.0};  ///< World.
  Vec3 normal{0.0}; ///< World, points to the side that the limb may not enter; need not be a unit vector.

  friend bool operator==(const StopPlane&, const StopPlane&) = default;
};

/// How a trail is seen by a camera, and what follows from that (docs/exaggeration.md, As the camera sees it).
struct Sight {
  bool asSeen = false;   ///< The scale counts in the limb's length in the camera's picture.
  bool keepDepth = true; ///< Then the path grows parallel to the picture.
  std::string camera; ///< Name of a camera of the file, or of a standard view (standardView); empty: `view`.
  double turnDegrees = 0.0; ///< So far at most the path is turned about the limb's base, for more of it to be
                            ///< seen, where the scale does not count as seen.
  std::optional<CameraPlace> view; ///< A view kept with the trail, world space; counts without `camera`.

  [[nodiscard]] bool hasCamera() const { return !camera.empty() || view.has_value(); }
  friend bool operator==(const Sight&, const Sight&) = default;
};

inline constexpr double freeTurnDegrees = 180.0; ///< A turn limit that limits nothing.
inline constexpr double smallestScale = 0.05;    ///< Smaller wishes are taken as this.
inline constexpr double largestScale = 5.0; ///< Largest scale that the interface offers; batch takes more.

/// Everything that shapes an exaggerated trail. Frames are the clip's (docs/exaggeration.md, Words).
struct TrailSettings {
  double startFrame = 0.0;
  double endFrame = 0.0;
  double scale = 1.0;                         ///< S: length of the limb at the tip over its reference length.
  std::array<bool, 3> axes{true, true, true}; ///< Active axes x, y, z of the trail's space.
  Pivot pivot = Pivot::start;
  TrailSpace space = TrailSpace::world;
  Mat3 viewAxes{1.0}; ///< Columns: right, up, towards the viewer, in world space; for `view`.
  Reference reference = Reference::pose;
  Bend bend = Bend::keep;
  RemapKind remap = RemapKind::spline;
  Ease easeIn{0.0, 0.1};
  Ease easeOut{0.0, 0.9};
  double stretchSwitch = 1.0;          ///< 0..1: how much of the wanted length the limb takes on.
  double volume = 1.0;                 ///< 0..1: volume preservation.
  std::optional<double> releaseFrames; ///< Empty: to the next key or a third of the range
                                       ///< (docs/exaggeration.md, Release).
  double lingerFrames = 0.0;           ///< Of the release: the tip keeps its whole offset for so long.
  double overshoot = 0.0; ///< 0..1: how far past the original the release swings, part of the tip's offset.
  bool pull = true;       ///< Straight to the length that the line of the path misses.
  double turnLimitDegrees = freeTurnDegrees; ///< 0..180: so far at most the walk to the tip turns the limb
                                             ///< about its base; beyond that it is pulled.
  double blend = 2.0;                        ///< 0 original, 1 half-way, 2 exaggerated.
  bool stayInWorld = false;                  ///< Does not ride along with an inner trail.
  bool turnEnd = false; ///< The hand or foot turns with the limb instead of keeping its orientation.
  std::optional<StopPlane> stopAt;
  Sight sight;
  std::vector<SphereOffset> spheres; ///< Ordered by frame, at most one for each frame.

  friend bool operator==(const TrailSettings&, const TrailSettings&) = default;
};

/// Frame of the range's end that does not stay where it is: where the limb reaches farthest.
[[nodiscard]] inline double tipFrameOf(const TrailSettings& settings) {
  return settings.pivot == Pivot::start ? settings.endFrame : settings.startFrame;
}

/// A limb's trail in one clip, as the user made it.
struct Trail {
  int id = 0;       ///< Stable within a document.
  std::string limb; ///< Limb::id.
  int clip = 0;     ///< Index into the file's animations.
  TrailSettings settings;
  bool exaggerated = false; ///< An exaggerated copy exists beside the original path.
  bool connected = false;   ///< The character follows the exaggerated copy.
  bool applied = false;     ///< The artist is done with it: connected, and quiet until it is
                            ///< changed. Saving does not ask.
  int colour = 0;           ///< Index into the palette of trails.
  bool visible = true;
  bool pinned = false; ///< Drawn even when its limb is not selected.
  /// Control spheres that the user set by hand, as frames; empty: chosen from the keys (docs/exaggeration.md,
  /// Control spheres).
  std::vector<double> controlFrames;
  bool follow = true;    ///< The character follows while a sphere is dragged.
  std::string name;      ///< The user's own; empty: the limb's.
  int group = 0;         ///< Trails of one number (above 0) were made as one; 0: stands alone.
  std::string groupName; ///< The user's own for the group, the same in all of its trails; empty: their limbs.

  friend bool operator==(const Trail&, const Trail&) = default;
};

} // namespace stretch::rig
