#pragma once

#include <cstddef>
#include <string_view>

namespace stretch::ui {

/// Cost that a frame may have.
struct Quality {
  int samples = 4; ///< Samples of anti-aliasing for each pixel; 1 for none. The driver may give fewer.
  int floorShadowPixels = 512; ///< Side of the floor shadow; 0 for no shadow on the floor.
  int floorShadowBlurs = 2;
  int selfShadowPixels = 2048; ///< Side of the shadow map that the character casts on itself; 0 for none.
  bool thinned = false;        ///< Draw a heavy character with fewer triangles, where there are such.

  friend bool operator==(const Quality&, const Quality&) = default;
};

/// From the cheapest (0) to the most beautiful (3).
inline constexpr int highestQualityLevel = 3;
[[nodiscard]] Quality qualityOf(int level);

/// Whether a renderer, as OpenGL names it, is one that draws in software (Mesa's llvmpipe and the like).
[[nodiscard]] bool isSoftwareRenderer(std::string_view renderer);

/// Whether the current context draws in software; false without one.
[[nodiscard]] bool drawsInSoftware();

/// The level to start with: 3 on a graphics card, 1 in software.
[[nodiscard]] int startingQualityLevel();

/// Triangles that a renderer in software poses and draws in a few hundredths of a second; a character that
/// moves is drawn with about so many.
inline constexpr std::size_t movingTriangles = 22'000;

/// Chooses the next level from how long frames take; the shell feeds it one duration for each drawn frame.
class QualityGovernor {
public:
  explicit QualityGovernor(int level) : level_(level) {}

  /// Lowers the level when frames stay above 1/24 s, raises it when they stay far below; returns the level to
  /// draw with. A level that proved too slow is not tried again.
  int frameTook(double seconds);
  [[nodiscard]] int level() const { return level_; }

private:
  int level_ = highestQualityLevel;
  int ceiling_ = highestQualityLevel;
  int slowFrames_ = 0;
  int fastFrames_ = 0;
};

} // namespace stretch::ui
