#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/state/editor_status.h"
#include "ui/render/view/camera.h"
#include "ui/viewport/camera/look_through.h"
#include "ui/viewport/limb_hover.h"
#include "ui/viewport/shown/shown_controllers.h"
#include "ui/viewport/shown/shown_trails.h"
#include "ui/viewport/shown/tangent_handles.h"
#include "ui/viewport/tip_watch.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

/// Gesture of the mouse in the viewport from press to release.
enum class ViewportGesture {
  none,
  orbit,
  pan,
  zoom,
  pressSphere,
  pressController,
  pressEnd,
  pressMenu,
  pressCube,
  boxSelect
};

/// Place of the messages on show.
struct MessageView {
  std::optional<Rect> figure;    ///< The character's place when the first of them came.
  std::size_t place = 0;         ///< Index among those that there are (drawMessages).
  std::vector<DrawnToast> drawn; ///< In the frame before.
};

/// Memory of the viewport between frames.
struct ViewportState {
  Camera camera;
  ViewportLook look;
  View view;                  ///< View in this frame; pixels are the framebuffer's.
  Rect box;                   ///< The picture's place, window units.
  double pixelsPerUnit = 1.0; ///< Framebuffer pixels per window unit.
  bool hovered = false;       ///< The mouse is over it and nothing lies above.
  bool framePending = false;  ///< Show the whole character in the next frame.
  bool frameSelectionPending = false;
  ShownTrails shown;
  ShownTangents tangents;
  std::vector<ShownController> controllers; ///< Empty while they are not shown.
  NodeIndex weightsOf;                      ///< Joint whose weights are drawn; none: they are not.

  ViewportGesture gesture = ViewportGesture::none;
  Vec2 pressPixels{0.0};
  Vec2 lastPixels{0.0};
  Vec2 mousePixels{0.0};
  std::optional<double> pressedFrame; ///< Sphere that a press took.
  double falloffRadius = 0.0;         ///< Kept from drag to drag, world units.

  // Under the mouse.
  std::optional<HandlePart> hoveredHandle; ///< Handle of the selected controllers.
  std::string hoveredController;           ///< Id; empty: none.
  std::optional<double> hoveredSphere;     ///< Frame, of the selected trail.
  std::optional<std::size_t> hoveredAxis;
  std::optional<std::size_t> hoveredTangent; ///< Place in `tangents`.
  int hoveredTrail = 0;
  std::string hoveredLimb;
  bool hoveredEnd = false; ///< Its hand, foot or head: a drag pulls it.
  NodeIndex hoveredJoint;  ///< That most of the place under the mouse follows.
  LimbHover limbs;
  MessageView messages;
  std::optional<double> tipFrame; ///< Frame whose pose stands as a ghost (tipGhostFrame).
  TipWatch tipWatch;
};

} // namespace stretch::ui
