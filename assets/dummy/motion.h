#pragma once

#include <string>
#include <vector>

#include "core/math/types.h"

namespace stretch::assets {

/// Keys of one joint's rotation, or of the hips' translation. With tangents (per second) they are glTF's
/// cubic splines, without they are joined by straight lines.
struct MotionTrack {
  int joint = 0;
  bool isTranslation = false; ///< Values are (x, y, z, 0) in metres; else quaternions (x, y, z, w).
  std::vector<Vec4> values;
  std::vector<Vec4> inTangents;
  std::vector<Vec4> outTangents;
  std::vector<int> frames; ///< Ascending, from 0.
};

struct Motion {
  std::string name;
  double framesPerSecond = 24.0;
  std::vector<MotionTrack> tracks;
};

} // namespace stretch::assets
