#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/widgets/axis.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

/// A trail's time: its range, and the release in which the limb comes back; or a hold's with its blends.
struct TimelineBar {
  int id = 0; ///< Id of a trail above 0, of a hold below.
  double start = 0.0;
  double end = 0.0;
  double windowStart = 0.0; ///< Range and release together.
  double windowEnd = 0.0;
  ImU32 colour = 0;
  std::string label = {};
  bool selected = false;
  bool active = false;  ///< The character follows it, and the artist is not done with it.
  bool applied = false; ///< The artist is done with it.
  std::size_t row = 0;  ///< Row of the bar; the bars of one row have one label.
};

/// A row of keys, for the dope sheet.
struct KeyRow {
  std::string label;
  std::vector<double> frames; ///< Increasing.
  bool selected = false;
  bool offsetKeys = false;         ///< Keys of a controller, drawn as circles; else the clip's own.
  std::vector<double> picked = {}; ///< Frames of picked keys, increasing.
};

/// A moment of the clip: where a limb strikes, steps or lands.
struct TimelineMoment {
  double start = 0.0;
  double tip = 0.0;
  float strength = 1.0F; ///< Of the clip's strongest.
  bool repeats = false;  ///< A cycle: drawn hollow.
  bool current = false;  ///< It is the limb and the range that are selected.
  Help help = {};
};

/// A sound that runs beside the clip.
struct TimelineSound {
  Span frames;       ///< In which it is heard.
  std::string label; ///< Name of its file.
  /// Least and greatest value of the sound between two frames, -1..1.
  std::function<std::pair<float, float>(double fromFrame, double toFrame)> peak;
};

struct TimelineModel {
  Span clip; ///< First and last frame.
  Span view; ///< Frames that are visible.
  double playhead = 0.0;
  Span range;                  ///< The working range.
  bool rangeIsDefault = false; ///< Not set by the user: drawn quieter.
  std::vector<KeyRow> keyRows;
  std::vector<TimelineBar> bars;
  std::vector<TimelineMoment> moments; ///< In a lane below the ruler, which is there when there are any.
  std::optional<TimelineSound> sound;  ///< In a lane of its own, below the moments.
  std::size_t rowsAbove = 0;           ///< Rows of bars that stand above the keys; the others stand below.
  std::vector<double> spheres;         ///< Frames of the selected trail's control spheres.
  bool loops = false;        ///< After the clip's end its start comes again: a release goes on there.
  double turn = 0.0;         ///< Frames from one start to the next.
  bool snap = true;          ///< Frames that the mouse sets are whole ones.
  bool keysEditable = false; ///< Keys can be picked and dragged; the playhead is moved in the ruler alone.
};

enum class TimelinePart {
  nothing,
  playhead,
  rangeStart,
  rangeEnd,
  barStart,
  barEnd,
  barBody,
  release,
  pan,
  moment,
  keys,
  keyBox
};

/// Gesture of the mouse, from press to release.
struct TimelineGesture {
  TimelinePart part = TimelinePart::nothing;
  int bar = 0;
  double grabbedAt = 0.0;   ///< Frame under the mouse at the press.
  Span startSpan{0.0, 0.0}; ///< Span of what is held, at the press.
  std::size_t row = 0;      ///< Row of the keys, at the press.
};

/// Keys of some rows, in some frames.
struct KeyBox {
  std::size_t firstRow = 0;
  std::size_t lastRow = 0;
  Span frames;
  bool add = false; ///< Beside those that are picked.
};

/// A right click, and what it was on.
struct TimelineMenu {
  bool asked = false;
  int bar = 0;          ///< On this bar,
  Rect row{};           ///< whose row is here, else
  double frame = 0.0;   ///< at this frame,
  bool onKey = false;   ///< where a key is,
  KeyBox keys{};        ///< this one,
  bool onRange = false; ///< or an end of the working range.
};

/// Requests of the user in this frame; spans are complete, ready to be set.
struct TimelineOutcome {
  bool playheadMoved = false;
  double playhead = 0.0;
  bool rangeChanged = false;
  Span range;
  int clickedBar = 0;
  std::optional<std::size_t> moment; ///< Moment under the mouse.
  int editedBar = 0;                 ///< A bar whose span is being dragged.
  bool barChanged = false;           ///< barSpan is new.
  Span barSpan;
  bool releaseChanged = false;
  double releaseEdge = 0.0; ///< Frame where the release ends.
  bool gestureEnded = false;
  bool viewChanged = false;
  Span view;
  TimelineMenu menu;
  int doubleClickedBar = 0;
  std::optional<KeyBox> keysPicked; ///< By a press on a key or a box around some.
  bool clickedBesideKeys = false;
  std::optional<double> keyFrames; ///< Keys are dragged: how far, since the press.
  bool hovered = false;            ///< The mouse is over the tracks,
  double mouseFrame = 0.0;
};

/// Height that the rows need, in screen pixels.
[[nodiscard]] float timelineHeight(const Theme& theme, const TimelineModel& model);

/// Width of the column of labels in which none is cut, within limits; screen pixels.
[[nodiscard]] float timelineLabelWidth(const Theme& theme, const TimelineModel& model);

/// Ruler, working range, keys and bars, as wide as available; labels of rows in a column on the left.
[[nodiscard]] TimelineOutcome timeline(const WidgetContext& context, const std::string& id,
                                       const TimelineModel& model, TimelineGesture& gesture, float labelWidth,
                                       float height);

} // namespace stretch::ui
