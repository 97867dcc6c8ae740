#pragma once

#include <map>
#include <vector>

#include "rig/rekey/exact_motion.h"
#include "rig/rekey/keyed_part.h"
#include "rig/rekey/rekey.h"
#include "rig/rekey/stretch_frames.h"

namespace stretch::rig {

/// A property that is changed.
struct ChangedChannel {
  NodeIndex node;
  Channel channel = Channel::translation;
  const Track* source = nullptr; ///< Null when the clip does not animate it.
  bool isCubic = false;          ///< Its keys get tangents: as the source, else as the others of the limb.
};

/// The new keys of one part.
struct PartKeys {
  const KeyedPart* part = nullptr;
  std::vector<ChangedChannel> channels;
  std::vector<NodeIndex> stretchedNodes;
  std::vector<std::vector<double>> times;        ///< Key times of each window, ascending, its ends included.
  std::vector<std::vector<double>> stretchTimes; ///< Times of the keys of the bones' stretch.
};

/// Stretched nodes with the frames of their stretches.
using FramesOfNodes = std::map<NodeIndex, StretchFrames>;

/// What parts change, and where they get keys.
struct ChosenKeys {
  std::vector<PartKeys> parts; ///< In the order of the parts, which have to outlive them.
  FramesOfNodes frames;        ///< Of every node that some part stretches.
  double largestMiss = 0.0;    ///< See RekeyedClip.
};

/// Chooses the keys of all parts. They are gone through in step with time, so that the frames of a long clip
/// are made once for all parts, and not once for each.
[[nodiscard]] ChosenKeys chooseKeys(ExactMotion& exact, const std::vector<KeyedPart>& parts,
                                    const RekeyOptions& options);

} // namespace stretch::rig
