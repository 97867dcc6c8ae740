#include "core/anim/sampling.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "core/base/check.h"

namespace stretch {

namespace {

Quat quatFrom(const double* xyzw) {
  return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

void store(const Quat& rotation, double* xyzw) {
  xyzw[0] = rotation.x;
  xyzw[1] = rotation.y;
  xyzw[2] = rotation.z;
  xyzw[3] = rotation.w;
}

// Files hold quaternions that are a little off unit length, and broken files hold zero.
Quat normalizedOrIdentity(const Quat& rotation) {
  const double length = glm::length(rotation);
  return length > 1e-12 ? rotation / length : Quat(1.0, 0.0, 0.0, 0.0);
}

std::size_t valueOffset(const Track& track, std::size_t key) {
  const auto width = static_cast<std::size_t>(track.width);
  return track.interpolation == Interpolation::cubicSpline ? (3 * key + 1) * width : key * width;
}

void copyKey(const Track& track, std::size_t key, double* out) {
  const std::size_t offset = valueOffset(track, key);
  for (std::size_t i = 0; i < static_cast<std::size_t>(track.width); ++i) {
    out[i] = static_cast<double>(track.values[offset + i]);
  }
}

void sampleLinear(const Track& track, std::size_t key, double fraction, double* out) {
  const auto width = static_cast<std::size_t>(track.width);
  const std::size_t offset = valueOffset(track, key);
  if (track.channel == Channel::rotation) {
    std::array<double, 4> from{};
    std::array<double, 4> to{};
    copyKey(track, key, from.data());
    copyKey(track, key + 1, to.data());
    const Quat a = normalizedOrIdentity(quatFrom(from.data()));
    const Quat b = normalizedOrIdentity(quatFrom(to.data()));
    store(normalizedOrIdentity(glm::slerp(a, b, fraction)), out); // glm takes the shorter arc
    return;
  }
  for (std::size_t i = 0; i < width; ++i) {
    const auto a = static_cast<double>(track.values[offset + i]);
    const auto b = static_cast<double>(track.values[offset + width + i]);
    out[i] = a + (b - a) * fraction;
  }
}

void sampleCubic(const Track& track, std::size_t key, double fraction, double spanSeconds, double* out) {
  const auto width = static_cast<std::size_t>(track.width);
  const double t = fraction;
  const double t2 = t * t;
  const double t3 = t2 * t;
  const std::size_t from = valueOffset(track, key);
  const std::size_t to = valueOffset(track, key + 1);
  for (std::size_t i = 0; i < width; ++i) {
    const auto a = static_cast<double>(track.values[from + i]);
    const auto outTangent = static_cast<double>(track.values[from + width + i]) * spanSeconds;
    const auto b = static_cast<double>(track.values[to + i]);
    const auto inTangent = static_cast<double>(track.values[to - width + i]) * spanSeconds;
    out[i] = (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * outTangent + (3 * t2 - 2 * t3) * b +
             (t3 - t2) * inTangent;
  }
}

void sampleRaw(const Track& track, double timeSeconds, double* out) {
  const auto next =
      std::upper_bound(track.times.begin(), track.times.end(), timeSeconds,
                       [](double time, float keyTime) { return time < static_cast<double>(keyTime); });
  if (next == track.times.begin()) {
    copyKey(track, 0, out);
    return;
  }
  const auto key = static_cast<std::size_t>(next - track.times.begin()) - 1;
  if (next == track.times.end() || track.interpolation == Interpolation::step) {
    copyKey(track, key, out);
    return;
  }
  const auto start = static_cast<double>(track.times[key]);
  const double span = static_cast<double>(*next) - start;
  const double fraction = (timeSeconds - start) / span;
  if (track.interpolation == Interpolation::linear) {
    sampleLinear(track, key, fraction, out);
  } else {
    sampleCubic(track, key, fraction, span, out);
  }
}

void applyTrack(const Track& track, double timeSeconds, Pose& pose) {
  const auto node = at(track.node);
  if (track.channel == Channel::weights) {
    std::vector<double> weights(static_cast<std::size_t>(track.width));
    sampleTrack(track, timeSeconds, weights.data());
    pose.weights[node].assign(weights.begin(), weights.end());
    return;
  }
  std::array<double, 4> value{};
  sampleTrack(track, timeSeconds, value.data());
  pose.usesMatrix[node] = false;
  Transform& local = pose.locals[node];
  if (track.channel == Channel::translation) {
    local.translation = {value[0], value[1], value[2]};
  } else if (track.channel == Channel::scale) {
    local.scale = {value[0], value[1], value[2]};
  } else {
    local.rotation = quatFrom(value.data());
  }
}

} // namespace

void sampleTrack(const Track& track, double timeSeconds, double* out) {
  check(!track.times.empty(), "a track has at least one key");
  sampleRaw(track, timeSeconds, out);
  if (track.channel == Channel::rotation) {
    store(normalizedOrIdentity(quatFrom(out)), out);
  }
}

Pose restPose(const Scene& scene) {
  Pose pose;
  pose.locals.reserve(scene.nodes.size());
  pose.usesMatrix.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) {
    pose.locals.push_back(node.rest);
    pose.usesMatrix.push_back(node.matrix.has_value());
  }
  for (const Node& node : scene.nodes) {
    pose.weights.push_back(node.morphWeights);
  }
  return pose;
}

Pose samplePose(const Scene& scene, const Clip& clip, double timeSeconds) {
  Pose pose = restPose(scene);
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    applyTrack(*track, timeSeconds, pose);
  }
  return pose;
}

Mat4 localMatrix(const Scene& scene, const Pose& pose, NodeIndex node) {
  const auto index = at(node);
  return pose.usesMatrix[index] ? *scene.nodes[index].matrix : toMatrix(pose.locals[index]);
}

std::vector<Mat4> worldMatrices(const Scene& scene, const Pose& pose) {
  std::vector<Mat4> worlds(scene.nodes.size(), Mat4(1.0));
  for (const NodeIndex node : parentsFirst(scene)) {
    const auto index = at(node);
    const NodeIndex parent = scene.nodes[index].parent;
    const Mat4 local = localMatrix(scene, pose, node);
    worlds[index] = !parent.exists() ? local : worlds[at(parent)] * local;
  }
  return worlds;
}

} // namespace stretch
