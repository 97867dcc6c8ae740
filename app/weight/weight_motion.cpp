#include "app/weight/weight_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "app/weight/loop.h"
#include "app/weight/standing.h"
#include "core/anim/frames.h"
#include "skinning/elastic/bone_strains.h"
#include "skinning/elastic/limb_elasticity.h"

namespace stretch::app {

namespace {

constexpr double earthGravity = 9.81;

const SampledClip::OfLimb* limbIn(const SampledClip& sampled, const std::string& id) {
  const auto found =
      std::ranges::find_if(sampled.limbs, [&](const SampledClip::OfLimb& one) { return one.limb.id == id; });
  return found == sampled.limbs.end() ? nullptr : &*found;
}

// Cylinders of the bones, metres.
std::vector<skinning::LimbSegment> segmentsOf(const WeightInput& input, const rig::Limb& limb,
                                              LimbSizes& sizes) {
  LimbSize size = sizes.of(input, limb);
  for (std::vector<double>* const list : {&size.lengths, &size.widths}) {
    for (double& value : *list) {
      value *= input.metresPerUnit();
    }
  }
  return skinning::limbSegments(size.lengths, size.widths);
}

double volumeOf(const std::vector<skinning::LimbSegment>& segments) {
  return std::accumulate(segments.begin(), segments.end(), 0.0,
                         [](double sum, const skinning::LimbSegment& s) { return sum + s.volume; });
}

// Of the body above the legs: a character of 1.75 m has the volume of a person of 70 kg.
double volumeAboveLegs(const WeightInput& input, LimbSizes& sizes) {
  constexpr double bodyVolume = 0.07; // m^3
  constexpr double leastShare = 0.3;
  double legs = 0.0;
  for (const rig::Limb& limb : input.limbs) {
    legs += rig::isLeg(limb) ? volumeOf(segmentsOf(input, limb, sizes)) : 0.0;
  }
  return std::max(leastShare * bodyVolume, bodyVolume - legs);
}

// The pressure that the limb at rest bears, Pa: the mean along its length, which is what its length shows.
double stillPressure(const std::vector<skinning::LimbSegment>& segments, double density, double carriedMass) {
  double sum = 0.0;
  double length = 0.0;
  double mass = carriedMass;
  for (const skinning::LimbSegment& segment : segments) {
    const double own = density * segment.volume;
    const double area = segment.volume / segment.length;
    sum += segment.length * (mass + 0.5 * own) * earthGravity / area;
    length += segment.length;
    mass += own;
  }
  return sum / length;
}

double modulusOf(const WeightSettings& settings, const rig::Limb& limb,
                 std::vector<skinning::LimbSegment> segments, double bodyVolume) {
  if (settings.youngModulus) {
    return *settings.youngModulus;
  }
  if (!rig::isLeg(limb)) { // hangs: what is beyond a bone pulls at it
    std::reverse(segments.begin(), segments.end());
  }
  const double carried = rig::isLeg(limb) ? 0.5 * settings.density * bodyVolume : 0.0;
  constexpr double softest = 1.0;
  return std::max(softest, stillPressure(segments, settings.density, carried) / stillSag);
}

skinning::LimbElasticity physicsOf(const WeightSettings& settings, double youngModulus) {
  skinning::LimbElasticity physics;
  physics.youngModulus = youngModulus;
  physics.moduli.ranges = settings.moduli;
  physics.density = settings.density;
  physics.gravity = settings.gravity;
  physics.inertia = settings.inertia;
  physics.stiffness = settings.stiffness;
  physics.damping = settings.damping;
  physics.amount = settings.amount;
  return physics;
}

skinning::LimbMotion limbMotion(const SampledClip& sampled, const SampledClip::OfLimb& one,
                                const Standing& standing, double bodyMass, const LoopRoom& room) {
  skinning::LimbMotion motion;
  motion.framesPerSecond = sampled.samplesPerSecond;
  motion.joints = one.joints;
  wrapJoints(motion.joints, room);
  const std::size_t leg = standing.indexOf(one.limb.id);
  if (leg < standing.legs.size()) {
    motion.planted = standing.planted[leg];
    for (const double share : standing.shares[leg]) {
      motion.carriedMass.push_back(share * bodyMass);
    }
    wrapList(motion.planted, room);
    wrapList(motion.carriedMass, room);
  }
  return motion;
}

// A frame that is an end of the clip is at its time, however the file rounded that.
double secondsOfFrame(const Clip& clip, double frame) {
  for (const double end : {clip.startSeconds, clip.endSeconds}) {
    if (sameFrame(frame, end * clip.framesPerSecond)) {
      return end;
    }
  }
  return frame / clip.framesPerSecond;
}

void setRange(const Clip& clip, const WeightedLimb& entry, rig::LimbWeight& weight) {
  weight.startSeconds = 0.0;
  weight.endSeconds = clip.endSeconds;
  if (!entry.settings.rangeFrames) {
    return;
  }
  weight.startSeconds = std::clamp(secondsOfFrame(clip, entry.settings.rangeFrames->x), 0.0, clip.endSeconds);
  weight.endSeconds =
      std::clamp(secondsOfFrame(clip, entry.settings.rangeFrames->y), weight.startSeconds, clip.endSeconds);
  constexpr double longestFade = 0.2;
  const double fade = std::min(longestFade, (weight.endSeconds - weight.startSeconds) / 3.0);
  weight.fadeInSeconds = weight.startSeconds > clip.startSeconds ? fade : 0.0;
  weight.fadeOutSeconds = weight.endSeconds < clip.endSeconds ? fade : 0.0;
}

// Everything that the limbs of one clip share.
struct Shared {
  const WeightInput& weight;
  const SampledClip& sampled;
  Standing standing;
  LoopRoom room;
  double bodyVolume = 0.0;
};

void addLimb(const Shared& input, const WeightedLimb& entry, const SampledClip::OfLimb& one, LimbSizes& sizes,
             WeightMotion& motion) {
  const std::vector<skinning::LimbSegment> segments = segmentsOf(input.weight, one.limb, sizes);
  const WeightSettings& settings = entry.settings;
  WeightReport report;
  report.limb = entry.limb;
  report.youngModulus = modulusOf(settings, one.limb, segments, input.bodyVolume);
  for (const skinning::LimbSegment& segment : segments) {
    report.widths.push_back(segment.width);
    report.masses.push_back(settings.density * segment.volume);
  }
  rig::LimbWeight weight{entry.limb, {}, 0.0, 0.0, 0.0, 0.0};
  setRange(*input.weight.clip, entry, weight);
  if (input.sampled.seconds.back() + 1.0 < input.weight.clip->endSeconds) {
    weight.endSeconds = std::min(weight.endSeconds, input.sampled.seconds.back());
    report.warnings.push_back(entry.limb + ": gives way in the first " +
                              std::to_string(std::lround(weight.endSeconds)) +
                              " seconds only: the clip is longer than " + "is looked at");
  }
  constexpr double sameWay = 0.9999; // cosine
  const double size = glm::length(settings.gravity);
  if (size > 0.0 && -glm::dot(settings.gravity, upOf(input.weight)) < sameWay * size) {
    report.warnings.push_back(entry.limb + ": its gravity is not along that of the limbs before it, by which "
                                           "feet stand; give all of them one direction");
  }
  const skinning::LimbMotion physical =
      limbMotion(input.sampled, one, input.standing, settings.density * input.bodyVolume, input.room);
  const auto stretches =
      skinning::limbElasticity(segments, physical, physicsOf(settings, report.youngModulus));
  if (!stretches) {
    report.warnings.push_back(entry.limb + ": " + stretches.error().line());
    motion.reports.push_back(std::move(report));
    return;
  }
  const auto first = stretches->begin() + static_cast<std::ptrdiff_t>(input.room.before);
  const std::vector<std::vector<skinning::LimbStretch>> shown(
      first, first + static_cast<std::ptrdiff_t>(input.sampled.seconds.size()));
  std::vector<std::vector<Mat3>> strains = skinning::boneStrains(shown, one.toJoint);
  const std::size_t leg = input.standing.indexOf(one.limb.id);
  const bool isLeg = leg < input.standing.legs.size();
  ReportWriter writer(report, input.weight.clip->framesPerSecond);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const double seconds = input.sampled.seconds[k];
    weight.samples.push_back({seconds, std::move(strains[k]), isLeg ? input.standing.planted[leg][k] : 0.0,
                              isLeg ? input.standing.kept[leg][k] : 0.0});
    if (seconds >= weight.startSeconds - 1e-6 && seconds <= weight.endSeconds + 1e-6) {
      writer.add(seconds, shown[k]);
    }
  }
  writer.finish();
  motion.weights.push_back(std::move(weight));
  motion.reports.push_back(std::move(report));
}

bool hasWeight(const std::vector<rig::LimbWeight>& weights, const std::string& limb) {
  return std::ranges::any_of(weights, [&](const rig::LimbWeight& one) { return one.limb == limb; });
}

// Legs without weight of their own do not give way, but know where their feet touch the ground while the
// other one moves the hips.
void addStiffLegs(const Shared& input, std::vector<rig::LimbWeight>& weights) {
  const std::vector<rig::LimbWeight> given = weights;
  const auto isGivenLeg = [&](const rig::LimbWeight& one) {
    return input.standing.indexOf(one.limb) < input.standing.legs.size();
  };
  const auto first = std::find_if(given.begin(), given.end(), isGivenLeg);
  for (std::size_t leg = 0; leg < input.standing.legs.size() && first != given.end(); ++leg) {
    const std::string& id = input.standing.legs[leg];
    if (hasWeight(given, id)) {
      continue;
    }
    rig::LimbWeight stiff{id, {}, first->startSeconds, first->endSeconds, 0.0, 0.0};
    const std::vector<Mat3> still(limbIn(input.sampled, id)->limb.joints.size(), Mat3(0.0));
    for (std::size_t k = 0; k < input.sampled.seconds.size(); ++k) {
      stiff.samples.push_back({input.sampled.seconds[k], still, 0.0, input.standing.kept[leg][k]});
    }
    weights.push_back(std::move(stiff));
  }
}

} // namespace

const LimbSize& LimbSizes::of(const WeightInput& input, const rig::Limb& limb) {
  if (scene_ != input.scene || limbs_ != input.limbs) {
    scene_ = input.scene;
    limbs_ = input.limbs;
    sizes_.clear();
  }
  if (const auto found = sizes_.find(limb.id); found != sizes_.end()) {
    return found->second;
  }
  std::vector<rig::Limb> ofBody = input.limbs; // a chain is part of them, not beside them
  std::erase_if(ofBody, [](const rig::Limb& other) { return other.kind == rig::LimbKind::chain; });
  return sizes_.emplace(limb.id, limbSize(*input.scene, limb, ofBody)).first->second;
}

WeightMotion weightMotion(const WeightInput& input, const SampledClip& sampled, LimbSizes& sizes) {
  const Shared shared{input, sampled, standingOf(sampled, input.metresPerUnit()),
                      loopRoom(input.loops, sampled.seconds.size(), sampled.samplesPerSecond),
                      volumeAboveLegs(input, sizes)};
  WeightMotion motion;
  for (const std::size_t i : activeWeights(input)) {
    const WeightedLimb& entry = input.weights[i];
    if (const SampledClip::OfLimb* const one = limbIn(sampled, entry.limb)) {
      addLimb(shared, entry, *one, sizes, motion);
    }
  }
  addStiffLegs(shared, motion.weights);
  return motion;
}

Vec3 upOf(const WeightInput& input) {
  for (const std::size_t i : activeWeights(input)) {
    const Vec3& gravity = input.weights[i].settings.gravity;
    if (const double size = glm::length(gravity); size > 0.0 && std::isfinite(size)) {
      return -gravity / size;
    }
  }
  return {0.0, 1.0, 0.0};
}

std::vector<std::size_t> activeWeights(const WeightInput& input) {
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < input.weights.size(); ++i) {
    const WeightedLimb& entry = input.weights[i];
    const bool isThere =
        std::ranges::any_of(input.limbs, [&](const rig::Limb& limb) { return limb.id == entry.limb; });
    if (entry.on && isThere) {
      active.push_back(i);
    }
  }
  return active;
}

} // namespace stretch::app
