#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "ui/render/overlay/controller_drawing.h"
#include "ui/render/overlay/overlay.h"
#include "ui/render/overlay/trail_drawing.h"
#include "ui/render/picking/picking.h"
#include "ui/render/picture/controller_handles.h"
#include "ui/render/scene/scene_renderer.h"

namespace stretch::ui {

/// A trail of a picture, and how it looks.
struct StyledTrail {
  TrailPicture path;
  TrailStyle style;
};

/// Content that is drawn of a scene at one moment, wherever the camera stands.
struct PictureContent {
  FrameState frame = {};
  std::function<SceneShape()> shape = {}; ///< Asked for when the picture is drawn; empty: the scene's own.
  std::vector<Ghost> ghosts = {};         ///< The farthest in time first.
  SceneStyle style = {};
  Overlay bones = {};    ///< Bones of a mesh sequence, drawn as they are.
  bool skeleton = false; ///< Bones over the mesh, always where there is none; `style.highlight` tells which
                         ///< are selected.
  std::vector<StyledTrail> trails = {};
  std::vector<ControllerPicture> controllers = {};
  std::optional<ControllerHandles> controllerHandles = {};
  std::optional<HandlePart> activeHandle = {}; ///< Part of the controllers' handles under the mouse.
  std::optional<AxisHandles> handles = {};
  std::optional<std::size_t> activeAxis = {}; ///< Axis of the handles under the mouse.
};

/// Skeleton, controllers, trails and handles, as they lie over the scene in a view.
[[nodiscard]] Overlay overlayOf(const Scene& scene, const View& view, const PictureContent& content);

/// Red, green, blue for x, y, z as everywhere, in shades that stay apart for every eye.
[[nodiscard]] const std::array<glm::vec4, 3>& axisColours();

/// The three arrows of axis handles. `active`: the axis under the mouse or being dragged, drawn brighter and
/// thicker; the others are then quieter.
[[nodiscard]] Overlay drawAxisHandles(const View& view, const AxisHandles& handles,
                                      std::optional<std::size_t> active = std::nullopt);

} // namespace stretch::ui
