#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/document.h"
#include "app/standing_floor.h"
#include "rig/reach/bind_places.h"
#include "skinning/long_edges.h"
#include "skinning/surface_part.h"

namespace stretch::app {

/// The mesh that follows some nodes, and its edges beside the bind pose.
struct BoundSurface {
  static constexpr double visibleLength = 5e-3; ///< Share of the height: a shorter edge is not seen to be
                                                ///< torn.

  skinning::SurfacePart part;
  skinning::LongEdges edges;

  /// `follows`: indexed by node; `height`: of the body.
  BoundSurface(const Scene& scene, const std::vector<bool>& follows, double height);
};

/// Facts about a character, whatever it does, that looking at trails needs. Each is worked out when it is
/// first asked for, and once.
class CharacterFacts {
public:
  explicit CharacterFacts(const Document& document);

  [[nodiscard]] const std::shared_ptr<const rig::BindPlaces>& places() const { return places_; }
  /// All of the mesh.
  [[nodiscard]] const skinning::SurfacePart& whole();
  /// `follows`: indexed by node.
  [[nodiscard]] std::shared_ptr<const BoundSurface> surfaceOf(const std::vector<bool>& follows);

private:
  std::shared_ptr<const Scene> scene_;
  double height_ = 0.0;
  std::shared_ptr<const rig::BindPlaces> places_;
  std::optional<skinning::SurfacePart> whole_;
  std::map<std::vector<bool>, std::shared_ptr<const BoundSurface>> surfaces_;
};

/// Facts about a clip without any trail that looking at each of its trails needs. Each is worked out when it
/// is first asked for, and once.
class ClipFacts {
public:
  /// The document has to outlive it. `character`: of that document; null: its own.
  ClipFacts(const Document& document, int clip, std::shared_ptr<CharacterFacts> character = {});

  [[nodiscard]] const Document& document() const { return document_; }
  [[nodiscard]] int clip() const { return clip_; }
  [[nodiscard]] CharacterFacts& character() { return *character_; }
  [[nodiscard]] const std::shared_ptr<const rig::BindPlaces>& places() const { return character_->places(); }

  [[nodiscard]] const StandingFloor& standing();
  /// Height of the lowest joint of the body in the clip and at rest, along +Y. What hangs in the air
  /// without beating wings is measured by it. Nothing for a body without joints.
  [[nodiscard]] std::optional<double> lowestPlace();
  /// Height that no vertex may go below in the clip, along +Y: the floor on which feet stand, or the lowest
  /// vertex where that is higher; without such a floor the lowest of joints and vertices, at rest as well.
  [[nodiscard]] double ground();
  /// Height that ground() is not above, told without looking at the whole clip.
  [[nodiscard]] double groundAtMost() { return groundOver(lowestVertex_.value_or(lowestVertexAtFirst())); }

private:
  // The ground if the lowest vertex were at this height.
  [[nodiscard]] double groundOver(double lowestVertex);
  // Returns the lower of what was found before and the lowest vertex in a frame.
  [[nodiscard]] double lowestVertexIn(const FrameState& frame, double before);
  [[nodiscard]] double lowestVertexAtFirst();
  [[nodiscard]] double lowestVertex();

  const Document& document_;
  int clip_ = -1;
  std::shared_ptr<CharacterFacts> character_;
  std::optional<StandingFloor> standing_;
  std::optional<std::optional<double>> lowestPlace_;
  std::optional<double> lowestAtFirst_; // of the vertices at frame 0
  std::optional<double> lowestVertex_;  // of the clip, and at rest where feet stand on no floor
};

} // namespace stretch::app
