#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/limb.h"
#include "rig/trail/trail.h"

namespace stretch::rig {

/// Samples only what a few nodes need: their own tracks and those of their ancestors. Answers what samplePose
/// and worldMatrices answer for these nodes, faster on clips with many tracks.
class NodeSampler {
public:
  NodeSampler(const Scene& scene, const Clip& clip, const std::vector<NodeIndex>& nodes);

  /// The clip at a time; only the asked nodes and their ancestors are filled in, the world matrices of others
  /// are the identity. `frame` may be one that was sampled before and changed since.
  void sample(double timeSeconds, FrameState& frame) const;

  /// The scene's nodes under their own indices, but only the asked ones and their ancestors are anyone's
  /// children. Nothing else of the scene is in it.
  [[nodiscard]] Scene skeleton() const;

private:
  struct Step {
    NodeIndex node;
    std::vector<const Track*> tracks;
  };
  [[nodiscard]] Transform localAt(const Step& step, double timeSeconds) const;
  [[nodiscard]] Mat4 worldOf(NodeIndex node, const Mat4& local, const std::vector<Mat4>& worlds) const;

  const Scene* scene_;
  std::vector<Step> steps_;       // parents first
  std::vector<BindChain> chains_; // of the sampled joints
};

/// The limb at one time of the source clip, world space.
struct LimbSample {
  double timeSeconds = 0.0;
  Vec3 base{0.0};      ///< P0.
  Vec3 end{0.0};       ///< c.
  Vec3 reference{0.0}; ///< Point from which the trail's space is measured: the hips (root), the base (base),
                       ///< 0 (world, view).
};

/// A limb's original path over the range.
struct LimbPath {
  std::vector<LimbSample> samples; ///< At every frame and every key time of the range; at least one.
  std::vector<double> ratios;      ///< r of each sample (docs/exaggeration.md, The path and its ratio).
  std::vector<LimbSample> between; ///< Halfway from each sample to the next: how far the path strays there.
  Mat3 axes{1.0};                  ///< Columns: the axes of the trail's space, in world space.

  [[nodiscard]] Vec3 toSpace(const LimbSample& sample, const Vec3& world) const;
  [[nodiscard]] Vec3 toWorld(const LimbSample& sample, const Vec3& inSpace) const;
  /// Ratio at any time of the range: linear in time within a piece; held outside.
  [[nodiscard]] double ratioAt(double timeSeconds) const;
};

/// The limb in a frame of the source clip.
[[nodiscard]] LimbSample limbSample(const Limb& limb, TrailSpace space, NodeIndex hips,
                                    const FrameState& source);

/// Times at which the range [start, end] is sampled: its frames, the key times in it that lie on none, and
/// both ends, ascending.
[[nodiscard]] std::vector<double> sampleTimes(double startSeconds, double endSeconds, double framesPerSecond,
                                              const std::vector<double>& keyTimes);

/// Halfway from each of these times to the next; where that is half a frame, exactly there.
[[nodiscard]] std::vector<double> timesBetween(const std::vector<double>& timesSeconds,
                                               double framesPerSecond);

/// Key times of the limb's joints (end and twist nodes of `nodes` included) within [start, end], ascending,
/// without repeats.
[[nodiscard]] std::vector<double> keyTimesOf(const Clip& clip, const std::vector<NodeIndex>& nodes,
                                             double startSeconds, double endSeconds);

/// Frames of the control spheres (docs/exaggeration.md, Control spheres): the keys of a sparsely keyed limb;
/// else the ends, the extremes and as few in between as keep a cubic through them within `tolerance` (world
/// units) of the path, about ten at most. `keysPerSecond`: by which the keys are counted.
[[nodiscard]] std::vector<double> chooseControlFrames(const LimbPath& path,
                                                      const std::vector<double>& keyTimes,
                                                      double framesPerSecond, double keysPerSecond,
                                                      double tolerance);

/// Whether as many keys within [start, end] are so dense (about one in each frame) that they say nothing
/// about poses.
[[nodiscard]] bool isDenselyKeyed(std::size_t keyCount, double startSeconds, double endSeconds,
                                  double framesPerSecond);
/// How the keys of some nodes lie over a whole clip.
struct KeySpacing {
  double keysPerSecond = 0.0; ///< Rate by which they are counted.
  bool isDense = false;       ///< isDenselyKeyed, at that rate.
};

/// Spacing of the nodes' keys (keyTimesOf). They are counted at the clip's rate, or at that on which keys lie
/// where they are too few for the own one and this one is lower: a clip that is shown at more frames per
/// second than it was made at is keyed no less densely.
[[nodiscard]] KeySpacing keySpacing(const Clip& clip, const std::vector<NodeIndex>& nodes);

} // namespace stretch::rig
