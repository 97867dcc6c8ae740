#pragma once

#include <vector>

#include "rig/body/reading/biped_reading.h"

namespace stretch::rig::body {

/// The joints in the middle of the body, as candidates, each list from the hips upwards.
struct Trunk {
  int hips = -1;
  std::vector<int> spine; ///< From the first joint above the hips to the one that carries the arms.
  std::vector<int> neck;
  int head = -1;
  double spineNameFit = 0.0;   ///< 0..1: share of the spine's joints that are named so.
  double neckNameFit = 0.0;    ///< 0..1: of the neck's joints and the head.
  bool hasRivalOfNeck = false; ///< Without names of neck and head: another row of joints may be these.
};

/// Reads hips, spine, neck and head along the chain from the root to the head, by names, by where legs and
/// arms join it and by where the head's vertices are.
[[nodiscard]] Trunk readTrunk(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading);

} // namespace stretch::rig::body
