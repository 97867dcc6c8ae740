#pragma once

#include <string>
#include <vector>

#include "app/session.h"
#include "ui/panels/ui_state.h"
#include "ui/render/bounds.h"
#include "ui/render/overlay.h"
#include "ui/render/palette.h"
#include "ui/render/picking.h"
#include "ui/render/scene_renderer.h"
#include "ui/viewport/viewport_state.h"

namespace stretch::ui {

// What the viewport shows, as plain values made from the session.

/// Makes `shown` again where the document's trails differ from what it was made from.
void updateShownTrails(app::Session& session, ShownTrails& shown);

/// Null when it is not shown.
[[nodiscard]] const ShownTrail* findShown(const ShownTrails& shown, int trailId);

/// Whether a trail is drawn: visible, and pinned, selected, or everything is.
[[nodiscard]] bool isDrawn(const app::Session& session, const ViewportOverlays& overlays,
                           const rig::Trail& trail);

/// The exaggerated path at a frame, or the original where there is none.
[[nodiscard]] Vec3 pointOnTrail(const ShownTrail& trail, double frame, bool exaggerated);

/// Axis handles at the last selected sphere; nothing when none is selected.
[[nodiscard]] std::optional<AxisHandles> handlesOf(const app::Session& session, const ShownTrails& shown);

/// Bones of every limb, each with the limb's index in `limbIds`.
struct LimbBones {
  std::vector<std::string> limbIds;
  std::vector<BoneSegment> bones; ///< `node` is the index into limbIds.
};
[[nodiscard]] LimbBones limbBones(const app::Document& document, const FrameState& frame);

/// 1 for the joints of selected limbs, less for the hovered limb.
[[nodiscard]] std::vector<float> highlightOf(const app::Session& session, const std::string& hoveredLimb);

/// Trails, skeleton and handles over the character.
[[nodiscard]] Overlay overlayOf(app::Session& session, const UiState& ui, const ViewportState& viewport,
                                const FrameState& frame, const Palette& palette);

/// The character at the frames around the playhead.
[[nodiscard]] std::vector<Ghost> ghostsOf(app::Session& session, const ViewportOverlays& overlays);

/// What "frame the selection" shows: limbs and trails that are selected, else nothing.
[[nodiscard]] Box selectionBox(app::Session& session, const ShownTrails& shown);

/// Yaw from which the character is seen from the front at a clip's first frame.
[[nodiscard]] double facingYaw(const app::Document& document, int clip);

/// A colour of the theme (Dear ImGui's packed sRGB) as shaders take it.
[[nodiscard]] glm::vec4 toColour(std::uint32_t colour);

} // namespace stretch::ui
