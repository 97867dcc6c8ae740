#include "app/quality.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

constexpr double room = 1.5;

double farthestVertex(const Scene& scene, const FrameState& before, const FrameState& after) {
  const std::vector<Vec3> from = skinning::skinnedPositions(scene, before);
  const std::vector<Vec3> to = skinning::skinnedPositions(scene, after);
  double farthest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    farthest = std::max(farthest, glm::length(to[i] - from[i]));
  }
  return farthest;
}

// The frames that are out of bounds, and the worst of them.
struct Finding {
  double first = -1.0;
  double last = -1.0;
  double worst = 0.0;
  double worstFrame = 0.0;

  void add(double frame, double value, double badness) {
    first = first < 0.0 ? frame : first;
    last = frame;
    if (badness > worstBadness) {
      worstBadness = badness;
      worst = value;
      worstFrame = frame;
    }
  }
  [[nodiscard]] bool any() const { return first >= 0.0; }
  [[nodiscard]] std::string frames() const {
    return first == last ? fmt::format("frame {:g}", first) : fmt::format("frames {:g} to {:g}", first, last);
  }

  double worstBadness = 0.0;
};

} // namespace

std::vector<std::string> motionWarnings(const Document& document, const rig::MotionState& motion,
                                        const rig::SolvedTrail& trail) {
  // One trail at a time: what others do to the body is not this one's doing.
  rig::MotionState alone = motion;
  std::erase_if(alone.trails,
                [&](const rig::SolvedTrail& other) { return other.trail.id != trail.trail.id; });
  const double fps = motion.framesPerSecond;
  const double scale = trail.settings.scale;
  const FrameState tipBefore = evaluateOriginal(document, motion.clip, trail.tipSeconds);
  const FrameState tipAfter = evaluate(document, alone, trail.tipSeconds);
  const double tipDisplacement =
      glm::length(rig::endPosition(trail.limb, tipAfter) - rig::endPosition(trail.limb, tipBefore));
  Finding lengths;
  Finding vertices;
  const double last = std::floor(std::min(trail.windowEndSeconds, motion.endSeconds) * fps + 1e-6);
  for (double frame = std::max(0.0, std::ceil(trail.windowStartSeconds * fps - 1e-6)); frame <= last;
       frame += 1.0) {
    const FrameState before = evaluateOriginal(document, motion.clip, frame / fps);
    const FrameState after = evaluate(document, alone, frame / fps);
    const double lengthBefore = rig::limbLength(trail.limb, before);
    const double ratio = lengthBefore > 0.0 ? rig::limbLength(trail.limb, after) / lengthBefore : 1.0;
    const double least = std::min(1.0, scale) / room;
    const double most = room * std::max(1.0, scale);
    if (ratio < least || ratio > most) {
      lengths.add(frame, ratio, std::max(least / std::max(ratio, 1e-9), ratio / most));
    }
    const double farthest = farthestVertex(*document.scene, before, after);
    if (farthest > room * tipDisplacement && farthest > 1e-4 * document.biped.height) {
      vertices.add(frame, farthest, farthest);
    }
  }
  std::vector<std::string> warnings;
  if (lengths.any()) {
    warnings.push_back(fmt::format("{}: the limb is {:.3g} times its own length at {} (worst at frame {:g})",
                                   trail.limb.id, lengths.worst, lengths.frames(), lengths.worstFrame));
  }
  if (vertices.any()) {
    warnings.push_back(
        fmt::format("{}: a vertex is {:.3g} from its place at {} (worst at frame {:g}), the tip only {:.3g}",
                    trail.limb.id, vertices.worst, vertices.frames(), vertices.worstFrame, tipDisplacement));
  }
  return warnings;
}

} // namespace stretch::app
