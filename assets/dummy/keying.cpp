#include "assets/dummy/keying.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include <glm/geometric.hpp>

#include "assets/dummy/pose_solver.h"

namespace stretch::assets {

namespace {

Vec4 asVector(const Quat& rotation) {
  return {rotation.x, rotation.y, rotation.z, rotation.w};
}

Quat asRotation(const Vec4& value) {
  return {value.w, value.x, value.y, value.z};
}

bool isLeg(std::string_view name) {
  return name.ends_with("UpLeg") || name.ends_with("Leg") || name.ends_with("Foot") ||
         name.ends_with("ToeBase");
}

bool isFinger(std::string_view name) {
  return name.ends_with("1") && name.find("Hand") != std::string_view::npos;
}

using Curve = std::function<Vec4(double frame)>;

/// On the same half of the quaternions as `reference`.
Vec4 aligned(const Vec4& value, const Vec4& reference, bool isTranslation) {
  return !isTranslation && glm::dot(value, reference) < 0.0 ? -value : value;
}

MotionTrack keyCurve(int joint, bool isTranslation, const Curve& curve, const std::vector<int>& frames,
                     double framesPerSecond) {
  constexpr double step = 1.0 / 64.0;
  MotionTrack track{joint, isTranslation, {}, {}, {}, frames};
  for (const int frame : frames) {
    Vec4 value = curve(frame);
    if (!track.values.empty()) {
      value = aligned(value, track.values.back(), isTranslation);
    }
    const double before = std::max(frame - step, 0.0);
    const double after = std::min(frame + step, static_cast<double>(frames.back()));
    const Vec4 rise =
        aligned(curve(after), value, isTranslation) - aligned(curve(before), value, isTranslation);
    const Vec4 tangent = rise * (framesPerSecond / (after - before));
    track.values.push_back(value);
    track.inTangents.push_back(frame == frames.front() ? Vec4(0.0) : tangent);
    track.outTangents.push_back(frame == frames.back() ? Vec4(0.0) : tangent);
  }
  return track;
}

} // namespace

Vec4 trackValue(const MotionTrack& track, double frame, double framesPerSecond) {
  std::size_t key = 0;
  while (key + 2 < track.frames.size() && frame >= track.frames[key + 1]) {
    ++key;
  }
  const double frames = track.frames[key + 1] - track.frames[key];
  const double t = std::clamp((frame - track.frames[key]) / frames, 0.0, 1.0);
  const double seconds = frames / framesPerSecond;
  const double t2 = t * t;
  const double t3 = t2 * t;
  const Vec4 value = (2.0 * t3 - 3.0 * t2 + 1.0) * track.values[key] +
                     seconds * (t3 - 2.0 * t2 + t) * track.outTangents[key] +
                     (3.0 * t2 - 2.0 * t3) * track.values[key + 1] +
                     seconds * (t3 - t2) * track.inTangents[key + 1];
  return track.isTranslation ? value : glm::normalize(value);
}

Motion keyPoses(const std::string& name, const std::vector<Joint>& skeleton, const std::vector<Pose>& poses,
                double framesPerSecond) {
  std::vector<int> frames;
  for (const Pose& pose : poses) {
    frames.push_back(pose.frame);
  }
  Motion motion{name, framesPerSecond, {}};
  const Curve hipsPosition = [&](double frame) { return Vec4(poseAt(poses, frame)[Control::hips], 0.0); };
  motion.tracks.push_back(keyCurve(0, true, hipsPosition, frames, framesPerSecond));
  const Curve hipsRotation = [&](double frame) {
    return asVector(solvePose(skeleton, poseAt(poses, frame)).rotations[0]);
  };
  motion.tracks.push_back(keyCurve(0, false, hipsRotation, frames, framesPerSecond));
  const MotionTrack hips = motion.tracks[0];
  const MotionTrack turn = motion.tracks[1];
  for (std::size_t joint = 1; joint < skeleton.size(); ++joint) {
    if (isFinger(skeleton[joint].name)) {
      continue;
    }
    const bool followsKeys = isLeg(skeleton[joint].name);
    const Curve rotation = [&](double frame) {
      const Pose pose = poseAt(poses, frame);
      const SolvedPose solved =
          followsKeys ? solvePose(skeleton, pose, Vec3(trackValue(hips, frame, framesPerSecond)),
                                  asRotation(trackValue(turn, frame, framesPerSecond)))
                      : solvePose(skeleton, pose);
      return asVector(localRotation(skeleton, solved, static_cast<int>(joint)));
    };
    motion.tracks.push_back(keyCurve(static_cast<int>(joint), false, rotation, frames, framesPerSecond));
  }
  return motion;
}

} // namespace stretch::assets
