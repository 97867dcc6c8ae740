#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// An elbow or a knee that pops: a limb that straightens moves its middle joint as the root of what is left
/// to straighten, far quicker than its ends (docs/controllers.md, Arms and legs). Or a limb that flips, as
/// one does that is folded up until its end passes its base. Or one that turns though its ends do not make it
/// (free_turns.h).
struct LimbPop {
  std::string limb;
  double frame = 0.0; ///< Whole frame at which it is worst.
  double times = 0.0; ///< Second difference of the joint over frames, in those of the limb's base and end
                      ///< around it; 0 for a limb that flips or turns.
  double turnDegrees = 0.0;   ///< Angle by which a bone turns within a frame, where the limb flips, or a
                              ///< joint, where it turns.
  double sourceDegrees = 0.0; ///< Likewise in the source: around that frame, or within it.
  std::vector<std::int64_t> freeFrames; ///< Whole frames into which the limb turns though its ends do not
                                        ///< make it, in order; empty for one that pops or flips.
  std::vector<std::int64_t> flipFrames; ///< Whole frames into which it flips, in order; empty for one that
                                        ///< pops or turns.
};

/// Whole frames that are looked at; those beyond the clip are passed over.
struct FrameSpan {
  std::int64_t first = 0;
  std::int64_t last = 20000;

  friend bool operator==(const FrameSpan&, const FrameSpan&) = default;
};

/// The worst pop of each limb with an elbow or a knee that is above 4 times, then where it flips by 45
/// degrees within a frame more than twice what the source turns (more in a clip of few frames per second),
/// where offsets and holds make it: the source's own jolts are not counted, nor what is too small to see.
/// After that where it turns freely by more than 5 degrees (more in a clip of few frames per second) at other
/// frames; where its pole moves, or a trail of its own without a hold that takes it all, it is meant to.
/// `motion`: of the clip.
[[nodiscard]] std::vector<LimbPop> limbPops(const Document& document, const rig::MotionState& motion,
                                            const FrameSpan& frames = {});

/// One line with the way out, such as some softness.
[[nodiscard]] std::string popWarning(const LimbPop& pop);

} // namespace stretch::app
