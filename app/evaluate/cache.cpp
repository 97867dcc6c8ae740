#include "app/evaluate/cache.h"

#include "app/evaluate/keyed_clip.h"
#include "rig/adjust/solve_adjustments.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/solve_holds.h"

namespace stretch::app {

namespace {

bool isSameClip(const EvaluationGround& a, const EvaluationGround& b) {
  return a.scene == b.scene && a.clips == b.clips && a.clip == b.clip;
}

} // namespace

const EvaluationCache::Body& EvaluationCache::body(const EvaluationGround& ground) {
  EvaluationGround unadjusted = ground;
  unadjusted.adjustments.clear();
  return body_.of(std::move(unadjusted), [&](const auto*) {
    return std::make_shared<const rig::AdjustedBody>(
        rig::adjustedBody({*ground.scene, clipOf(ground), ground.hips, ground.limbs}));
  });
}

const EvaluationCache::Places& EvaluationCache::places(const std::shared_ptr<const Scene>& scene) {
  return places_.of(
      scene, [&](const auto*) { return std::make_shared<const rig::BindPlaces>(rig::bindPlaces(*scene)); });
}

const EvaluationCache::Motion& EvaluationCache::trails(const EvaluationInput& input) {
  return trails_.of({input.ground, input.trails}, [&](const auto* last) {
    rig::MotionInput wanted = motionInput(input);
    if (last != nullptr && last->key.ground == input.ground) {
      wanted.previous = last->value.get();
    }
    if (last != nullptr && isSameClip(last->key.ground, input.ground)) {
      wanted.sameClip = last->value.get();
    }
    if (input.ground.adjustments.empty()) {
      wanted.places = places(input.ground.scene);
    } else {
      wanted.body = body(input.ground);
    }
    return std::make_shared<const rig::MotionState>(rig::solveMotion(wanted));
  });
}

const EvaluationCache::Motion& EvaluationCache::held(const EvaluationInput& input) {
  const Motion& solved = trails(input);
  return held_.of({solved, input.holds}, [&](const auto*) {
    if (input.holds.empty()) {
      return solved;
    }
    rig::MotionState motion = *solved;
    rig::setHolds(motionInput(input), motion);
    return std::make_shared<const rig::MotionState>(std::move(motion));
  });
}

const SampledClip& EvaluationCache::sampled(const WeightInput& weight, const Motion& held) {
  std::vector<std::string> limbs;
  for (const std::size_t i : activeWeights(weight)) {
    limbs.push_back(weight.weights[i].limb);
  }
  return sampled_.of({held, std::move(limbs), upOf(weight)},
                     [&](const auto*) { return sampleClip(weight, *held); });
}

const EvaluationCache::Weighted& EvaluationCache::weighted(const Document& document, int clip) {
  const EvaluationInput input = evaluationInput(document, clip);
  const Motion& solved = held(input);
  return weighted_.of({solved, input.weights}, [&](const auto*) {
    const WeightInput weight = weightInput(input);
    if (activeWeights(weight).empty()) {
      return Weighted{solved, {}};
    }
    WeightMotion made = weightMotion(weight, sampled(weight, solved), sizes_);
    rig::MotionState motion = *solved;
    rig::setWeight(motionInput(input), std::move(made.weights), motion);
    return Weighted{std::make_shared<const rig::MotionState>(std::move(motion)), std::move(made.reports)};
  });
}

std::shared_ptr<const rig::MotionState> EvaluationCache::motion(const Document& document, int clip) {
  return weighted(document, clip).motion;
}

const std::vector<WeightReport>& EvaluationCache::weightReports(const Document& document, int clip) {
  const Weighted& made = weighted(document, clip);
  return reports_.of(made.motion, [&](const auto*) {
    std::vector<WeightReport> reports = made.reports;
    measureLengths(weightInput(evaluationInput(document, clip)), *made.motion, reports);
    return reports;
  });
}

const FrameState& EvaluationCache::frame(const Document& document, int clip, double timeSeconds) {
  const Motion& moving = weighted(document, clip).motion;
  return frame_.of({moving, timeSeconds}, [&](const auto*) {
    return rig::evaluateMotion(*document.scene, clipOrStill(*document.clips, clip), *moving, timeSeconds);
  });
}

const std::vector<rig::PlacedController>& EvaluationCache::controllers(const Document& document, int clip,
                                                                       double timeSeconds) {
  const Motion moving = weighted(document, clip).motion;
  return controllers_.of({moving, timeSeconds}, [&](const auto*) {
    const EvaluationGround ground = evaluationInput(document, clip).ground;
    rig::SolvedAdjustments adjustments = moving->adjustments;
    adjustments.body = body(ground);
    return rig::placeControllers(
        {*document.scene, clipOf(ground), adjustments, frame(document, clip, timeSeconds)});
  });
}

const std::vector<rig::ControllerShape>& EvaluationCache::shapes(const Document& document, int clip) {
  const EvaluationGround ground = evaluationInput(document, clip).ground;
  const Body standing = body(ground);
  return shapes_.of(
      standing, [&](const auto*) { return rig::controllerShapes(*ground.scene, ground.limbs, *standing); });
}

const FrameState& EvaluationCache::original(const Document& document, int clip, double timeSeconds) {
  return original_.of({document.scene, sourceClipsOf(document), clip, timeSeconds}, [&](const auto*) {
    const Clip& shown = clipOrStill(*sourceClipsOf(document), clip);
    return frameOf(*document.scene, samplePose(*document.scene, shown, timeSeconds), timeSeconds);
  });
}

const std::vector<TrailPaths>& EvaluationCache::paths(const Document& document, int clip,
                                                      std::size_t samplesPerFrame) {
  const EvaluationInput input = evaluationInput(document, clip);
  const Motion& solved = held(input);
  return paths_.of({input.ground, solved, samplesPerFrame}, [&](const auto* last) {
    const bool usable =
        last != nullptr && last->key.ground == input.ground && last->key.samplesPerFrame == samplesPerFrame;
    return drawPaths(input.ground, *solved, samplesPerFrame,
                     usable ? EarlierPaths{last->key.held.get(), &last->value} : EarlierPaths{});
  });
}

const Clip& EvaluationCache::keyed(const Document& document, int clip, rig::KeyPlaces places) {
  const Document applied = appliedOnly(document);
  const EvaluationInput input = evaluationInput(applied, clip);
  if (input.trails.empty() && input.ground.adjustments.empty() && input.holds.empty()) {
    return clipOf(document, clip);
  }
  return keyed_.of({{input.ground, input.trails}, input.holds, places}, [&](const auto*) {
    const Clip& source = clipOf(document, clip);
    rig::RekeyOptions options = keyingOptions(document);
    options.places = places;
    // Of a cache of its own: what is remembered here is the motion that is seen.
    const Motion motion = EvaluationCache().motion(applied, clip);
    return rig::withTracks(source, rig::rekey(*document.scene, source, *motion, options).tracks);
  });
}

} // namespace stretch::app
