#include "app/evaluate/quality.h"
#include "rig/limb.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "core/math/rotation.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

constexpr double room = 1.5;
constexpr double farthestTurn = 120.0 * pi / 180.0; // beyond it an arm or a leg looks torn out and put back

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
    return first == last ? fmt::format("at frame {:g}", first)
                         : fmt::format("at frames {:g} to {:g} (worst at {:g})", first, last, worstFrame);
  }

  double worstBadness = 0.0;
};

struct Findings {
  Finding lengths;
  Finding turns;
  Finding vertices;

  [[nodiscard]] bool any() const { return lengths.any() || turns.any() || vertices.any(); }
};

// One trail at a time: what others do to the body is not this one's doing.
rig::MotionState aloneIn(const rig::MotionState& motion, int trailId) {
  rig::MotionState alone = motion;
  alone.weights.clear();
  std::erase_if(alone.trails, [&](const rig::SolvedTrail& other) { return other.trail.id != trailId; });
  return alone;
}

std::vector<double> framesOf(const rig::MotionState& motion, const rig::SolvedTrail& trail) {
  const double fps = motion.framesPerSecond;
  const double last = std::floor(std::min(trail.windowEndSeconds, motion.endSeconds) * fps + 1e-6);
  std::vector<double> frames;
  for (double frame = std::max(0.0, std::ceil(trail.windowStartSeconds * fps - 1e-6)); frame <= last;
       frame += 1.0) {
    frames.push_back(frame);
  }
  return frames;
}

Vec3 reachOf(const rig::Limb& limb, const FrameState& frame) {
  return rig::endPosition(limb, frame) - positionOf(frame.worlds[at(limb.joints.front())]);
}

void lookAtLimb(const rig::SolvedTrail& trail, const FrameState& before, const FrameState& after,
                double frame, Findings& findings) {
  const Vec3 reachBefore = reachOf(trail.limb, before);
  const Vec3 reachAfter = reachOf(trail.limb, after);
  if (!(glm::length(reachBefore) > 0.0)) {
    return;
  }
  const double scale = trail.settings.scale;
  const double ratio = glm::length(reachAfter) / glm::length(reachBefore);
  const double least = std::min(1.0, scale) / room;
  const double most = room * std::max(1.0, scale);
  if (ratio < least || ratio > most) {
    findings.lengths.add(frame, ratio, std::max(least / std::max(ratio, 1e-9), ratio / most));
  }
  const double turn = angleBetween(reachBefore, reachAfter);
  if (turn > farthestTurn) {
    findings.turns.add(frame, turn, turn);
  }
}

// The same trail with other settings, solved alone.
rig::MotionState solvedWith(const Document& document, int clip, const rig::SolvedTrail& trail,
                            const rig::TrailSettings& settings) {
  Document other = document;
  other.trails = {trail.trail};
  other.weights.clear();
  other.trails.front().settings = settings;
  return prepareMotion(other, clip);
}

bool staysInBounds(const Document& document, const rig::MotionState& motion) {
  const rig::SolvedTrail& trail = motion.trails.front();
  Findings findings;
  for (const double frame : framesOf(motion, trail)) {
    const double seconds = frame / motion.framesPerSecond;
    lookAtLimb(trail, evaluateOriginal(document, motion.clip, seconds), evaluate(document, motion, seconds),
               frame, findings);
  }
  return !findings.any();
}

struct Remedy {
  rig::TrailSettings settings;
  std::string advice;
};

// What an artist would try, the least intrusive first.
std::vector<Remedy> remediesFor(const rig::MotionState& motion, const rig::SolvedTrail& trail,
                                const Findings& findings) {
  std::vector<Remedy> remedies;
  const bool forwards = trail.settings.pivot == rig::Pivot::start;
  const auto tipAt = [&](double frame, const std::string& why) {
    rig::TrailSettings settings = trail.settings;
    (forwards ? settings.endFrame : settings.startFrame) = frame;
    remedies.push_back(
        {settings, fmt::format("{} the range at frame {:g}{}", forwards ? "end" : "start", frame, why)});
  };
  if (trail.tip.moved) {
    const auto farthest = static_cast<std::size_t>(trail.tip.farthestSample);
    tipAt(trail.path.samples[farthest].timeSeconds * motion.framesPerSecond,
          ", where the limb's end is farthest from the pivot");
  }
  if (trail.settings.space == rig::TrailSpace::world) {
    rig::TrailSettings settings = trail.settings;
    settings.space = rig::TrailSpace::base;
    remedies.push_back({settings, "set the space to base, which leaves the body's own way out"});
  }
  const double early = forwards ? findings.lengths.first - 1.0 : findings.lengths.last + 1.0;
  if (findings.lengths.any() && early > trail.settings.startFrame && early < trail.settings.endFrame) {
    tipAt(early, "");
  }
  constexpr int steps = 8;
  for (int step = steps - 1; trail.settings.scale > 1.0 && step > 0; --step) {
    rig::TrailSettings settings = trail.settings;
    settings.scale = std::round(100.0 + 100.0 * (trail.settings.scale - 1.0) * step / steps) / 100.0;
    remedies.push_back({settings, fmt::format("lower the scale to {:g}", settings.scale)});
  }
  return remedies;
}

// Tried before it is told: what keeps the limb in bounds.
std::string adviceFor(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail,
                      const Findings& findings) {
  for (const Remedy& remedy : remediesFor(motion, trail, findings)) {
    const rig::MotionState other = solvedWith(document, motion.clip, trail, remedy.settings);
    if (!other.trails.empty() && staysInBounds(document, other)) {
      return remedy.advice;
    }
  }
  return "shorten the range, or pull the control spheres there";
}

Findings lookAt(const Document& document, const rig::MotionState& alone, double tipDisplacement,
                LookAt what) {
  const rig::SolvedTrail& trail = alone.trails.front();
  Findings findings;
  for (const double frame : framesOf(alone, trail)) {
    const double seconds = frame / alone.framesPerSecond;
    const FrameState before = evaluateOriginal(document, alone.clip, seconds);
    const FrameState after = evaluate(document, alone, seconds);
    lookAtLimb(trail, before, after, frame, findings);
    const double farthest =
        what == LookAt::limbAndMesh ? farthestVertex(*document.scene, before, after) : 0.0;
    if (farthest > room * tipDisplacement && farthest > 1e-4 * document.biped.height) {
      findings.vertices.add(frame, farthest, farthest);
    }
  }
  return findings;
}

} // namespace

std::vector<std::string> motionWarnings(const Document& document, const rig::MotionState& motion,
                                        const rig::SolvedTrail& trail, LookAt what) {
  const rig::MotionState alone = aloneIn(motion, trail.trail.id);
  const FrameState tipBefore = evaluateOriginal(document, motion.clip, trail.tipSeconds);
  const FrameState tipAfter = evaluate(document, alone, trail.tipSeconds);
  const double tipDisplacement =
      glm::length(rig::endPosition(trail.limb, tipAfter) - rig::endPosition(trail.limb, tipBefore));
  const Findings findings = lookAt(document, alone, tipDisplacement, what);
  std::vector<std::string> warnings;
  if (!findings.any()) {
    return warnings;
  }
  const std::string advice = adviceFor(document, motion, trail, findings);
  const auto warn = [&](const std::string& found, const Finding& finding) {
    warnings.push_back(fmt::format("{}: {} {}; {}", trail.limb.id, found, finding.frames(), advice));
  };
  if (findings.lengths.any()) {
    warn(fmt::format("the limb is {:.3g} times its own length", findings.lengths.worst), findings.lengths);
  }
  if (findings.turns.any()) {
    warn(fmt::format("the limb points {:.0f} degrees away from where it did",
                     findings.turns.worst * 180.0 / pi),
         findings.turns);
  }
  if (findings.vertices.any()) {
    warn(fmt::format("a vertex is {:.3g} from its place, the tip only {:.3g},", findings.vertices.worst,
                     tipDisplacement),
         findings.vertices);
  }
  return warnings;
}

} // namespace stretch::app
