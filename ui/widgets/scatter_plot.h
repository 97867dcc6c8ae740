#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/math/types.h"
#include "ui/widgets/axis.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

struct PlotPoint {
  Vec2 at{0.0};
  bool quiet = false; ///< Shown, but left out of what the lines were made from.
};

struct PlotLine {
  ImU32 colour = 0;
  std::vector<Vec2> points; ///< By increasing x.
};

struct ScatterPlotModel {
  std::string xLabel; ///< With the unit.
  std::string yLabel;
  std::vector<PlotPoint> points;
  std::vector<PlotLine> lines;
  std::optional<std::size_t> current; ///< A point that is marked.
  ImU32 pointColour = 0;
  std::function<std::string(std::size_t)> describe; ///< Describes the point under the mouse. May be empty.
};

/// The values along one direction (0 x, 1 y) that all points and lines cover, with a margin; never without
/// width.
[[nodiscard]] Span plottedSpan(const ScatterPlotModel& model, int direction);

/// Points and lines over two axes, as wide as available. The index of the point that was clicked.
std::optional<std::size_t> scatterPlot(const WidgetContext& context, const std::string& id,
                                       const ScatterPlotModel& model, float height);

} // namespace stretch::ui
