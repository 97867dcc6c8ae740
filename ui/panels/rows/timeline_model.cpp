#include "ui/panels/rows/timeline_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "app/commands/keys/keys.h"
#include "app/commands/pose/posing.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/moments.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/rows/shown_holds.h"

namespace stretch::ui {

namespace {

using KeyedRows = std::vector<app::KeyRow>;

/// The rows of a limb's joints.
KeyedRows rowsOfLimb(const KeyedRows& all, const rig::Limb& limb) {
  std::set<NodeIndex> nodes(limb.joints.begin(), limb.joints.end());
  nodes.insert(limb.endNode);
  KeyedRows rows;
  std::copy_if(all.begin(), all.end(), std::back_inserter(rows),
               [&](const app::KeyRow& row) { return !row.isOffset() && nodes.count(row.node) != 0; });
  return rows;
}

/// In order, each once, to a thousandth of a frame.
void sortFrames(std::vector<double>& frames) {
  for (double& frame : frames) {
    frame = std::round(frame * 1000.0) / 1000.0;
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
}

/// Gathers rows for the timeline and the dope sheet.
class RowGatherer {
public:
  /// `own`: the keys that can be edited; else those of the clip as it is shown, with the keys of applied
  /// trails and poses.
  RowGatherer(app::Session& session, KeyRowsState& state, bool own)
      : own_(own), session_(session), document_(session.document()),
        all_(app::keyedRows(document_, session.view().clip)), state_(state) {
    state_.rows.clear();
    state_.keyed.clear();
  }

  void addClip(const std::string& label, const std::vector<std::string>& limbs, bool selected) {
    KeyedRows keyed;
    for (const std::string& id : limbs) {
      if (const rig::Limb* const limb = app::findLimb(document_, id)) {
        const KeyedRows some = rowsOfLimb(all_, *limb);
        keyed.insert(keyed.end(), some.begin(), some.end());
        inLimbs_.insert(some.begin(), some.end());
      }
    }
    keyed = limbs.empty() ? all_ : std::move(keyed);
    std::vector<double> frames = own_ ? framesOf(keyed) : app::shownKeyFrames(session_, limbs);
    add({label, std::move(frames), selected}, std::move(keyed));
  }

  /// A row of the clip's own keys that are in no limb's row, of the nodes that belong to it; none without
  /// keys.
  template <typename Belongs>
  void addOthers(const std::string& label, Belongs&& belongs) {
    KeyedRows keyed;
    std::ranges::copy_if(all_, std::back_inserter(keyed), [&](const app::KeyRow& row) {
      return !row.isOffset() && !inLimbs_.contains(row) && belongs(row.node);
    });
    if (!keyed.empty()) {
      std::vector<double> frames = framesOf(keyed);
      add({label, std::move(frames)}, std::move(keyed));
    }
  }

  void addController(const std::string& id, bool selected) {
    const app::KeyRow row{NodeIndex::none, Channel::translation, id};
    const std::vector<double> frames = app::keyFramesOf(document_, session_.view().clip, row);
    add({capitalised(app::rowTitle(document_, row)), frames, selected, true}, {row});
  }

  [[nodiscard]] std::vector<std::string> keyedControllers() const {
    std::vector<std::string> ids;
    for (const app::KeyRow& row : all_) {
      if (row.isOffset()) {
        ids.push_back(row.controller);
      }
    }
    return ids;
  }

private:
  [[nodiscard]] std::vector<double> framesOf(const KeyedRows& keyed) const {
    std::vector<double> frames;
    for (const app::KeyRow& row : keyed) {
      const std::vector<double> some = app::keyFramesOf(document_, session_.view().clip, row);
      frames.insert(frames.end(), some.begin(), some.end());
    }
    sortFrames(frames);
    return frames;
  }

  void add(KeyRow row, KeyedRows keyed) {
    state_.rows.push_back(std::move(row));
    state_.keyed.push_back(std::move(keyed));
  }

  bool own_;
  app::Session& session_;
  const app::Document& document_;
  KeyedRows all_;
  std::set<app::KeyRow> inLimbs_;
  KeyRowsState& state_;
};

bool isPosed(const app::Session& session, const std::string& id) {
  const std::vector<std::string> posed = app::posedIds(session);
  return std::find(posed.begin(), posed.end(), id) != posed.end();
}

void gatherSelection(app::Session& session, KeyRowsState& state) {
  const app::Document& document = session.document();
  const std::vector<std::string>& limbs = session.view().selection.limbs();
  RowGatherer gatherer(session, state, false);
  const std::string label = limbs.empty()       ? "All keys"
                            : limbs.size() == 1 ? limbHeading(document, limbs.front())
                                                : std::to_string(limbs.size()) + " limbs";
  gatherer.addClip(label, limbs, false);
  constexpr std::size_t most = 4; ///< Rows of controllers: the bars of trails have to be seen too.
  for (const std::string& id : gatherer.keyedControllers()) {
    if (state.rows.size() <= most && isPosed(session, id)) {
      gatherer.addController(id, false);
    }
  }
}

void gatherEveryLimb(app::Session& session, KeyRowsState& state) {
  const app::Document& document = session.document();
  RowGatherer gatherer(session, state, true);
  gatherer.addClip("All keys", {}, false);
  for (const rig::Limb& limb : app::allLimbs(document)) {
    gatherer.addClip(limbHeading(document, limb.id), {limb.id}, app::isSelected(session, limb.id));
  }
  // All rows together are all keys: whoever boxes them takes the body along.
  const auto isAboveHips = [&](NodeIndex node) {
    return document.body.hips.exists() && isAncestorOrSelf(*document.scene, node, document.body.hips);
  };
  gatherer.addOthers("Hips and root", isAboveHips);
  gatherer.addOthers("Other joints", [&](NodeIndex node) { return !isAboveHips(node); });
  for (const std::string& id : gatherer.keyedControllers()) {
    gatherer.addController(id, isPosed(session, id));
  }
}

/// Frames of the picked keys in each row.
void markPickedFrames(const app::Session& session, KeyRowsState& state) {
  const app::KeySelection& picked = app::pickedKeys(session);
  if (state.shownPicks == picked) {
    return;
  }
  state.shownPicks = picked;
  std::map<app::KeyRow, std::vector<double>> frames;
  for (const app::PickedRow& row : picked) {
    const std::vector<double> all = app::keyFramesOf(session.document(), session.view().clip, row.row);
    for (const app::PickedKey& key : row.keys) {
      frames[row.row].push_back(all[at(key.key)]);
    }
  }
  for (std::size_t i = 0; i < state.rows.size(); ++i) {
    std::vector<double>& marked = state.rows[i].picked;
    marked.clear();
    for (const app::KeyRow& row : picked.empty() ? KeyedRows{} : state.keyed[i]) {
      const auto found = frames.find(row);
      if (found != frames.end()) {
        marked.insert(marked.end(), found->second.begin(), found->second.end());
      }
    }
    sortFrames(marked);
  }
}

/// The rows, gathered again where what they show is another.
const std::vector<KeyRow>& keyRows(PanelContext& context, RowDetail detail) {
  app::Session& session = context.character();
  KeyRowsState& state = context.ui.time.rows;
  const app::ViewState& view = session.view();
  std::vector<std::string> selected = view.selection.limbs();
  selected.push_back("clip " + std::to_string(view.clip));
  selected.insert(selected.end(), view.selection.controllers().begin(), view.selection.controllers().end());
  const bool every = detail == RowDetail::everyLimb;
  const std::shared_ptr<const rig::MotionState> motion = session.sharedMotion();
  if (state.motion != motion || state.clips != session.document().clips || state.selected != selected ||
      state.everyLimb != every) {
    (every ? gatherEveryLimb : gatherSelection)(session, state);
    state.shownPicks.reset();
    state.motion = motion;
    state.clips = session.document().clips;
    state.selected = std::move(selected);
    state.everyLimb = every;
  }
  markPickedFrames(session, state);
  return state.rows;
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
  bar.selected = session.view().selection.trail() == trail.id;
  bar.active = trail.connected && !trail.applied;
  bar.applied = trail.applied;
  return bar;
}

TimelineBar barOf(const app::Session& session, const ShownHold& hold, const ThemeColours& colours) {
  TimelineBar bar;
  bar.id = barOfHold(hold.place);
  bar.start = hold.time.rangeFrames.x;
  bar.end = hold.time.rangeFrames.y;
  bar.windowStart = rig::touchedFrames(hold.time).x;
  bar.windowEnd = rig::touchedFrames(hold.time).y;
  bar.colour = mixed(colours.quietText, colours.text, 0.35F);
  bar.label = hold.title;
  bar.selected = app::isSelected(session, hold.limb);
  bar.active = true;
  return bar;
}

// Those of one limb share a row. The dope sheet has the first above its many rows of keys, where they are
// seen, and the others below: the keys are what it is for. Below are all that last the whole clip, as things
// in a file's hands do.
void addHolds(PanelContext& context, bool above, TimelineModel& model) {
  constexpr std::size_t mostAbove = 2;
  const app::Session& session = context.character();
  std::vector<ShownHold> holds = shownHolds(session.document(), session.view().clip);
  const auto isTimed = [&](const ShownHold& hold) {
    return hold.time.rangeFrames != Vec2(model.clip.start, model.clip.end);
  };
  std::stable_partition(holds.begin(), holds.end(), isTimed);
  std::size_t rows = above ? 0 : model.bars.size();
  for (const ShownHold& hold : holds) {
    TimelineBar bar = barOf(session, hold, context.theme.colours);
    const auto same = std::find_if(model.bars.begin(), model.bars.end(), [&](const TimelineBar& other) {
      return other.id < 0 && other.label == bar.label;
    });
    bar.row = same != model.bars.end() ? same->row : rows++;
    model.rowsAbove = above && isTimed(hold) ? std::min(rows, mostAbove) : model.rowsAbove;
    model.bars.push_back(std::move(bar));
  }
  if (above) {
    const auto trails = static_cast<std::size_t>(
        std::ranges::count_if(model.bars, [](const TimelineBar& bar) { return bar.id > 0; }));
    for (TimelineBar& bar : model.bars) {
      bar.row += bar.id > 0 ? model.rowsAbove : bar.row >= model.rowsAbove ? trails : 0;
    }
  }
}

void addTrails(PanelContext& context, TimelineModel& model) {
  app::Session& session = context.character();
  const int clip = session.view().clip;
  const double rate = app::clipOf(session.document(), clip).framesPerSecond;
  for (const rig::Trail& trail : session.document().trails) {
    if (trail.clip == clip) {
      model.bars.push_back(
          barOf(session, trail, app::solvedTrail(session, trail.id), rate, context.theme.kind));
      model.bars.back().row = model.bars.size() - 1;
    }
  }
}

void addMoments(const app::Session& session, TimelineModel& model) {
  const std::vector<rig::Moment> shown = app::shownMoments(session);
  const std::optional<rig::Moment> current = app::currentMoment(session);
  const rig::Moment* const strongest = rig::strongestMoment(shown);
  for (const rig::Moment& moment : shown) {
    model.moments.push_back({moment.startFrame,
                             moment.tipFrame,
                             static_cast<float>(moment.strength / strongest->strength),
                             moment.kind == rig::MomentKind::cycle,
                             moment == current,
                             {app::momentText(session.document(), moment),
                              "A click selects its limb and its range; E goes on from there.",
                              {}}});
  }
}

void addSound(const ShownSound& shown, double framesPerSecond, TimelineModel& model) {
  if (shown.sound == nullptr) {
    return;
  }
  // The loudest of it fills the lane: a quiet sound is read as well.
  const float gain = 1.0F / std::max(shown.sound->loudest, 0.01F);
  const double start = shown.startFrame;
  model.sound = TimelineSound{{start, start + shown.sound->seconds() * framesPerSecond},
                              shown.name,
                              [sound = shown.sound, start, framesPerSecond, gain](double from, double to) {
                                const app::SoundPeak peak = app::peakBetween(
                                    *sound, (from - start) / framesPerSecond, (to - start) / framesPerSecond);
                                return std::pair(gain * peak.low, gain * peak.high);
                              }};
}

} // namespace

Span visibleFrames(const PanelContext& context) {
  const TimelineState& time = context.ui.time.timeline;
  if (time.viewEnd > time.viewStart) {
    return {time.viewStart, time.viewEnd};
  }
  const app::Session& session = context.character();
  return {0.0, std::max(1.0, app::lastFrame(session.document(), session.view().clip))};
}

Span shownSpan(const app::Session& session) {
  const Vec2 range = app::shownRange(session);
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
  model.range = shownSpan(session);
  model.rangeIsDefault = session.view().rangeEnd < session.view().rangeStart;
  model.keyRows = keyRows(context, detail);
  model.keysEditable = detail == RowDetail::everyLimb;
  model.snap = context.ui.time.timeline.snapToFrames;
  const Clip& shown = app::clipOf(document, clip);
  const double rate = shown.framesPerSecond;
  model.loops = app::isLooping(document, clip);
  model.turn = (shown.endSeconds - shown.startSeconds) * rate;
  addSound(context.ui.time.sound, rate, model);
  addTrails(context, model);
  addMoments(session, model);
  const bool isDopeSheet = detail == RowDetail::everyLimb;
  addHolds(context, isDopeSheet, model);
  if (const rig::SolvedTrail* selected = app::solvedTrail(session, session.view().selection.trail())) {
    model.spheres = selected->controlFrames;
  }
  return model;
}

} // namespace stretch::ui
