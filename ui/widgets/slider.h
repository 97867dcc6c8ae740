#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/control.h"

namespace stretch::ui {

/// A number with a range: dragged sideways (Shift: a tenth as fast), typed after a click, sums included
/// (typedNumber), reset, copied and pasted from the menu that a right click opens. What is typed may lie
/// outside the dragged range, up to the hard limits.
struct SliderSpec {
  std::string id;
  double minimum = 0.0;
  double maximum = 1.0;
  double step = 0.01;    ///< Dragged values are multiples of it,
  double fineStep = 0.0; ///< or with Shift of this; 0: of the step.
  int decimals = 2;
  const char* prefix = "";
  const char* suffix = "";
  double displayFactor = 1.0; ///< Shown value = value x this (100 for percent).
  std::optional<double> defaultValue = {};
  std::optional<double> hardMinimum = {}; ///< Least value that can be typed; `minimum` when empty.
  std::optional<double> hardMaximum = {};
  bool showsFill = true; ///< The part of the range filled, from the left.
  float width = 0.0F;    ///< 0: the available width.
  Help help = {};
  bool enabled = true;
};

EditPhase slider(const WidgetContext& context, const SliderSpec& spec, double& value);

/// The value as the slider shows it.
[[nodiscard]] std::string sliderText(const SliderSpec& spec, double value);

} // namespace stretch::ui
