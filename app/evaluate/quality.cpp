#include "app/evaluate/quality.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "app/evaluate/evaluation_input.h"
#include "app/evaluate/left_behind.h"
#include "app/evaluate/stopped.h"
#include "app/evaluate/trail_look.h"
#include "app/standing_floor.h"

namespace stretch::app {

namespace {

// Of a range: what a shorter one has to leave of it to be worth advising.
constexpr double smallestPart = 0.2;

// One trail at a time: what others do to the body is not this one's doing.
rig::MotionState aloneIn(const rig::MotionState& motion, int trailId) {
  rig::MotionState alone = motion;
  alone.weights.clear();
  alone.holds = {};
  std::erase_if(alone.trails, [&](const rig::SolvedTrail& other) { return other.trail.id != trailId; });
  return alone;
}

// The same trail of a motion with other settings, solved alone.
rig::MotionState solvedWith(const Document& document, const rig::MotionState& motion,
                            const rig::SolvedTrail& trail, const rig::TrailSettings& settings,
                            const std::shared_ptr<const rig::BindPlaces>& places) {
  Document other = document;
  other.trails = {trail.trail};
  other.weights.clear();
  other.holds = {};
  other.trails.front().settings = settings;
  const EvaluationInput input = evaluationInput(other, motion.clip);
  rig::MotionInput wanted = motionInput(input);
  wanted.places = places;
  wanted.previous = &motion; // its path is the same under most settings
  return rig::solveMotion(wanted);
}

struct Remedy {
  rig::TrailSettings settings;
  std::string advice;
};

// What an artist would try, the least intrusive first.
class Remedies {
public:
  Remedies(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail,
           const TrailLook& look)
      : document_(document), motion_(motion), trail_(trail), look_(look) {}

  [[nodiscard]] std::vector<Remedy> against(const Findings& findings) {
    if (trail_.tip.moved) {
      const auto farthest = static_cast<std::size_t>(trail_.tip.farthestSample);
      tipAt(trail_.path.samples[farthest].timeSeconds * motion_.framesPerSecond,
            ", where the limb's end is farthest from the pivot");
    }
    if (trail_.settings.space == rig::TrailSpace::world) {
      const char* const why = "which leaves the body's own way out";
      add([](rig::TrailSettings& s) { s.space = rig::TrailSpace::root; },
          fmt::format("set the space to root, {}", why));
      add([](rig::TrailSettings& s) { s.space = rig::TrailSpace::base; },
          fmt::format("set the space to base, {}", why));
    }
    if (findings.ends.any() && !isStoppedAtTip(document_, motion_, trail_)) {
      stopAtFloor();
    }
    if (trail_.settings.stopAt && (findings.jumps.any() || findings.swings.any())) {
      add([](rig::TrailSettings& s) { s.stopAt.reset(); },
          "set Stop at to Nowhere (a recipe without stop_at)");
    }
    if (findings.lows.any() || findings.floors.any()) {
      goNoLower();
    }
    const double early = isForwards() ? findings.firstFrame() - 1.0 : findings.lastFrame() + 1.0;
    const double left = isForwards() ? early - trail_.settings.startFrame : trail_.settings.endFrame - early;
    const double whole = trail_.settings.endFrame - trail_.settings.startFrame;
    if (left >= smallestPart * whole && left < whole) {
      tipAt(early, "");
    }
    return std::move(remedies_);
  }

private:
  [[nodiscard]] bool isForwards() const { return trail_.settings.pivot == rig::Pivot::start; }

  template <typename Change>
  void add(const Change& change, std::string advice) {
    rig::TrailSettings settings = trail_.settings;
    change(settings);
    remedies_.push_back({settings, std::move(advice)});
  }

  void tipAt(double frame, const std::string& why) {
    add([&](rig::TrailSettings& s) { (isForwards() ? s.endFrame : s.startFrame) = frame; },
        fmt::format("{} the range at frame {:g}{}", isForwards() ? "end" : "start", frame, why));
  }

  void goNoLower() {
    if (trail_.settings.axes[1]) {
      add([](rig::TrailSettings& s) { s.axes[1] = false; }, "switch the axis Y off");
    }
    if (!isStoppedAtTip(document_, motion_, trail_)) {
      stopAt(look_.lowestPlace());
      ClipFacts& facts = *look_.facts();
      if (const std::optional<rig::StopPlane> floor =
              floorForLeg(document_, motion_.clip, trail_.limb, tipFrameOf(trail_.settings), *facts.places(),
                          facts.standing())) {
        stopAt(floor->point.y);
      }
    }
  }

  void stopAtFloor() {
    const StandingFloor& standing = look_.facts()->standing();
    stopAt(isLeg(trail_.limb) ? standingEnd(document_, trail_.limb, *look_.facts()->places(), standing)
                              : standing.floor);
  }

  void stopAt(std::optional<double> height) {
    if (height) {
      add(
          [&](rig::TrailSettings& s) {
            s.stopAt = rig::StopPlane{{0.0, *height, 0.0}, {0.0, -1.0, 0.0}};
          },
          fmt::format("stop the limb's end at the floor, below y = {:.4g}", *height));
    }
  }

  const Document& document_;
  const rig::MotionState& motion_;
  const rig::SolvedTrail& trail_;
  const TrailLook& look_;
  std::vector<Remedy> remedies_;
};

// Tries what an artist would try.
class Trial {
public:
  Trial(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail,
        const TrailLook& look, const Findings& findings)
      : document_(document), motion_(motion), trail_(trail), look_(look), findings_(findings),
        likely_(findings.worstFrames()) {}

  // The largest scale, in quarters, that leaves nothing: the same one from whatever scale above it.
  [[nodiscard]] std::optional<double> smallerScale() {
    constexpr double quarter = 0.25;
    int worksAt = 4; // quarters: no exaggeration, which is not worth advising
    int failsAt = static_cast<int>(std::ceil(trail_.settings.scale / quarter - 1e-9));
    while (failsAt - worksAt > 1) {
      const int middle = (worksAt + failsAt) / 2;
      rig::TrailSettings settings = trail_.settings;
      settings.scale = quarter * middle;
      (helps(settings) ? worksAt : failsAt) = middle;
    }
    return worksAt > 4 ? std::optional(quarter * worksAt) : std::nullopt;
  }

  [[nodiscard]] std::string other() {
    for (const Remedy& remedy : Remedies(document_, motion_, trail_, look_).against(findings_)) {
      if (helps(remedy.settings)) {
        return remedy.advice;
      }
    }
    return {};
  }

private:
  [[nodiscard]] bool helps(const rig::TrailSettings& settings) {
    const rig::MotionState other = solvedWith(document_, motion_, trail_, settings, look_.facts()->places());
    if (other.trails.empty()) {
      return false;
    }
    const std::optional<double> found = look_.foundAt(other, likely_);
    if (found) { // the next one most likely fails there, too
      std::erase(likely_, *found);
      likely_.insert(likely_.begin(), *found);
    }
    return !found;
  }

  const Document& document_;
  const rig::MotionState& motion_;
  const rig::SolvedTrail& trail_;
  const TrailLook& look_;
  const Findings& findings_;   // of the trail as it is
  std::vector<double> likely_; // frames where what is tried may not look right, the likeliest first
};

// The smaller scale comes first, whatever else would help as well: advice that stays the same while a number
// is changed.
std::string adviceFor(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail,
                      const TrailLook& look, const Findings& findings) {
  Trial trial(document, motion, trail, look, findings);
  const std::optional<double> scale = trial.smallerScale();
  const std::string other = trial.other();
  const std::string smaller = scale ? fmt::format("lower the scale to {:g}", *scale) : std::string();
  if (smaller.empty() && other.empty()) {
    return "shorten the range, or pull the control spheres there";
  }
  return smaller + (smaller.empty() || other.empty() ? "" : ", or ") + other;
}

std::vector<std::string> lines(const rig::Limb& limb, const Findings& findings, bool knowsFloor,
                               const std::string& advice) {
  std::vector<std::string> warnings;
  const auto warn = [&](const Finding& finding, const std::string& found) {
    if (finding.any()) {
      warnings.push_back(fmt::format("{} {}; {}", found, finding.frames(), advice));
    }
  };
  warn(findings.lengths, fmt::format("the limb is {:.3g} times its own length", findings.lengths.worst));
  warn(findings.turns, fmt::format("the limb points {:.0f} degrees away from where it did",
                                   findings.turns.worst * 180.0 / pi));
  warn(findings.vertices, fmt::format("a vertex is {:.3g} from its place, the tip only {:.3g},",
                                      findings.vertices.worst, findings.tipDisplacement));
  const char* const end = isLeg(limb) ? "foot" : isArm(limb) ? "hand" : "limb's end";
  const std::string jump = fmt::format("jumps by {:.3g} within a frame where it stops", findings.jumps.worst);
  const bool jumps = findings.jumps.any();
  warn(findings.swings,
       fmt::format("the {} is carried {:.3g} away, at the tip only {:.3g},{}", end, findings.swings.worst,
                   findings.tipDisplacement,
                   jumps ? fmt::format(" and {} (frame {:g}),", jump, findings.jumps.worstFrame) : ""));
  if (!findings.swings.any()) {
    warn(findings.jumps, fmt::format("the {} {}", end, jump));
  }
  warn(findings.edges, fmt::format("an edge of the mesh is {:.3g} times its length", findings.edges.worst));
  warn(findings.elbows, fmt::format("the elbow is {:.3g} above the head", findings.elbows.worst));
  warn(findings.ends, fmt::format("the {} is {:.3g} below {}", isLeg(limb) ? "foot" : "hand",
                                  findings.ends.worst, isLeg(limb) ? "where feet stand" : "the floor"));
  warn(findings.lows, fmt::format("the limb is {:.3g} below the lowest place of the body in the clip, most "
                                  "likely through the floor,",
                                  findings.lows.worst));
  if (!findings.ends.any() && !findings.lows.any()) {
    warn(findings.floors, fmt::format("the limb's surface is {:.3g} below {}", findings.floors.worst,
                                      knowsFloor ? "the floor"
                                                 : "the lowest place of the body in the clip, most likely "
                                                   "through the floor,"));
  }
  warn(findings.bends, fmt::format("a joint bends the other way than in the clip, by {:.0f} degrees",
                                   findings.bends.worst * 180.0 / pi));
  return warnings;
}

} // namespace

std::vector<std::string> motionWarnings(const std::shared_ptr<ClipFacts>& facts,
                                        const rig::MotionState& motion, const rig::SolvedTrail& trail,
                                        LookAt what) {
  if (!trail.active) {
    return {};
  }
  const Document& document = facts->document();
  const TrailLook look(facts, trail, what);
  const Findings findings = look.findings(aloneIn(motion, trail.trail.id));
  std::vector<std::string> warnings;
  if (findings.any()) {
    const bool knowsFloor = facts->standing().floor.has_value();
    warnings = lines(trail.limb, findings, knowsFloor, adviceFor(document, motion, trail, look, findings));
  }
  const std::vector<std::string> parts =
      partsLeftBehind(document, trail.limb, look.moved(), *facts->places());
  warnings.insert(warnings.end(), parts.begin(), parts.end());
  return warnings;
}

std::vector<std::string> motionWarnings(const Document& document, const rig::MotionState& motion,
                                        const rig::SolvedTrail& trail, LookAt what) {
  return motionWarnings(std::make_shared<ClipFacts>(document, motion.clip), motion, trail, what);
}

} // namespace stretch::app
