#include "assets/dummy/keying.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

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

using PoseCurve = std::function<Pose(double frame)>;
using Tracks = std::vector<MotionTrack>;

/// Whole frames in the middle of the gaps between keys in which something is farther off than two
/// millimetres.
std::vector<int> gapsBeyondTolerance(const std::vector<int>& keys,
                                     const std::function<double(double frame)>& distanceAt) {
  constexpr double tolerance = 0.002;
  std::vector<int> gaps;
  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    double farthest = 0.0;
    for (double frame = keys[key]; frame < keys[key + 1]; frame += 0.25) {
      farthest = std::max(farthest, distanceAt(frame));
    }
    if (farthest > tolerance && keys[key + 1] - keys[key] > 1) {
      gaps.push_back((keys[key] + keys[key + 1]) / 2);
    }
  }
  return gaps;
}

struct Keying {
  const std::vector<Joint>& skeleton;
  PoseCurve poseAtFrame;
  double framesPerSecond;

  [[nodiscard]] Tracks hipsTracks(const std::vector<int>& frames) const {
    const Curve position = [&](double frame) { return Vec4(poseAtFrame(frame)[Control::hips], 0.0); };
    return {keyCurve(0, true, position, frames, framesPerSecond), poseTrack(0, frames)};
  }

  /// Hips, trunk, head and arms.
  [[nodiscard]] Tracks upperBody(const std::vector<int>& frames) const {
    Tracks tracks = hipsTracks(frames);
    for (std::size_t joint = 1; joint < skeleton.size(); ++joint) {
      if (!isFinger(skeleton[joint].name) && !isLeg(skeleton[joint].name)) {
        tracks.push_back(poseTrack(static_cast<int>(joint), frames));
      }
    }
    return tracks;
  }

  [[nodiscard]] Tracks propTracks(const std::vector<MovingProp>& props,
                                  const std::vector<int>& frames) const {
    Tracks tracks;
    for (const MovingProp& prop : props) {
      const Curve position = [&](double frame) { return Vec4(prop.place(poseAtFrame(frame)).position, 0.0); };
      const Curve rotation = [&](double frame) { return asVector(prop.place(poseAtFrame(frame)).rotation); };
      tracks.push_back(keyCurve(prop.node, true, position, frames, framesPerSecond));
      tracks.push_back(keyCurve(prop.node, false, rotation, frames, framesPerSecond));
    }
    return tracks;
  }

  [[nodiscard]] MotionTrack poseTrack(int joint, const std::vector<int>& frames) const {
    const Curve rotation = [&](double frame) {
      return asVector(localRotation(skeleton, solvePose(skeleton, poseAtFrame(frame)), joint));
    };
    return keyCurve(joint, false, rotation, frames, framesPerSecond);
  }

  /// Tracks of a leg's four joints, from the hips as their tracks move them, with keys put into the gaps in
  /// which the ball of the foot would stray.
  [[nodiscard]] Tracks plantedLeg(const std::string& side, const Tracks& hips,
                                  std::vector<int> frames) const {
    Tracks leg = legTracks(side, hips, frames);
    for (std::vector<int> more = strayingFrames(side, hips, leg); !more.empty();
         more = strayingFrames(side, hips, leg)) {
      frames.insert(frames.end(), more.begin(), more.end());
      std::sort(frames.begin(), frames.end());
      leg = legTracks(side, hips, frames);
    }
    return leg;
  }

  [[nodiscard]] Tracks legTracks(const std::string& side, const Tracks& hips,
                                 const std::vector<int>& frames) const {
    Tracks tracks;
    for (const char* name : {"UpLeg", "Leg", "Foot", "ToeBase"}) {
      const int joint = jointIndex(skeleton, side + name);
      const Curve rotation = [&](double frame) {
        const SolvedPose solved =
            solvePose(skeleton, poseAtFrame(frame), Vec3(trackValue(hips[0], frame, framesPerSecond)),
                      asRotation(trackValue(hips[1], frame, framesPerSecond)));
        return asVector(localRotation(skeleton, solved, joint));
      };
      tracks.push_back(keyCurve(joint, false, rotation, frames, framesPerSecond));
    }
    return tracks;
  }

  /// Where the tracks put the ball of the foot.
  [[nodiscard]] Vec3 ballAt(const Tracks& hips, const Tracks& leg, double frame) const {
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
  [[nodiscard]] std::vector<int> strayingFrames(const std::string& side, const Tracks& hips,
                                                const Tracks& leg) const {
    const Control ball = side == "Left" ? Control::leftBall : Control::rightBall;
    return gapsBeyondTolerance(leg.front().frames, [&](double frame) {
      return glm::length(ballAt(hips, leg, frame) - poseAtFrame(frame)[ball]);
    });
  }

  /// Place and rotation of a joint by the tracks of it and those above it.
  [[nodiscard]] PropPlace placeOf(const Tracks& tracks, int joint, double frame) const {
    const int parent = skeleton[static_cast<std::size_t>(joint)].parent;
    PropPlace place;
    if (parent >= 0) {
      const PropPlace above = placeOf(tracks, parent, frame);
      const Vec3 offset = skeleton[static_cast<std::size_t>(joint)].position -
                          skeleton[static_cast<std::size_t>(parent)].position;
      place = {above.position + above.rotation * offset, above.rotation};
    }
    for (const MotionTrack& track : tracks) {
      if (track.joint == joint && track.isTranslation) {
        place.position = Vec3(trackValue(track, frame, framesPerSecond));
      } else if (track.joint == joint) {
        place.rotation = place.rotation * asRotation(trackValue(track, frame, framesPerSecond));
      }
    }
    return place;
  }

  /// The same in the middle of gaps in which a knuckle or a prop strays from where the poses have it.
  [[nodiscard]] std::vector<int> strayingHolds(const Tracks& body, const Tracks& props,
                                               const std::vector<MovingProp>& moving) const {
    return gapsBeyondTolerance(body.front().frames, [&](double frame) {
      const Pose pose = poseAtFrame(frame);
      const SolvedPose solved = solvePose(skeleton, pose);
      double farthest = 0.0;
      for (const char* name : {"LeftHandMiddle1", "RightHandMiddle1"}) {
        const int joint = jointIndex(skeleton, name);
        const Vec3& meant = solved.positions[static_cast<std::size_t>(joint)];
        farthest = std::max(farthest, glm::length(placeOf(body, joint, frame).position - meant));
      }
      for (std::size_t prop = 0; prop < moving.size(); ++prop) {
        const PropPlace meant = moving[prop].place(pose);
        const Vec3 position(trackValue(props[2 * prop], frame, framesPerSecond));
        const Quat rotation = asRotation(trackValue(props[2 * prop + 1], frame, framesPerSecond));
        const Vec3 tip(0.0, 0.5, 0.0);
        farthest = std::max({farthest, glm::length(position - meant.position),
                             0.5 * glm::length(rotation * tip - meant.rotation * tip)});
      }
      return farthest;
    });
  }
};

/// Key frames, with more in between wherever hands and props would stray.
std::vector<int> holdingFrames(const Keying& keying, std::vector<int> frames,
                               const std::vector<MovingProp>& props) {
  for (;;) {
    const std::vector<int> more =
        keying.strayingHolds(keying.upperBody(frames), keying.propTracks(props, frames), props);
    if (more.empty()) {
      return frames;
    }
    frames.insert(frames.end(), more.begin(), more.end());
    std::sort(frames.begin(), frames.end());
  }
}

std::vector<int> framesOf(const std::vector<Pose>& poses) {
  std::vector<int> frames;
  frames.reserve(poses.size());
  for (const Pose& pose : poses) {
    frames.push_back(pose.frame);
  }
  return frames;
}

/// The upper body, keyed already, and the legs below it.
Motion withLegs(const std::string& name, const Keying& keying, Tracks upperBody,
                const std::vector<int>& frames) {
  Motion motion{name, keying.framesPerSecond, std::move(upperBody)};
  const Tracks hips(motion.tracks.begin(), motion.tracks.begin() + 2);
  for (const char* side : {"Left", "Right"}) {
    const Tracks leg = keying.plantedLeg(side, hips, frames);
    motion.tracks.insert(motion.tracks.end(), leg.begin(), leg.end());
  }
  return motion;
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
  const Keying keying{skeleton, [&](double frame) { return poseAt(poses, frame); }, framesPerSecond};
  const std::vector<int> frames = framesOf(poses);
  return withLegs(name, keying, keying.upperBody(frames), frames);
}

Motion keyHolding(const std::string& name, const std::vector<Joint>& skeleton, const std::vector<Pose>& poses,
                  double framesPerSecond, const std::function<Pose(const Pose&)>& complete,
                  const std::vector<MovingProp>& props) {
  const Keying keying{skeleton, [&](double frame) { return complete(poseAt(poses, frame)); },
                      framesPerSecond};
  const std::vector<int> posed = framesOf(poses);
  const std::vector<int> frames = holdingFrames(keying, posed, props);
  Motion motion = withLegs(name, keying, keying.upperBody(frames), posed);
  const Tracks moving = keying.propTracks(props, frames);
  motion.tracks.insert(motion.tracks.end(), moving.begin(), moving.end());
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
