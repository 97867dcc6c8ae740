#pragma once

#include "ui/widgets/timeline.h"

namespace stretch::ui::timeline_detail {

// The two halves of the timeline: where things are and how they are drawn; what the mouse grabs and what that
// changes.

/// Where the parts of a timeline are, screen pixels.
struct Layout {
  Rect box;   ///< Everything.
  Rect ruler; ///< Right of the labels.
  Rect track; ///< Right of the labels, full height.
  Axis frames;
  float labelLeft = 0.0F;
};

[[nodiscard]] Layout layoutOf(const Theme& theme, const Rect& box, const TimelineModel& model,
                              float labelWidth);
/// Where a span of a bar is.
[[nodiscard]] Rect barBox(const Theme& theme, const Layout& layout, const TimelineModel& model,
                          const TimelineBar& bar, const Span& span);

/// Where the ends of range and release together stand: on a loop one past the seam stands at the clip's other
/// end.
[[nodiscard]] Span shownWindow(const TimelineModel& model, const TimelineBar& bar);

void draw(const WidgetContext& context, const Layout& layout, const TimelineModel& model);

/// What the mouse would grab.
struct Hit {
  TimelinePart part = TimelinePart::nothing;
  int bar = 0;
  Span span{0.0, 0.0}; ///< Of what is grabbed.
  std::size_t row = 0; ///< Of keys,
  double frame = 0.0;  ///< and where the key is.
};
/// The key of a row at the mouse.
[[nodiscard]] std::optional<double> keyAt(const Theme& theme, const Layout& layout, const KeyRow& row,
                                          float x);
[[nodiscard]] Hit hitTest(const Theme& theme, const Layout& layout, const TimelineModel& model,
                          const ImVec2& mouse);

/// What a gesture asks for while the mouse is there.
void applyGesture(const TimelineModel& model, const Layout& layout, const TimelineGesture& gesture,
                  const ImVec2& mouse, TimelineOutcome& outcome);
/// The wheel zooms about the mouse, with Shift it scrolls.
void applyWheel(const TimelineModel& model, const Layout& layout, const ImVec2& mouse,
                TimelineOutcome& outcome);

/// A right click and a double click.
void applyClicks(const Theme& theme, const TimelineModel& model, const Layout& layout, const Hit& hit,
                 const ImVec2& mouse, TimelineOutcome& outcome);

/// Where a row of keys is.
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
