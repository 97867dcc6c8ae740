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

using Curve = std::function<Vec4(double frame)>;

bool isLeg(std::string_view name) {
  return name.ends_with("UpLeg") || name.ends_with("Leg") || name.ends_with("Foot") ||
         name.ends_with("ToeBase");
}

bool isFinger(std::string_view name) {
  return name.ends_with("1") && name.find("Hand") != std::string_view::npos;
}

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

struct Keying {
  const std::vector<Joint>& skeleton;
  const std::vector<Pose>& poses;
  double framesPerSecond;

  [[nodiscard]] std::vector<MotionTrack> hipsTracks(const std::vector<int>& frames) const {
    const Curve position = [&](double frame) { return Vec4(poseAt(poses, frame)[Control::hips], 0.0); };
    return {keyCurve(0, true, position, frames, framesPerSecond), poseTrack(0, frames)};
  }

  [[nodiscard]] MotionTrack poseTrack(int joint, const std::vector<int>& frames) const {
    const Curve rotation = [&](double frame) {
      return asVector(localRotation(skeleton, solvePose(skeleton, poseAt(poses, frame)), joint));
    };
    return keyCurve(joint, false, rotation, frames, framesPerSecond);
  }

  /// Tracks of a leg's four joints, from the hips as their tracks move them, with keys put into the gaps in
  /// which the ball of the foot would stray.
  [[nodiscard]] std::vector<MotionTrack>
  plantedLeg(const std::string& side, const std::vector<MotionTrack>& hips, std::vector<int> frames) const {
    std::vector<MotionTrack> leg = legTracks(side, hips, frames);
    for (std::vector<int> more = strayingFrames(side, hips, leg); !more.empty();
         more = strayingFrames(side, hips, leg)) {
      frames.insert(frames.end(), more.begin(), more.end());
      std::sort(frames.begin(), frames.end());
      leg = legTracks(side, hips, frames);
    }
    return leg;
  }

  [[nodiscard]] std::vector<MotionTrack> legTracks(const std::string& side,
                                                   const std::vector<MotionTrack>& hips,
                                                   const std::vector<int>& frames) const {
    std::vector<MotionTrack> tracks;
    for (const char* name : {"UpLeg", "Leg", "Foot", "ToeBase"}) {
      const int joint = jointIndex(skeleton, side + name);
      const Curve rotation = [&](double frame) {
        const SolvedPose solved =
            solvePose(skeleton, poseAt(poses, frame), Vec3(trackValue(hips[0], frame, framesPerSecond)),
                      asRotation(trackValue(hips[1], frame, framesPerSecond)));
        return asVector(localRotation(skeleton, solved, joint));
      };
      tracks.push_back(keyCurve(joint, false, rotation, frames, framesPerSecond));
    }
    return tracks;
  }

  /// Where the tracks put the ball of the foot.
  [[nodiscard]] Vec3 ballAt(const std::vector<MotionTrack>& hips, const std::vector<MotionTrack>& leg,
                            double frame) const {
    Vec3 position(trackValue(hips[0], frame, framesPerSecond));
    Quat rotation = asRotation(trackValue(hips[1], frame, framesPerSecond));
    for (const MotionTrack& track : leg) {
      const Joint& joint = skeleton[static_cast<std::size_t>(track.joint)];
      position += rotation * (joint.position - skeleton[static_cast<std::size_t>(joint.parent)].position);
      rotation = rotation * asRotation(trackValue(track, frame, framesPerSecond));
    }
    return position;
  }

  /// Whole frames in the middle of the gaps between keys in which the ball strays from where the poses put
  /// it.
  [[nodiscard]] std::vector<int> strayingFrames(const std::string& side, const std::vector<MotionTrack>& hips,
                                                const std::vector<MotionTrack>& leg) const {
    constexpr double tolerance = 0.002;
    const Control ball = side == "Left" ? Control::leftBall : Control::rightBall;
    const std::vector<int>& keys = leg.front().frames;
    std::vector<int> straying;
    for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
      double farthest = 0.0;
      for (double frame = keys[key]; frame < keys[key + 1]; frame += 0.25) {
        farthest = std::max(farthest, glm::length(ballAt(hips, leg, frame) - poseAt(poses, frame)[ball]));
      }
      if (farthest > tolerance && keys[key + 1] - keys[key] > 1) {
        straying.push_back((keys[key] + keys[key + 1]) / 2);
      }
    }
    return straying;
  }
};

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
  frames.reserve(poses.size());

  for (const Pose& pose : poses) {
    frames.push_back(pose.frame);
  }
  const Keying keying{skeleton, poses, framesPerSecond};
  const std::vector<MotionTrack> hips = keying.hipsTracks(frames);
  Motion motion{name, framesPerSecond, hips};
  for (std::size_t joint = 1; joint < skeleton.size(); ++joint) {
    if (!isFinger(skeleton[joint].name) && !isLeg(skeleton[joint].name)) {
      motion.tracks.push_back(keying.poseTrack(static_cast<int>(joint), frames));
    }
  }
  for (const char* side : {"Left", "Right"}) {
    const std::vector<MotionTrack> leg = keying.plantedLeg(side, hips, frames);
    motion.tracks.insert(motion.tracks.end(), leg.begin(), leg.end());
  }
  return motion;
}

Motion bakePoses(const std::string& name, const std::vector<Joint>& skeleton, const std::vector<Pose>& poses,
                 double framesPerSecond) {
  Motion motion{name, framesPerSecond, {{0, true, {}, {}, {}, {}}}};
  for (std::size_t joint = 0; joint < skeleton.size(); ++joint) {
    if (!isFinger(skeleton[joint].name)) {
      motion.tracks.push_back({static_cast<int>(joint), false, {}, {}, {}, {}});
    }
  }
  for (int frame = poses.front().frame; frame <= poses.back().frame; ++frame) {
    const Pose pose = poseAt(poses, frame);
    const SolvedPose solved = solvePose(skeleton, pose);
    for (MotionTrack& track : motion.tracks) {
      const Vec4 value = track.isTranslation ? Vec4(pose[Control::hips], 0.0)
                                             : asVector(localRotation(skeleton, solved, track.joint));
      track.values.push_back(track.values.empty() ? value
                                                  : aligned(value, track.values.back(), track.isTranslation));
      track.frames.push_back(frame);
    }
  }
  return motion;
}

} // namespace stretch::assets
