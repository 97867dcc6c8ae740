#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/document.h"
#include "core/anim/frame_state.h"
#include "ui/render/scene/backdrop_pass.h"
#include "ui/render/view/camera_view.h"
#include "ui/render/view/view_cube.h"

namespace stretch::ui {

/// A view that is kept under a number.
struct ViewBookmark {
  Camera camera;
  std::string through = {}; ///< Name of the file's camera that is looked through instead; empty: none.

  friend bool operator==(const ViewBookmark&, const ViewBookmark&) = default;
};

/// The views that the user keeps, with the file's settings.
using ViewBookmarks = std::array<std::optional<ViewBookmark>, 9>;

/// From where the viewport looks, beside its own camera.
struct ViewportLook {
  std::string name = {};                     ///< Camera of the file that is looked through; empty: none.
  std::optional<ThroughCamera> through = {}; ///< It, where it stands at the playhead.
  ViewBookmarks kept = {};
  double facingYawRadians = 0.0; ///< The quarter turn nearest to where the character faces at the clip's
                                 ///< start.
  std::optional<Backdrop> reference = {};   ///< Image of the clip's reference at the playhead.
  std::optional<CubePart> hoveredPart = {}; ///< Part of the view cube under the mouse.
};

/// A camera of the file in a frame of the document, to be looked through; nothing where its node is squashed
/// flat.
[[nodiscard]] std::optional<ThroughCamera> throughCamera(const app::Document& document,
                                                         const SceneCamera& camera, const FrameState& frame);

/// Takes the view's own camera to where the file's camera stands, and looks through it no longer: what the
/// hand moves is never the file's.
void lookFreely(ViewportLook& look, Camera& camera);

/// The lens that is looked through, in words: "Side, perspective, 39 mm".
[[nodiscard]] std::string lensText(const ViewportLook& look, const Camera& camera);

} // namespace stretch::ui
