#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/math/types.h"
#include "ui/render/overlay/overlay.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

enum class BodySide { centre, left, right };

/// A controller as it stands in the world at one moment.
struct ControllerPicture {
  std::vector<std::vector<Vec3>> lines; ///< World; each a run of points.
  std::optional<Vec3> knob;             ///< A pole: a ball at the end of its line.
  std::optional<Vec3> ring;       ///< On a joint: a ring of the same size at any zoom, where it has room.
  std::optional<double> ringRoom; ///< World: how far the ring may reach; none: as far as it likes.
  BodySide side = BodySide::centre;
  bool selected = false;
  bool hovered = false;
};

struct ControllerStyle {
  glm::vec4 centre{1.0F};
  glm::vec4 left{1.0F};
  glm::vec4 right{1.0F};
  glm::vec4 selected{1.0F};
  float widthPoints = 1.5F; ///< At any zoom.
  float knobPoints = 5.0F;  ///< Radius.
  float ringPoints = 7.0F;
  float leastRingPoints = 2.5F;
};

[[nodiscard]] ControllerStyle controllerStyle(const Palette& palette);

/// Thin lines with an edge of opposite lightness, weaker where the body hides them; what is under the mouse
/// or selected is thicker, brighter and drawn last.
[[nodiscard]] Overlay drawControllers(const View& view, std::span<const ControllerPicture> controllers,
                                      const ControllerStyle& style);

} // namespace stretch::ui
