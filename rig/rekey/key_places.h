#pragma once

namespace stretch::rig {

/// Where a motion gets keys, beside the key times of the source, the tip and the ends of range and release.
enum class KeyPlaces {
  needed,      ///< Wherever the tolerance needs one, on whole frames where those do.
  wholeFrames, ///< On whole frames alone, as animators key; between them the motion may miss the tolerance.
  everyFrame,  ///< On every frame, as the thesis does, and wherever else the tolerance needs one.
  asClip       ///< On whole frames alone where every key of the clip stands on one, else as needed.
};

} // namespace stretch::rig
