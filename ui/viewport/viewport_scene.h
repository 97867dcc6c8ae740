#pragma once

#include <string>
#include <vector>

#include "app/session.h"
#include "ui/render/picking/picking.h"
#include "ui/viewport/assemble_picture.h"
#include "ui/viewport/viewport_state.h"

namespace stretch::ui {

// Parts of the session that the viewport shows, picks and frames, as plain values.

/// Returns what is selected, and what lies under the mouse.
[[nodiscard]] PictureSelection selectionOf(const app::Session& session, const ViewportState& viewport);

/// Returns the picture that the window shows of its character.
[[nodiscard]] PictureContent workPicture(app::Session& session, const ViewportState& viewport,
                                         const ViewportOverlays& overlays, const Palette& palette,
                                         const SceneMeasures& measures);

/// The original for comparison beside it.
[[nodiscard]] PictureContent originalPicture(app::Session& session, const ViewportState& viewport,
                                             const ViewportOverlays& overlays, const Palette& palette,
                                             const SceneMeasures& measures);

/// Bones of every limb.
struct LimbBones {
  std::vector<BoneSegment> bones;
  std::vector<std::string> limbOf; ///< Id of the limb of each bone.
};
[[nodiscard]] LimbBones limbBones(const app::Document& document, const FrameState& frame);

/// Returns the box that "frame the selection" shows: limbs, trails and controllers that are selected, else
/// nothing.
[[nodiscard]] Box selectionBox(app::Session& session, const ShownTrails& shown);

/// How far a hand or a foot stands out from where the limb of a trail ends, world units; 0 without the trail.
[[nodiscard]] double fleshRadius(const app::Document& document, int trailId);

/// Yaw from which the character is seen from the front at a clip's first frame.
[[nodiscard]] double facingYaw(const app::Document& document, int clip);

} // namespace stretch::ui
