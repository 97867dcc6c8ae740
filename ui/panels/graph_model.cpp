#include "ui/panels/graph_model.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/evaluate/evaluate.h"
#include "rig/limb.h"
#include "rig/motion/motion.h"
#include "ui/panels/panel_support.h"

namespace stretch::ui {

namespace {

constexpr int mostSamples = 600;

double unwrapped(double angle, double previous) {
  return angle + 2.0 * pi * std::round((previous - angle) / (2.0 * pi));
}

double distanceBetween(const Vec3& a, const Vec3& b) {
  return glm::length(a - b);
}

/// What the graph shows of a frame: up to three values.
struct Sampler {
  GraphChannels channels;
  const rig::Limb* limb;
  NodeIndex node;
  Vec3 previous{0.0};

  Vec3 operator()(const FrameState& frame) {
    if (channels == GraphChannels::stretch) {
      const std::vector<Vec3> points = rig::limbPoints(*limb, frame);
      return {points.size() < 2 ? 0.0 : distanceBetween(points.front(), points.back()), 0.0, 0.0};
    }
    const Transform& local = frame.pose.locals[at(node)];
    if (channels == GraphChannels::rotation) {
      previous = eulerNear(local.rotation, previous);
      return previous * (180.0 / pi);
    }
    return channels == GraphChannels::translation ? local.translation : local.scale;
  }
};

Channel trackChannel(GraphChannels channels) {
  return channels == GraphChannels::translation ? Channel::translation
         : channels == GraphChannels::scale     ? Channel::scale
                                                : Channel::rotation;
}

std::vector<double> keyFramesOf(const Clip& clip, NodeIndex node, GraphChannels channels) {
  std::vector<double> frames;
  const int track = channels == GraphChannels::stretch ? -1 : findTrack(clip, node, trackChannel(channels));
  if (track >= 0) {
    for (const float time : clip.tracks[static_cast<std::size_t>(track)]->times) {
      frames.push_back(static_cast<double>(time) * clip.framesPerSecond);
    }
  }
  return frames;
}

std::vector<Curve> emptyCurves(const Theme& theme, const GraphState& graph) {
  std::vector<Curve> curves;
  if (graph.channels == GraphChannels::stretch) {
    curves.push_back({.label = "Length", .colour = trailPalette[0]});
    return curves;
  }
  for (int axis = 0; axis < 3; ++axis) {
    curves.push_back({.label = std::string(1, "XYZ"[axis]), .colour = axisColour(theme, axis)});
  }
  return curves;
}

std::vector<double> sampleFrames(const Span& frames, double lastFrame) {
  const double start = std::max(0.0, std::floor(frames.start));
  const double end = std::min(lastFrame, std::ceil(frames.end));
  const double step = std::max(1.0, std::ceil((end - start) / mostSamples));
  std::vector<double> samples;
  for (double frame = start; frame <= end + 1e-9; frame += step) {
    samples.push_back(frame);
  }
  if (!samples.empty() && samples.back() < end - 1e-9) {
    samples.push_back(end); // A clip may end between frames.
  }
  return samples;
}

void addSamples(std::vector<Curve>& curves, std::vector<Vec2> Curve::*target, double frame,
                const Vec3& values) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    (curves[i].*target).emplace_back(frame, values[static_cast<glm::length_t>(i)]);
  }
}

bool movesIn(const rig::MotionState& motion) {
  return std::any_of(motion.trails.begin(), motion.trails.end(),
                     [](const rig::SolvedTrail& trail) { return trail.active; });
}

/// Whether an applied trail keys the clip there.
bool isApplied(const rig::MotionState& motion, double seconds) {
  constexpr double tolerance = 1e-6;
  return std::any_of(motion.trails.begin(), motion.trails.end(), [&](const rig::SolvedTrail& trail) {
    return trail.trail.applied && seconds > trail.windowStartSeconds - tolerance &&
           seconds < trail.windowEndSeconds + tolerance;
  });
}

std::vector<Curve> makeCurves(PanelContext& context, const rig::Limb& limb, NodeIndex node,
                              const Span& frames) {
  app::Session& session = context.character();
  const app::Document& document = session.document();
  const Clip& clip = app::clipOf(document, session.view().clip);
  const rig::MotionState& motion = session.motion();
  const bool moves = movesIn(motion);
  std::vector<Curve> curves = emptyCurves(context.theme, context.ui.graph);
  Sampler current{context.ui.graph.channels, &limb, node};
  Sampler source = current;
  for (const double frame : sampleFrames(frames, clip.endSeconds * clip.framesPerSecond)) {
    const double seconds = frame / clip.framesPerSecond;
    const FrameState original = app::evaluateOriginal(document, session.view().clip, seconds);
    addSamples(curves, moves ? &Curve::before : &Curve::points, frame, source(original));
    if (moves) {
      addSamples(curves, &Curve::points, frame, current(app::evaluate(document, motion, seconds)));
    }
  }
  for (const double frame : keyFramesOf(session.shownClip(), node, context.ui.graph.channels)) {
    const bool onSource = moves && !isApplied(motion, frame / clip.framesPerSecond);
    for (Curve& curve : curves) {
      curve.keys.emplace_back(frame, curveValue(onSource ? curve.before : curve.points, frame));
    }
  }
  return curves;
}

} // namespace

std::vector<NodeIndex> graphNodes(const rig::Limb& limb) {
  std::vector<NodeIndex> nodes = limb.joints;
  if (limb.endNode.exists()) {
    nodes.push_back(limb.endNode);
  }
  return nodes;
}

const std::vector<Curve>& graphCurves(PanelContext& context, const rig::Limb& limb, const Span& frames) {
  GraphState& graph = context.ui.graph;
  const std::vector<NodeIndex> nodes = graphNodes(limb);
  const NodeIndex node =
      nodes[static_cast<std::size_t>(std::clamp(graph.joint, 0, static_cast<int>(nodes.size()) - 1))];
  const GraphKey key{
      context.character().sharedMotion(), limb.id, node, graph.channels, frames.start, frames.end};
  if (!graph.madeFrom || !(*graph.madeFrom == key)) {
    graph.curves = makeCurves(context, limb, node, frames);
    graph.madeFrom = key;
  }
  for (std::size_t i = 0; i < graph.curves.size() && i < graph.hidden.size(); ++i) {
    graph.curves[i].hidden = graph.hidden[i];
  }
  return graph.curves;
}

const char* graphUnit(GraphChannels channels) {
  switch (channels) {
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

Vec3 eulerNear(const Quat& rotation, const Vec3& previous) {
  const Vec3 angles = glm::eulerAngles(rotation);
  // The same rotation has a second set of angles; the one nearer to the previous frame gives a curve without
  // jumps.
  const Vec3 other(angles.x + pi, pi - angles.y, angles.z + pi);
  const auto near = [&](const Vec3& a) {
    return Vec3(unwrapped(a.x, previous.x), unwrapped(a.y, previous.y), unwrapped(a.z, previous.z));
  };
  const Vec3 first = near(angles);
  const Vec3 second = near(other);
  return distanceBetween(first, previous) <= distanceBetween(second, previous) ? first : second;
}

} // namespace stretch::ui
