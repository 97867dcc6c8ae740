#pragma once

#include <string>

#include "core/scene/scene.h"

namespace stretch::test {

/// Side of the tiles that pictures are compared by, pixels.
inline constexpr int tileSide = 16;

/// How far two pictures of one size are apart.
struct PictureDifference {
  double mean = 0.0; ///< Of a channel, 0..255.
  int worstTile = 0; ///< Pixels that are far off in the worst tile.
  int worstLeft = 0; ///< Where that is.
  int worstTop = 0;
};
[[nodiscard]] PictureDifference differenceBetween(const Image& a, const Image& b);

/// Panels stand on whole pixels, so that drivers draw them alike; edges of what is seen in perspective
/// differ.
enum class PictureKind { scene, panel };

/// How many pixels of a tile may be far off before a picture counts as another one: of a panel a
/// thirty-second of them, of a scene a sixteenth where the current context draws in software, as for the
/// baselines, else an eighth.
[[nodiscard]] int mostFarPixels(PictureKind kind);

/// More than what drivers make of the same picture: on average over one step of 255 for each channel, or over
/// `mostFar` pixels of a tile far off, as when a row of text moves by a pixel or two.
[[nodiscard]] bool isVisible(const PictureDifference& difference, int mostFar = tileSide * tileSide / 8);

/// Compares a picture with tests/render/baselines/NAME.png. When they visibly differ, or without a baseline,
/// the picture is written to `render-differences` beside the test program, and the answer says where and what
/// to do; empty when equal.
[[nodiscard]] std::string differenceFromBaseline(const std::string& name, const Image& picture,
                                                 PictureKind kind = PictureKind::scene);

} // namespace stretch::test
