#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/document.h"
#include "app/weight/weight_motion.h"
#include "core/anim/frame_state.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// The trails and the weight of limbs of one clip, prepared for evaluation at any time. Active trails only
/// move the character; the others are prepared too, so that their paths can be drawn.
[[nodiscard]] rig::MotionState prepareMotion(const Document& document, int clip);

/// What the limbs of a clip that have weight come to.
[[nodiscard]] std::vector<WeightReport> weightReports(const Document& document, int clip);

/// The character at one time (seconds of the clip), trails and weight included. The one function that
/// renderer, panels, batch and tests read.
[[nodiscard]] FrameState evaluate(const Document& document, const rig::MotionState& motion,
                                  double timeSeconds);

/// The clip as the source has it.
[[nodiscard]] FrameState evaluateOriginal(const Document& document, int clip, double timeSeconds);

/// The paths of one trail, as they are drawn.
struct TrailPaths {
  rig::DrawnTrail drawn;   ///< Evenly over range and release.
  rig::DrawnTrail spheres; ///< At SolvedTrail::controlFrames.
};

/// One for each trail of `motion`, `samplesPerFrame` samples per frame.
[[nodiscard]] std::vector<TrailPaths> trailPaths(const Document& document, const rig::MotionState& motion,
                                                 std::size_t samplesPerFrame);

/// Remembers the last answers; keys on the identity and value of what they were made from, so nobody
/// invalidates it. What it keys on by identity it also keeps, so that no other document can take its place in
/// memory. Of trails that did not change, and of paths that no changed trail moves, the last answers are used
/// again.
class EvaluationCache {
public:
  [[nodiscard]] std::shared_ptr<const rig::MotionState> motion(const Document& document, int clip);
  /// Of the limbs with weight, in the order of Document::weights.
  [[nodiscard]] const std::vector<WeightReport>& weightReports(const Document& document, int clip);
  [[nodiscard]] const FrameState& frame(const Document& document, int clip, double timeSeconds);
  [[nodiscard]] const FrameState& original(const Document& document, int clip, double timeSeconds);
  /// One for each trail of motion(); the clip must be there.
  [[nodiscard]] const std::vector<TrailPaths>& paths(const Document& document, int clip,
                                                     std::size_t samplesPerFrame);

private:
  /// What every trail of a clip is solved from.
  struct Ground {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const std::vector<Clip>> clips;
    int clip = -1;
    int hips = -1;
    std::vector<rig::Limb> limbs;
    std::vector<int> looping;
    friend bool operator==(const Ground&, const Ground&) = default;
  };
  [[nodiscard]] static Ground groundOf(const Document& document, int clip);

  void giveWay(const Document& document, int clip, rig::MotionState& motion);

  Ground ground_;
  std::vector<rig::Trail> trails_;
  std::vector<WeightedLimb> weights_;
  std::optional<SampledClip> sampled_; ///< Of the trails alone: a drag of a limb's softness keeps it.
  LimbSizes sizes_;
  std::vector<WeightReport> weightReports_;
  std::shared_ptr<const rig::MotionState> motion_;
  std::shared_ptr<const rig::MotionState> frameMotion_;
  double frameSeconds_ = 0.0;
  FrameState frame_;
  std::shared_ptr<const Scene> originalScene_;
  std::shared_ptr<const std::vector<Clip>> originalClips_;
  int originalClip_ = -1;
  double originalSeconds_ = 0.0;
  FrameState original_;
  Ground pathsGround_;
  std::shared_ptr<const rig::MotionState> pathsMotion_;
  std::size_t pathsSamplesPerFrame_ = 0;
  std::vector<TrailPaths> paths_;
};

} // namespace stretch::app
