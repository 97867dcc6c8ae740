#pragma once

#include <optional>

#include "core/scene/camera.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// A camera of the file at one moment, to be looked through.
struct ThroughCamera {
  SceneCamera lens;
  CameraPlace place;
  double reach = 5.0; ///< Distance to what is looked at, world units, above 0: the clipping planes hang on
                      ///< it.
};

/// The whole picture of the camera is in the view; a viewport of another shape shows more beside or above it.
[[nodiscard]] View viewThrough(const ThroughCamera& camera, const Viewport& viewport);

/// A camera that orbits a target at the reach, as near to it as one without roll comes.
[[nodiscard]] Camera orbitingFrom(const ThroughCamera& camera);

/// The place of a view, to be kept with a trail.
[[nodiscard]] CameraPlace placeOf(const View& view);

/// A rectangle of pixels, y down.
struct PixelBox {
  Vec2 low{0.0};
  Vec2 high{0.0};
};

/// The part of a viewport's picture that the camera's own picture is, and the middle `share` of it along each
/// side. `aspect`: the camera's; empty: all of the viewport.
[[nodiscard]] PixelBox frameIn(const Viewport& viewport, std::optional<double> aspect, double share = 1.0);

} // namespace stretch::ui
