#include "app/evaluate/clip_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/anim/frames.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/limb.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

FrameState bindPoseOf(const Scene& scene) {
  FrameState bind;
  bind.worlds = rig::bindPoseWorlds(scene);
  return bind;
}

// All of the body's joints at frames of the clip and at rest.
double lowestPlaceOf(const Document& document, int clip) {
  constexpr double mostFrames = 240.0;
  const Scene& scene = *document.scene;
  const std::vector<rig::Limb> limbs = allLimbs(document);
  std::vector<NodeIndex> joints;
  if (document.body.hips.exists()) {
    joints.push_back(document.body.hips);
  }
  for (const rig::Limb& limb : limbs) {
    joints.insert(joints.end(), limb.joints.begin(), limb.joints.end());
  }
  const std::vector<NodeIndex> body = withSubtrees(scene, joints);
  double lowest = std::numeric_limits<double>::infinity();
  const auto lookAt = [&](const FrameState& frame) {
    for (const NodeIndex node : body) {
      lowest = std::min(lowest, positionOf(frame.worlds[at(node)]).y);
    }
    for (const rig::Limb& limb : limbs) {
      lowest = std::min(lowest, rig::endPosition(limb, frame).y);
    }
  };
  lookAt(frameOf(scene, restPose(scene), 0.0));
  const Clip& motion = clipOf(document, clip);
  const double last = endInFrames(motion);
  const double step = std::max(1.0, last / mostFrames);
  for (double frame = 0.0; frame <= last; frame += step) {
    lookAt(rig::sampledFrame(scene, motion, frame / motion.framesPerSecond));
  }
  return lowest;
}

} // namespace

BoundSurface::BoundSurface(const Scene& scene, const std::vector<bool>& follows, double height)
    : part(scene, follows), edges(part, bindPoseOf(scene), visibleLength * height) {}

CharacterFacts::CharacterFacts(const Document& document)
    : scene_(document.scene), height_(document.body.height),
      places_(std::make_shared<const rig::BindPlaces>(rig::bindPlaces(*scene_))) {}

const skinning::SurfacePart& CharacterFacts::whole() {
  if (!whole_) {
    whole_ = skinning::SurfacePart::whole(*scene_);
  }
  return *whole_;
}

std::shared_ptr<const BoundSurface> CharacterFacts::surfaceOf(const std::vector<bool>& follows) {
  std::shared_ptr<const BoundSurface>& surface = surfaces_[follows];
  if (surface == nullptr) {
    surface = std::make_shared<const BoundSurface>(*scene_, follows, height_);
  }
  return surface;
}

ClipFacts::ClipFacts(const Document& document, int clip, std::shared_ptr<CharacterFacts> character)
    : document_(document), clip_(clip),
      character_(character != nullptr ? std::move(character) : std::make_shared<CharacterFacts>(document)) {}

const StandingFloor& ClipFacts::standing() {
  if (!standing_) {
    standing_ = standingFloor(document_, clip_, *places());
  }
  return *standing_;
}

std::optional<double> ClipFacts::lowestPlace() {
  if (!lowestPlace_) {
    const double lowest = lowestPlaceOf(document_, clip_);
    lowestPlace_ = std::isfinite(lowest) ? std::optional(lowest) : std::nullopt;
  }
  return *lowestPlace_;
}

double ClipFacts::groundOver(double lowestVertex) {
  const std::optional<double> floor = standing().floor;
  return floor ? std::max(*floor, lowestVertex)
               : std::min(lowestPlace().value_or(lowestVertex), lowestVertex);
}

double ClipFacts::ground() {
  return groundOver(lowestVertex());
}

double ClipFacts::lowestVertexIn(const FrameState& frame, double before) {
  const skinning::SurfacePart& whole = character_->whole();
  const std::optional<Vec3> lowest = whole.lowest(whole.posed(frame), before);
  return lowest ? lowest->y : before;
}

// The lowest vertex of the clip is no higher than that.
double ClipFacts::lowestVertexAtFirst() {
  if (!lowestAtFirst_) {
    lowestAtFirst_ = lowestVertexIn(rig::sampledFrame(*document_.scene, clipOf(document_, clip_), 0.0),
                                    std::numeric_limits<double>::infinity());
  }
  return *lowestAtFirst_;
}

double ClipFacts::lowestVertex() {
  constexpr double mostFrames = 48.0;
  if (!lowestVertex_) {
    const Scene& scene = *document_.scene;
    const Clip& clip = clipOf(document_, clip_);
    double lowest = lowestVertexAtFirst();
    const double step = std::max(1.0, endInFrames(clip) / mostFrames);
    for (double frame = step; frame <= endInFrames(clip); frame += step) {
      lowest = lowestVertexIn(rig::sampledFrame(scene, clip, frame / clip.framesPerSecond), lowest);
    }
    // At rest, not as it is bound: what rests in a frame of a clip is bound wherever its legs are straight.
    lowestVertex_ = standing().floor ? lowest : lowestVertexIn(frameOf(scene, restPose(scene), 0.0), lowest);
  }
  return *lowestVertex_;
}

} // namespace stretch::app
