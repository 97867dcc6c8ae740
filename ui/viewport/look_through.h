#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/document.h"
#include "core/anim/frame_state.h"
#include "ui/render/view/camera_view.h"

namespace stretch::ui {

struct ViewportState;

/// A view that is kept under a number.
struct ViewBookmark {
  Camera camera;
  std::string through = {}; ///< Name of the file's camera that is looked through instead; empty: none.

  friend bool operator==(const ViewBookmark&, const ViewBookmark&) = default;
};

/// The views that the user keeps, with the file's settings.
using ViewBookmarks = std::array<std::optional<ViewBookmark>, 9>;

/// A camera of the file in a frame of the document, to be looked through; nothing where its node is squashed
/// flat.
[[nodiscard]] std::optional<ThroughCamera> throughCamera(const app::Document& document,
                                                         const SceneCamera& camera, const FrameState& frame);

/// Takes the view's own camera to where the file's camera stands, and looks through it no longer: what the
/// hand moves is never the file's.
void lookFreely(ViewportState& viewport);

/// The lens that the viewport looks through, in words: "Side, perspective, 39 mm".
[[nodiscard]] std::string lensText(const ViewportState& viewport);

} // namespace stretch::ui
