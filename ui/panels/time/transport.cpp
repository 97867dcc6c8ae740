#include "ui/panels/time/transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/commands/keys/clips.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/edits/keys/rate_edits.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/row_parts.h"
#include "ui/panels/rows/clip_name.h"
#include "ui/panels/rows/timeline_model.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

constexpr float clipLoopWidth = 84.0F;

void jumps(PanelContext& context) {
  const bool hasKeys = context.open.sequence() == nullptr;
  iconButton(context, command::timeStart, icon::toStart, "|<");
  if (hasKeys) {
    iconButton(context, command::timePreviousKey, icon::previousKey, "<k");
  }
  iconButton(context, command::timeBack, icon::stepBack, "<");
  commandButton(context, {.command = command::timePlay,
                          .icon = context.ui.time.timeline.playing ? icon::pause : icon::play,
                          .text = " ",
                          .width = context.theme.px(40.0F),
                          .fallback = context.ui.time.timeline.playing ? "||" : ">"});
  ImGui::SameLine(0.0F, context.theme.px(2.0F));
  iconButton(context, command::timeForward, icon::stepForward, ">");
  if (hasKeys) {
    iconButton(context, command::timeNextKey, icon::nextKey, "k>");
  }
  iconButton(context, command::timeEnd, icon::toEnd, ">|");
}

void loopSwitch(PanelContext& context) {
  ButtonSpec loop{.id = "timeline/loop",
                  .icon = icon::loop,
                  .emphasis = Emphasis::quiet,
                  .on = context.ui.time.timeline.loop,
                  .width = context.theme.px(30.0F),
                  .fallback = "L"};
  loop.help = {"Loop", "Plays from the start again at the end.", {}};
  if (button(widgetsOf(context), loop)) {
    context.ui.time.timeline.loop = !context.ui.time.timeline.loop;
  }
  ImGui::SameLine(0.0F, context.theme.unit());
}

/// Whether the clip is played as a loop: another thing than playing it again and again here.
void clipLoopSwitch(PanelContext& context) {
  commandButton(
      context,
      {.command = command::clipLoop, .emphasis = Emphasis::quiet, .width = context.theme.px(clipLoopWidth)});
  ImGui::SameLine(0.0F, context.theme.unit());
}

/// Wide enough for the last frame of a clip of thousands.
float frameFieldWidth(const Theme& theme, double lastFrame) {
  const double digits = std::floor(std::log10(std::max(1.0, lastFrame))) + 1.0;
  return theme.px(56.0F) + theme.px(9.0F) * static_cast<float>(std::max(0.0, digits - 3.0));
}

void frameField(PanelContext& context, const ShownTime& time) {
  SliderSpec spec{.id = "timeline/frame",
                  .maximum = std::max(1.0, time.last),
                  .step = 1.0,
                  .decimals = frameDecimals(*time.frame),
                  .showsFill = false,
                  .width = frameFieldWidth(context.theme, time.last)};
  spec.help = {"Frame", "Drag, or click and type the frame to go to.", {}};
  double frame = *time.frame;
  if (slider(widgetsOf(context), spec, frame).changed) {
    *time.frame = frame;
  }
  ImGui::SameLine(0.0F, context.theme.unit());
}

/// Speeds, and below them how playing goes on.
void speedChooser(PanelContext& context) {
  constexpr std::array<double, 5> speeds{0.1, 0.25, 0.5, 1.0, 2.0};
  TimelineState& time = context.ui.time.timeline;
  std::vector<Choice> choices;
  int selected = 3;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    choices.push_back({"\xC3\x97" + shortNumber(speeds[i])});
    selected = std::abs(speeds[i] - time.speed) < 1e-9 ? static_cast<int>(i) : selected;
  }
  for (const char* id : {command::timeEveryFrame, command::timeOnTwos}) {
    const CommandInfo* const info = findCommand(context, id);
    choices.push_back(
        {info == nullptr ? id : info->label, {}, info != nullptr, info != nullptr && info->checked});
    if (info != nullptr) {
      choices.back().help = {info->label, info->help, info->keyText};
    }
  }
  const int chosen =
      dropdown(widgetsOf(context), "timeline/speed", choices, selected,
               {"Playback", "Speed, of real time; every frame or in time; on ones or twos.", {}},
               context.theme.px(72.0F));
  if (chosen >= static_cast<int>(speeds.size())) {
    request(context,
            chosen == static_cast<int>(speeds.size()) ? command::timeEveryFrame : command::timeOnTwos);
  } else if (chosen >= 0) {
    time.speed = speeds[static_cast<std::size_t>(chosen)];
  }
  ImGui::SameLine(0.0F, context.theme.unit());
}

/// At which rate the clip is worked on: its own, or one that films are made at.
void rateChooser(PanelContext& context) {
  const app::Session& session = context.character();
  const int clip = session.view().clip;
  const double own = app::ownRate(session.document(), clip);
  const double now = app::clipOf(session.document(), clip).framesPerSecond;
  std::vector<std::pair<double, const char*>> rates{{own, command::clipRateOwn}};
  for (const auto& usual : {std::pair(24.0, command::clipRate24), std::pair(25.0, command::clipRate25),
                            std::pair(30.0, command::clipRate30)}) {
    if (std::abs(usual.first - own) > 1e-6) {
      rates.push_back(usual);
    }
  }
  std::vector<Choice> choices;
  int selected = -1;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    choices.push_back({shortNumber(rates[i].first) + "\xC2\xA0"
                                                     "fps"});
    choices.back().help = {i == 0 ? "The clip's own rate" : "Work at this rate",
                           "Frames are counted in it; keys and motion stay as they are.",
                           {}};
    choices.back().note = i == 0 ? "the clip's own" : "";
    selected = std::abs(rates[i].first - now) < 1e-6 ? static_cast<int>(i) : selected;
  }
  const std::string other = shortNumber(now) + " fps"; // Of the option --fps.
  const int chosen =
      dropdown(widgetsOf(context), "timeline/rate", choices, selected,
               {"Frame rate", "In which frames are counted. The keys stay where they are.", {}},
               context.theme.px(84.0F), other.c_str());
  if (chosen >= 0 && chosen != selected) {
    request(context, rates[static_cast<std::size_t>(chosen)].second);
  }
  ImGui::SameLine(0.0F, context.theme.unit());
}

std::string rangeText(const PanelContext& context) {
  if (context.open.sequence() != nullptr) {
    const MeshSequence& mesh = *context.sequence().document().mesh;
    const std::size_t frame = app::shownFrame(context.sequence());
    return frame < mesh.frameNames.size() ? mesh.frameNames[frame] : std::string();
  }
  const Span range = shownSpan(context.character());
  return "range " + shortNumber(range.start, 1) + "\xE2\x80\x93" + shortNumber(range.end, 1);
}

Help rangeHelp(const PanelContext& context) {
  if (context.open.sequence() != nullptr) {
    return {
        "Frame, time and rate", "Mesh sequences carry no rate of their own unless their file says one.", {}};
  }
  return {"Working range, time and rate",
          "The playhead's time, and the frames of the working range, which new trails take. Set it with the "
          "keys or by dragging its ends in the ruler.",
          keyOf(context, command::rangeStart) + "  " + keyOf(context, command::rangeEnd)};
}

void timeText(PanelContext& context, const ShownTime& time) {
  const WidgetContext widgets = widgetsOf(context);
  std::vector<std::string> words{rangeText(context)};
  if (context.open.sequence() != nullptr) {
    words.push_back(shortNumber(time.framesPerSecond) + " fps");
  }
  const double seconds = *time.frame / time.framesPerSecond;
  const float width = ImGui::GetContentRegionAvail().x;
  std::string text = timeWords(seconds, words);
  while (!words.empty() && textSize(context.theme.fonts.label, text).x > width) {
    words.pop_back(); // Rather whole words than the start of the next.
    text = timeWords(seconds, words);
  }
  if (width < context.theme.px(48.0F)) {
    ImGui::NewLine(); // What follows stands below the row all the same.
    return;
  }
  const Control place =
      takePlace(widgets, "timeline/text", {std::max(1.0F, width), context.theme.rowHeight()}, false);
  drawText(widgets, context.theme.fonts.label, place.box, context.theme.colours.quietText, text, 1.0F);
  tooltip(widgets, rangeHelp(context));
}

/// ", 2 trails": the work in a clip; empty without any.
std::string workText(const app::Document& document, int clip) {
  const auto trails =
      std::ranges::count_if(document.trails, [&](const rig::Trail& trail) { return trail.clip == clip; });
  std::string text = trails == 0 ? "" : trails == 1 ? ", 1 trail" : ", " + std::to_string(trails) + " trails";
  return text + (app::hasWeight(document, clip) ? ", weight" : "");
}

/// As wide as the shown clip's name asks for, in what the other parts leave of the row.
float clipChooserWidth(const PanelContext& context, const std::vector<RowControl>& others, float available) {
  const Theme& theme = context.theme;
  const app::Session& session = *context.open.character();
  const int clip = session.view().clip;
  const std::string name =
      clipName(app::clipOf(session.document(), clip).name, static_cast<std::size_t>(clip));
  float left = available - theme.px(60.0F); // Of the text at the row's end.
  for (const RowControl& part : others) {
    left -= part.width;
  }
  const float wanted = textSize(theme.fonts.body, name).x + theme.px(42.0F);
  return std::clamp(wanted, theme.px(110.0F), std::max(theme.px(150.0F), left));
}

} // namespace

std::string timeWords(double playheadSeconds, const std::vector<std::string>& others) {
  std::string text = "time " + shortNumber(playheadSeconds) + " s";
  for (const std::string& other : others) {
    if (!other.empty()) {
      text.append("  \xC2\xB7  ").append(other);
    }
  }
  return text;
}

ShownTime shownTime(PanelContext& context) {
  if (context.open.sequence() != nullptr) {
    return {&context.sequence().view().frame, app::lastFrame(context.sequence()),
            context.sequence().document().mesh->framesPerSecond};
  }
  app::Session& session = context.character();
  const app::Document& document = session.document();
  const int clip = session.view().clip;
  return {&session.view().frame, app::lastFrame(document, clip), app::clipOf(document, clip).framesPerSecond};
}

void drawTransport(PanelContext& context) {
  const ShownTime time = shownTime(context);
  const Theme& theme = context.theme;
  jumps(context);
  std::vector<RowControl> parts{{theme.px(30.0F) + theme.unit(), [&] { loopSwitch(context); }},
                                {theme.px(56.0F) + theme.unit(), [&] { frameField(context, time); }},
                                {theme.px(72.0F) + theme.unit(), [&] { speedChooser(context); }}};
  if (context.open.character() != nullptr) {
    parts.push_back({theme.px(84.0F) + theme.unit(), [&] { rateChooser(context); }});
    parts.push_back({theme.px(clipLoopWidth) + theme.unit(), [&] { clipLoopSwitch(context); }});
    if (context.character().document().clips->size() > 1) {
      const float width = clipChooserWidth(context, parts, ImGui::GetContentRegionAvail().x);
      parts.push_back({width + theme.unit(), [&context, width] {
                         clipChooser(context, "timeline/clip", width);
                         ImGui::SameLine(0.0F, context.theme.unit());
                       }});
    }
  }
  rowOfParts(context, "timeline/more", ImGui::GetContentRegionAvail().x, parts);
  timeText(context, time);
}

void clipChooser(PanelContext& context, const std::string& id, float width) {
  constexpr std::size_t manyClips = 8;
  const std::vector<Clip>& clips = *context.character().document().clips;
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const std::string seconds = shortNumber(clips[i].endSeconds) + " s";
    const std::string work = workText(context.character().document(), static_cast<int>(i));
    choices.push_back({clipName(clips[i].name, i),
                       {.title = clipName(clips[i].name, i), .text = seconds + work},
                       true,
                       !work.empty()});
    choices.back().note = clips.size() > manyClips ? seconds : "";
  }
  const Help help{.title = "Clip",
                  .text = "The animation to work on. Trails belong to the clip that they were made in.",
                  .keyText =
                      keyOf(context, command::clipPrevious) + "  " + keyOf(context, command::clipNext)};
  std::string* const filter = clips.size() > manyClips ? &context.ui.time.clipFilter : nullptr;
  const int chosen =
      dropdown(widgetsOf(context), id, choices, context.character().view().clip, help, width, "", filter);
  if (chosen >= 0 && chosen != context.character().view().clip) {
    app::showClip(context.character(), chosen);
  }
}

} // namespace stretch::ui
