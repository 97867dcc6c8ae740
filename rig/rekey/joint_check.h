#pragma once

#include <vector>

#include "rig/rekey/key_times.h"
#include "rig/rekey/span_fit.h"

namespace stretch::rig {

/// How far joints, and the meshes that follow them, are from the exact motion where the channels of a part
/// run along spans between two keys. Only what the part's channels move is looked at.
class JointCheck {
public:
  /// `keys` with its channels; they stay as they are.
  JointCheck(ExactMotion& exact, const PartKeys& keys);

  /// The farthest of them at a time, world units. `spans`: one for each channel.
  [[nodiscard]] double missAt(const PartKeys& keys, const std::vector<ChannelSpan>& spans,
                              double timeSeconds);

private:
  struct Step {
    NodeIndex node;
    int parent = -1; // place of the parent among the steps; -1: it stands where the exact motion has it
    double reach = 0.0;
  };
  ExactMotion& exact_;
  std::vector<Step> steps_;         // parents first
  std::vector<std::size_t> stepOf_; // of each channel
  std::vector<Transform> locals_;   // of the steps, at the time that is looked at
  std::vector<bool> usesMatrix_;
  std::vector<Mat4> worlds_;
};

} // namespace stretch::rig
