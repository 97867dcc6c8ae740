#include "app/edits/trail/mirror_edits.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/frames.h"
#include "core/anim/sampling.h"

namespace stretch::app {

namespace {

/// Rest positions of the bases of the first pair of limbs that was found, left then right.
std::optional<std::pair<Vec3, Vec3>> pairBases(const Document& document, const std::vector<Mat4>& worlds) {
  const std::vector<rig::Limb>& limbs = document.body.limbs;
  for (const rig::Limb& left : limbs) {
    const rig::Limb* const right = left.side == rig::LimbSide::left ? limbAt(limbs, mirrored(left)) : nullptr;
    if (right != nullptr && !left.joints.empty()) {
      return std::pair(positionOf(worlds[at(left.joints.front())]),
                       positionOf(worlds[at(right->joints.front())]));
    }
  }
  return std::nullopt;
}

Vec3 levelUnit(const Vec3& vector) {
  const Vec3 level(vector.x, 0.0, vector.z);
  const double length = glm::length(level);
  return length > 1e-9 ? level / length : Vec3(1.0, 0.0, 0.0);
}

std::vector<Mat4> worldsAt(const Document& document, int clip, double frame) {
  const Clip& motion = clipOf(document, clip);
  return worldMatrices(*document.scene, samplePose(*document.scene, motion, frame / motion.framesPerSecond));
}

/// A point of the sagittal plane: the hips, else the origin.
Vec3 sagittalPoint(const Document& document, int clip, double frame) {
  const NodeIndex hips = document.body.hips;
  return hips.exists() ? positionOf(worldsAt(document, clip, frame)[at(hips)]) : Vec3(0.0);
}

} // namespace

Vec3 reflected(const Vec3& vector, const Vec3& normal) {
  return vector - 2.0 * glm::dot(vector, normal) * normal;
}

Result<std::string> otherSide(const Document& document, const std::string& limbId) {
  const rig::Limb* limb = findLimb(document, limbId);
  if (limb == nullptr) {
    return Error{"the character has no such limb", limbId, "pick a limb that was found"};
  }
  if (limb->side == rig::LimbSide::middle) {
    return Error{"this limb has no other side", limbId, "mirror an arm or a leg"};
  }
  const rig::Limb* const other = limbAt(document.body.limbs, mirrored(*limb));
  if (other == nullptr) {
    return Error{"the limb on the other side was not found", limbId, "correct the limbs by hand"};
  }
  return other->id;
}

std::optional<SagittalPlane> sagittalPlaneOf(const Document& document, const std::vector<Mat4>& worlds) {
  const auto bases = pairBases(document, worlds);
  return bases ? std::optional(SagittalPlane{0.5 * (bases->first + bases->second),
                                             levelUnit(bases->first - bases->second)})
               : std::nullopt;
}

Vec3 sagittalNormal(const Document& document, int clip, double frame) {
  const std::vector<Mat4> rest = worldMatrices(*document.scene, restPose(*document.scene));
  const auto bases = pairBases(document, rest);
  if (!bases) {
    return {1.0, 0.0, 0.0};
  }
  const Vec3 restNormal = bases->first - bases->second;
  const NodeIndex hips = document.body.hips;
  if (!hips.exists()) {
    return levelUnit(restNormal);
  }
  const auto index = at(hips);
  const Quat turn =
      rotationOf(worldsAt(document, clip, frame)[index]) * glm::conjugate(rotationOf(rest[index]));
  return levelUnit(turn * restNormal);
}

Vec3 headingNormal(const Document& document, int clip, double frame) {
  constexpr int samples = 64;
  constexpr double leastAgreement = 0.8; // length of the mean of unit normals
  const double last = lastFrame(clipOf(document, clip));
  Vec3 sum(0.0);
  for (int i = 0; i < samples; ++i) {
    sum += sagittalNormal(document, clip, last * i / (samples - 1));
  }
  const bool keepsItsWay = glm::length(sum) > leastAgreement * samples;
  return keepsItsWay ? levelUnit(sum) : sagittalNormal(document, clip, frame);
}

rig::TrailSettings mirroredSettings(const rig::TrailSettings& settings, const Vec3& normal,
                                    const Vec3& planePoint) {
  rig::TrailSettings mirrored = settings;
  const bool inView = settings.space == rig::TrailSpace::view;
  // The reflection of the view's axes is left-handed; turning its first axis round makes it an orientation
  // again.
  mirrored.viewAxes = Mat3(-reflected(settings.viewAxes[0], normal), reflected(settings.viewAxes[1], normal),
                           reflected(settings.viewAxes[2], normal));
  const auto mirror = [&](const Vec3& v) { return inView ? Vec3(-v.x, v.y, v.z) : reflected(v, normal); };
  for (rig::SphereOffset& sphere : mirrored.spheres) {
    sphere.offset = mirror(sphere.offset);
    sphere.tangent = sphere.tangent ? std::optional(mirror(*sphere.tangent)) : std::nullopt;
  }
  if (mirrored.stopAt) {
    mirrored.stopAt->point = planePoint + reflected(mirrored.stopAt->point - planePoint, normal);
    mirrored.stopAt->normal = reflected(mirrored.stopAt->normal, normal);
  }
  return mirrored;
}

Result<CreatedTrail> mirrorTrail(const Document& document, const rig::Trail& trail) {
  const Result<std::string> limb = otherSide(document, trail.limb);
  if (!limb) {
    return limb.error();
  }
  const double frame = trail.settings.startFrame;
  rig::Trail mirrored = trail;
  mirrored.settings = mirroredSettings(trail.settings, sagittalNormal(document, trail.clip, frame),
                                       sagittalPoint(document, trail.clip, frame));
  return pasteTrail(document, mirrored, *limb, trail.clip);
}

} // namespace stretch::app
