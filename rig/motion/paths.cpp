#include "rig/motion/paths.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "core/anim/frames.h"
#include "rig/adjust/frame_table.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/order.h"
#include "rig/motion/release_length.h"

namespace stretch::rig {

namespace {

// The active trails that move the limb of one of the asked trails, in the order in which they act.
std::vector<std::size_t> innerTrails(const Scene& scene, const MotionState& motion,
                                     const std::vector<PathRequest>& requests) {
  std::vector<std::size_t> inner;
  for (std::size_t trail = 0; trail < motion.trails.size(); ++trail) {
    const bool moves = std::any_of(requests.begin(), requests.end(), [&](const PathRequest& request) {
      return shapesPath(scene, motion, trail, request.trail);
    });
    if (moves) {
      inner.push_back(trail);
    }
  }
  return inner;
}

std::vector<NodeIndex> nodesOf(const MotionState& motion, const std::vector<std::size_t>& inner,
                               const std::vector<PathRequest>& requests) {
  std::set<NodeIndex> nodes;
  for (const std::size_t trail : inner) {
    const SolvedTrail& solved = motion.trails[trail];
    const std::vector<NodeIndex> touched = touchedNodes(solved.limb, solved.topology);
    nodes.insert(touched.begin(), touched.end());
  }
  for (const PathRequest& request : requests) {
    const std::vector<NodeIndex> own = jointsAndEnd(motion.trails[request.trail].limb);
    nodes.insert(own.begin(), own.end());
  }
  if (motion.hips.exists()) {
    nodes.insert(motion.hips);
  }
  return {nodes.begin(), nodes.end()};
}

std::vector<double> framesOfAll(const std::vector<PathRequest>& requests) {
  std::vector<double> frames;
  std::vector<double> merged;
  for (const PathRequest& request : requests) {
    merged.clear();
    std::ranges::set_union(frames, request.frames, std::back_inserter(merged));
    std::swap(frames, merged);
  }
  return frames;
}

// On a loop, a time past the clip's end is one of its next turn, and one before its start of the last; what a
// range has before the start is held there.
double insideLoop(const MotionState& motion, const std::vector<PathRequest>& requests, double timeSeconds) {
  const double turn = motion.endSeconds - motion.startSeconds;
  double first = motion.startSeconds;
  for (const PathRequest& request : requests) {
    first = std::min(first, firstSeconds(motion, motion.trails[request.trail]));
  }
  const bool isPast = timeSeconds > motion.endSeconds;
  if (!motion.loops || !(isPast || timeSeconds < first)) {
    return timeSeconds;
  }
  return isPast ? timeSeconds - turn : timeSeconds + turn;
}

// Walks through all frames once: a frame that several paths ask for is sampled once.
class PathSweep {
public:
  PathSweep(const Scene& scene, const Clip& clip, const MotionState& motion,
            const std::vector<PathRequest>& requests)
      : motion_(motion), requests_(requests), inner_(innerTrails(scene, motion, requests)),
        frames_(scene, clip, motion.adjustments, nodesOf(motion, inner_, requests),
                motion.adjustedFrames.get()),
        skeleton_(frames_.skeleton()), order_(requests.size()) {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      order_[i] = i;
    }
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return requests_[a].trail < requests_[b].trail; // as they act
    });
  }

  [[nodiscard]] std::vector<DrawnTrail> run() {
    std::vector<DrawnTrail> drawn(requests_.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      drawn[i].frames = requests_[i].frames;
      drawn[i].original.resize(drawn[i].frames.size());
      drawn[i].exaggerated.resize(drawn[i].frames.size());
    }
    for (const double frame : framesOfAll(requests_)) {
      visit(frame, drawn);
    }
    return drawn;
  }

private:
  void visit(double frameNumber, std::vector<DrawnTrail>& drawn) {
    const FrameState& source =
        frames_.at(insideLoop(motion_, requests_, frameNumber / motion_.framesPerSecond));
    if (!inner_.empty()) {
      moved_ = source;
    }
    const FrameState& frame = inner_.empty() ? source : moved_;
    auto next = inner_.begin();
    for (const std::size_t i : order_) {
      const PathRequest& request = requests_[i];
      for (; next != inner_.end() && *next < request.trail; ++next) {
        applyTrail(skeleton_, motion_, *next, source, moved_);
      }
      const auto found = std::equal_range(request.frames.begin(), request.frames.end(), frameNumber);
      if (found.first == found.second) {
        continue;
      }
      const PathPoint point = pathPoint(skeleton_, motion_, request.trail, source, frame);
      for (auto place = found.first; place != found.second; ++place) {
        const auto sample = static_cast<std::size_t>(place - request.frames.begin());
        drawn[i].original[sample] = point.original;
        drawn[i].exaggerated[sample] = point.exaggerated;
      }
    }
  }

  const MotionState& motion_;
  const std::vector<PathRequest>& requests_;
  std::vector<std::size_t> inner_;
  FrameSource frames_;
  const Scene& skeleton_;          // the sampled nodes only
  std::vector<std::size_t> order_; // of the requests, as their trails act
  FrameState moved_;               // by the trails before the one that is asked for
};

// The requests about trails that the character follows, on limbs that are held.
std::vector<PathRequest> heldRequests(const MotionState& motion, const std::vector<PathRequest>& requests) {
  std::vector<PathRequest> held;
  std::copy_if(requests.begin(), requests.end(), std::back_inserter(held), [&](const PathRequest& request) {
    return motion.trails[request.trail].active && isHeldLimb(motion, motion.trails[request.trail].limb.id);
  });
  return held;
}

// Every trail and hold of the clip: each may move a limb that is held.
std::vector<NodeIndex> nodesOfAll(const MotionState& motion, const std::vector<PathRequest>& requests) {
  std::vector<std::size_t> active;
  for (std::size_t trail = 0; trail < motion.trails.size(); ++trail) {
    if (motion.trails[trail].active) {
      active.push_back(trail);
    }
  }
  std::vector<NodeIndex> nodes = nodesOf(motion, active, requests);
  nodes.insert(nodes.end(), motion.holds.nodes.begin(), motion.holds.nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// Lays the path of a limb where the holds keep it at the times at which they do.
void layHeldPaths(const Scene& scene, const Clip& clip, const MotionState& motion,
                  const std::vector<PathRequest>& requests, std::vector<DrawnTrail>& drawn) {
  const std::vector<PathRequest> held = heldRequests(motion, requests);
  if (held.empty()) {
    return;
  }
  FrameSource frames(scene, clip, motion.adjustments, nodesOfAll(motion, held), motion.adjustedFrames.get());
  const Scene& skeleton = frames.skeleton();
  for (const double frameNumber : framesOfAll(held)) {
    FrameState frame = frames.at(insideLoop(motion, requests, frameNumber / motion.framesPerSecond));
    for (const HeldGoal& goal : applyTrailsAndHolds(skeleton, motion, frame)) {
      const Limb& limb = motion.holds.limbs[goal.limb].limb;
      for (std::size_t i = 0; i < requests.size(); ++i) {
        const SolvedTrail& solved = motion.trails[requests[i].trail];
        const auto [first, last] =
            std::equal_range(requests[i].frames.begin(), requests[i].frames.end(), frameNumber);
        if (solved.active && solved.limb.id == limb.id) {
          std::fill(drawn[i].exaggerated.begin() + (first - requests[i].frames.begin()),
                    drawn[i].exaggerated.begin() + (last - requests[i].frames.begin()),
                    leadingPosition(limb, frame));
        }
      }
    }
  }
}

} // namespace

bool isHeldLimb(const MotionState& motion, const std::string& limb) {
  return std::ranges::any_of(motion.holds.limbs,
                             [&](const ReachingLimb& held) { return held.limb.id == limb; });
}

bool shapesPath(const Scene& scene, const MotionState& motion, std::size_t inner, std::size_t outer) {
  if (inner >= outer || !motion.trails[inner].active) {
    return false;
  }
  const Limb& carrier = motion.trails[inner].limb;
  const Limb& carried = motion.trails[outer].limb;
  const NodeIndex base = carried.joints.front();
  return carrier.joints.front() == base || carries(scene, carrier, carried) ||
         std::ranges::any_of(motion.trails[inner].topology.companions,
                             [&](NodeIndex node) { return isAncestorOrSelf(scene, node, base); });
}

std::vector<DrawnTrail> pathsAt(const Scene& scene, const Clip& clip, const MotionState& motion,
                                const std::vector<PathRequest>& requests) {
  std::vector<DrawnTrail> drawn = PathSweep(scene, clip, motion, requests).run();
  layHeldPaths(scene, clip, motion, requests, drawn);
  return drawn;
}

DrawnTrail pathsAt(const Scene& scene, const Clip& clip, const MotionState& motion, std::size_t trail,
                   const std::vector<double>& frames) {
  return pathsAt(scene, clip, motion, std::vector<PathRequest>{{trail, frames}}).front();
}

std::vector<double> drawnFrames(const Clip& clip, const SolvedTrail& solved, std::size_t samplesPerFrame,
                                bool acrossSeam) {
  const double fps = clip.framesPerSecond;
  const double first = acrossSeam ? solved.windowStartSeconds
                                  : std::max(solved.windowStartSeconds, std::min(0.0, clip.startSeconds));
  const double start = fps * first;
  const double last =
      acrossSeam ? solved.windowEndSeconds : std::min(solved.windowEndSeconds, clip.endSeconds);
  const double end = std::max(start, fps * last);
  const auto perFrame = static_cast<double>(std::max<std::size_t>(1, samplesPerFrame));
  const auto count = static_cast<std::size_t>(wholeFrameAtMost((end - start) * perFrame)) + 1;
  std::vector<double> frames;
  for (std::size_t i = 0; i < count; ++i) {
    frames.push_back(start + static_cast<double>(i) / perFrame);
  }
  return frames;
}

} // namespace stretch::rig
