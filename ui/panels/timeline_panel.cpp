#include <algorithm>
#include <cmath>

#include "app/commands/frames.h"
#include "app/commands/selection.h"
#include "app/edits/trail_edits.h"
#include "ui/panels/clip_chooser.h"
#include "ui/panels/command_ids.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
#include "ui/panels/timeline_model.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

constexpr float labelWidth = 112.0F;

void frameField(PanelContext& context) {
  app::Session& session = *context.session;
  SliderSpec spec{.id = "timeline/frame",
                  .maximum = std::max(1.0, app::lastFrame(session.document(), session.view().clip)),
                  .step = 1.0,
                  .decimals = 0,
                  .showsFill = false,
                  .width = context.theme.px(56.0F)};
  spec.help = {"Frame", "Drag, or double click to type the frame to go to.", {}};
  double frame = session.view().frame;
  if (slider(widgetsOf(context), spec, frame).changed) {
    session.view().frame = frame;
  }
  ImGui::SameLine(0.0F, context.theme.unit());
}

void speedChooser(PanelContext& context) {
  constexpr std::array<double, 5> speeds{0.1, 0.25, 0.5, 1.0, 2.0};
  TimelineState& time = context.ui.timeline;
  std::vector<Choice> choices;
  int selected = 3;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    choices.push_back({"\xC3\x97" + shortNumber(speeds[i])});
    selected = std::abs(speeds[i] - time.speed) < 1e-9 ? static_cast<int>(i) : selected;
  }
  const int chosen = dropdown(widgetsOf(context), "timeline/speed", choices, selected,
                              {"Playback speed", "Of real time.", {}}, context.theme.px(72.0F));
  time.speed = chosen >= 0 ? speeds[static_cast<std::size_t>(chosen)] : time.speed;
  ImGui::SameLine(0.0F, context.theme.unit());
}

void rangeText(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const app::Session& session = *context.session;
  const Clip& clip = app::clipOf(session.document(), session.view().clip);
  const Span range = shownRange(session);
  const std::string text = "range " + shortNumber(range.start, 1) + "\xE2\x80\x93" +
                           shortNumber(range.end, 1) + "   " +
                           shortNumber(session.view().frame / clip.framesPerSecond) + " s   " +
                           shortNumber(clip.framesPerSecond) + " fps";
  const float width = ImGui::GetContentRegionAvail().x;
  const Control place =
      takePlace(widgets, "timeline/text", {std::max(1.0F, width), context.theme.rowHeight()}, false);
  drawText(widgets, context.theme.fonts.label, place.box, context.theme.colours.quietText, text, 1.0F);
  tooltip(widgets,
          {"Working range, time and rate",
           "New trails take the working range. Set it with the keys or by dragging its ends in the ruler.",
           keyOf(context, command::rangeStart) + "  " + keyOf(context, command::rangeEnd)});
}

void transport(PanelContext& context) {
  iconButton(context, command::timeStart, icon::toStart, "|<");
  iconButton(context, command::timePreviousKey, icon::previousKey, "<k");
  iconButton(context, command::timeBack, icon::stepBack, "<");
  commandButton(context, {.command = command::timePlay,
                          .icon = context.ui.timeline.playing ? icon::pause : icon::play,
                          .text = " ",
                          .width = context.theme.px(40.0F),
                          .fallback = context.ui.timeline.playing ? "||" : ">"});
  ImGui::SameLine(0.0F, context.theme.px(2.0F));
  iconButton(context, command::timeForward, icon::stepForward, ">");
  iconButton(context, command::timeNextKey, icon::nextKey, "k>");
  iconButton(context, command::timeEnd, icon::toEnd, ">|");
  ButtonSpec loop{.id = "timeline/loop",
                  .icon = icon::loop,
                  .emphasis = Emphasis::quiet,
                  .on = context.ui.timeline.loop,
                  .width = context.theme.px(30.0F),
                  .fallback = "L"};
  loop.help = {"Loop", "Plays from the start again at the end.", {}};
  if (button(widgetsOf(context), loop)) {
    context.ui.timeline.loop = !context.ui.timeline.loop;
  }
  ImGui::SameLine(0.0F, context.theme.unit());
  frameField(context);
  speedChooser(context);
  if (context.session->document().clips->size() > 1) {
    clipChooser(context, "timeline/clip", context.theme.px(150.0F));
    ImGui::SameLine(0.0F, context.theme.unit());
  }
  rangeText(context);
}

void applyRange(app::Session& session, const TimelineOutcome& outcome) {
  if (outcome.rangeChanged) {
    session.view().rangeStart = outcome.range.start;
    session.view().rangeEnd = outcome.range.end;
  }
  if (outcome.playheadMoved) {
    session.view().frame = outcome.playhead;
  }
}

/// Control spheres keep their place in the range's time when the whole range moves.
void moveRange(rig::TrailSettings& settings, const Span& span) {
  const double shift = span.start - settings.startFrame;
  const bool whole = std::abs((span.end - settings.endFrame) - shift) < 1e-9;
  if (whole) {
    for (rig::SphereOffset& sphere : settings.spheres) {
      sphere.frame += shift;
    }
  }
  settings.startFrame = span.start;
  settings.endFrame = span.end;
}

void applyBars(PanelContext& context, const TimelineOutcome& outcome) {
  app::Session& session = *context.session;
  if (outcome.clickedBar != 0) {
    app::selectTrail(session, outcome.clickedBar);
  }
  const EditPhase phase{outcome.barChanged || outcome.releaseChanged, outcome.gestureEnded};
  const int id = outcome.editedBar;
  editThrough(context, phase, outcome.releaseChanged ? "Change the release" : "Change the range",
              [&](const app::Document& start) -> Result<app::Document> {
                const rig::Trail* trail = app::findTrail(start, id);
                if (trail == nullptr) {
                  return app::missingTrail(id);
                }
                rig::TrailSettings settings = trail->settings;
                if (outcome.barChanged) {
                  moveRange(settings, outcome.barSpan);
                } else {
                  const double frames = settings.pivot == rig::Pivot::start
                                            ? outcome.releaseEdge - settings.endFrame
                                            : settings.startFrame - outcome.releaseEdge;
                  settings.releaseFrames = std::max(0.0, frames);
                }
                return app::setTrailSettings(start, id, settings);
              });
}

void applyView(PanelContext& context, const TimelineOutcome& outcome) {
  if (outcome.viewChanged) {
    context.ui.timeline.viewStart = outcome.view.start;
    context.ui.timeline.viewEnd = outcome.view.end;
  }
}

void timeRows(PanelContext& context, const char* id, RowDetail detail) {
  const TimelineModel model = timelineModel(context, detail);
  ImGui::BeginChild(id, ImGui::GetContentRegionAvail(), false,
                    ImGuiWindowFlags_NoScrollWithMouse); // the wheel zooms
  const float height = std::max(timelineHeight(context.theme, model), ImGui::GetContentRegionAvail().y);
  const TimelineOutcome outcome = timeline(widgetsOf(context), id, model, context.ui.timelineGesture,
                                           context.theme.px(labelWidth), height);
  ImGui::EndChild();
  applyRange(*context.session, outcome);
  applyBars(context, outcome);
  applyView(context, outcome);
}

void tabs(PanelContext& context) {
  ImGui::BeginChild("bottom/tabs", {context.theme.px(288.0F), context.theme.rowHeight()});
  const std::vector<Choice> choices{
      {"Timeline", {"Timeline", "Keys of the selection and trails over time.", {}}},
      {"Graph", {"Graph", "Curves of the selected limb's joints.", {}}},
      {"Dope sheet", {"Dope sheet", "Keys of every limb.", {}}}};
  const int chosen =
      segmented(widgetsOf(context), "bottom/tab", choices, static_cast<int>(context.ui.bottomTab));
  ImGui::EndChild();
  context.ui.bottomTab = chosen >= 0 ? static_cast<BottomTab>(chosen) : context.ui.bottomTab;
}

} // namespace

void drawBottomPanel(PanelContext& context) {
  if (!hasViewedClip(context)) {
    emptyState(widgetsOf(context), icon::clock, "No clip",
               "Open a character with an animation to see its time and curves here.");
    return;
  }
  tabs(context);
  ImGui::SameLine(0.0F, context.theme.px(16.0F));
  if (context.ui.bottomTab == BottomTab::timeline) {
    drawTimelinePanel(context);
  } else {
    transport(context);
    drawGraphPanel(context);
  }
}

void drawTimelinePanel(PanelContext& context) {
  if (hasViewedClip(context)) {
    transport(context);
    timeRows(context, "timeline", RowDetail::selection);
  }
}

void drawDopeSheet(PanelContext& context) {
  if (hasViewedClip(context)) {
    timeRows(context, "dope-sheet", RowDetail::everyLimb);
  }
}

} // namespace stretch::ui
