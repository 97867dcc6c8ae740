#pragma once

#include <array>
#include <set>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/evidence/symmetry.h"

namespace stretch::rig::body {

/// Part that a joint's name tells beyond a biped's words.
enum class PartWord { leg, arm, wing, fin, feeler, tail, head, ornament, front, back, claw };
inline constexpr std::size_t partWordCount = 11;

/// A row of joints that ends free: what reaches out from the middle of a body, or a part of its middle.
struct Extremity {
  int attach = -1;          ///< Candidate that carries it; -1: none.
  std::vector<int> path;    ///< Candidates, base first; at least one.
  NodeIndex tip;            ///< End joint below the last one that moves nothing itself; -1: none.
  std::vector<Vec3> points; ///< Points of the path, and the tip, or an estimated end, where there is one.
  double length = 0.0;      ///< Along the points.
  double lateral = 0.0;     ///< Mean signed distance from the mirror plane.
  double lowest = 0.0;      ///< Height of its lowest joint or vertex.
  double highest = 0.0;     ///< Height of its highest joint.
  std::array<double, partWordCount> words{}; ///< Share of its joints that are named so.

  [[nodiscard]] double word(PartWord which) const { return words[static_cast<std::size_t>(which)]; }
};

/// Two extremities that mirror each other.
struct ExtremityPair {
  Extremity negative; ///< On the negative side of the plane.
  Extremity positive;
  double mirrorError = 0.0; ///< Mean distance of a point from its counterpart's image, in lengths.

  [[nodiscard]] double length() const { return (negative.length + positive.length) / 2.0; }
  [[nodiscard]] double word(PartWord which) const {
    return (negative.word(which) + positive.word(which)) / 2.0;
  }
};

/// Whether 0.3 of its joints or more are named so.
[[nodiscard]] inline bool isNamed(const ExtremityPair& pair, PartWord word) {
  return pair.word(word) >= 0.3;
}

/// A body taken apart.
struct Extremities {
  std::vector<ExtremityPair> pairs;
  std::vector<Extremity> middle; ///< Rows in the middle of the body, from its topmost joint to a free end.
  double floor = 0.0;            ///< Height of the lowest joint or vertex that the body has.
  double top = 0.0;
};

/// Takes a body apart: what stands on one side of the mirror plane only is traced to its free end, a joint of
/// which several long rows start (the legs of a spider on one anchor) in several; what has no counterpart
/// counts as middle. Heights are along `up`, unit. Where more stands out on a side than a body has limbs, no
/// pair and no middle is told.
[[nodiscard]] Extremities takeApart(const Scene& scene, const BindPose& bindPose, const BodyView& view,
                                    const MirrorPlane& plane, const Vec3& up);

/// The name's own word: of its words, also of those that are written without gaps ("frontleg", "LEFTWING").
[[nodiscard]] std::set<PartWord> partWords(std::string_view name);

} // namespace stretch::rig::body
