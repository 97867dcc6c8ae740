#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ui/render/overlay/overlay.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

/// A key of a trail that can be dragged.
struct TrailSphere {
  Vec3 world{0.0};
  bool selected = false;
  bool hovered = false;
  bool nearby = true; ///< Near the playhead; others are drawn smaller.
};

/// Picture of a trail at one moment. Paths have one point for each sample, evenly in time; world space.
struct TrailPicture {
  std::vector<Vec3> original;    ///< The limb's end as the clip moves it.
  std::vector<Vec3> exaggerated; ///< Path as the trail moves it; empty for a trail that shows the original
                                 ///< only.
  std::vector<glm::vec4> exaggeratedColors; ///< One for each sample (speed or stretch as colour); empty: the
                                            ///< style's colour.
  std::size_t samplesPerFrame = 1;          ///< A frame tick stands at every so many samples; 0 for no ticks.
  std::optional<double> currentSample; ///< Place of the playhead, in samples; nothing when it is outside the
                                       ///< range.
  std::vector<TrailSphere> spheres;
  std::optional<Vec3> pivot; ///< Point that the path grows from.
  std::optional<Vec3> tip;   ///< The farthest point of the exaggerated path.
  /// Samples before and after the current one that are drawn in full; farther ones fade out. Nothing: all.
  std::optional<double> windowSamples;
};

struct TrailStyle {
  glm::vec4 originalColor = rgba(okabe::skyBlue);
  glm::vec4 exaggeratedColor = rgba(okabe::orange);
  glm::vec4 currentColor = rgba(0xFFFFFF);
  float originalWidthPoints = 1.5F;
  float exaggeratedWidthPoints = 3.5F;
  float sphereRadiusPoints = 7.0F;
  bool emphasised = true; ///< False for a trail that is not the selected one: thinner and quieter.
};

/// The trail as overlay: original thin and dashed, exaggerated thick; ticks across the original and dots on
/// the exaggerated path at every frame, so that their spacing shows the speed; the current frame marked on
/// both; spheres larger, the selected and hovered ones larger still, those far from the playhead or close
/// together on the screen smaller; through those that nobody picked the character shows. Paths of fewer than
/// two points are drawn as a dot.
[[nodiscard]] Overlay drawTrail(const View& view, const TrailPicture& trail, const TrailStyle& wanted = {});

/// Point of a path at a fractional sample, clamped to its ends; the path must not be empty.
[[nodiscard]] Vec3 pointOfPath(const std::vector<Vec3>& path, double sample);

} // namespace stretch::ui
