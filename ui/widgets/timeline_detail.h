#pragma once

#include "ui/widgets/timeline.h"

namespace stretch::ui::timeline_detail {

// The two halves of the timeline: where things are and how they are drawn; what the mouse grabs and what that
// changes.

/// Places of a timeline's parts, screen pixels.
struct Layout {
  Rect box;   ///< Everything.
  Rect ruler; ///< Right of the labels.
  Rect lane;  ///< Below the ruler, where moments are marked; without height where there are none.
  Rect sound; ///< Below the lane, where the sound is drawn; without height where there is none.
  Rect track; ///< Right of the labels, full height.
  Axis frames;
  float labelLeft = 0.0F;
};

[[nodiscard]] Layout layoutOf(const Theme& theme, const Rect& box, const TimelineModel& model,
                              float labelWidth);
/// Returns the box of a bar's span.
[[nodiscard]] Rect barBox(const Theme& theme, const Layout& layout, const TimelineModel& model,
                          const TimelineBar& bar, const Span& span);

/// Returns the ends of range and release together: on a loop one past the seam stands at the clip's other
/// end.
[[nodiscard]] Span shownWindow(const TimelineModel& model, const TimelineBar& bar);

void draw(const WidgetContext& context, const Layout& layout, const TimelineModel& model);

/// Part that the mouse would grab.
struct Hit {
  TimelinePart part = TimelinePart::nothing;
  int bar = 0;
  Span span{0.0, 0.0}; ///< Span of what is grabbed.
  std::size_t row = 0; ///< Row of keys, or place of a moment,
  double frame = 0.0;  ///< and where the key is.
};
/// The key of a row at the mouse.
[[nodiscard]] std::optional<double> keyAt(const Theme& theme, const Layout& layout, const KeyRow& row,
                                          float x);
[[nodiscard]] Hit hitTest(const Theme& theme, const Layout& layout, const TimelineModel& model,
                          const ImVec2& mouse);

/// Applies what a gesture asks for while the mouse is there.
void applyGesture(const TimelineModel& model, const Layout& layout, const TimelineGesture& gesture,
                  const ImVec2& mouse, TimelineOutcome& outcome);
/// The wheel zooms about the mouse, with Shift it scrolls.
void applyWheel(const TimelineModel& model, const Layout& layout, const ImVec2& mouse,
                TimelineOutcome& outcome);

/// A right click and a double click.
void applyClicks(const Theme& theme, const TimelineModel& model, const Layout& layout, const Hit& hit,
                 const ImVec2& mouse, TimelineOutcome& outcome);

/// Returns the box of a row of keys.
[[nodiscard]] Rect keyRowBox(const Theme& theme, const Layout& layout, const TimelineModel& model,
                             std::size_t row);
/// The row of keys at this height; keyRows.size() for none.
[[nodiscard]] std::size_t keyRowAt(const Theme& theme, const Layout& layout, const TimelineModel& model,
                                   float y);

/// The label left of the tracks at this height, where it is cut; empty elsewhere.
[[nodiscard]] std::string cutLabelAt(const Theme& theme, const Layout& layout, const TimelineModel& model,
                                     const ImVec2& mouse);

/// `bar`: TimelineBar::id of what the part belongs to; 0: none.
[[nodiscard]] Help helpFor(TimelinePart part, int bar);

} // namespace stretch::ui::timeline_detail
