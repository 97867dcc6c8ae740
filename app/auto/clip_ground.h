#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/evaluate/clip_facts.h"
#include "core/anim/frame_state.h"

namespace stretch::app {

/// Limbs at one frame, in the order of allLimbs: where each of their points is, the place that stays first.
using LimbPlaces = std::vector<std::vector<Vec3>>;

/// Facts about a clip without new trails that every choice for it is measured against. Of a clip that flies
/// (StandingFloor) all heights that nothing may go below are minus infinity.
struct ClipGround {
  const Document& document; ///< Has to outlive it.
  int clip = 0;
  double framesPerSecond = 30.0;
  double lastFrame = 0.0;   ///< Whole.
  double turnFrames = 0.0;  ///< From its first key to its last one, whole: so much later a loop is where it
                            ///< was.
  bool endsMeet = false;    ///< Its last pose is its first again, or goes on to it.
  bool nearlyMeets = false; ///< Three of four limbs do so, and none is far off.
  bool wraps = false; ///< A way back may go on at its start: it has keys from there on, or holds its first
                      ///< pose for a frame, and nothing hangs on its end.
  std::vector<rig::Limb> limbs = {};
  std::vector<LimbPlaces> places = {};                   ///< One for each whole frame from 0.
  std::map<std::string, std::vector<Vec2>> stands = {};  ///< By leg: first and last frame of standing,
                                                         ///< ascending.
  std::map<std::string, std::vector<Vec2>> slides = {};  ///< `stands`, and where a foot slides while another
                                                         ///< leg stands.
  std::shared_ptr<ClipFacts> facts = {};                 ///< Facts that looking at each of its trails needs.
  double lowestVertex = 0.0;                             ///< Height that no vertex goes below in the clip.
  std::vector<double> lowestVertices = {};               ///< Lowest of each whole frame from 0.
  std::map<std::string, std::vector<double>> soles = {}; ///< By leg: how high its foot is at each whole
                                                         ///< frame.
  double lowest = 0.0;              ///< Height that no point of a limb goes below in the clip.
  std::optional<double> floor = {}; ///< Floor on which feet stand or slide.

  [[nodiscard]] const LimbPlaces& placesAt(double frame) const;
  /// Points of the limb of this id, which is there.
  [[nodiscard]] const std::vector<Vec3>& pointsOf(const std::string& limb, double frame) const;
  /// From the limb's place that stays to the one that leads.
  [[nodiscard]] Vec3 reachOf(const std::string& limb, double frame) const;
  /// The lowest vertex of the mesh as a frame shows it; nothing for a body without one.
  [[nodiscard]] std::optional<Vec3> lowestVertexIn(const FrameState& frame) const;
  /// Height of the lowest vertex at a whole frame of a body that has a mesh.
  [[nodiscard]] double lowestVertexAt(double frame) const;
  /// Height that no vertex may go below at a whole frame: the floor on which feet stand, or what the clip
  /// itself has below it there; the clip's lowest place where there is no such floor, or a lower one.
  [[nodiscard]] double leastHeightAt(double frame) const;
  /// Height of the floor on which feet stand, or of the lowest vertex where that is higher or there is none.
  [[nodiscard]] double groundHeight() const { return std::max(lowestVertex, floor.value_or(lowestVertex)); }
  /// The frame of a loop at which it is as at this one, a turn later. The pose before its first key is that
  /// of its first key.
  [[nodiscard]] double aTurnLater(double frame) const {
    return std::max(frame, lastFrame - turnFrames) + turnFrames;
  }
  /// Takes its last pose to go on to its first.
  void closeLoop();
  [[nodiscard]] const std::vector<Vec2>& standsOf(const std::string& leg, bool orSlides = false) const;
};

[[nodiscard]] ClipGround clipGround(const Document& document, int clip);

/// Height of the lowest of all points.
[[nodiscard]] double lowestOf(const LimbPlaces& places);

/// From the place that stays to the one that leads.
[[nodiscard]] double straightLength(const std::vector<Vec3>& points);

[[nodiscard]] LimbPlaces placesOf(const std::vector<rig::Limb>& limbs, const FrameState& frame);

} // namespace stretch::app
