#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/widgets/icons.h"
#include "ui/widgets/shapes.h"
#include "ui/widgets/timeline_detail.h"

namespace stretch::ui {

namespace timeline_detail {

namespace {

constexpr float rulerHeight = 26.0F;
constexpr float laneHeight = 16.0F;
constexpr float soundHeight = 36.0F;
constexpr float keyRowHeight = 22.0F;
constexpr float barRowHeight = 24.0F;

std::string playheadText(const TimelineModel& model) {
  char text[24];
  const bool whole = std::abs(model.playhead - std::round(model.playhead)) < 1e-6;
  std::snprintf(text, sizeof text, whole ? "%.0f" : "%.1f", model.playhead);
  return text;
}

/// Where the ruler says the playhead's frame.
Rect playheadFlag(const Theme& theme, const Layout& layout, const TimelineModel& model) {
  const float x = std::round(layout.frames.toPixel(model.playhead));
  const float half =
      std::max(theme.px(14.0F), textSize(theme.fonts.label, playheadText(model)).x * 0.5F + theme.px(6.0F));
  return {{x - half, layout.ruler.min.y + theme.px(1.0F)}, {x + half, layout.ruler.min.y + theme.px(18.0F)}};
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
  }
  // Frames that the clip does not have are covered.
  const float first =
      std::clamp(layout.frames.toPixel(model.clip.start), layout.track.min.x, layout.track.max.x);
  const float last =
      std::clamp(layout.frames.toPixel(model.clip.end), layout.track.min.x, layout.track.max.x);
  const ImU32 outside = faded(colours.background, 0.55F);
  list->AddRectFilled(layout.track.min, {first, layout.track.max.y}, outside);
  list->AddRectFilled({last, layout.track.min.y}, layout.track.max, outside);
  const Rect flag = playheadFlag(theme, layout, model);
  for (const double frame : marks(layout.frames, numbered)) {
    const float half = theme.px(26.0F);
    char text[24];
    std::snprintf(text, sizeof text, "%.0f", frame);
    const float width = textSize(theme.fonts.label, text).x;
    // The last number of a long clip is drawn whole, though its mark is at the edge.
    const float x =
        std::min(layout.frames.toPixel(frame), std::ceil(list->GetClipRectMax().x - 0.5F * width));
    if (x + 0.5F * width > flag.min.x - theme.px(3.0F) && x - 0.5F * width < flag.max.x + theme.px(3.0F)) {
      continue; // The playhead's flag would cover a part of it.
    }
    const Rect place{{x - half, layout.ruler.min.y}, {x + half, layout.ruler.max.y - theme.px(7.0F)}};
    drawText(context, theme.fonts.label, place, colours.quietText, text, 0.5F);
  }
}

/// Arrows at the seam of a loop: out at the clip's end, in at its start.
void drawSeam(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  const float reach = theme.px(6.0F);
  const float middle = layout.ruler.max.y - theme.px(5.0F); // Below the numbers.
  for (const float x : {layout.frames.toPixel(model.clip.start) - reach,
                        layout.frames.toPixel(model.clip.end) + theme.px(1.0F)}) {
    if (model.loops && x >= layout.track.min.x && x + reach <= layout.track.max.x) {
      ImGui::GetWindowDrawList()->AddTriangleFilled({x, middle - 0.7F * reach}, {x + reach, middle},
                                                    {x, middle + 0.7F * reach}, theme.colours.accent);
    }
  }
}

void drawRange(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  const float left = layout.frames.toPixel(model.range.start);
  const float right = layout.frames.toPixel(model.range.end);
  const float opacity = model.rangeIsDefault ? 0.45F : 1.0F;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(layout.track.min, layout.track.max, true);
  list->AddRectFilled({left, layout.ruler.min.y}, {right, layout.track.max.y},
                      faded(theme.colours.accent, 0.07F * opacity));
  const float bottom = layout.ruler.max.y;
  const ImU32 colour = faded(theme.colours.accent, opacity);
  list->AddRectFilled({left, bottom - theme.px(3.0F)}, {right, bottom}, colour);
  const float tab = theme.px(6.0F);
  const float top = bottom - theme.px(11.0F);
  list->AddTriangleFilled({left, top}, {left + tab, bottom}, {left, bottom}, colour);
  list->AddTriangleFilled({right, top}, {right, bottom}, {right - tab, bottom}, colour);
  list->PopClipRect();
}

void drawKeyMark(const Theme& theme, const KeyRow& keys, const ImVec2& at, float radius, ImU32 colour) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (keys.offsetKeys) {
    list->AddCircleFilled(at, theme.px(radius - 0.5F), colour);
  } else {
    addDiamond(*list, at, theme.px(radius), colour);
  }
}

void drawKeyRow(const WidgetContext& context, const Layout& layout, const TimelineModel& model,
                const KeyRow& keys, float y) {
  const Theme& theme = context.theme;
  const ImU32 plain = keys.offsetKeys ? trailColour(0, theme.kind)
                                      : mixed(theme.colours.quietText, theme.colours.text, 0.35F);
  float lastX = -1e9F;
  const auto first = std::lower_bound(keys.frames.begin(), keys.frames.end(), model.view.start - 1.0);
  for (auto frame = first; frame != keys.frames.end() && *frame <= model.view.end + 1.0; ++frame) {
    const float x = layout.frames.toPixel(*frame);
    if (x < layout.track.min.x || x > layout.track.max.x || x - lastX < theme.px(1.5F)) {
      continue; // marks that would cover each other say nothing
    }
    lastX = x;
    const bool here = std::abs(*frame - model.playhead) < 0.5;
    drawKeyMark(theme, keys, {x, y}, 4.5F, here ? theme.colours.accent : plain);
  }
  for (const double frame : keys.picked) {
    const float x = layout.frames.toPixel(frame);
    if (x >= layout.track.min.x && x <= layout.track.max.x) {
      drawKeyMark(theme, keys, {x, y}, 6.5F, theme.colours.background);
      drawKeyMark(theme, keys, {x, y}, 5.5F, theme.colours.text);
    }
  }
}

void drawKeys(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t row = 0; row < model.keyRows.size(); ++row) {
    const KeyRow& keys = model.keyRows[row];
    const Rect box = keyRowBox(theme, layout, model, row);
    if (keys.selected) {
      list->AddRectFilled({layout.labelLeft, box.min.y}, box.max, faded(theme.colours.accent, 0.10F));
    }
    list->AddLine({layout.labelLeft, box.max.y}, {box.max.x, box.max.y}, faded(theme.colours.border, 0.5F));
    const Rect label{{layout.labelLeft + theme.unit(), box.min.y},
                     {layout.track.min.x - theme.unit(), box.max.y}};
    drawText(context, theme.fonts.label, label, keys.selected ? theme.colours.text : theme.colours.quietText,
             keys.label);
    drawKeyRow(context, layout, model, keys, box.centre().y);
  }
}

/// From the wind-up to the tip a line, at the tip a mark, larger for a stronger moment; the strongest on top.
void drawMoments(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  const Theme& theme = context.theme;
  if (model.moments.empty()) {
    return;
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float y = layout.lane.centre().y;
  list->AddLine({layout.labelLeft, layout.lane.max.y}, {layout.lane.max.x, layout.lane.max.y},
                faded(theme.colours.border, 0.5F));
  const Rect label{{layout.labelLeft + theme.unit(), layout.lane.min.y},
                   {layout.track.min.x - theme.unit(), layout.lane.max.y}};
  drawText(context, theme.fonts.label, label, theme.colours.quietText, "Moments");
  std::vector<const TimelineMoment*> weakestFirst;
  for (const TimelineMoment& moment : model.moments) {
    weakestFirst.push_back(&moment);
  }
  std::ranges::stable_sort(weakestFirst, {}, [](const TimelineMoment* moment) {
    return std::pair(moment->current, moment->strength);
  });
  list->PushClipRect(layout.track.min, layout.track.max, true);
  for (const TimelineMoment* const moment : weakestFirst) {
    const ImU32 colour =
        moment->current ? theme.colours.accent
                        : mixed(theme.colours.quietText, theme.colours.text, 0.3F + 0.7F * moment->strength);
    const ImVec2 tip{layout.frames.toPixel(moment->tip), y};
    const float radius = theme.px(3.0F + 3.0F * moment->strength);
    list->AddLine({layout.frames.toPixel(moment->start), y}, tip, faded(colour, 0.6F), theme.px(1.5F));
    addDiamond(*list, tip, radius + theme.px(1.5F), theme.colours.sunken); // Stands off from its neighbours.
    addDiamond(*list, tip, radius, colour);
    if (moment->repeats) {
      addDiamond(*list, tip, radius - theme.px(1.75F), theme.colours.sunken);
    }
  }
  list->PopClipRect();
}

/// The wave of the sound, a line for each pixel.
void drawSound(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  if (!model.sound) {
    return;
  }
  const Theme& theme = context.theme;
  const TimelineSound& sound = *model.sound;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddLine({layout.labelLeft, layout.sound.max.y}, {layout.sound.max.x, layout.sound.max.y},
                faded(theme.colours.border, 0.5F));
  const Rect label{{layout.labelLeft + theme.unit(), layout.sound.min.y},
                   {layout.track.min.x - theme.unit(), layout.sound.max.y}};
  drawText(context, theme.fonts.label, label, theme.colours.quietText, sound.label);
  const float first = std::max(layout.sound.min.x, std::floor(layout.frames.toPixel(sound.frames.start)));
  const float last = std::min(layout.sound.max.x, std::ceil(layout.frames.toPixel(sound.frames.end)));
  const float middle = layout.sound.centre().y;
  const float reach = 0.5F * layout.sound.height() - theme.px(2.0F);
  const ImU32 colour = mixed(theme.colours.quietText, theme.colours.accent, 0.5F);
  for (float x = first; x < last; x += 1.0F) {
    const auto [low, high] = sound.peak(layout.frames.toValue(x), layout.frames.toValue(x + 1.0F));
    // Silence is a line too.
    list->AddRectFilled(
        {x, std::floor(middle - high * reach)},
        {x + 1.0F, std::max(std::floor(middle - high * reach) + 1.0F, std::ceil(middle - low * reach))},
        colour);
  }
}

/// A release from the bar's edge `from` to `to`, later or earlier: it fades. On a loop what lies past the
/// clip's end stands at its start, and the other way round.
void drawRelease(const Layout& layout, const TimelineModel& model, const Rect& box, const TimelineBar& bar,
                 double from, double to) {
  const double length = to - from;
  if (std::abs(length) < 1e-6) {
    return;
  }
  const float strength = bar.active ? 0.45F : 0.25F;
  const auto piece = [&](double near, double far, double shift) {
    const auto tint = [&](double frame) {
      return faded(bar.colour, 0.02F + strength * static_cast<float>((to - frame) / length));
    };
    const float x0 = layout.frames.toPixel(near + shift);
    const float x1 = layout.frames.toPixel(far + shift);
    const ImU32 left = tint(near < far ? near : far);
    const ImU32 right = tint(near < far ? far : near);
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor(
        {std::min(x0, x1), box.min.y}, {std::max(x0, x1), box.max.y}, left, right, right, left);
  };
  const double seam = length > 0.0 ? model.clip.end : model.clip.start;
  const bool crosses = model.loops && (length > 0.0 ? to > seam : to < seam);
  piece(from, crosses ? seam : to, 0.0);
  if (crosses) {
    piece(seam, to, length > 0.0 ? -model.turn : model.turn);
  }
}

/// On a bar of a trail that was applied.
void drawCheck(const Theme& theme, const Rect& box, ImU32 colour) {
  const ImVec2 at{box.max.x - theme.px(14.0F), box.centre().y};
  const ImVec2 points[] = {{at.x - theme.px(4.0F), at.y},
                           {at.x - theme.px(1.0F), at.y + theme.px(3.5F)},
                           {at.x + theme.px(5.0F), at.y - theme.px(4.0F)}};
  if (box.width() > theme.px(26.0F)) {
    ImGui::GetWindowDrawList()->AddPolyline(points, 3, colour, ImDrawFlags_None, theme.px(2.0F));
  }
}

void drawBarLabel(const WidgetContext& context, const Layout& layout, const TimelineBar& bar,
                  const Rect& box) {
  const Theme& theme = context.theme;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Rect label{{layout.labelLeft + theme.unit(), box.min.y},
                   {layout.track.min.x - theme.unit(), box.max.y}};
  if (bar.id > 0) {
    list->AddCircleFilled({label.min.x + theme.px(4.0F), label.centre().y}, theme.px(4.0F), bar.colour);
  } else {
    drawText(context, theme.fonts.label,
             {{label.min.x, label.min.y}, {label.min.x + theme.px(12.0F), label.max.y}}, bar.colour,
             icon::pin);
  }
  drawText(context, theme.fonts.label, {{label.min.x + theme.px(14.0F), label.min.y}, label.max},
           bar.selected ? theme.colours.text : theme.colours.quietText, bar.label);
}

void drawBar(const WidgetContext& context, const Layout& layout, const TimelineModel& model,
             std::size_t place) {
  const Theme& theme = context.theme;
  const TimelineBar& bar = model.bars[place];
  const Rect box = barBox(theme, layout, model, bar, {bar.start, bar.end});
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float strength = bar.active ? 0.55F : 0.28F;
  const ImU32 fill = mixed(theme.colours.sunken, bar.colour, strength);
  list->PushClipRect(layout.track.min, layout.track.max, true); // The names stand left of it.
  drawRelease(layout, model, box, bar, bar.end, bar.windowEnd);
  drawRelease(layout, model, box, bar, bar.start, bar.windowStart);
  list->AddRectFilled(box.min, box.max, fill, theme.corner());
  list->AddRect(box.min, box.max, bar.selected ? theme.colours.text : bar.colour, theme.corner(),
                ImDrawFlags_None, theme.px(bar.selected ? 1.5F : 1.0F));
  for (const double frame : bar.selected ? model.spheres : std::vector<double>{}) {
    list->AddCircleFilled({layout.frames.toPixel(frame), box.centre().y}, theme.px(3.0F), theme.colours.text);
  }
  if (bar.applied) {
    drawCheck(theme, box, theme.colours.text);
  }
  list->PopClipRect();
  const bool isLabelled =
      std::any_of(model.bars.begin(), model.bars.begin() + static_cast<std::ptrdiff_t>(place),
                  [&](const TimelineBar& other) { return other.row == bar.row; });
  if (!isLabelled) {
    drawBarLabel(context, layout, bar, box);
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
  const Rect flag = playheadFlag(theme, layout, model);
  list->AddRectFilled(flag.min, flag.max, colour, theme.px(3.0F));
  drawText(context, theme.fonts.label, flag, theme.colours.panel, playheadText(model), 0.5F);
}

} // namespace

Layout layoutOf(const Theme& theme, const Rect& box, const TimelineModel& model, float labelWidth) {
  Layout layout;
  layout.box = box;
  const float left = box.min.x + labelWidth;
  const float right = box.max.x - theme.px(12.0F);
  layout.track = {{left, box.min.y}, {box.max.x, box.max.y}};
  layout.ruler = {{left, box.min.y}, {box.max.x, box.min.y + theme.px(rulerHeight)}};
  const float lane = model.moments.empty() ? 0.0F : theme.px(laneHeight);
  layout.lane = {{left, layout.ruler.max.y}, {box.max.x, layout.ruler.max.y + lane}};
  layout.sound = {{left, layout.lane.max.y},
                  {box.max.x, layout.lane.max.y + (model.sound ? theme.px(soundHeight) : 0.0F)}};
  layout.frames = {model.view.start, std::max(model.view.end, model.view.start + 1e-6),
                   left + theme.px(12.0F), right};
  layout.labelLeft = box.min.x;
  return layout;
}

Rect keyRowBox(const Theme& theme, const Layout& layout, const TimelineModel& model, std::size_t row) {
  const float y = layout.sound.max.y + theme.px(barRowHeight) * static_cast<float>(model.rowsAbove) +
                  theme.px(keyRowHeight) * static_cast<float>(row);
  return {{layout.track.min.x, y}, {layout.track.max.x, y + theme.px(keyRowHeight)}};
}

Rect barBox(const Theme& theme, const Layout& layout, const TimelineModel& model, const TimelineBar& bar,
            const Span& span) {
  const bool isAbove = bar.row < model.rowsAbove;
  const float keys = theme.px(keyRowHeight) * static_cast<float>(model.keyRows.size()) + theme.px(4.0F);
  const float y =
      layout.sound.max.y + (isAbove ? 0.0F : keys) + theme.px(barRowHeight) * static_cast<float>(bar.row);
  return {{layout.frames.toPixel(span.start), y + theme.px(2.0F)},
          {layout.frames.toPixel(span.end), y + theme.px(barRowHeight - 2.0F)}};
}

std::size_t keyRowAt(const Theme& theme, const Layout& layout, const TimelineModel& model, float y) {
  for (std::size_t row = 0; row < model.keyRows.size(); ++row) {
    const Rect box = keyRowBox(theme, layout, model, row);
    if (y >= box.min.y && y < box.max.y) {
      return row;
    }
  }
  return model.keyRows.size();
}

std::string cutLabelAt(const Theme& theme, const Layout& layout, const TimelineModel& model,
                       const ImVec2& mouse) {
  if (mouse.x < layout.labelLeft || mouse.x >= layout.track.min.x) {
    return {};
  }
  std::string label;
  float indent = 0.0F;
  if (const std::size_t row = keyRowAt(theme, layout, model, mouse.y); row < model.keyRows.size()) {
    label = model.keyRows[row].label;
  }
  for (const TimelineBar& bar : model.bars) {
    const Rect box = barBox(theme, layout, model, bar, {bar.start, bar.end});
    if (mouse.y >= box.min.y && mouse.y < box.max.y) {
      label = bar.label;
      indent = theme.px(14.0F);
    }
  }
  const float room = layout.track.min.x - layout.labelLeft - 2.0F * theme.unit() - indent;
  return textSize(theme.fonts.label, label).x > room ? label : std::string();
}

void draw(const WidgetContext& context, const Layout& layout, const TimelineModel& model) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(layout.box.min, layout.box.max, context.theme.colours.sunken, context.theme.corner());
  list->PushClipRect(layout.box.min, layout.box.max, true);
  drawRuler(context, layout, model);
  drawSeam(context, layout, model);
  drawRange(context, layout, model);
  drawMoments(context, layout, model);
  drawSound(context, layout, model);
  drawKeys(context, layout, model);
  for (std::size_t place = 0; place < model.bars.size(); ++place) {
    drawBar(context, layout, model, place);
  }
  drawPlayhead(context, layout, model);
  list->PopClipRect();
}

} // namespace timeline_detail

float timelineLabelWidth(const Theme& theme, const TimelineModel& model) {
  constexpr float least = 112.0F;
  constexpr float most = 240.0F;
  constexpr float mostOfHold = 130.0F; ///< Its long name is cut: the frames need the room.
  float width = 0.0F;
  for (const KeyRow& row : model.keyRows) {
    width = std::max(width, textSize(theme.fonts.label, row.label).x);
  }
  for (const TimelineBar& bar : model.bars) {
    const float own = textSize(theme.fonts.label, bar.label).x + theme.px(14.0F);
    width = std::max(width, bar.id < 0 ? std::min(own, theme.px(mostOfHold)) : own);
  }
  return std::clamp(std::ceil(width) + theme.px(20.0F), theme.px(least), theme.px(most));
}

float timelineHeight(const Theme& theme, const TimelineModel& model) {
  using namespace timeline_detail;
  std::size_t rows = 0;
  for (const TimelineBar& bar : model.bars) {
    rows = std::max(rows, bar.row + 1);
  }
  return theme.px(rulerHeight + (model.moments.empty() ? 0.0F : laneHeight) +
                  (model.sound ? soundHeight : 0.0F) +
                  keyRowHeight * static_cast<float>(model.keyRows.size()) +
                  barRowHeight * static_cast<float>(rows) + 12.0F);
}

} // namespace stretch::ui
