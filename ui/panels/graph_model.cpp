#include "ui/panels/graph_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "app/commands/keys.h"
#include "app/commands/posing.h"
#include "app/edits/track_edits.h"
#include "app/evaluate/evaluate.h"
#include "core/math/euler.h"
#include "rig/limb.h"
#include "rig/motion/motion.h"
#include "ui/panels/panel_support.h"

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
  return adjusted || std::any_of(motion.trails.begin(), motion.trails.end(),
                                 [](const rig::SolvedTrail& trail) { return trail.active; });
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

void addPoints(std::vector<Curve>& curves, std::vector<Vec2> Curve::*target,
               const std::vector<double>& frames, const std::vector<app::KeyValues>& values) {
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

void addKeys(const app::KeyedRow& read, std::vector<Curve>& curves) {
  for (Curve& curve : curves) {
    const std::size_t c = curve.component;
    for (std::size_t i = 0; i < read.keys.size(); ++i) {
      const app::RowKey& key = read.keys[i];
      curve.keys.push_back({Vec2(key.frame, key.values[c]), Vec2(key.inSlopes[c], key.outSlopes[c]),
                            static_cast<int>(i), false});
    }
  }
}

/// Colours and names of the curves of a row, without points.
std::vector<Curve> bareCurves(const PanelContext& context, const app::KeyRow& row, std::size_t place,
                              std::size_t components) {
  std::vector<Curve> curves;
  for (const std::size_t component : shownComponents(row, components, context.ui.graph.channels)) {
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

std::vector<Curve> curvesOfRow(PanelContext& context, std::size_t place, const app::KeyRow& row,
                               const GraphRowKey& key, const std::vector<double>& frames) {
  app::Session& session = context.character();
  const app::Document& document = session.document();
  const int clip = session.view().clip;
  const app::KeyedRow read = app::readRow(document, clip, row);
  std::vector<Curve> curves = bareCurves(context, row, place, read.components);
  if (frames.empty()) {
    return curves;
  }
  const auto after = std::upper_bound(read.keys.begin(), read.keys.end(), frames.front(),
                                      [](double frame, const app::RowKey& one) { return frame < one.frame; });
  const app::KeyValues near = after == read.keys.begin() ? app::KeyValues{} : (after - 1)->values;
  const std::vector<app::KeyValues> own = app::sampleRow(document, clip, row, frames, near);
  addPoints(curves, key.motion ? &Curve::before : &Curve::points, frames, own);
  if (key.motion) {
    addPoints(curves, &Curve::points, frames, resultValues(session, row, frames, near));
  }
  if (key.source) {
    addPoints(curves, &Curve::source, frames, sourceValues(document, clip, row, frames, near));
  }
  addKeys(read, curves);
  return curves;
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

/// Puts the new curves of a row in the place of its old ones.
void replaceRow(std::vector<Curve>& curves, std::size_t place, std::vector<Curve> made) {
  const auto isOfRow = [&](const Curve& curve) { return curve.row == place; };
  const auto first = std::find_if(curves.begin(), curves.end(), isOfRow);
  const auto last = std::find_if_not(first, curves.end(), isOfRow);
  const auto there = curves.erase(first, last);
  curves.insert(there, std::make_move_iterator(made.begin()), std::make_move_iterator(made.end()));
}

void markPicked(GraphState& graph, const app::KeySelection& picked, const std::vector<app::KeyRow>& rows) {
  if (graph.shownPicks == picked) {
    return;
  }
  for (Curve& curve : graph.curves) {
    for (CurveKey& key : curve.keys) {
      key.picked = false;
    }
    curve.picked = 0;
    const auto found = std::find_if(picked.begin(), picked.end(), [&](const app::PickedRow& row) {
      return curve.row < rows.size() && row.row == rows[curve.row];
    });
    for (const app::PickedKey& key : found == picked.end() ? std::vector<app::PickedKey>{} : found->keys) {
      if (at(key.key) < curve.keys.size()) {
        const bool picked = (key.components >> curve.component & 1U) != 0;
        curve.keys[at(key.key)].picked = picked;
        curve.picked += picked ? 1 : 0;
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

std::vector<NodeIndex> graphNodes(const rig::Limb& limb) {
  std::vector<NodeIndex> nodes = limb.joints;
  if (limb.endNode.exists()) {
    nodes.push_back(limb.endNode);
  }
  return nodes;
}

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
  for (const std::string& id : session.view().selectedLimbs) {
    const rig::Limb* const limb = app::findLimb(document, id);
    for (const NodeIndex node : limb != nullptr ? graphNodes(*limb) : std::vector<NodeIndex>{}) {
      if (id == session.view().selectedLimbs.front()) {
        subjects.push_back({nodeName(*document.scene, node), {node}, {}, id});
      }
      all.nodes.push_back(node);
    }
  }
  if (all.nodes.size() > 1) {
    all.limb = session.view().selectedLimbs.front();
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

std::vector<app::KeyRow> graphRows(const PanelContext& context, const GraphSubject& subject) {
  const GraphChannels channels = context.ui.graph.channels;
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

/// Makes the curves of the rows that are others than before; of all where `isNew`.
void updateRows(PanelContext& context, bool isOne, bool isNew, const std::vector<double>& samples) {
  GraphState& graph = context.ui.graph;
  for (std::size_t place = 0; place < graph.rows.size(); ++place) {
    GraphRowKey made = keyOfRow(context, graph.rows[place], isOne);
    if (!isNew && made == graph.madeRows[place]) {
      continue;
    }
    std::vector<Curve> curves = curvesOfRow(context, place, graph.rows[place], made, samples);
    if (isNew) {
      std::move(curves.begin(), curves.end(), std::back_inserter(graph.curves));
    } else {
      replaceRow(graph.curves, place, std::move(curves));
    }
    graph.madeRows[place] = std::move(made);
  }
  graph.shownPicks.reset();
}

/// Whether only the motion, or keys of rows that both have, are others.
bool hasSameRows(const GraphKey& a, GraphKey b) {
  b.clips = a.clips;
  b.motion = a.motion;
  return a == b;
}

void updateCurves(PanelContext& context, const GraphSubject& subject, const GraphKey& key) {
  GraphState& graph = context.ui.graph;
  const app::Document& document = context.character().document();
  const Clip& shown = app::clipOf(document, key.clip);
  const rig::Limb* const limb = key.lengthOf.empty() ? nullptr : app::findLimb(document, key.lengthOf);
  std::vector<app::KeyRow> rows = limb != nullptr ? std::vector<app::KeyRow>{} : graphRows(context, subject);
  const bool isNew = !graph.madeFrom || !hasSameRows(*graph.madeFrom, key) || rows != graph.rows;
  const double share = mostPoints / std::max(1.0, 3.0 * static_cast<double>(rows.size()));
  const std::vector<double> samples =
      sampleFrames({key.firstFrame, key.lastFrame}, shown.endSeconds * shown.framesPerSecond,
                   std::clamp(share, fewestSamples, mostSamples));
  if (isNew) {
    graph.curves.clear();
    graph.rows = std::move(rows);
    graph.madeRows.assign(graph.rows.size(), {});
  }
  if (limb != nullptr) {
    graph.curves = lengthCurve(context, *limb, samples);
  }
  updateRows(context, subject.isOne, isNew, samples);
  graph.madeFrom = key;
}

} // namespace

const std::vector<Curve>& graphCurves(PanelContext& context, const GraphSubject& subject,
                                      const Span& frames) {
  GraphState& graph = context.ui.graph;
  app::Session& session = context.character();
  const bool isLength = graph.channels == GraphChannels::stretch && subject.controller.empty();
  const GraphKey key{session.document().clips,
                     session.sharedMotion(),
                     subject.nodes,
                     subject.controller,
                     graph.channels,
                     isLength ? subject.limb : std::string(),
                     frames.start,
                     frames.end,
                     session.view().clip,
                     static_cast<int>(context.theme.kind)};
  if (!graph.madeFrom || !(*graph.madeFrom == key)) {
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
  switch (context.ui.graph.channels) {
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
