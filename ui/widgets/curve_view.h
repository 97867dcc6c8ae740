#pragma once

#include <string>
#include <vector>

#include "core/math/types.h"
#include "ui/widgets/axis.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

struct Curve {
  std::string label;
  ImU32 colour = 0;
  std::vector<Vec2> points = {}; ///< (frame, value), frames increasing.
  std::vector<Vec2> before = {}; ///< The curve before the edit, drawn dashed; empty for none.
  std::vector<Vec2> keys = {};
  bool hidden = false;
};

struct CurveViewModel {
  std::vector<Curve> curves;
  Span frames; ///< Visible.
  Span values; ///< Visible.
  double playhead = 0.0;
  Span range; ///< The working range, shaded.
  const char* unit = "";
};

struct CurveViewOutcome {
  bool framesChanged = false;
  Span frames;
  bool valuesChanged = false;
  Span values;
  bool playheadMoved = false;
  double playhead = 0.0;
  bool fitAsked = false; ///< A double click.
};

/// Value of a curve at a frame, linear between its points; held outside. 0 without points.
[[nodiscard]] double curveValue(const std::vector<Vec2>& points, double frame);

/// The values that all visible curves cover, with a margin; never without width.
[[nodiscard]] Span fittedValues(const std::vector<Curve>& curves);

/// A graph of curves over frames: wheel zooms frames (Ctrl: values), middle drag pans, left drag moves the
/// playhead.
[[nodiscard]] CurveViewOutcome curveView(const WidgetContext& context, const std::string& id,
                                         const CurveViewModel& model, float height);

/// One entry for each curve, clicked to hide or show it: the index, or -1.
[[nodiscard]] int curveLegend(const WidgetContext& context, const std::string& id,
                              const std::vector<Curve>& curves);

} // namespace stretch::ui
