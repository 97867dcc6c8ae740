#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace stretch::interchange {

/// Facts of an FBX that the library does not tell, found in its bytes without taking them apart.
struct FbxHead {
  bool hasTangents = false;    ///< Some curve bends between its keys.
  bool hasRepetition = false;  ///< Some curve goes on, other than held, outside its keys.
  std::size_t layersOnTop = 0; ///< Animation layers beyond the first of each take.
};

/// Error for what the library does not read: big endian, and versions before 7.1.
[[nodiscard]] Result<FbxHead> fbxHeadOf(std::span<const std::uint8_t> bytes);

/// Frames that a BVH says and those that it holds.
struct BvhFrames {
  std::size_t said = 0;
  std::size_t held = 0;
};
[[nodiscard]] BvhFrames bvhFramesOf(std::span<const std::uint8_t> bytes);

} // namespace stretch::interchange
