#pragma once

#include <optional>
#include <vector>

#include "app/document.h"
#include "core/math/bounds.h"
#include "rig/reach/bind_places.h"

namespace stretch::app {

/// Heights that legs stand at in a clip, world units along +Y. Nothing where no leg stands.
struct StandingFloor {
  /// Whether a body with wings is in the air: they beat, seen from where they hang, and clearly below where
  /// the body stands in the bind pose and below its feet, on a quarter of the clip or more, and no foot keeps
  /// its place while its leg's base moves. What only dips or hangs there is not. No leg stands then.
  bool flies = false;
  std::optional<double> floor = {}; ///< Below the end of a leg that stands as far as its sole in the bind
                                    ///< pose; of several legs the lowest.
};

/// `places`: those of the document's scene.
[[nodiscard]] StandingFloor standingFloor(const Document& document, int clip, const rig::BindPlaces& places);

/// Its floor alone.
[[nodiscard]] std::optional<double> floorHeight(const Document& document, int clip);

/// How high the end of a leg is where it stands on the floor. Nothing where no leg stands.
[[nodiscard]] std::optional<double> standingEnd(const Document& document, const rig::Limb& leg,
                                                const rig::BindPlaces& places, const StandingFloor& standing);

/// How high the lowest point of all feet is in the bind pose, along +Y. Nothing where there is no leg.
[[nodiscard]] std::optional<double> soleHeight(const Document& document, const rig::BindPlaces& places);

/// Height of a leg's end above the lowest point of its foot at a frame, along +Y: the boxes around the foot's
/// meshes in the bind pose go along with its nodes. 0 for a leg without a mesh on its foot.
[[nodiscard]] double footDepth(const Scene& scene, const rig::Limb& leg, const rig::BindPlaces& places,
                               const FrameState& frame);

/// Returns what a foot may stand on beside the floor, as boxes in the world: what holds a mesh, stands still
/// in the clip, is not held in it and is no part of the body.
[[nodiscard]] std::vector<Bounds> blocksOf(const Document& document, int clip);

/// How high the top of the highest block under a place is, along +Y. Nothing where there is none.
[[nodiscard]] std::optional<double> blockTopUnder(const std::vector<Bounds>& blocks, const Vec3& place);

/// The plane that a leg does not reach through with its tip at a frame: as far above the floor, or above the
/// block under its foot or that it comes down on soon after, as the ankle is above the lowest point of the
/// foot, which may hang down around there. Nothing where no leg stands in the clip.
[[nodiscard]] std::optional<rig::StopPlane> floorForLeg(const Document& document, int clip,
                                                        const rig::Limb& leg, double tipFrame);
/// Returns it where the scene's places and the clip's standing floor are known.
[[nodiscard]] std::optional<rig::StopPlane> floorForLeg(const Document& document, int clip,
                                                        const rig::Limb& leg, double tipFrame,
                                                        const rig::BindPlaces& places,
                                                        const StandingFloor& standing);

} // namespace stretch::app
