#include <algorithm>
#include <cmath>

#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/time/transport.h"
#include "ui/widgets/timeline.h"

namespace stretch::ui {

namespace {

constexpr float sequenceLabelWidth = 112.0F;

/// The working range is what the fits use: its start is the number of settling frames that are left out.
TimelineModel modelOf(const PanelContext& context) {
  const app::SequenceSession& session = context.sequence();
  const TimelineState& time = context.ui.time.timeline;
  TimelineModel model;
  model.clip = {0.0, app::lastFrame(session)};
  model.view = time.viewEnd > time.viewStart ? Span{time.viewStart, time.viewEnd}
                                             : Span{0.0, std::max(1.0, model.clip.end)};
  model.playhead = session.view().frame;
  const auto skip = static_cast<double>(session.document().settings.body.firstFittedFrame);
  model.range = {std::min(skip, model.clip.end), model.clip.end};
  model.snap = true;
  return model;
}

void apply(PanelContext& context, const TimelineOutcome& outcome) {
  app::SequenceSession& session = context.sequence();
  if (outcome.playheadMoved) {
    session.view().frame = outcome.playhead;
  }
  if (outcome.rangeChanged) {
    const double first = std::clamp(std::round(outcome.range.start), 0.0, app::lastFrame(session));
    editSequence(context, {true, outcome.gestureEnded}, "Skip frames", [&](app::SequenceDocument& document) {
      document.settings.body.firstFittedFrame = static_cast<std::size_t>(first);
    });
  } else if (outcome.gestureEnded) {
    editSequence(context, {false, true}, "Skip frames", [](app::SequenceDocument&) {});
  }
  if (outcome.viewChanged) {
    context.ui.time.timeline.viewStart = outcome.view.start;
    context.ui.time.timeline.viewEnd = outcome.view.end;
  }
}

} // namespace

void drawSequenceTimeline(PanelContext& context) {
  drawTransport(context);
  const TimelineModel model = modelOf(context);
  ImGui::BeginChild("timeline", ImGui::GetContentRegionAvail(), false, ImGuiWindowFlags_NoScrollWithMouse);
  const float height = std::max(timelineHeight(context.theme, model), ImGui::GetContentRegionAvail().y);
  const TimelineOutcome outcome = timeline(widgetsOf(context), "timeline", model, context.ui.time.gesture,
                                           context.theme.px(sequenceLabelWidth), height);
  ImGui::EndChild();
  apply(context, outcome);
}

} // namespace stretch::ui
