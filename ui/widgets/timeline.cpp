#include "ui/widgets/timeline.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/timeline_detail.h"

namespace stretch::ui {

namespace timeline_detail {

namespace {

constexpr float grabWidth = 6.0F; ///< Either side of an edge, design pixels.

Hit barHit(const Theme& theme, const Layout& layout, const TimelineModel& model, const ImVec2& mouse) {
  const float reach = theme.px(grabWidth);
  for (const TimelineBar& bar : model.bars) {
    const Rect box = barBox(theme, layout, model, bar, {bar.start, bar.end});
    const Rect window = barBox(theme, layout, model, bar, shownWindow(model, bar));
    if (mouse.y < box.min.y || mouse.y >= box.max.y) {
      continue;
    }
    const Span span{bar.start, bar.end};
    const bool isTrail = bar.id > 0;
    const bool releaseAfter =
        isTrail && bar.windowEnd > bar.end && std::abs(window.max.x - box.max.x) > reach;
    const bool releaseBefore =
        isTrail && bar.windowStart < bar.start && std::abs(box.min.x - window.min.x) > reach;
    if (std::abs(mouse.x - box.min.x) <= reach) {
      return {TimelinePart::barStart, bar.id, span};
    }
    if (std::abs(mouse.x - box.max.x) <= reach) {
      return {TimelinePart::barEnd, bar.id, span};
    }
    if ((releaseAfter && std::abs(mouse.x - window.max.x) <= reach) ||
        (releaseBefore && std::abs(mouse.x - window.min.x) <= reach)) {
      return {TimelinePart::release, bar.id, {bar.windowStart, bar.windowEnd}};
    }
    if (mouse.x > box.min.x && mouse.x < box.max.x) {
      return {TimelinePart::barBody, bar.id, span};
    }
  }
  return {};
}

/// The moment whose tip is nearest to the mouse, of those that meet the strongest.
Hit momentHit(const Theme& theme, const Layout& layout, const TimelineModel& model, const ImVec2& mouse) {
  const auto away = [&](std::size_t i) {
    return std::abs(layout.frames.toPixel(model.moments[i].tip) - mouse.x);
  };
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < model.moments.size(); ++i) {
    const bool isNearer =
        !nearest || away(i) < away(*nearest) ||
        (away(i) == away(*nearest) && model.moments[i].strength > model.moments[*nearest].strength);
    nearest = isNearer ? i : *nearest;
  }
  return nearest && away(*nearest) <= theme.px(grabWidth + 2.0F)
             ? Hit{TimelinePart::moment, 0, model.range, *nearest}
             : Hit{TimelinePart::playhead, 0, model.range};
}

double snapped(const TimelineModel& model, double frame) {
  const double clamped = std::clamp(frame, model.clip.start, model.clip.end);
  return model.snap ? std::clamp(std::round(clamped), model.clip.start, model.clip.end) : clamped;
}

Span movedSpan(const TimelineModel& model, const TimelineGesture& gesture, double frame) {
  Span span = gesture.startSpan;
  const double least = 1.0;
  switch (gesture.part) {
  case TimelinePart::rangeStart:
  case TimelinePart::barStart:
    span.start = std::min(snapped(model, frame), span.end - least);
    break;
  case TimelinePart::rangeEnd:
  case TimelinePart::barEnd:
    span.end = std::max(snapped(model, frame), span.start + least);
    break;
  case TimelinePart::barBody: {
    const double wanted = snapped(model, span.start + frame - gesture.grabbedAt);
    const double width = span.end - span.start;
    span.start = std::min(wanted, model.clip.end - width);
    span.end = span.start + width;
    break;
  }
  case TimelinePart::nothing:
  case TimelinePart::playhead:
  case TimelinePart::release:
  case TimelinePart::pan:
  case TimelinePart::moment:
  case TimelinePart::keys:
  case TimelinePart::keyBox:
    break;
  }
  return span;
}

/// Where a release ends that is dragged to a frame. On a loop it goes on across the seam, and one that was
/// taken hold of past the seam stays a turn away from where the mouse is.
double releaseEdge(const TimelineModel& model, const TimelineGesture& gesture, const TimelineBar& bar,
                   double frame) {
  const bool isAfter = bar.windowEnd > bar.end;
  const double held = isAfter ? gesture.startSpan.end : gesture.startSpan.start;
  const double turns = model.turn > 0.0 ? std::round((held - gesture.grabbedAt) / model.turn) : 0.0;
  const double wanted = frame + (model.loops ? turns * model.turn : 0.0);
  const double beyond = model.loops ? model.turn : 0.0;
  const double least = model.clip.start - (isAfter ? 0.0 : beyond);
  const double most = model.clip.end + (isAfter ? beyond : 0.0);
  return std::clamp(model.snap ? std::round(wanted) : wanted, least, most);
}

bool differs(const Span& a, const Span& b) {
  return a.start != b.start || a.end != b.end;
}

void dragBar(const TimelineModel& model, const TimelineGesture& gesture, double frame,
             TimelineOutcome& outcome) {
  outcome.editedBar = gesture.bar;
  const auto bar =
      std::ranges::find_if(model.bars, [&](const TimelineBar& b) { return b.id == gesture.bar; });
  if (bar == model.bars.end()) {
    return;
  }
  if (gesture.part == TimelinePart::release) {
    outcome.releaseEdge = releaseEdge(model, gesture, *bar, frame);
    const double edge = bar->windowEnd > bar->end ? bar->windowEnd : bar->windowStart;
    outcome.releaseChanged = outcome.releaseEdge != edge;
    return;
  }
  outcome.barSpan = movedSpan(model, gesture, frame);
  outcome.barChanged = differs(outcome.barSpan, {bar->start, bar->end});
}

} // namespace

std::optional<double> keyAt(const Theme& theme, const Layout& layout, const KeyRow& row, float x) {
  std::optional<double> found;
  float nearest = theme.px(grabWidth);
  const double start = layout.frames.toValue(x - nearest);
  for (auto frame = std::lower_bound(row.frames.begin(), row.frames.end(), start);
       frame != row.frames.end() && layout.frames.toPixel(*frame) <= x + theme.px(grabWidth); ++frame) {
    const float away = std::abs(layout.frames.toPixel(*frame) - x);
    if (away <= nearest) {
      nearest = away;
      found = *frame;
    }
  }
  return found;
}

Span shownWindow(const TimelineModel& model, const TimelineBar& bar) {
  const bool endWraps = model.loops && bar.windowEnd > model.clip.end;
  const bool startWraps = model.loops && bar.windowStart < model.clip.start;
  return {bar.windowStart + (startWraps ? model.turn : 0.0), bar.windowEnd - (endWraps ? model.turn : 0.0)};
}

Hit hitTest(const Theme& theme, const Layout& layout, const TimelineModel& model, const ImVec2& mouse) {
  if (!layout.track.contains(mouse)) {
    return {};
  }
  const float reach = theme.px(grabWidth);
  const bool nearRange =
      mouse.y >= layout.ruler.max.y - theme.px(12.0F) && mouse.y <= layout.ruler.max.y + theme.px(2.0F);
  if (nearRange && std::abs(mouse.x - layout.frames.toPixel(model.range.end)) <= reach) {
    return {TimelinePart::rangeEnd, 0, model.range};
  }
  if (nearRange && std::abs(mouse.x - layout.frames.toPixel(model.range.start)) <= reach) {
    return {TimelinePart::rangeStart, 0, model.range};
  }
  if (mouse.y > layout.lane.min.y && mouse.y < layout.lane.max.y) {
    return momentHit(theme, layout, model, mouse);
  }
  const std::size_t row = keyRowAt(theme, layout, model, mouse.y);
  if (model.keysEditable && row < model.keyRows.size()) {
    const std::optional<double> key = keyAt(theme, layout, model.keyRows[row], mouse.x);
    return {key ? TimelinePart::keys : TimelinePart::keyBox, 0, model.range, row, key.value_or(0.0)};
  }
  const Hit bar = barHit(theme, layout, model, mouse);
  return bar.part != TimelinePart::nothing ? bar : Hit{TimelinePart::playhead, 0, model.range};
}

void applyGesture(const TimelineModel& model, const Layout& layout, const TimelineGesture& gesture,
                  const ImVec2& mouse, TimelineOutcome& outcome) {
  const double frame = layout.frames.toValue(mouse.x);
  switch (gesture.part) {
  case TimelinePart::playhead:
    outcome.playhead = snapped(model, frame);
    outcome.playheadMoved = outcome.playhead != model.playhead;
    break;
  case TimelinePart::rangeStart:
  case TimelinePart::rangeEnd:
    outcome.range = movedSpan(model, gesture, frame);
    outcome.rangeChanged = differs(outcome.range, model.range);
    break;
  case TimelinePart::barStart:
  case TimelinePart::barEnd:
  case TimelinePart::barBody:
  case TimelinePart::release:
    dragBar(model, gesture, frame, outcome);
    break;
  case TimelinePart::pan: {
    const double shift = layout.frames.valuesPerPixel() * -static_cast<double>(ImGui::GetIO().MouseDelta.x);
    outcome.view = {model.view.start + shift, model.view.end + shift};
    outcome.viewChanged = shift != 0.0;
    break;
  }
  case TimelinePart::keys: {
    const double away = frame - gesture.grabbedAt;
    outcome.keyFrames = model.snap ? std::round(away) : away;
    break;
  }
  case TimelinePart::nothing:
  case TimelinePart::moment:
  case TimelinePart::keyBox:
    break;
  }
}

void applyWheel(const TimelineModel& model, const Layout& layout, const ImVec2& mouse,
                TimelineOutcome& outcome) {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0.0F || !layout.track.contains(mouse)) {
    return;
  }
  if (ImGui::GetIO().KeyShift) {
    const double shift = (model.view.end - model.view.start) * -0.1 * static_cast<double>(wheel);
    outcome.view = {model.view.start + shift, model.view.end + shift};
  } else {
    const double factor = std::pow(0.85, static_cast<double>(wheel));
    const double longest = std::max(10.0, (model.clip.end - model.clip.start) * 3.0);
    outcome.view = zoomed(model.view, layout.frames.toValue(mouse.x), factor, 4.0, longest);
  }
  outcome.viewChanged = true;
}

void applyClicks(const Theme& theme, const TimelineModel& model, const Layout& layout, const Hit& hit,
                 const ImVec2& mouse, TimelineOutcome& outcome) {
  if (hit.bar != 0 && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    outcome.doubleClickedBar = hit.bar;
  }
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Right) || !layout.track.contains(mouse)) {
    return;
  }
  outcome.menu.asked = true;
  outcome.menu.bar = hit.bar;
  for (const TimelineBar& bar : model.bars) {
    outcome.menu.row = bar.id == hit.bar ? barBox(theme, layout, model, bar, {0.0, 0.0}) : outcome.menu.row;
  }
  outcome.menu.frame = snapped(model, layout.frames.toValue(mouse.x));
  if (hit.part == TimelinePart::rangeStart || hit.part == TimelinePart::rangeEnd) {
    outcome.menu.onRange = true;
    outcome.menu.frame = hit.part == TimelinePart::rangeStart ? model.range.start : model.range.end;
    return;
  }
  const std::size_t row = keyRowAt(theme, layout, model, mouse.y);
  float nearest = theme.px(grabWidth);
  for (const double frame : row < model.keyRows.size() ? model.keyRows[row].frames : std::vector<double>{}) {
    const float distance = std::abs(layout.frames.toPixel(frame) - mouse.x);
    if (distance <= nearest) {
      nearest = distance;
      outcome.menu.onKey = true;
      outcome.menu.frame = snapped(model, frame);
      outcome.menu.keys = {row, row, {frame, frame}};
    }
  }
}

namespace {

Help helpForHold(TimelinePart part) {
  return part == TimelinePart::barStart ? Help{"Start of the hold", "Drag it to change when it holds.", {}}
         : part == TimelinePart::barEnd
             ? Help{"End of the hold", "Drag it to change when it holds.", {}}
             : Help{"Pin, grip or prop",
                    "Click selects what it holds, dragging moves its range, a right click opens its menu.",
                    {}};
}

} // namespace

Help helpFor(TimelinePart part, int bar) {
  if (bar < 0) {
    return helpForHold(part);
  }
  switch (part) {
  case TimelinePart::rangeStart:
    return {"Start of the working range", "Drag it. New trails take this range.", {}};
  case TimelinePart::rangeEnd:
    return {"End of the working range", "Drag it. New trails take this range.", {}};
  case TimelinePart::barStart:
    return {"Start of the trail", "Drag it to change the trail's range.", {}};
  case TimelinePart::barEnd:
    return {"End of the trail", "Drag it to change the trail's range.", {}};
  case TimelinePart::release:
    return {"Release", "Drag it: over these frames the limb comes back to the original motion.", {}};
  case TimelinePart::barBody:
    return {"Trail",
            "Click selects it, dragging moves its range, a double click renames it, a right click opens its "
            "menu.",
            {}};
  case TimelinePart::nothing:
  case TimelinePart::playhead:
  case TimelinePart::pan:
  case TimelinePart::moment:
  case TimelinePart::keys:
  case TimelinePart::keyBox:
    break;
  }
  return {};
}

} // namespace timeline_detail

namespace {

void recordItems(const WidgetContext& context, const std::string& id, const timeline_detail::Layout& layout,
                 const TimelineModel& model) {
  static const std::vector<double> noFrames;
  const float reach = context.theme.px(4.0F);
  const auto add = [&](const std::string& name, float x, float y) {
    context.items.add(id + "/" + name, {x - reach, y - reach}, {x + reach, y + reach});
  };
  add("range-start", layout.frames.toPixel(model.range.start), layout.ruler.max.y - context.theme.px(5.0F));
  add("range-end", layout.frames.toPixel(model.range.end), layout.ruler.max.y - context.theme.px(5.0F));
  const std::vector<double>& keys = model.keyRows.empty() ? noFrames : model.keyRows.front().frames;
  if (std::binary_search(keys.begin(), keys.end(), model.playhead)) {
    add("key", layout.frames.toPixel(model.playhead),
        timeline_detail::keyRowBox(context.theme, layout, model, 0).centre().y);
  }
  for (std::size_t row = 0; model.keysEditable && row < model.keyRows.size(); ++row) {
    const float y = timeline_detail::keyRowBox(context.theme, layout, model, row).centre().y;
    const std::vector<double>& frames = model.keyRows[row].frames;
    for (std::size_t i = 0; i < std::min<std::size_t>(frames.size(), 40); ++i) {
      add("row-" + std::to_string(row) + "/" + std::to_string(i), layout.frames.toPixel(frames[i]), y);
    }
  }
  for (std::size_t i = 0; i < model.moments.size(); ++i) {
    add("moment-" + std::to_string(i), layout.frames.toPixel(model.moments[i].tip), layout.lane.centre().y);
  }
  for (const TimelineBar& bar : model.bars) {
    const Rect box = timeline_detail::barBox(context.theme, layout, model, bar, {bar.start, bar.end});
    const std::string name = (bar.id > 0 ? "trail-" : "hold-") + std::to_string(std::abs(bar.id));
    add(name + "/start", box.min.x, box.centre().y);
    add(name + "/end", box.max.x, box.centre().y);
    add(name + "/body", box.centre().x, box.centre().y);
    context.items.add(id + "/" + name + "/name", {layout.labelLeft, box.min.y},
                      {layout.track.min.x, box.max.y});
    const Span window = timeline_detail::shownWindow(model, bar);
    if (bar.id > 0 && (bar.windowEnd > bar.end || bar.windowStart < bar.start)) {
      add(name + "/release", layout.frames.toPixel(bar.windowEnd > bar.end ? window.end : window.start),
          box.centre().y);
    }
  }
}

} // namespace

namespace {

/// A press on a key picks it, unless it is picked.
void pressKeys(const TimelineModel& model, const timeline_detail::Hit& hit, TimelineOutcome& outcome) {
  if (hit.part != TimelinePart::keys) {
    return;
  }
  const std::vector<double>& picked = model.keyRows[hit.row].picked;
  if (!std::binary_search(picked.begin(), picked.end(), hit.frame)) {
    outcome.keysPicked = KeyBox{hit.row, hit.row, {hit.frame, hit.frame}, ImGui::GetIO().KeyShift};
  }
}

/// The box that is drawn around keys.
void holdKeyBox(const WidgetContext& context, const timeline_detail::Layout& layout,
                const TimelineGesture& gesture, const ImVec2& mouse) {
  const ImVec2 from(layout.frames.toPixel(gesture.grabbedAt), ImGui::GetIO().MouseClickedPos[0].y);
  const ImVec2 least(std::min(from.x, mouse.x), std::min(from.y, mouse.y));
  const ImVec2 most(std::max(from.x, mouse.x), std::max(from.y, mouse.y));
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(least, most, faded(context.theme.colours.accent, 0.12F));
  list->AddRect(least, most, context.theme.colours.accent);
}

void releaseKeyBox(const WidgetContext& context, const timeline_detail::Layout& layout,
                   const TimelineModel& model, const TimelineGesture& gesture, const ImVec2& mouse,
                   TimelineOutcome& outcome) {
  if (gesture.part != TimelinePart::keyBox) {
    return;
  }
  const ImVec2 pressed = ImGui::GetIO().MouseClickedPos[0];
  const float least = context.theme.px(3.0F);
  if (std::abs(mouse.x - pressed.x) < least && std::abs(mouse.y - pressed.y) < least) {
    outcome.clickedBesideKeys = !ImGui::GetIO().KeyShift;
    return;
  }
  const std::size_t last = model.keyRows.size() - 1;
  const std::size_t to =
      mouse.y < timeline_detail::keyRowBox(context.theme, layout, model, 0).min.y
          ? 0
          : std::min(last, timeline_detail::keyRowAt(context.theme, layout, model, mouse.y));
  const double frame = layout.frames.toValue(mouse.x);
  outcome.keysPicked = KeyBox{std::min(gesture.row, to), std::max(gesture.row, to),
                              Span{std::min(gesture.grabbedAt, frame), std::max(gesture.grabbedAt, frame)},
                              ImGui::GetIO().KeyShift};
}

} // namespace

TimelineOutcome timeline(const WidgetContext& context, const std::string& id, const TimelineModel& model,
                         TimelineGesture& gesture, float labelWidth, float height) {
  const Theme& theme = context.theme;
  TimelineOutcome outcome;
  const Control control = takePlace(context, id, {ImGui::GetContentRegionAvail().x, height});
  if (!control.visible) {
    return outcome;
  }
  const timeline_detail::Layout layout = timeline_detail::layoutOf(theme, control.box, model, labelWidth);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const timeline_detail::Hit hit =
      control.hovered ? timeline_detail::hitTest(theme, layout, model, mouse) : timeline_detail::Hit{};
  if (ImGui::IsItemActivated()) {
    gesture = {hit.part, hit.bar, layout.frames.toValue(mouse.x), hit.span, hit.row};
    outcome.clickedBar = hit.bar;
    pressKeys(model, hit, outcome);
  } else if (control.hovered && ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0F)) {
    timeline_detail::applyGesture(model, layout, {.part = TimelinePart::pan}, mouse, outcome);
  }
  if (control.held && (gesture.part == TimelinePart::playhead ||
                       ImGui::IsMouseDragging(ImGuiMouseButton_Left, theme.px(2.0F)))) {
    timeline_detail::applyGesture(model, layout, gesture, mouse, outcome);
  }
  if (ImGui::IsItemDeactivated()) {
    outcome.gestureEnded = true;
    releaseKeyBox(context, layout, model, gesture, mouse, outcome);
    gesture = {};
  }
  if (control.hovered) {
    timeline_detail::applyWheel(model, layout, mouse, outcome);
    timeline_detail::applyClicks(theme, model, layout, hit, mouse, outcome);
  }
  timeline_detail::draw(context, layout, model);
  if (control.held && gesture.part == TimelinePart::keyBox) {
    holdKeyBox(context, layout, gesture, mouse);
  }
  outcome.moment = hit.part == TimelinePart::moment ? std::optional(hit.row) : std::nullopt;
  outcome.hovered = control.hovered && layout.track.contains(mouse);
  outcome.mouseFrame = layout.frames.toValue(mouse.x);
  recordItems(context, id, layout, model);
  const TimelinePart shown = control.held ? gesture.part : hit.part;
  if (shown != TimelinePart::nothing && shown != TimelinePart::playhead && shown != TimelinePart::barBody &&
      shown != TimelinePart::keyBox && shown != TimelinePart::moment) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (!control.held) {
    const std::string name = timeline_detail::cutLabelAt(theme, layout, model, mouse);
    const Help& help =
        outcome.moment ? model.moments[hit.row].help : timeline_detail::helpFor(hit.part, hit.bar);
    tooltip(context, name.empty() ? help : Help{.title = name});
  }
  return outcome;
}

} // namespace stretch::ui