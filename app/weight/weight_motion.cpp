#include "app/weight/weight_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/evaluate/bone_strains.h"
#include "app/evaluate/evaluate.h"
#include "app/weight/standing.h"
#include "skinning/elastic/limb_elasticity.h"

namespace stretch::app {

namespace {

constexpr double earthGravity = 9.81;

double metresPerUnit(const Document& document) {
  return characterHeightMetres / document.biped.height;
}

const SampledClip::OfLimb* limbIn(const SampledClip& sampled, const std::string& id) {
  const auto found = std::find_if(sampled.limbs.begin(), sampled.limbs.end(),
                                  [&](const SampledClip::OfLimb& one) { return one.limb.id == id; });
  return found == sampled.limbs.end() ? nullptr : &*found;
}

std::vector<const WeightedLimb*> activeIn(const Document& document, int clip) {
  std::vector<const WeightedLimb*> active;
  for (const WeightedLimb& entry : document.weights) {
    if (entry.on && entry.clip == clip && findLimb(document, entry.limb) != nullptr) {
      active.push_back(&entry);
    }
  }
  return active;
}

// Cylinders of the bones, metres.
std::vector<skinning::LimbSegment> segmentsOf(const Document& document, const rig::Limb& limb,
                                              LimbSizes& sizes) {
  LimbSize size = sizes.of(document, limb);
  const double metres = metresPerUnit(document);
  for (std::vector<double>* const list : {&size.lengths, &size.widths}) {
    for (double& value : *list) {
      value *= metres;
    }
  }
  return skinning::limbSegments(size.lengths, size.widths);
}

double volumeOf(const std::vector<skinning::LimbSegment>& segments) {
  return std::accumulate(segments.begin(), segments.end(), 0.0,
                         [](double sum, const skinning::LimbSegment& s) { return sum + s.volume; });
}

// Of the body above the legs: a character of 1.75 m has the volume of a person of 70 kg.
double volumeAboveLegs(const Document& document, LimbSizes& sizes) {
  constexpr double bodyVolume = 0.07; // m^3
  constexpr double leastShare = 0.3;
  double legs = 0.0;
  for (const rig::Limb& limb : document.biped.limbs) {
    legs += rig::isLeg(limb) ? volumeOf(segmentsOf(document, limb, sizes)) : 0.0;
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

// A loop comes from its own end and goes on with its own beginning, wherever it got to meanwhile.
struct LoopRoom {
  std::size_t before = 0;
  std::size_t after = 0;
};

LoopRoom loopRoom(const Document& document, const SampledClip& sampled, int clip) {
  const bool loops = std::find(document.loopingClips.begin(), document.loopingClips.end(), clip) !=
                     document.loopingClips.end();
  const std::size_t period = sampled.seconds.size() - 1;
  constexpr std::size_t smoothed = 6;
  return loops && period > 1 ? LoopRoom{period, std::min(smoothed, period)} : LoopRoom{};
}

template <typename T>
void wrapList(std::vector<T>& list, const LoopRoom& room) {
  if (room.before == 0) {
    return;
  }
  const std::size_t period = list.size() - 1;
  std::vector<T> wrapped;
  for (std::size_t k = 0; k <= 2 * period + room.after; ++k) {
    wrapped.push_back(list[k < period ? k : (k <= 2 * period ? k - period : k - 2 * period)]);
  }
  list = std::move(wrapped);
}

void wrapJoints(std::vector<std::vector<Vec3>>& joints, const LoopRoom& room) {
  if (room.before == 0) {
    return;
  }
  const Vec3 travel = joints.back().front() - joints.front().front();
  const std::size_t period = room.before;
  wrapList(joints, room);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const double turn = k < period ? -1.0 : (k > 2 * period ? 1.0 : 0.0);
    for (Vec3& joint : joints[k]) {
      joint += turn * travel;
    }
  }
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

void setRange(const Document& document, const WeightedLimb& entry, rig::LimbWeight& weight) {
  const Clip& clip = clipOf(document, entry.clip);
  const double first = std::min(0.0, clip.startSeconds);
  weight.startSeconds = first;
  weight.endSeconds = clip.endSeconds;
  if (!entry.settings.rangeFrames) {
    return;
  }
  weight.startSeconds =
      std::clamp(entry.settings.rangeFrames->x / clip.framesPerSecond, first, clip.endSeconds);
  weight.endSeconds =
      std::clamp(entry.settings.rangeFrames->y / clip.framesPerSecond, weight.startSeconds, clip.endSeconds);
  constexpr double longestFade = 0.2;
  const double fade = std::min(longestFade, (weight.endSeconds - weight.startSeconds) / 3.0);
  weight.fadeInSeconds = weight.startSeconds > std::max(first, clip.startSeconds) ? fade : 0.0;
  weight.fadeOutSeconds = weight.endSeconds < clip.endSeconds ? fade : 0.0;
}

// Notes the extremes and what the model was not made for.
class ReportWriter {
public:
  ReportWriter(WeightReport& report, const std::vector<skinning::LimbSegment>& segments,
               double framesPerSecond)
      : report_(report), segments_(segments), framesPerSecond_(framesPerSecond) {}

  void add(double seconds, const std::vector<skinning::LimbStretch>& bones) {
    const double frame = seconds * framesPerSecond_;
    double length = 0.0;
    double rest = 0.0;
    for (std::size_t i = 0; i < bones.size(); ++i) {
      length += bones[i].factors.along * segments_[i].length;
      rest += segments_[i].length;
      judge(frame, bones[i].factors);
    }
    const double ratio = length / rest;
    if (ratio < report_.shortest) {
      report_.shortest = ratio;
      report_.shortestFrame = frame;
    }
    if (ratio > report_.longest) {
      report_.longest = ratio;
      report_.longestFrame = frame;
    }
  }

  void finish() {
    if (flattest_ > skinning::largestSmallStrain) {
      report_.warnings.push_back(fmt::format(
          "{}: flattened by {:.3g} at frame {:.4g}{}; past {:g} the model no longer holds: make it stiffer",
          report_.limb, flattest_, flattestFrame_,
          flattest_ > skinning::largestCompression - 1e-6 ? ", which is the most allowed" : "",
          skinning::largestSmallStrain));
    }
    if (clampedFrame_ >= 0.0) {
      report_.warnings.push_back(
          fmt::format("{}: the stretch along a bone is held at {:g} from frame {:.4g} on: make it stiffer",
                      report_.limb, clampedAt_, clampedFrame_));
    }
  }

private:
  void judge(double frame, const skinning::StretchFactors& factors) {
    const double flattened = 1.0 - factors.withLoad * std::sqrt(factors.along);
    if (flattened > flattest_) {
      flattest_ = flattened;
      flattestFrame_ = frame;
    }
    if ((factors.along <= 0.5 || factors.along >= 2.0) && clampedFrame_ < 0.0) {
      clampedFrame_ = frame;
      clampedAt_ = factors.along;
    }
  }

  WeightReport& report_;
  const std::vector<skinning::LimbSegment>& segments_;
  double framesPerSecond_ = 30.0;
  double flattest_ = 0.0;
  double flattestFrame_ = 0.0;
  double clampedAt_ = 0.0;
  double clampedFrame_ = -1.0;
};

// Everything that the limbs of one clip share.
struct ElasticInput {
  const Document& document;
  const SampledClip& sampled;
  Standing standing;
  LoopRoom room;
  double bodyVolume = 0.0;
};

void addLimb(const ElasticInput& input, const WeightedLimb& entry, const SampledClip::OfLimb& one,
             LimbSizes& sizes, WeightMotion& motion) {
  const std::vector<skinning::LimbSegment> segments = segmentsOf(input.document, one.limb, sizes);
  const WeightSettings& settings = entry.settings;
  WeightReport report;
  report.limb = entry.limb;
  report.youngModulus = modulusOf(settings, one.limb, segments, input.bodyVolume);
  for (const skinning::LimbSegment& segment : segments) {
    report.widths.push_back(segment.width);
    report.masses.push_back(settings.density * segment.volume);
  }
  rig::LimbWeight weight{entry.limb, {}, 0.0, 0.0, 0.0, 0.0};
  setRange(input.document, entry, weight);
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
  std::vector<std::vector<Mat3>> strains = boneStrains(shown, one.toJoint);
  const std::size_t leg = input.standing.indexOf(one.limb.id);
  ReportWriter writer(report, segments, clipOf(input.document, entry.clip).framesPerSecond);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const double seconds = input.sampled.seconds[k];
    const double planted = leg < input.standing.legs.size() ? input.standing.planted[leg][k] : 0.0;
    weight.samples.push_back({seconds, std::move(strains[k]), planted});
    if (seconds >= weight.startSeconds - 1e-6 && seconds <= weight.endSeconds + 1e-6) {
      writer.add(seconds, shown[k]);
    }
  }
  writer.finish();
  motion.weights.push_back(std::move(weight));
  motion.reports.push_back(std::move(report));
}

} // namespace

const LimbSize& LimbSizes::of(const Document& document, const rig::Limb& limb) {
  if (scene_ != document.scene || limbs_ != document.biped.limbs) {
    scene_ = document.scene;
    limbs_ = document.biped.limbs;
    sizes_.clear();
  }
  const auto found = sizes_.find(limb.id);
  return found != sizes_.end()
             ? found->second
             : sizes_.emplace(limb.id, limbSize(*document.scene, limb, document.biped.limbs)).first->second;
}

WeightMotion weightMotion(const Document& document, const SampledClip& sampled, int clip, LimbSizes& sizes) {
  const ElasticInput input{document, sampled, standingOf(document, sampled),
                           loopRoom(document, sampled, clip), volumeAboveLegs(document, sizes)};
  WeightMotion motion;
  for (const WeightedLimb* const entry : activeIn(document, clip)) {
    if (const SampledClip::OfLimb* const one = limbIn(sampled, entry->limb)) {
      addLimb(input, *entry, *one, sizes, motion);
    }
  }
  return motion;
}

bool hasWeight(const Document& document, int clip) {
  return !activeIn(document, clip).empty();
}

const WeightedLimb* findWeight(const Document& document, const std::string& limb, int clip) {
  const auto found =
      std::find_if(document.weights.begin(), document.weights.end(),
                   [&](const WeightedLimb& entry) { return entry.limb == limb && entry.clip == clip; });
  return found == document.weights.end() ? nullptr : &*found;
}

} // namespace stretch::app
