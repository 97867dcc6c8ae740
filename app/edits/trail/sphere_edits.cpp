#include "app/edits/trail/sphere_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/trail_edits.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

using Spheres = std::vector<rig::SphereOffset>;

Spheres::iterator findSphere(Spheres& spheres, double frame) {
  return std::ranges::find_if(
      spheres, [&](const rig::SphereOffset& sphere) { return sameFrame(sphere.frame, frame); });
}

void dropUnmoved(Spheres& spheres) {
  std::erase_if(
      spheres, [](const rig::SphereOffset& sphere) { return sphere.offset == Vec3(0.0) && !sphere.tangent; });
}

bool namesOneOf(std::span<const double> frames, double frame) {
  return std::any_of(frames.begin(), frames.end(), [&](double other) { return sameFrame(other, frame); });
}

/// Adds to the sphere's offset, keeping the list ordered by frame.
void addOffset(Spheres& spheres, double frame, const Vec3& delta) {
  const auto found = findSphere(spheres, frame);
  if (found != spheres.end()) {
    found->offset += delta;
    return;
  }
  const auto after =
      std::ranges::find_if(spheres, [&](const rig::SphereOffset& sphere) { return sphere.frame > frame; });
  spheres.insert(after, {frame, delta, std::nullopt});
}

/// Spheres change neither range nor stop, so nothing else of the trail's settings moves with them.
Result<Document> changeSpheres(const Document& document, int trailId, Spheres spheres) {
  Document changed = document;
  rig::Trail* const trail = findTrail(changed, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  dropUnmoved(spheres);
  const bool isSame = trail->settings.spheres == spheres;
  trail->settings.spheres = std::move(spheres);
  if (const Status valid = checkTrailSettings(changed, *trail); !valid) {
    return valid.error();
  }
  trail->exaggerated = true;
  trail->connected = trail->follow;
  trail->applied = trail->applied && isSame && trail->connected;
  return changed;
}

double nearestSelected(const PlacedSphere& sphere, std::span<const PlacedSphere> spheres,
                       std::span<const double> selectedFrames) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const PlacedSphere& other : spheres) {
    if (namesOneOf(selectedFrames, other.frame)) {
      nearest = std::min(nearest, glm::distance(sphere.positionWorld, other.positionWorld));
    }
  }
  return nearest;
}

double falloff(double distance, double radius) {
  if (distance <= 0.0) {
    return 1.0;
  }
  if (radius <= 0.0 || distance >= radius) {
    return 0.0;
  }
  const double share = 1.0 - (distance / radius) * (distance / radius);
  return share * share;
}

} // namespace

Result<Document> moveSpheres(const Document& document, int trailId, std::span<const SphereMove> moves) {
  const rig::Trail* trail = findTrail(document, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  Spheres spheres = trail->settings.spheres;
  for (const SphereMove& move : moves) {
    addOffset(spheres, move.frame, move.delta);
  }
  return changeSpheres(document, trailId, std::move(spheres));
}

Result<Document> clearSpheres(const Document& document, int trailId, std::span<const double> frames) {
  const rig::Trail* trail = findTrail(document, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  rig::TrailSettings settings = trail->settings;
  std::erase_if(settings.spheres,
                [&](const rig::SphereOffset& sphere) { return namesOneOf(frames, sphere.frame); });
  return setTrailSettings(document, trailId, settings);
}

Result<Document> setSphereOffset(const Document& document, int trailId, const rig::SphereOffset& offset) {
  const rig::Trail* trail = findTrail(document, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  Spheres spheres = trail->settings.spheres;
  std::erase_if(spheres,
                [&](const rig::SphereOffset& sphere) { return sameFrame(sphere.frame, offset.frame); });
  addOffset(spheres, offset.frame, offset.offset);
  findSphere(spheres, offset.frame)->tangent = offset.tangent;
  return changeSpheres(document, trailId, std::move(spheres));
}

Result<Document> setSphereTangent(const Document& document, int trailId, double frame,
                                  const std::optional<Vec3>& tangent) {
  const rig::Trail* trail = findTrail(document, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  Spheres spheres = trail->settings.spheres;
  addOffset(spheres, frame, Vec3(0.0));
  findSphere(spheres, frame)->tangent = tangent;
  return changeSpheres(document, trailId, std::move(spheres));
}

Result<Document> removeSpheres(const Document& document, int trailId, std::span<const double> present,
                               std::span<const double> frames) {
  std::vector<double> left;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (i == 0 || i + 1 == present.size() || !namesOneOf(frames, present[i])) {
      left.push_back(present[i]);
    }
  }
  Result<Document> cleared = clearSpheres(document, trailId, frames);
  return cleared && left.size() < present.size() ? setControlFrames(*cleared, trailId, std::move(left))
                                                 : cleared;
}

Result<Document> setControlFrames(const Document& document, int trailId, std::vector<double> frames) {
  Document changed = document;
  rig::Trail* trail = findTrail(changed, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  if (!std::all_of(frames.begin(), frames.end(), [](double frame) { return std::isfinite(frame); })) {
    return Error{"a frame is not a number", "trail " + std::to_string(trailId), "type a number"};
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end(), sameFrame), frames.end());
  trail->controlFrames = std::move(frames);
  trail->applied = trail->applied && trail->settings.spheres.empty(); // What was pulled bends anew.
  return changed;
}

Vec3 toTrailAxes(const rig::TrailSettings& settings, const Vec3& worldVector) {
  return settings.space == rig::TrailSpace::view ? glm::transpose(settings.viewAxes) * worldVector
                                                 : worldVector;
}

std::vector<SphereMove> softMoves(const rig::TrailSettings& settings, std::span<const PlacedSphere> spheres,
                                  std::span<const double> selectedFrames, const Vec3& deltaWorld,
                                  double radiusWorld) {
  const Vec3 delta = toTrailAxes(settings, deltaWorld);
  std::vector<SphereMove> moves;
  for (const PlacedSphere& sphere : spheres) {
    const bool selected = namesOneOf(selectedFrames, sphere.frame);
    const double share =
        selected ? 1.0 : falloff(nearestSelected(sphere, spheres, selectedFrames), radiusWorld);
    if (share > 0.0) {
      moves.push_back({sphere.frame, share * delta});
    }
  }
  return moves;
}

} // namespace stretch::app
