#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/math/types.h"
#include "ui/widgets/axis.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

/// A key of a curve.
struct CurveKey {
  Vec2 at{0.0};     ///< (frame, value)
  Vec2 slopes{0.0}; ///< Before and after it, for each frame.
  int key = 0;      ///< Place in its row.
  bool picked = false;
};

struct Curve {
  std::string label;
  ImU32 colour = 0;
  std::vector<Vec2> points = {}; ///< (frame, value), frames increasing.
  std::vector<Vec2> before = {}; ///< Under what was put on top of it, drawn dashed; empty for none.
  std::vector<Vec2> source = {}; ///< Curve before its keys were edited: a ghost; empty for none.
  std::vector<CurveKey> keys = {};
  bool hidden = false;
  bool seen = false;         ///< Since the view was set a part of it was in sight.
  std::size_t picked = 0;    ///< How many of the keys are.
  bool offsetKeys = false;   ///< Keys of a controller, drawn as circles; else the clip's own, as diamonds.
  std::size_t row = 0;       ///< Row whose curve it is: the caller's number,
  std::size_t component = 0; ///< and which of its values.
};

/// Gesture of the mouse in a graph, from press to release.
struct CurveGesture {
  enum class Part { nothing, playhead, box, keys, tangent };
  Part part = Part::nothing;
  Vec2 from{0.0};        ///< (frame, value) at the press.
  std::size_t curve = 0; ///< Curve of the key whose tangent is held.
  int key = 0;
  bool after = true;  ///< The tangent after the key.
  bool moved = false; ///< The mouse left its place.
};

struct CurveViewModel {
  std::span<const Curve> curves;
  Span frames; ///< Visible.
  Span values; ///< Visible.
  double playhead = 0.0;
  Span range; ///< The working range, shaded.
  const char* unit = "";
  bool editable = false; ///< Keys can be picked and dragged.
  bool snap = true;      ///< Drags go by whole frames.
};

struct CurveKeyHit {
  std::size_t curve = 0;
  int key = 0;
};

/// Right click in a view of curves.
struct CurveMenu {
  std::optional<CurveKeyHit> key; ///< That it is on; none: beside the keys.
  bool onPick = false;            ///< The key is picked.
};

struct CurveViewOutcome {
  bool framesChanged = false;
  Span frames;
  bool valuesChanged = false;
  Span values;
  bool playheadMoved = false;
  double playhead = 0.0;
  bool fitAsked = false;                ///< A double click.
  std::optional<CurveKeyHit> pickedKey; ///< Pressed on.
  bool boxDrawn = false;                ///< Around these:
  Span boxFrames;
  Span boxValues;
  bool addToPicks = false; ///< Shift was held.
  bool clickedBeside = false;
  bool keysDragged = false; ///< By this since the press:
  Vec2 drag{0.0};
  std::optional<CurveKeyHit> tangent; ///< Dragged to this slope,
  double slope = 0.0;
  bool tangentAfter = true;
  bool tangentAlone = false;      ///< Alt: the other side stays.
  std::optional<double> insertAt; ///< A click with Ctrl, at a frame.
  bool gestureEnded = false;
  std::optional<CurveMenu> menu; ///< A right click.
  bool hovered = false;          ///< The mouse is over the curves, here:
  Vec2 mouse{0.0};
};

/// Value of a curve at a frame, linear between its points; held outside. 0 without points.
[[nodiscard]] double curveValue(const std::vector<Vec2>& points, double frame);

/// The values that all visible curves cover, with a margin; never without width.
[[nodiscard]] Span fittedValues(const std::vector<Curve>& curves);
/// Whether an edit took a visible curve that was seen out of sight; remembers what is seen.
[[nodiscard]] bool lostFromSight(std::vector<Curve>& curves, const Span& values);
/// The frames and values of the picked keys, with a margin; nothing without one.
struct CurveFit {
  Span frames;
  Span values;
};
[[nodiscard]] std::optional<CurveFit> fittedPicks(std::span<const Curve> curves);

/// A graph of curves over frames: wheel zooms frames (Ctrl: values), middle drag pans, a drag in the row of
/// frames moves the playhead. A drag beside the keys draws a box around some; one of a key moves those that
/// are picked (Shift: in time or in value alone), one of a handle its tangent.
[[nodiscard]] CurveViewOutcome curveView(const WidgetContext& context, const std::string& id,
                                         const CurveViewModel& model, CurveGesture& gesture, float height);

/// One entry for each of the first `count` curves, clicked to hide or show it: the index, or -1.
[[nodiscard]] int curveLegend(const WidgetContext& context, const std::string& id,
                              std::span<const Curve> curves, std::size_t count);

} // namespace stretch::ui
