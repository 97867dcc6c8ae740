#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// How the curve of an offset passes a key (docs/controllers.md, Keys).
enum class KeyInterpolation { automatic, flat, linear, stepped, free };

/// Offset of a controller, or value of an attribute, keyed at one frame.
struct OffsetKey {
  double frame = 0.0;
  Vec3 move{0.0};     ///< World units, along the axes of the controller's carrier.
  Vec3 turn{0.0};     ///< Rotation vector along the same axes: axis times angle in radians.
  double value = 0.0; ///< Value of an attribute; a controller has none.
  KeyInterpolation interpolation = KeyInterpolation::automatic;
  Vec3 moveSlope{0.0}; ///< For each frame, of a free key.
  Vec3 turnSlope{0.0};
  double valueSlope = 0.0;

  friend bool operator==(const OffsetKey&, const OffsetKey&) = default;
};

/// The offset keys of one controller, or of one attribute, in one clip.
struct Adjustment {
  std::string controller; ///< Controller::id or Attribute::id.
  int clip = 0;           ///< Index into the file's animations.
  /// Outside of it, and at its ends unless a key stands there, nothing is offset and an attribute has its
  /// standard value. Without it the first and the last key are held to the ends of the clip.
  std::optional<Vec2> rangeFrames;
  std::vector<OffsetKey> keys; ///< Ascending by frame, at most one for each frame, inside the range.

  friend bool operator==(const Adjustment&, const Adjustment&) = default;
};

} // namespace stretch::rig
