#include "app/auto/remedies.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"

namespace stretch::app {

namespace {

constexpr double calmRelease = 3.0; // frames, at least

// Whether the foot of a loop is put down again before a frame past its seam.
bool standsBefore(const ClipGround& ground, const std::string& limb, double frame) {
  return std::ranges::any_of(ground.standsOf(limb),
                             [&](const Vec2& stand) { return ground.aTurnLater(stand.x) < frame; });
}

// Keeps still what the trail adds from a frame before the seam to a frame after it, where it can: a loop then
// closes as it did. False where nothing is left to do, or the foot stands by then.
bool calmAtSeam(const ClipGround& ground, const std::string& limb, rig::TrailSettings& settings) {
  const Clip& clip = clipOf(ground.document, ground.clip);
  const double end = endInFrames(clip);
  const rig::TrailSettings before = settings;
  const double range = settings.endFrame - settings.startFrame;
  const double first = wholeFrameAtLeast(std::max(0.0, clip.startSeconds * clip.framesPerSecond)) + 1.0;
  if (settings.startFrame < first && settings.endFrame - first >= shortestRange) {
    settings.startFrame = first;
  }
  const double release = settings.releaseFrames.value_or(0.5 * range);
  const double wayEnd = settings.endFrame + release;
  const double room = ground.lastFrame - 1.0 - settings.endFrame;
  if (room >= calmRelease && wayEnd > ground.lastFrame - 1.0) {
    settings.releaseFrames = room;
    settings.lingerFrames = std::clamp(settings.lingerFrames, 0.0, room - calmRelease);
  } else if (wayEnd > ground.lastFrame - 1.0 && ground.wraps &&
             !standsBefore(ground, limb, end + 1.0 + calmRelease)) {
    settings.endFrame = std::min(settings.endFrame, ground.lastFrame - 1.0);
    settings.lingerFrames = end + 1.0 - settings.endFrame;
    settings.releaseFrames = std::max(wayEnd - settings.endFrame, settings.lingerFrames + calmRelease);
  }
  return !(settings == before);
}

// Takes the trail back before the seam; false where its limb would hardly have started by then, or a step
// would be over so much earlier than that of the other side that it limps.
bool endBeforeSeam(const ClipGround& ground, const rig::Limb& limb, rig::TrailSettings& settings) {
  constexpr double seconds = 0.1; // hardly seen as a jump, and leaves most of a stride
  const double back = std::max(calmRelease, std::round(seconds * ground.framesPerSecond));
  const double end = ground.lastFrame - 1.0 - back;
  const double range = settings.endFrame - settings.startFrame;
  const double most = isLeg(limb) ? ground.framesPerSecond / 12.0 : range;
  if (settings.endFrame <= end || settings.endFrame - end > most ||
      end - settings.startFrame < std::max(shortestRange, 0.5 * range)) {
    return false;
  }
  settings.endFrame = end;
  settings.lingerFrames = 0.0;
  settings.releaseFrames = back;
  return true;
}

// The world's axis that lies along the line between the bases of a limb and of that on the other side; none
// for what follows or has no other side.
std::optional<std::size_t> axisAcross(const ClipGround& ground, const PlannedTrail& planned) {
  const rig::Limb& limb = *findLimb(ground.document, planned.trail.limb);
  const rig::Limb* const other = rig::limbAt(ground.limbs, rig::mirrored(limb));
  if (planned.follows || limb.side == rig::LimbSide::middle || other == nullptr) {
    return std::nullopt;
  }
  const double tip = planned.trail.settings.endFrame;
  const Vec3 across =
      glm::abs(ground.pointsOf(limb.id, tip).front() - ground.pointsOf(other->id, tip).front());
  return across.x >= std::max(across.y, across.z) ? 0 : across.y >= across.z ? 1 : 2;
}

// A foot along the ground that goes a little below it, as its toes do on the way, is lifted by as much; false
// where it would hang in the air.
bool liftFoot(const ClipGround& ground, PlannedTrail& planned, double depth) {
  constexpr double most = 0.03; // of the height
  constexpr double spare = 1.1;
  const std::vector<rig::SphereOffset>& spheres = planned.trail.settings.spheres;
  const double lift = spare * depth + (spheres.empty() ? 0.0 : spheres.back().offset.y);
  if (planned.follows || planned.trail.settings.axes[1] || depth <= 0.0 ||
      lift > most * ground.document.body.height || !isLeg(*findLimb(ground.document, planned.trail.limb))) {
    return false;
  }
  pullAlong(planned, {0.0, lift, 0.0});
  return true;
}

// A foot that is lifted while it still counts as standing starts when that is over; false where that is so,
// or too little of its way would be left.
bool startAfterStand(const ClipGround& ground, PlannedTrail& planned) {
  rig::TrailSettings& settings = planned.trail.settings;
  for (const Vec2& stand : ground.standsOf(planned.trail.limb)) {
    if (stand.x <= settings.startFrame && settings.startFrame < stand.y &&
        settings.endFrame - stand.y >= shortestRange) {
      settings.startFrame = stand.y;
      return true;
    }
  }
  return false;
}

} // namespace

double excessOf(const ClipGround& ground, const PlannedTrail& planned) {
  const rig::TrailSettings& settings = planned.trail.settings;
  const bool isPulled = planned.follows && !settings.spheres.empty(); // else a foot is lifted
  const double pulled = isPulled ? glm::length(settings.spheres.back().offset) : 0.0;
  return std::abs(settings.scale - 1.0) + pulled / findLimb(ground.document, planned.trail.limb)->restLength;
}

bool letGo(const ClipGround& ground, rig::TrailSettings& settings) {
  if (settings.lingerFrames <= 0.0 || settings.endFrame + settings.lingerFrames > ground.lastFrame) {
    return false;
  }
  *settings.releaseFrames -= settings.lingerFrames;
  settings.lingerFrames = 0.0;
  return true;
}

void lower(const ClipGround& ground, AutoPlan& plan, const Fault& fault) {
  const std::string why = textOf(fault.kind);
  PlannedTrail& planned = plan.trails[fault.trail];
  rig::TrailSettings& settings = planned.trail.settings;
  if (letGo(ground, settings)) {
    return;
  }
  if ((fault.kind == FaultKind::floor || fault.kind == FaultKind::lifted) && settings.axes == allAxes) {
    settings.axes = levelAxes;
    return;
  }
  if (fault.kind == FaultKind::floor && liftFoot(ground, planned, fault.depth)) {
    return;
  }
  const std::optional<std::size_t> across =
      fault.kind == FaultKind::sides ? axisAcross(ground, planned) : std::nullopt;
  if (across && settings.axes == allAxes) {
    settings.axes.at(*across) = false;
    return;
  }
  if (fault.kind == FaultKind::stand && startAfterStand(ground, planned)) {
    return;
  }
  if (fault.kind == FaultKind::seam && calmAtSeam(ground, planned.trail.limb, settings)) {
    return;
  }
  if (fault.kind == FaultKind::seam && settings.bend != rig::Bend::keep) {
    settings.bend = rig::Bend::keep; // a limb that is nearly straight makes much of a small step at the seam
    return;
  }
  if (fault.kind == FaultKind::seam &&
      endBeforeSeam(ground, *findLimb(ground.document, planned.trail.limb), settings)) {
    return;
  }
  settings = withShare(settings, lowered);
  planned.why = planned.why.empty() ? why : planned.why;
  if (excessOf(ground, planned) < leastExcess) {
    leaveOut(plan, fault.trail, why);
  }
}

} // namespace stretch::app
