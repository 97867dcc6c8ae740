#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// One control sphere and how far it is pulled further: world units along the axes of the trail's space.
struct SphereMove {
  double frame = 0.0;
  Vec3 delta{0.0};
};

/// Adds each delta to the offset that its sphere has. A sphere whose offset becomes nothing is as if never
/// pulled. With follow on the character is connected, so that it follows; with follow off it is disconnected
/// until the user connects it (docs/exaggeration.md, Control spheres). Makes the exaggerated copy where there
/// is none.
[[nodiscard]] Result<Document> moveSpheres(const Document& document, int trailId,
                                           std::span<const SphereMove> moves);

/// Takes the offsets and tangents at these frames back.
[[nodiscard]] Result<Document> clearSpheres(const Document& document, int trailId,
                                            std::span<const double> frames);

/// Sets one sphere's offset outright.
[[nodiscard]] Result<Document> setSphereOffset(const Document& document, int trailId,
                                               const rig::SphereOffset& offset);

/// Gives a sphere the slope of its offset, world units for each frame along the axes of the trail's space;
/// nothing: from its neighbours again. As with a move the character follows.
[[nodiscard]] Result<Document> setSphereTangent(const Document& document, int trailId, double frame,
                                                const std::optional<Vec3>& tangent);

/// Takes spheres away, offsets and all. `present` are the trail's spheres as they are shown; the first and
/// the last of them stay and are put back instead.
[[nodiscard]] Result<Document> removeSpheres(const Document& document, int trailId,
                                             std::span<const double> present, std::span<const double> frames);

/// The control spheres that the user chose by hand; empty: chosen from the keys again. Sorted, doubles
/// dropped.
[[nodiscard]] Result<Document> setControlFrames(const Document& document, int trailId,
                                                std::vector<double> frames);

/// A world vector along the axes of the trail's space, as offsets are stored.
[[nodiscard]] Vec3 toTrailAxes(const rig::TrailSettings& settings, const Vec3& worldVector);

/// A control sphere as it stands in the world.
struct PlacedSphere {
  double frame = 0.0;
  Vec3 positionWorld{0.0};
};

/// The moves of a pull with soft falloff: the selected spheres take the whole delta (world), the others
/// within `radiusWorld` of a selected one a share of it, (1 - (d/r)^2)^2. Radius 0 moves the selected ones
/// only.
[[nodiscard]] std::vector<SphereMove> softMoves(const rig::TrailSettings& settings,
                                                std::span<const PlacedSphere> spheres,
                                                std::span<const double> selectedFrames,
                                                const Vec3& deltaWorld, double radiusWorld);

} // namespace stretch::app
