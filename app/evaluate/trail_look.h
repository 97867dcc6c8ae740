#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/evaluate/clip_facts.h"
#include "app/evaluate/quality.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// The frames that are out of bounds in one respect, and the worst of them.
struct Finding {
  double first = -1.0;
  double last = -1.0;
  double worst = 0.0;
  double worstFrame = 0.0;
  double worstBadness = 0.0;

  void add(double frame, double value, double badness);
  [[nodiscard]] bool any() const { return first >= 0.0; }
  /// "at frame 3", "at frames 3 to 9 (worst at 5)".
  [[nodiscard]] std::string frames() const;
};

/// Findings that an animator would stumble over when playing one trail.
struct Findings {
  Finding lengths;  ///< The limb over its source length.
  Finding turns;    ///< Radians between where it points and where it did.
  Finding vertices; ///< World units from a vertex to its place in the source.
  Finding swings;   ///< Likewise where the limb's end itself goes as far: less than at the tip.
  Finding jumps;    ///< World units by which the end jumps within a frame where it stops.
  Finding edges;    ///< An edge of the mesh over its length.
  Finding elbows;   ///< World units of an arm's joint above the head.
  Finding ends;     ///< World units of the limb's end below the floor.
  Finding lows;     ///< World units of the limb below all that the body has in the clip.
  Finding floors;   ///< World units of the mesh below the floor, or below all that the body has in the clip.
  Finding bends;    ///< Radians by which a joint bends the other way.
  double tipDisplacement = 0.0;

  [[nodiscard]] std::array<const Finding*, 11> each() const {
    return {&lengths, &turns, &vertices, &swings, &jumps, &edges, &elbows, &ends, &lows, &floors, &bends};
  }

  [[nodiscard]] bool any() const;
  [[nodiscard]] double firstFrame() const; ///< First frame of all findings.
  [[nodiscard]] double lastFrame() const;
  [[nodiscard]] std::vector<double> worstFrames() const; ///< One for each respect that something is found in.
};

/// All that looking at one trail needs beside the trail's settings: made once, and used again for every
/// remedy that is tried.
class TrailLook {
public:
  TrailLook(std::shared_ptr<ClipFacts> facts, const rig::SolvedTrail& trail, LookAt what);

  /// `alone`: a motion of the one trail, with these or other settings.
  [[nodiscard]] Findings findings(const rig::MotionState& alone) const;
  /// A frame where that motion has any, none where it has not; `likely` frames are looked at first.
  [[nodiscard]] std::optional<double> foundAt(const rig::MotionState& alone,
                                              const std::vector<double>& likely) const;
  /// Whether a node's place depends on the trail.
  [[nodiscard]] const std::vector<bool>& moved() const { return moved_; }

  /// Lowest place of the body in the clip and in the bind pose, where no floor is known for the limb's end.
  [[nodiscard]] std::optional<double> lowestPlace() const { return lowestPlace_; }
  [[nodiscard]] const std::shared_ptr<ClipFacts>& facts() const { return facts_; }

private:
  class Walk;

  // The ellipsoid in the box around the head's mesh in the bind pose.
  struct Head {
    NodeIndex joint;
    Mat4 fromBind{1.0}; // world of the bind pose to the joint's space
    Vec3 centre{0.0};
    Vec3 half{0.0};
    double aboveHips = 0.0; // in the bind pose

    /// Height of its highest point.
    [[nodiscard]] double top(const Mat4& jointWorld) const;
  };

  void findHead();

  std::shared_ptr<ClipFacts> facts_;
  std::vector<bool> moved_;
  std::shared_ptr<const BoundSurface> surface_; // null: the limb alone is looked at
  std::vector<NodeIndex> nodes_;
  std::optional<Head> head_;
  std::optional<double> lowestEnd_;
  std::optional<double> lowestPlace_;
};

} // namespace stretch::app
