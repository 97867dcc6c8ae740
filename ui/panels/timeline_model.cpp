#include "ui/panels/timeline_model.h"

#include <algorithm>

#include "app/commands/frames.h"
#include "app/commands/ranges.h"
#include "app/commands/selection.h"
#include "ui/panels/panel_support.h"

namespace stretch::ui {

namespace {

std::vector<KeyRow> keyRows(app::Session& session, RowDetail detail) {
  const app::Document& document = session.document();
  if (detail == RowDetail::selection) {
    const std::vector<std::string>& limbs = session.view().selectedLimbs;
    const std::string label = limbs.empty()       ? "All keys"
                              : limbs.size() == 1 ? limbHeading(document, limbs.front())
                                                  : std::to_string(limbs.size()) + " limbs";
    return {{label, app::shownKeyFrames(session, limbs), false}};
  }
  std::vector<KeyRow> rows{{"All keys", app::shownKeyFrames(session, {}), false}};
  const auto add = [&](const rig::Limb& limb) {
    rows.push_back({limbHeading(document, limb.id), app::shownKeyFrames(session, {limb.id}),
                    app::isSelected(session, limb.id)});
  };
  std::for_each(document.biped.limbs.begin(), document.biped.limbs.end(), add);
  std::for_each(document.chains.begin(), document.chains.end(), add);
  return rows;
}

TimelineBar barOf(const app::Session& session, const rig::Trail& trail, const rig::SolvedTrail* solved,
                  double framesPerSecond, ThemeKind theme) {
  TimelineBar bar;
  bar.id = trail.id;
  bar.start = bar.windowStart = trail.settings.startFrame;
  bar.end = bar.windowEnd = trail.settings.endFrame;
  if (solved != nullptr && trail.exaggerated) {
    const double release = solved->release.seconds() * framesPerSecond;
    const bool tipIsEnd = trail.settings.pivot == rig::Pivot::start;
    bar.windowEnd += tipIsEnd ? release : 0.0;
    bar.windowStart -= tipIsEnd ? 0.0 : release;
  }
  bar.colour = trailColour(trail.colour, theme);
  bar.label = trailHeading(session.document(), trail);
  bar.selected = session.view().selectedTrail == trail.id;
  bar.active = trail.connected && !trail.applied;
  bar.applied = trail.applied;
  return bar;
}

} // namespace

Span visibleFrames(const PanelContext& context) {
  const TimelineState& time = context.ui.timeline;
  if (time.viewEnd > time.viewStart) {
    return {time.viewStart, time.viewEnd};
  }
  const app::Session& session = context.character();
  return {0.0, std::max(1.0, app::lastFrame(session.document(), session.view().clip))};
}

Span shownRange(const app::Session& session) {
  const app::ViewState& view = session.view();
  const double last = app::lastFrame(session.document(), view.clip);
  if (view.rangeEnd >= view.rangeStart) {
    return {std::clamp(view.rangeStart, 0.0, last), std::clamp(view.rangeEnd, 0.0, last)};
  }
  const rig::Limb* limb =
      view.selectedLimbs.empty() ? nullptr : app::findLimb(session.document(), view.selectedLimbs.front());
  if (limb == nullptr) {
    return {0.0, last};
  }
  const Vec2 range = app::workingRange(session, *limb);
  return {range.x, range.y};
}

TimelineModel timelineModel(PanelContext& context, RowDetail detail) {
  app::Session& session = context.character();
  const app::Document& document = session.document();
  const int clip = session.view().clip;
  TimelineModel model;
  model.clip = {0.0, app::lastFrame(document, clip)};
  model.view = visibleFrames(context);
  model.playhead = session.view().frame;
  model.range = shownRange(session);
  model.rangeIsDefault = session.view().rangeEnd < session.view().rangeStart;
  model.keyRows = keyRows(session, detail);
  model.snap = context.ui.timeline.snapToFrames;
  const Clip& shown = app::clipOf(document, clip);
  const double rate = shown.framesPerSecond;
  model.loops = app::isLooping(document, clip);
  model.turn = (shown.endSeconds - shown.startSeconds) * rate;
  for (const rig::Trail& trail : document.trails) {
    if (trail.clip == clip) {
      model.bars.push_back(
          barOf(session, trail, app::solvedTrail(session, trail.id), rate, context.theme.kind));
    }
  }
  if (const rig::SolvedTrail* selected = app::solvedTrail(session, session.view().selectedTrail)) {
    model.spheres = selected->controlFrames;
  }
  return model;
}

} // namespace stretch::ui
