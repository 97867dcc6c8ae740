#include "app/evaluate/clip_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

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

BoundSurface boundSurface(const Scene& scene, const std::vector<bool>& follows) {
  BoundSurface surface{skinning::SurfacePart(scene, follows)};
  std::vector<glm::vec3> places;
  surface.part.positions(bindPoseOf(scene), places);
  for (const skinning::SurfacePart::Edge& edge : surface.part.edges()) {
    surface.edgeLengths.push_back(std::sqrt(static_cast<double>(
        glm::dot(places[edge.moved] - places[edge.other], places[edge.moved] - places[edge.other]))));
  }
  return surface;
}

// All of the body's joints at frames of the clip and in the bind pose.
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
  lookAt(bindPoseOf(scene));
  const Clip& motion = clipOf(document, clip);
  const double last = endInFrames(motion);
  const double step = std::max(1.0, last / mostFrames);
  for (double frame = 0.0; frame <= last; frame += step) {
    lookAt(rig::sampledFrame(scene, motion, frame / motion.framesPerSecond));
  }
  return lowest;
}

} // namespace

ClipFacts::ClipFacts(const Document& document, int clip)
    : document_(document), clip_(clip),
      places_(std::make_shared<const rig::BindPlaces>(rig::bindPlaces(*document.scene))) {}

const StandingFloor& ClipFacts::standing() {
  if (!standing_) {
    standing_ = standingFloor(document_, clip_, *places_);
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

// The lowest vertex of the clip is no higher than that of its first frame.
bool ClipFacts::isBelowGround(double height, double margin) {
  return groundOver(lowestVertexAtFirst()) - height > margin && ground() - height > margin;
}

double ClipFacts::lowestVertexIn(const FrameState& frame) {
  if (!whole_) {
    const Scene& scene = *document_.scene;
    whole_.emplace(scene, std::vector<bool>(scene.nodes.size(), true), skinning::SurfaceEdges::none);
  }
  std::vector<glm::vec3> places;
  whole_->positions(frame, places);
  const auto lowest = std::ranges::min_element(places, {}, &glm::vec3::y);
  return lowest == places.end() ? std::numeric_limits<double>::infinity() : static_cast<double>(lowest->y);
}

double ClipFacts::lowestVertexAtFirst() {
  if (!lowestAtFirst_) {
    lowestAtFirst_ = lowestVertexIn(rig::sampledFrame(*document_.scene, clipOf(document_, clip_), 0.0));
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
      lowest = std::min(lowest, lowestVertexIn(rig::sampledFrame(scene, clip, frame / clip.framesPerSecond)));
    }
    lowestVertex_ = standing().floor ? lowest : std::min(lowest, lowestVertexIn(bindPoseOf(scene)));
  }
  return *lowestVertex_;
}

std::shared_ptr<const BoundSurface> ClipFacts::surfaceOf(const std::vector<bool>& follows) {
  std::shared_ptr<const BoundSurface>& surface = surfaces_[follows];
  if (surface == nullptr) {
    surface = std::make_shared<const BoundSurface>(boundSurface(*document_.scene, follows));
  }
  return surface;
}

} // namespace stretch::app
