#include "app/evaluate/seen.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/evaluation_input.h"
#include "core/math/polyline.h"
#include "core/math/rotation.h"
#include "rig/motion/best_view.h"
#include "rig/motion/paths.h"
#include "rig/motion/trail_camera.h"
#include "rig/reach/limb_reach.h"

namespace stretch::app {

namespace {

constexpr double degrees = 180.0 / pi;

struct Extreme {
  FrameState before;
  FrameState after;
};

Extreme extremeOf(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail) {
  return {evaluateOriginal(document, motion.clip, trail.tipSeconds),
          evaluate(document, motion, trail.tipSeconds)};
}

// Over the range, four times a frame.
rig::DrawnTrail pathsOf(const Document& document, const rig::MotionState& motion,
                        const rig::SolvedTrail& trail) {
  const double length = trail.settings.endFrame - trail.settings.startFrame;
  const double steps = std::clamp(std::ceil(4.0 * length), 1.0, 1000.0);
  std::vector<double> frames;
  for (double i = 0.0; i <= steps; i += 1.0) {
    frames.push_back(trail.settings.startFrame + length * i / steps);
  }
  const std::size_t place = rig::placeOfTrail(motion, trail.trail.id).value_or(0);
  return rig::pathsAt(*document.scene, clipOrStill(*document.clips, motion.clip), motion, place, frames);
}

double seenLength(const CameraPlace& camera, const std::vector<Vec3>& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += rig::seenLength(camera, path[i - 1], path[i]).value_or(0.0);
  }
  return length;
}

// Of the way that the limb's end is carried, seen from its base: what is left of it in the picture.
double carriedShare(const CameraPlace& camera, const rig::Limb& limb, const Extreme& at) {
  const Vec3 before = reachOf(limb, at.before);
  const Vec3 carried = reachOf(limb, at.after) - before;
  const double whole = glm::length(carried);
  const Vec3 eye = towardsEye(camera, rig::leadingPosition(limb, at.before));
  return whole > 1e-3 * glm::length(before) ? glm::length(carried - eye * glm::dot(eye, carried)) / whole
                                            : 1.0;
}

std::optional<Seen> seenAt(const CameraPlace& camera, const rig::SolvedTrail& trail, const Extreme& at) {
  const rig::Limb& limb = trail.limb;
  const auto before =
      rig::seenLength(camera, rig::stayingPosition(limb, at.before), rig::leadingPosition(limb, at.before));
  const auto after =
      rig::seenLength(camera, rig::stayingPosition(limb, at.after), rig::leadingPosition(limb, at.after));
  const double length = glm::length(reachOf(limb, at.before));
  if (!before || !after || !(*before > 0.0) || !(length > 0.0)) {
    return std::nullopt;
  }
  const double scale = glm::length(reachOf(limb, at.after)) / length;
  Seen seen;
  seen.ratio = *after / *before;
  const double asked = trail.settings.scale *
                       (trail.settings.reference == rig::Reference::rest ? limb.restLength / length : 1.0);
  seen.of = trail.settings.sight.asSeen ? asked : scale;
  constexpr double lengthened = 0.05; // less is no exaggeration of the length
  const double share = std::abs(scale - 1.0) > lengthened ? (seen.ratio - 1.0) / (scale - 1.0) : 1.0;
  seen.share = std::clamp(std::min(share, carriedShare(camera, limb, at)), 0.0, 1.0);
  return seen;
}

// Where the face looks: as in the bind pose, turned with the head.
std::optional<Vec3> faceOf(const Document& document, const FrameState& frame) {
  const NodeIndex head = document.body.head;
  if (!head.exists()) {
    return std::nullopt;
  }
  const rig::BindPlaces places = rig::bindPlaces(*document.scene);
  return rotationOf(frame.worlds[at(head)]) * glm::conjugate(rotationOf(places.worlds[at(head)])) *
         rig::facingInBind(document.body.limbs, places);
}

// The file's camera that sees most of a trail's exaggeration, if that is worth naming.
const SceneCamera* betterCamera(const Document& document, const rig::SolvedTrail& trail, const Extreme& at) {
  const SceneCamera* best = nullptr;
  double most = smallestSeenShare;
  for (const SceneCamera& camera : document.scene->cameras) {
    if (camera.name == trail.settings.sight.camera) {
      continue;
    }
    const std::optional<CameraPlace> place = cameraIn(camera, at.after);
    const std::optional<Seen> seen = place ? seenAt(*place, trail, at) : std::nullopt;
    if (seen && seen->share > most) {
      most = seen->share;
      best = &camera;
    }
  }
  return best;
}

std::string betterView(const Document& document, const rig::MotionState& motion,
                       const rig::SolvedTrail& trail, const Extreme& at) {
  const Vec3 eye = bestViewOf(document, motion, trail);
  const std::optional<Seen> seen = seenAt(cameraFrom(eye), trail, at);
  std::string view = "look " + viewInWords(document, motion.clip, eye);
  view += seen ? fmt::format(", where x{:.3g} is seen", seen->ratio) : "";
  const SceneCamera* const camera = betterCamera(document, trail, at);
  return camera != nullptr ? view + ", or through '" + camera->name + "'" : view;
}

// Whether all of a limb is in the part of the picture that every screen shows.
bool isInSafeFrame(const SceneCamera& camera, const CameraPlace& place, const rig::Limb& limb,
                   const FrameState& frame) {
  const bool isPerspective = camera.kind == CameraKind::perspective;
  const double halfHeight = isPerspective ? std::tan(0.5 * camera.fieldOfViewRadians) : camera.halfHeight;
  const double halfWidth = halfHeight * camera.aspect.value_or(16.0 / 9.0);
  return std::ranges::all_of(rig::limbPoints(limb, frame), [&](const Vec3& point) {
    const std::optional<Vec2> inside = inPicture(place, point);
    return inside && std::abs(inside->x) <= safeFrame * halfWidth &&
           std::abs(inside->y) <= safeFrame * halfHeight;
  });
}

bool leavesSafeFrame(const Document& document, const rig::SolvedTrail& trail, const Extreme& at) {
  const SceneCamera* const camera = cameraNamed(*document.scene, trail.settings.sight.camera);
  const std::optional<CameraPlace> place = camera != nullptr ? cameraIn(*camera, at.after) : std::nullopt;
  return place && isInSafeFrame(*camera, *place, trail.limb, at.before) &&
         !isInSafeFrame(*camera, *place, trail.limb, at.after);
}

} // namespace

Vec3 reachOf(const rig::Limb& limb, const FrameState& frame) {
  return rig::leadingPosition(limb, frame) - rig::stayingPosition(limb, frame);
}

std::optional<Seen> seenBy(const Document& document, const rig::MotionState& motion,
                           const rig::SolvedTrail& trail, const CameraPlace& camera) {
  return seenAt(camera, trail, extremeOf(document, motion, trail));
}

double seenPath(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail,
                const CameraPlace& camera) {
  const rig::DrawnTrail paths = pathsOf(document, motion, trail);
  const double before = seenLength(camera, paths.original);
  return before > 0.0 ? seenLength(camera, paths.exaggerated) / before : 1.0;
}

Vec3 bestViewOf(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& trail) {
  constexpr double trunk = 0.08; // thickness, of the height
  const FrameState frame = evaluate(document, motion, trail.tipSeconds);
  rig::SightedAction action;
  action.path = pathsOf(document, motion, trail).exaggerated;
  action.base = rig::stayingPosition(trail.limb, frame);
  action.tip = rig::leadingPosition(trail.limb, frame);
  action.facing = faceOf(document, frame);
  if (document.body.hips.exists() && document.body.head.exists()) {
    action.trunkLow = positionOf(frame.worlds[at(document.body.hips)]);
    action.trunkHigh = positionOf(frame.worlds[at(document.body.head)]);
    action.trunkRadius = trunk * document.body.height;
  }
  return rig::bestView(action);
}

std::string viewInWords(const Document& document, int clip, const Vec3& towardsEye) {
  const Vec3 facing =
      rig::facingInClip(*document.scene, clipOrStill(*document.clips, clip), document.body.hips,
                        document.body.limbs, rig::bindPlaces(*document.scene));
  const Vec3 left = glm::cross(Vec3(0.0, 1.0, 0.0), facing);
  const double yaw =
      std::round(std::atan2(glm::dot(left, towardsEye), glm::dot(facing, towardsEye)) * degrees);
  const double pitch = std::round(std::asin(std::clamp(towardsEye.y, -1.0, 1.0)) * degrees);
  std::string words =
      yaw == 0.0 ? "from the front"
                 : fmt::format("from {:g} degrees to its {}", std::abs(yaw), yaw > 0.0 ? "left" : "right");
  if (pitch != 0.0) {
    words += fmt::format(", {:g} degrees {}", std::abs(pitch), pitch > 0.0 ? "above" : "below");
  }
  return words;
}

std::optional<CameraPlace> cameraIn(const SceneCamera& camera, const FrameState& frame) {
  return cameraPlace(camera.kind, frame.worlds[at(camera.node)]);
}

std::vector<std::string> seenWarnings(const Document& document, const rig::MotionState& motion,
                                      const rig::SolvedTrail& trail) {
  std::vector<std::string> warnings;
  if (!trail.camera || !trail.active || trail.tip.outcome == rig::TipOutcome::nothingToScale) {
    return warnings;
  }
  const Extreme at = extremeOf(document, motion, trail);
  const std::optional<Seen> seen = seenAt(*trail.camera, trail, at);
  const bool asSeen = trail.settings.sight.asSeen;
  if (!seen || (asSeen && !trail.tip.reached())) {
    warnings.push_back("little of it is seen: " + betterView(document, motion, trail, at));
  } else if (seen->share < smallestSeenShare) {
    warnings.push_back(fmt::format(
        "the exaggeration points along the view, {:.0f} % of it is seen (x{:.3g} of "
        "x{:.3g}): {}{}",
        100.0 * seen->share, seen->ratio, seen->of, asSeen ? "" : "turn on Scale as seen (--as-seen), or ",
        betterView(document, motion, trail, at)));
  }
  if (leavesSafeFrame(document, trail, at)) {
    warnings.push_back("the limb leaves the safe frame of '" + trail.settings.sight.camera +
                       "': make it shorter, or move the camera back");
  }
  return warnings;
}

} // namespace stretch::app
