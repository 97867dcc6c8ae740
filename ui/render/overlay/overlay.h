#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "core/math/types.h"

namespace stretch::ui {

// Marks that are drawn over the character with sizes of the screen: plain values, made by pure functions
// (skeleton_drawing, trail_drawing) and drawn by the overlay renderer. Colours are sRGB with opacity; sizes
// are points.

/// How an overlay meets the surface: what lies behind the character keeps `hiddenOpacity` of its opacity.
enum class OverlayDepth {
  faded, ///< Behind the surface still visible, weaker.
  onTop, ///< Always in full.
};

struct LinePoint {
  Vec3 world{0.0};
  glm::vec4 color{1.0F};
  float widthPoints = 2.0F;
};

/// A line of constant width on the screen through points; round joints and ends.
struct Polyline {
  std::vector<LinePoint> points;
  float dashPoints = 0.0F; ///< Length of a dash; 0 for a solid line.
  float gapPoints = 0.0F;
  OverlayDepth depth = OverlayDepth::faded;
  bool outlined = false; ///< With an edge of opposite lightness (Palette::outline).
};

enum class MarkerShape { disc, sphere, ring, diamond, tick };

/// A mark of constant size on the screen.
struct Marker {
  Vec3 world{0.0};
  MarkerShape shape = MarkerShape::disc;
  float radiusPoints = 4.0F;
  glm::vec4 fill{1.0F};
  glm::vec4 edge{0.0F};
  float edgePoints = 0.0F;
  double turnRadians = 0.0; ///< Direction of a tick: the one across it, from the screen's right towards its
                            ///< top.
  OverlayDepth depth = OverlayDepth::faded;
};

/// A line with an arrowhead, of constant size on the screen, shaded as a solid.
struct Arrow {
  Vec3 from{0.0};
  Vec3 to{0.0};
  glm::vec4 color{1.0F};
  float widthPoints = 3.0F;
  float headPoints = 13.0F; ///< Length of the head.
};

/// Everything of one frame. Lines are drawn first, in order; then marks, the farthest first; then arrows.
struct Overlay {
  std::vector<Polyline> lines;
  std::vector<Marker> markers;
  std::vector<Arrow> arrows;

  void add(const Overlay& other); ///< Appends what the other holds.
};

} // namespace stretch::ui
