#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/document.h"
#include "app/standing_floor.h"
#include "rig/reach/bind_places.h"
#include "skinning/surface_part.h"

namespace stretch::app {

/// The mesh that follows some nodes, and the lengths of its edges in the bind pose, world units.
struct BoundSurface {
  skinning::SurfacePart part;
  std::vector<double> edgeLengths = {};
};

/// Facts about a clip without any trail that looking at each of its trails needs. Each is worked out when it
/// is first asked for, and once.
class ClipFacts {
public:
  /// The document has to outlive it.
  ClipFacts(const Document& document, int clip);

  [[nodiscard]] const Document& document() const { return document_; }
  [[nodiscard]] int clip() const { return clip_; }
  [[nodiscard]] const std::shared_ptr<const rig::BindPlaces>& places() const { return places_; }

  [[nodiscard]] const StandingFloor& standing();
  /// Height of the lowest joint of the body in the clip and in the bind pose, along +Y. What hangs in the air
  /// without beating wings is measured by it. Nothing for a body without joints.
  [[nodiscard]] std::optional<double> lowestPlace();
  /// Height that no vertex may go below in the clip, along +Y: the floor on which feet stand, or the lowest
  /// vertex where that is higher; without such a floor the lowest of joints, vertices and the bind pose.
  [[nodiscard]] double ground();
  /// Whether a height is below ground() by more than a margin; mostly tells without looking for the ground.
  [[nodiscard]] bool isBelowGround(double height, double margin);
  /// `follows`: indexed by node.
  [[nodiscard]] std::shared_ptr<const BoundSurface> surfaceOf(const std::vector<bool>& follows);

private:
  // The ground if the lowest vertex were at this height.
  [[nodiscard]] double groundOver(double lowestVertex);
  [[nodiscard]] double lowestVertexIn(const FrameState& frame);
  [[nodiscard]] double lowestVertexAtFirst();
  [[nodiscard]] double lowestVertex();

  const Document& document_;
  int clip_ = -1;
  std::shared_ptr<const rig::BindPlaces> places_;
  std::optional<StandingFloor> standing_;
  std::optional<std::optional<double>> lowestPlace_;
  std::optional<skinning::SurfacePart> whole_;
  std::optional<double> lowestAtFirst_; // of the vertices at frame 0
  std::optional<double> lowestVertex_;  // of the clip, and of the bind pose where feet stand on no floor
  std::map<std::vector<bool>, std::shared_ptr<const BoundSurface>> surfaces_;
};

} // namespace stretch::app
