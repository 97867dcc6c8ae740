#include "ui/panels/rows/graph_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/pose/posing.h"
#include "app/edits/keys/track_edits.h"
#include "app/evaluate/evaluate.h"
#include "core/anim/frames.h"
#include "core/math/euler.h"
#include "rig/limb.h"
#include "rig/motion/motion.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

namespace {

constexpr double mostSamples = 600.0;
constexpr double fewestSamples = 24.0;
constexpr double mostPoints = 60000.0; ///< Of all curves together.

Channel trackChannel(GraphChannels channels) {
  return channels == GraphChannels::translation ? Channel::translation
         : channels == GraphChannels::scale     ? Channel::scale
                                                : Channel::rotation;
}

/// Evenly over the visible frames; frames themselves where they are far apart.
std::vector<double> sampleFrames(const Span& frames, double lastFrame, double most) {
  const double start = std::max(0.0, std::floor(frames.start));
  const double end = std::max(start, std::min(lastFrame, std::ceil(frames.end)));
  const double step = end - start > 150.0 ? std::max(1.0, std::ceil((end - start) / most)) : 0.25;
  std::vector<double> samples;
  for (double frame = start; frame <= end + 1e-9; frame += std::max(step, (end - start) / most)) {
    samples.push_back(frame);
  }
  if (!samples.empty() && samples.back() < end - 1e-9) {
    samples.push_back(end); // A clip may end between frames.
  }
  return samples;
}

bool movesIn(app::Session& session) {
  const rig::MotionState& motion = session.motion();
  const auto& adjustments = session.document().adjustments;
  const bool adjusted = std::any_of(adjustments.begin(), adjustments.end(), [&](const auto& adjustment) {
    return adjustment.clip == session.view().clip;
  });
  return adjusted ||
         std::ranges::any_of(motion.trails, [](const rig::SolvedTrail& trail) { return trail.active; });
}

/// The components of a row that the graph shows.
std::vector<std::size_t> shownComponents(const app::KeyRow& row, std::size_t components,
                                         GraphChannels channels) {
  if (components == 1) {
    return {0};
  }
  return row.isOffset() && channels == GraphChannels::rotation ? std::vector<std::size_t>{3, 4, 5}
                                                               : std::vector<std::size_t>{0, 1, 2};
}

std::optional<CopyOnWrite<Track>> leafOf(const Clip& clip, const app::KeyRow& row) {
  const int index = findTrack(clip, row.node, row.channel);
  return index < 0 ? std::nullopt : std::optional(clip.tracks[at(index)]);
}

GraphRowKey keyOfRow(PanelContext& context, const app::KeyRow& row, bool withResult) {
  app::Session& session = context.character();
  const app::Document& document = session.document();
  GraphRowKey key;
  if (row.isOffset()) {
    for (const rig::Adjustment& adjustment : document.adjustments) {
      if (adjustment.clip == session.view().clip && adjustment.controller == row.controller) {
        key.adjustments.push_back(adjustment);
      }
    }
    return key;
  }
  key.track = leafOf(app::clipOf(document, session.view().clip), row);
  if (app::hasEditedKeys(document)) {
    key.source = leafOf(app::sourceClipOf(document, session.view().clip), row);
    key.source = key.source == key.track ? std::nullopt : key.source;
  }
  key.motion = withResult && movesIn(session) ? session.sharedMotion() : nullptr;
  return key;
}

void addPoints(std::span<Curve> curves, std::vector<Vec2> Curve::*target, const std::vector<double>& frames,
               const std::vector<app::KeyValues>& values) {
  for (Curve& curve : curves) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      (curve.*target).emplace_back(frames[i], values[i][curve.component]);
    }
  }
}

/// What the character does at a joint.
std::vector<app::KeyValues> resultValues(app::Session& session, const app::KeyRow& row,
                                         const std::vector<double>& frames, const app::KeyValues& near) {
  const app::Document& document = session.document();
  const rig::MotionState& motion = session.motion();
  const double rate = app::clipOf(document, session.view().clip).framesPerSecond;
  Vec3 angles = Vec3(near[0], near[1], near[2]) * (pi / 180.0);
  std::vector<app::KeyValues> values;
  for (const double frame : frames) {
    const Transform local = app::evaluate(document, motion, frame / rate).pose.locals[at(row.node)];
    Vec3 value = row.channel == Channel::scale ? local.scale : local.translation;
    if (row.channel == Channel::rotation) {
      angles = eulerNear(local.rotation, angles);
      value = angles * (180.0 / pi);
    }
    values.push_back({value.x, value.y, value.z});
  }
  return values;
}

/// As the source has it, where its keys were edited.
std::vector<app::KeyValues> sourceValues(const app::Document& document, int clip, const app::KeyRow& row,
                                         const std::vector<double>& frames, const app::KeyValues& near) {
  app::Document source = document;
  source.clips = app::sourceClipsOf(document);
  source.sourceClips = nullptr;
  const double rate = app::clipOf(document, clip).framesPerSecond / app::clipOf(source, clip).framesPerSecond;
  std::vector<double> counted = frames;
  std::transform(frames.begin(), frames.end(), counted.begin(), [&](double frame) { return frame / rate; });
  return app::sampleRow(source, clip, row, counted, near);
}

void setKeys(const app::KeyedRow& read, Curve& curve) {
  const std::size_t c = curve.component;
  curve.keys.clear();
  curve.keys.reserve(read.keys.size());
  for (std::size_t i = 0; i < read.keys.size(); ++i) {
    const app::RowKey& key = read.keys[i];
    curve.keys.push_back({Vec2(key.frame, key.values[c]), Vec2(key.inSlopes[c], key.outSlopes[c]),
                          static_cast<int>(i), false});
  }
  curve.picked = 0;
}

/// Colours and names of the curves of a row, without points.
std::vector<Curve> bareCurves(const PanelContext& context, const app::KeyRow& row, std::size_t place,
                              std::size_t components) {
  std::vector<Curve> curves;
  for (const std::size_t component : shownComponents(row, components, context.ui.time.graph.offsetChannels)) {
    Curve curve;
    curve.label = components == 1 ? "Value" : std::string(1, "XYZ"[component % 3]);
    curve.colour = components == 1 ? trailColour(0, context.theme.kind)
                                   : axisColour(context.theme, static_cast<int>(component % 3));
    curve.offsetKeys = row.isOffset();
    curve.row = place;
    curve.component = component;
    curves.push_back(std::move(curve));
  }
  return curves;
}

/// The values that the angles at a frame are followed from.
app::KeyValues valuesBefore(std::span<const Curve> curves, double frame) {
  app::KeyValues values{};
  for (const Curve& curve : curves) {
    const auto after = std::upper_bound(curve.keys.begin(), curve.keys.end(), frame,
                                        [](double at, const CurveKey& key) { return at < key.at.x; });
    values[curve.component] = after == curve.keys.begin() ? 0.0 : (after - 1)->at.y;
  }
  return values;
}

/// The points of a row's curves over the frames.
void setPoints(PanelContext& context, const app::KeyRow& row, const GraphRowKey& key,
               const std::vector<double>& frames, std::span<Curve> curves) {
  app::Session& session = context.character();
  const app::Document& document = session.document();
  const int clip = session.view().clip;
  for (Curve& curve : curves) {
    curve.points.clear();
    curve.before.clear();
    curve.source.clear();
  }
  if (frames.empty()) {
    return;
  }
  const app::KeyValues near = valuesBefore(curves, frames.front());
  addPoints(curves, key.motion ? &Curve::before : &Curve::points, frames,
            app::sampleRow(document, clip, row, frames, near));
  if (key.motion) {
    addPoints(curves, &Curve::points, frames, resultValues(session, row, frames, near));
  }
  if (key.source) {
    addPoints(curves, &Curve::source, frames, sourceValues(document, clip, row, frames, near));
  }
}

/// The limb's length, straight from its base to its end.
std::vector<Curve> lengthCurve(PanelContext& context, const rig::Limb& limb,
                               const std::vector<double>& frames) {
  app::Session& session = context.character();
  const app::Document& document = session.document();
  const rig::MotionState& motion = session.motion();
  const int clip = session.view().clip;
  const double rate = app::clipOf(document, clip).framesPerSecond;
  const bool moves = movesIn(session) || app::hasEditedKeys(document);
  const auto lengthIn = [&](const FrameState& frame) {
    const std::vector<Vec3> points = rig::limbPoints(limb, frame);
    return points.size() < 2 ? 0.0 : glm::length(points.back() - points.front());
  };
  Curve curve{.label = "Length", .colour = trailPalette[0]};
  for (const double frame : frames) {
    const double source = lengthIn(app::evaluateOriginal(document, clip, frame / rate));
    const double now = moves ? lengthIn(app::evaluate(document, motion, frame / rate)) : source;
    curve.points.emplace_back(frame, now);
    if (moves) {
      curve.before.emplace_back(frame, source);
    }
  }
  return {curve};
}

/// The curves of a row.
std::span<Curve> curvesOfRow(std::vector<Curve>& curves, std::size_t place) {
  const auto isBefore = [](const Curve& curve, std::size_t row) { return curve.row < row; };
  const auto first = std::lower_bound(curves.begin(), curves.end(), place, isBefore);
  const auto last = std::lower_bound(first, curves.end(), place + 1, isBefore);
  return {first, last};
}

void markPicked(GraphState& graph, const app::KeySelection& picked, const std::vector<app::KeyRow>& rows) {
  if (graph.shownPicks == picked) {
    return;
  }
  std::map<app::KeyRow, const app::PickedRow*> pickedRows;
  for (const app::PickedRow& row : picked) {
    pickedRows.emplace(row.row, &row);
  }
  for (Curve& curve : graph.curves) {
    for (std::size_t i = 0; i < curve.keys.size() && curve.picked > 0; ++i) {
      curve.keys[i].picked = false;
    }
    curve.picked = 0;
    const auto found = curve.row < rows.size() ? pickedRows.find(rows[curve.row]) : pickedRows.end();
    if (found == pickedRows.end()) {
      continue;
    }
    for (const app::PickedKey& key : found->second->keys) {
      if (at(key.key) < curve.keys.size() && (key.components >> curve.component & 1U) != 0) {
        curve.keys[at(key.key)].picked = true;
        ++curve.picked;
      }
    }
  }
  graph.shownPicks = picked;
}

void hideCurves(GraphState& graph) {
  for (Curve& curve : graph.curves) {
    const std::size_t slot = curve.component % 3;
    const bool off = slot < graph.hidden.size() && graph.hidden[slot];
    const bool alone = graph.isolated && !curve.keys.empty() && curve.picked == 0;
    curve.hidden = off || alone;
  }
}

} // namespace

std::vector<GraphSubject> graphSubjects(const PanelContext& context) {
  const app::Session& session = context.character();
  const app::Document& document = session.document();
  std::vector<GraphSubject> subjects;
  const auto addOffset = [&](const std::string& id) {
    const std::string title = app::rowTitle(document, {NodeIndex::none, Channel::translation, id});
    subjects.push_back({capitalised(title), {}, id});
  };
  const std::vector<rig::Controller> controllers = app::selectedControllers(session);
  std::for_each(controllers.begin(), controllers.end(),
                [&](const rig::Controller& controller) { addOffset(controller.id); });
  for (const rig::Attribute& attribute : app::attributesOf(session, controllers)) {
    addOffset(attribute.id);
  }
  GraphSubject all{"All joints", {}, {}, {}, false};
  for (const std::string& id : session.view().selection.limbs()) {
    const rig::Limb* const limb = app::findLimb(document, id);
    for (const NodeIndex node : limb != nullptr ? rig::jointsAndEnd(*limb) : std::vector<NodeIndex>{}) {
      if (id == session.view().selection.limbs().front()) {
        subjects.push_back({nodeName(*document.scene, node), {node}, {}, id});
      }
      all.nodes.push_back(node);
    }
  }
  if (all.nodes.size() > 1) {
    all.limb = session.view().selection.limbs().front();
    subjects.push_back(all);
  }
  if (!subjects.empty()) {
    GraphSubject every{"Whole body", {}, {}, all.limb, false};
    for (const app::KeyRow& row : app::keyedRows(document, session.view().clip)) {
      if (!row.isOffset() && (every.nodes.empty() || every.nodes.back() != row.node)) {
        every.nodes.push_back(row.node);
      }
    }
    subjects.push_back(every);
  }
  return subjects;
}

GraphChannels graphChannels(const PanelContext& context, const GraphSubject& subject) {
  const GraphState& graph = context.ui.time.graph;
  return subject.controller.empty() ? graph.channels : graph.offsetChannels;
}

std::vector<app::KeyRow> graphRows(const PanelContext& context, const GraphSubject& subject) {
  const GraphChannels channels = graphChannels(context, subject);
  if (!subject.controller.empty()) {
    return {{NodeIndex::none, Channel::translation, subject.controller}};
  }
  std::vector<app::KeyRow> rows;
  if (channels == GraphChannels::stretch) {
    return rows;
  }
  const app::Session& session = context.character();
  const Clip& clip = app::clipOf(session.document(), session.view().clip);
  std::set<NodeIndex> animated;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    if (track->channel == trackChannel(channels)) {
      animated.insert(track->node);
    }
  }
  std::set<NodeIndex> known;
  for (const NodeIndex node : subject.nodes) {
    if (known.insert(node).second && (subject.isOne || animated.count(node) != 0)) {
      rows.push_back({node, trackChannel(channels), {}});
    }
  }
  return rows;
}

namespace {

/// Curves of all rows, without points and keys.
void startRows(PanelContext& context, std::vector<app::KeyRow> rows) {
  GraphState& graph = context.ui.time.graph;
  const app::Session& session = context.character();
  graph.curves.clear();
  graph.rows = std::move(rows);
  graph.madeRows.assign(graph.rows.size(), {});
  graph.madeFrames.assign(graph.rows.size(), {0.0, -1.0});
  for (std::size_t place = 0; place < graph.rows.size(); ++place) {
    const app::KeyRow& row = graph.rows[place];
    const std::size_t components =
        row.isOffset()
            ? app::readRow(session.document(), session.view().clip, row, app::RowDetail::times).components
            : 3;
    std::vector<Curve> curves = bareCurves(context, row, place, components);
    std::move(curves.begin(), curves.end(), std::back_inserter(graph.curves));
  }
}

/// Makes the rows anew whose keys or frames are others. What is much waits for the next frames of the window,
/// and shows what it was until then.
void updateRows(PanelContext& context, bool isOne, const Span& frames, const std::vector<double>& samples) {
  constexpr std::size_t mostAtOnce = 8000; // Keys that are read and points that are sampled.
  GraphState& graph = context.ui.time.graph;
  app::Session& session = context.character();
  std::size_t done = 0;
  graph.complete = true;
  for (std::size_t place = 0; place < graph.rows.size(); ++place) {
    GraphRowKey made = keyOfRow(context, graph.rows[place], isOne);
    const bool sameKeys = made == graph.madeRows[place] && graph.madeFrames[place].end >= 0.0;
    const bool sameFrames =
        graph.madeFrames[place].start == frames.start && graph.madeFrames[place].end == frames.end;
    if (sameKeys && sameFrames) {
      continue;
    }
    if (done > mostAtOnce) {
      graph.complete = false;
      return;
    }
    const std::span<Curve> curves = curvesOfRow(graph.curves, place);
    if (!sameKeys) {
      const app::KeyedRow read = app::readRow(session.document(), session.view().clip, graph.rows[place]);
      std::for_each(curves.begin(), curves.end(), [&](Curve& curve) { setKeys(read, curve); });
      graph.shownPicks.reset();
      done += read.keys.size();
    }
    setPoints(context, graph.rows[place], made, samples, curves);
    std::for_each(curves.begin(), curves.end(), [&](Curve& curve) { curve.seen = curve.seen && sameFrames; });
    done += samples.size();
    graph.madeRows[place] = std::move(made);
    graph.madeFrames[place] = frames;
  }
}

/// Whether only frames, the motion, or keys of rows that both have, are others.
bool hasSameRows(const GraphKey& a, GraphKey b) {
  b.clips = a.clips;
  b.motion = a.motion;
  b.firstFrame = a.firstFrame;
  b.lastFrame = a.lastFrame;
  return a == b;
}

void updateCurves(PanelContext& context, const GraphSubject& subject, const GraphKey& key) {
  GraphState& graph = context.ui.time.graph;
  const app::Document& document = context.character().document();
  const Clip& shown = app::clipOf(document, key.clip);
  const rig::Limb* const limb = key.lengthOf.empty() ? nullptr : app::findLimb(document, key.lengthOf);
  std::vector<app::KeyRow> rows = limb != nullptr ? std::vector<app::KeyRow>{} : graphRows(context, subject);
  const bool isOther = !graph.madeFrom || !hasSameRows(*graph.madeFrom, key);
  const bool isNew = isOther || rows != graph.rows;
  const double share = mostPoints / std::max(1.0, 3.0 * static_cast<double>(rows.size()));
  const std::vector<double> samples = sampleFrames({key.firstFrame, key.lastFrame}, endInFrames(shown),
                                                   std::clamp(share, fewestSamples, mostSamples));
  if (isNew) {
    startRows(context, std::move(rows));
    graph.shownPicks.reset();
    graph.fitPending = graph.fitPending || isOther; // Other curves have other values.
  }
  if (limb != nullptr) {
    graph.curves = lengthCurve(context, *limb, samples);
  }
  updateRows(context, subject.isOne, {key.firstFrame, key.lastFrame}, samples);
  graph.madeFrom = key;
}

} // namespace

const std::vector<Curve>& graphCurves(PanelContext& context, const GraphSubject& subject,
                                      const Span& frames) {
  GraphState& graph = context.ui.time.graph;
  app::Session& session = context.character();
  const GraphChannels channels = graphChannels(context, subject);
  const bool isLength = channels == GraphChannels::stretch && subject.controller.empty();
  const GraphKey key{session.document().clips,
                     session.sharedMotion(),
                     subject.nodes,
                     subject.controller,
                     channels,
                     isLength ? subject.limb : std::string(),
                     frames.start,
                     frames.end,
                     session.view().clip,
                     static_cast<int>(context.theme.kind)};
  if (!graph.madeFrom || !(*graph.madeFrom == key) || !graph.complete) {
    updateCurves(context, subject, key);
  }
  markPicked(graph, app::pickedKeys(session), graph.rows);
  hideCurves(graph);
  return graph.curves;
}

const char* graphUnit(const PanelContext& context, const GraphSubject& subject) {
  if (subject.controller.find('.') != std::string::npos) {
    return "";
  }
  switch (graphChannels(context, subject)) {
  case GraphChannels::rotation:
    return "\xC2\xB0";
  case GraphChannels::translation:
  case GraphChannels::stretch:
    return " m";
  case GraphChannels::scale:
    break;
  }
  return "";
}

} // namespace stretch::ui
