#pragma once

#include <functional>
#include <string>

#include "core/math/types.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

/// The two draggable points of the remap curve (docs/exaggeration.md, Remap and ease). Percents are fractions
/// in [0, 1), 0 = off; ease-out's point stands at x = 1 - percent.
struct RemapPoints {
  Vec2 easeIn{0.0, 0.1};  ///< (percent, value in [0, 0.5])
  Vec2 easeOut{0.0, 0.9}; ///< (percent, value in [0.5, 1])

  friend bool operator==(const RemapPoints&, const RemapPoints&) = default;
};

/// The nearest points that are allowed: values in range, percents not negative and together below 1.
[[nodiscard]] RemapPoints clampedRemap(RemapPoints points);

/// A square graph of w(r) with the two points as handles. A point that is off waits in its corner, hollow;
/// dragged out it turns on, dragged back to the edge it turns off. A double click turns it off.
EditPhase remapEditor(const WidgetContext& context, const std::string& id,
                      const std::function<double(double)>& curve, RemapPoints& points, ImU32 colour,
                      float height);

} // namespace stretch::ui
