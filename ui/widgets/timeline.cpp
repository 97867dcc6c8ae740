#include "ui/widgets/timeline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/widgets/shapes.h"

namespace stretch::ui {

namespace {

constexpr float rulerHeight = 26.0F;
constexpr float keyRowHeight = 22.0F;
constexpr float barRowHeight = 24.0F;
constexpr float grabWidth = 6.0F; ///< Either side of an edge, design pixels.

struct Layout {
  Rect box;   ///< Everything.
  Rect ruler; ///< Right of the labels.
  Rect track; ///< Right of the labels, full height.
  Axis frames;
  float labelLeft = 0.0F;
};

Layout layoutOf(const Theme& theme, const Rect& box, const TimelineModel& model, float labelWidth) {
  Layout layout;
  layout.box = box;
  const float left = box.min.x + labelWidth;
  const float right = box.max.x - theme.px(12.0F);
  layout.track = {{left, box.min.y}, {box.max.x, box.max.y}};
  layout.ruler = {{left, box.min.y}, {box.max.x, box.min.y + theme.px(rulerHeight)}};
  layout.frames = {model.view.start, std::max(model.view.end, model.view.start + 1e-6),
                   left + theme.px(12.0F), right};
  layout.labelLeft = box.min.x;
  return layout;
}

Rect keyRowBox(const Theme& theme, const Layout& layout, std::size_t row) {
  const float y = layout.ruler.max.y + theme.px(keyRowHeight) * static_cast<float>(row);
  return {{layout.track.min.x, y}, {layout.track.max.x, y + theme.px(keyRowHeight)}};
}

Rect barBox(const Theme& theme, const Layout& layout, const TimelineModel& model, std::size_t row,
            const Span& span) {
  const float top =
      layout.ruler.max.y + theme.px(keyRowHeight) * static_cast<float>(model.keyRows.size()) + theme.px(4.0F);
  const float y = top + theme.px(barRowHeight) * static_cast<float>(row);
  return {{layout.frames.toPixel(span.start), y + theme.px(2.0F)},
          {layout.frames.toPixel(span.end), y + theme.px(barRowHeight - 2.0F)}};
}

void drawRuler(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  const ThemeColours& colours = theme.colours;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(layout.ruler.min, layout.ruler.max, colours.raised);
  const double numbered = markStep(layout.frames, theme.px(52.0F), true);
  const double fine = markStep(layout.frames, theme.px(7.0F), true);
  for (const double frame : marks(layout.frames, fine)) {
    const float x = layout.frames.toPixel(frame);
    list->AddLine({x, layout.ruler.max.y - theme.px(4.0F)}, {x, layout.ruler.max.y},
                  faded(colours.quietText, 0.5F));
  }
  for (const double frame : marks(layout.frames, numbered)) {
    const float x = layout.frames.toPixel(frame);
    list->AddLine({x, layout.ruler.max.y - theme.px(8.0F)}, {x, layout.ruler.max.y}, colours.quietText);
    list->AddLine({x, layout.ruler.max.y}, {x, layout.track.max.y}, faded(colours.border, 0.45F));
    char text[24];
    std::snprintf(text, sizeof text, "%.0f", frame);
    const float half = theme.px(26.0F);
    const Rect place{{x - half, layout.ruler.min.y}, {x + half, layout.ruler.max.y - theme.px(7.0F)}};
    drawText(context, theme.fonts.label, place, colours.quietText, text, 0.5F);
  }
  // Frames that the clip does not have are covered.
  const float first =
      std::clamp(layout.frames.toPixel(model.clip.start), layout.track.min.x, layout.track.max.x);
  const float last =
      std::clamp(layout.frames.toPixel(model.clip.end), layout.track.min.x, layout.track.max.x);
  const ImU32 outside = faded(colours.background, 0.55F);
  list->AddRectFilled(layout.track.min, {first, layout.track.max.y}, outside);
  list->AddRectFilled({last, layout.track.min.y}, layout.track.max, outside);
}

void drawRange(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  const float left = layout.frames.toPixel(model.range.start);
  const float right = layout.frames.toPixel(model.range.end);
  const float opacity = model.rangeIsDefault ? 0.45F : 1.0F;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled({left, layout.ruler.min.y}, {right, layout.track.max.y},
                      faded(theme.colours.accent, 0.07F * opacity));
  const float bottom = layout.ruler.max.y;
  const ImU32 colour = faded(theme.colours.accent, opacity);
  list->AddRectFilled({left, bottom - theme.px(3.0F)}, {right, bottom}, colour);
  const float tab = theme.px(6.0F);
  const float top = bottom - theme.px(11.0F);
  list->AddTriangleFilled({left, top}, {left + tab, bottom}, {left, bottom}, colour);
  list->AddTriangleFilled({right, top}, {right, bottom}, {right - tab, bottom}, colour);
}

void drawKeys(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t row = 0; row < model.keyRows.size(); ++row) {
    const KeyRow& keys = model.keyRows[row];
    const Rect box = keyRowBox(theme, layout, row);
    if (keys.selected) {
      list->AddRectFilled({layout.labelLeft, box.min.y}, box.max, faded(theme.colours.accent, 0.10F));
    }
    list->AddLine({layout.labelLeft, box.max.y}, {box.max.x, box.max.y}, faded(theme.colours.border, 0.5F));
    const Rect label{{layout.labelLeft + theme.unit(), box.min.y},
                     {layout.track.min.x - theme.unit(), box.max.y}};
    drawText(context, theme.fonts.label, label, keys.selected ? theme.colours.text : theme.colours.quietText,
             keys.label);
    float lastX = -1e9F;
    for (const double frame : keys.frames) {
      const float x = layout.frames.toPixel(frame);
      if (x < layout.track.min.x || x > layout.track.max.x || x - lastX < theme.px(1.5F)) {
        continue; // diamonds that would cover each other say nothing
      }
      lastX = x;
      const bool here = std::abs(frame - model.playhead) < 0.5;
      addDiamond(*list, {x, box.centre().y}, theme.px(4.5F),
                 here ? theme.colours.accent : mixed(theme.colours.quietText, theme.colours.text, 0.35F));
    }
  }
}

void drawBar(const WidgetContext& context, const Layout& layout, const TimelineModel& model,
             std::size_t row) {
  const Theme& theme = context.theme;
  const TimelineBar& bar = model.bars[row];
  const Rect box = barBox(theme, layout, model, row, {bar.start, bar.end});
  const Rect whole = barBox(theme, layout, model, row, {bar.windowStart, bar.windowEnd});
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float strength = bar.active ? 0.55F : 0.28F;
  const ImU32 fill = mixed(theme.colours.sunken, bar.colour, strength);
  const ImU32 clear = faded(bar.colour, 0.02F);
  const ImU32 tail = faded(bar.colour, bar.active ? 0.45F : 0.25F);
  if (whole.max.x > box.max.x) {
    list->AddRectFilledMultiColor({box.max.x, box.min.y}, whole.max, tail, clear, clear, tail);
  }
  if (whole.min.x < box.min.x) {
    list->AddRectFilledMultiColor(whole.min, {box.min.x, box.max.y}, clear, tail, tail, clear);
  }
  list->AddRectFilled(box.min, box.max, fill, theme.corner());
  list->AddRect(box.min, box.max, bar.selected ? theme.colours.text : bar.colour, theme.corner(),
                ImDrawFlags_None, theme.px(bar.selected ? 1.5F : 1.0F));
  const Rect label{{layout.labelLeft + theme.unit(), box.min.y},
                   {layout.track.min.x - theme.unit(), box.max.y}};
  list->AddCircleFilled({label.min.x + theme.px(4.0F), label.centre().y}, theme.px(4.0F), bar.colour);
  drawText(context, theme.fonts.label, {{label.min.x + theme.px(14.0F), label.min.y}, label.max},
           bar.selected ? theme.colours.text : theme.colours.quietText, bar.label);
  if (bar.selected) {
    for (const double frame : model.spheres) {
      list->AddCircleFilled({layout.frames.toPixel(frame), box.centre().y}, theme.px(3.0F),
                            theme.colours.text);
    }
  }
}

void drawPlayhead(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  const float x = std::round(layout.frames.toPixel(model.playhead));
  if (x < layout.track.min.x || x > layout.track.max.x) {
    return;
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 colour = theme.colours.text;
  list->AddRectFilled({x - theme.px(0.75F), layout.ruler.min.y}, {x + theme.px(0.75F), layout.track.max.y},
                      colour);
  char text[24];
  const bool whole = std::abs(model.playhead - std::round(model.playhead)) < 1e-6;
  std::snprintf(text, sizeof text, whole ? "%.0f" : "%.1f", model.playhead);
  const float half = std::max(theme.px(14.0F), textSize(theme.fonts.label, text).x * 0.5F + theme.px(6.0F));
  const Rect flag{{x - half, layout.ruler.min.y + theme.px(1.0F)},
                  {x + half, layout.ruler.min.y + theme.px(18.0F)}};
  list->AddRectFilled(flag.min, flag.max, colour, theme.px(3.0F));
  drawText(context, theme.fonts.label, flag, theme.colours.panel, text, 0.5F);
}

struct Hit {
  TimelinePart part = TimelinePart::nothing;
  int bar = 0;
  Span span{0.0, 0.0};
};

Hit barHit(const Theme& theme, const Layout& layout, const TimelineModel& model, const ImVec2& mouse) {
  const float reach = theme.px(grabWidth);
  for (std::size_t row = 0; row < model.bars.size(); ++row) {
    const TimelineBar& bar = model.bars[row];
    const Rect box = barBox(theme, layout, model, row, {bar.start, bar.end});
    const Rect whole = barBox(theme, layout, model, row, {bar.windowStart, bar.windowEnd});
    if (mouse.y < box.min.y || mouse.y >= box.max.y) {
      continue;
    }
    const Span span{bar.start, bar.end};
    const Span window{bar.windowStart, bar.windowEnd};
    const bool releaseAfter = whole.max.x - box.max.x > reach;
    const bool releaseBefore = box.min.x - whole.min.x > reach;
    if (std::abs(mouse.x - box.min.x) <= reach) {
      return {TimelinePart::barStart, bar.id, span};
    }
    if (std::abs(mouse.x - box.max.x) <= reach) {
      return {TimelinePart::barEnd, bar.id, span};
    }
    if ((releaseAfter && std::abs(mouse.x - whole.max.x) <= reach) ||
        (releaseBefore && std::abs(mouse.x - whole.min.x) <= reach)) {
      return {TimelinePart::release, bar.id, window};
    }
    if (mouse.x > box.min.x && mouse.x < box.max.x) {
      return {TimelinePart::barBody, bar.id, span};
    }
  }
  return {};
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
  const Hit bar = barHit(theme, layout, model, mouse);
  return bar.part != TimelinePart::nothing ? bar : Hit{TimelinePart::playhead, 0, model.range};
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
    break;
  }
  return span;
}

bool differs(const Span& a, const Span& b) {
  return a.start != b.start || a.end != b.end;
}

void dragBar(const TimelineModel& model, const TimelineGesture& gesture, double frame,
             TimelineOutcome& outcome) {
  outcome.editedBar = gesture.bar;
  const auto bar = std::find_if(model.bars.begin(), model.bars.end(),
                                [&](const TimelineBar& b) { return b.id == gesture.bar; });
  if (bar == model.bars.end()) {
    return;
  }
  if (gesture.part == TimelinePart::release) {
    outcome.releaseEdge = snapped(model, frame);
    const double edge = bar->windowEnd > bar->end ? bar->windowEnd : bar->windowStart;
    outcome.releaseChanged = outcome.releaseEdge != edge;
    return;
  }
  outcome.barSpan = movedSpan(model, gesture, frame);
  outcome.barChanged = differs(outcome.barSpan, {bar->start, bar->end});
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
  case TimelinePart::nothing:
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

Help helpFor(TimelinePart part) {
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
    return {"Trail", "Click selects it, dragging moves its range.", {}};
  case TimelinePart::nothing:
  case TimelinePart::playhead:
  case TimelinePart::pan:
    break;
  }
  return {};
}

void recordItems(const WidgetContext& context, const std::string& id, const Layout& layout,
                 const TimelineModel& model) {
  const float reach = context.theme.px(4.0F);
  const auto add = [&](const std::string& name, float x, float y) {
    context.items.add(id + "/" + name, {x - reach, y - reach}, {x + reach, y + reach});
  };
  add("range-start", layout.frames.toPixel(model.range.start), layout.ruler.max.y - context.theme.px(5.0F));
  add("range-end", layout.frames.toPixel(model.range.end), layout.ruler.max.y - context.theme.px(5.0F));
  for (std::size_t row = 0; row < model.bars.size(); ++row) {
    const TimelineBar& bar = model.bars[row];
    const Rect box = barBox(context.theme, layout, model, row, {bar.start, bar.end});
    const std::string name = "trail-" + std::to_string(bar.id);
    add(name + "/start", box.min.x, box.centre().y);
    add(name + "/end", box.max.x, box.centre().y);
    add(name + "/body", box.centre().x, box.centre().y);
    if (bar.windowEnd > bar.end) {
      add(name + "/release", layout.frames.toPixel(bar.windowEnd), box.centre().y);
    }
  }
}

} // namespace

float timelineHeight(const Theme& theme, const TimelineModel& model) {
  return theme.px(rulerHeight + keyRowHeight * static_cast<float>(model.keyRows.size()) +
                  barRowHeight * static_cast<float>(model.bars.size()) + 12.0F);
}

TimelineOutcome timeline(const WidgetContext& context, const std::string& id, const TimelineModel& model,
                         TimelineGesture& gesture, float labelWidth, float height) {
  const Theme& theme = context.theme;
  TimelineOutcome outcome;
  const Control control = takePlace(context, id, {ImGui::GetContentRegionAvail().x, height});
  if (!control.visible) {
    return outcome;
  }
  const Layout layout = layoutOf(theme, control.box, model, labelWidth);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Hit hit = control.hovered ? hitTest(theme, layout, model, mouse) : Hit{};
  if (ImGui::IsItemActivated()) {
    gesture = {hit.part, hit.bar, layout.frames.toValue(mouse.x), hit.span};
    outcome.clickedBar = hit.bar;
  } else if (control.hovered && ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0F)) {
    applyGesture(model, layout, {.part = TimelinePart::pan}, mouse, outcome);
  }
  if (control.held && (gesture.part == TimelinePart::playhead ||
                       ImGui::IsMouseDragging(ImGuiMouseButton_Left, theme.px(2.0F)))) {
    applyGesture(model, layout, gesture, mouse, outcome);
  }
  if (ImGui::IsItemDeactivated()) {
    outcome.gestureEnded = true;
    gesture = {};
  }
  if (control.hovered) {
    applyWheel(model, layout, mouse, outcome);
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(control.box.min, control.box.max, theme.colours.sunken, theme.corner());
  list->PushClipRect(control.box.min, control.box.max, true);
  drawRuler(context, layout, model);
  drawRange(context, layout, model);
  drawKeys(context, layout, model);
  for (std::size_t row = 0; row < model.bars.size(); ++row) {
    drawBar(context, layout, model, row);
  }
  drawPlayhead(context, layout, model);
  list->PopClipRect();
  recordItems(context, id, layout, model);
  const TimelinePart shown = control.held ? gesture.part : hit.part;
  if (shown != TimelinePart::nothing && shown != TimelinePart::playhead && shown != TimelinePart::barBody) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (!control.held) {
    const Help help = helpFor(hit.part);
    tooltip(context, help);
  }
  return outcome;
}

} // namespace stretch::ui
