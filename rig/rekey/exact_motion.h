#pragma once

#include <map>
#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/part_motion.h"
#include "rig/rekey/mesh_reach.h"

namespace stretch::rig {

/// Values that were asked for last, remembered per time: at most two generations of `capacity` entries, so
/// that a long clip costs no more memory than a short one. A reference stays good until `capacity` other
/// times were asked for.
template <typename Value>
class RecentTimes {
public:
  explicit RecentTimes(std::size_t capacity) : capacity_(capacity) {}

  template <typename Make>
  const Value& of(double timeSeconds, Make&& make) {
    if (const auto found = now_.find(timeSeconds); found != now_.end()) {
      return found->second;
    }
    if (now_.size() >= capacity_) {
      before_ = std::move(now_);
      now_.clear();
    }
    if (auto found = before_.extract(timeSeconds); !found.empty()) {
      return now_.insert(std::move(found)).position->second;
    }
    return now_.emplace(timeSeconds, make()).first->second;
  }

private:
  std::size_t capacity_;
  std::map<double, Value> now_;
  std::map<double, Value> before_;
};

/// Where makers of keys at these times stop for each other: a long clip's frames are made once for all of
/// them, since those between two stops are few enough to be remembered. Ascending, the last endless.
[[nodiscard]] std::vector<double> stopsAmong(std::vector<double> times);

/// The motion that keys are made to follow: of the nodes that it moves, and of what they hang from, alone.
class ExactMotion {
public:
  ExactMotion(const Scene& scene, const Clip& clip, const MotionState& motion)
      : ExactMotion(scene, clip, motion, usualCapacity(scene)) {}
  /// Remembers the frames of so many times, twice as many at most.
  ExactMotion(const Scene& scene, const Clip& clip, const MotionState& motion, std::size_t capacity)
      : scene_(scene), clip_(clip), motion_(motion), part_(scene, clip, motion, {}), reach_(meshReach(scene)),
        frames_(capacity) {}

  /// Good for the frames around it.
  [[nodiscard]] const FrameState& at(double timeSeconds);
  /// Good until the next one is asked for.
  [[nodiscard]] const Pose& sourceAt(double timeSeconds);
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Clip& clip() const { return clip_; }
  [[nodiscard]] const MotionState& motion() const { return motion_; }
  [[nodiscard]] double reachOf(std::size_t node) const { return reach_[node]; } ///< See meshReach.
  /// Frames that were made so far, those that were forgotten and made again among them.
  [[nodiscard]] std::size_t made() const { return made_; }

private:
  // Frames of about 64 MB, and no fewer than a second of them.
  static std::size_t usualCapacity(const Scene& scene);

  const Scene& scene_;
  const Clip& clip_;
  const MotionState& motion_;
  PartMotion part_;
  std::vector<double> reach_;
  RecentTimes<FrameState> frames_;
  FrameState source_;
  std::size_t made_ = 0;
};

/// A node's animated property as numbers: translation and scale in x, y, z, rotation as (x, y, z, w).
[[nodiscard]] Vec4 channelValue(const Pose& pose, NodeIndex node, Channel channel);
void setChannelValue(Transform& local, Channel channel, const Vec4& value);

} // namespace stretch::rig
