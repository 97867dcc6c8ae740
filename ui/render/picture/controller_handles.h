#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/math/types.h"
#include "ui/render/overlay/overlay.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

/// Handles of a selected controller, along the world's axes and of constant size on the screen
/// (smaller in a small picture): arrows and squares where it moves, rings where it turns.
struct ControllerHandles {
  Vec3 origin{0.0};
  bool moves = true;
  bool turns = true;
};

enum class HandleKind { axis, plane, ring };

/// One of the handles. `axis`: 0 x, 1 y, 2 z; of a plane the one across it.
struct HandlePart {
  HandleKind kind = HandleKind::axis;
  std::size_t axis = 0;

  friend bool operator==(const HandlePart&, const HandlePart&) = default;
};

/// How far the handles reach from their middle, pixels.
[[nodiscard]] double handleReachPixels(const View& view);

/// Every handle that is there.
[[nodiscard]] std::vector<HandlePart> partsOf(const ControllerHandles& handles);

/// Points of a handle in the world: an arrow from its foot to its tip, a square and a ring closed.
[[nodiscard]] std::vector<Vec3> pointsOf(const View& view, const ControllerHandles& handles,
                                         const HandlePart& part);

/// Whether a part of a ring lies on the side of the viewer: the other half is drawn faintly and not taken.
[[nodiscard]] bool facesViewer(const View& view, const Vec3& origin, const Vec3& point);

/// The handle under the mouse: a square that it is in, else the nearest arrow or near half of a ring. What
/// points at the viewer cannot be taken.
[[nodiscard]] std::optional<HandlePart> pickHandle(const View& view, const ControllerHandles& handles,
                                                   const Vec2& mousePixels);

/// Red, green, blue for x, y, z. `active`: the handle under the mouse or being dragged; the others are then
/// quieter.
[[nodiscard]] Overlay drawControllerHandles(const View& view, const ControllerHandles& handles,
                                            const std::optional<HandlePart>& active);

} // namespace stretch::ui
