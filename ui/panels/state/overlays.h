#pragma once

namespace stretch::ui {

/// Engine whose shading the mesh has: exact, or normals by the plain joint matrix (docs/engines.md).
enum class ShadeAs { exact, three, godot };

/// Switches of what the viewport draws over the character.
struct ViewportOverlays {
  bool controllers = false; ///< Else only while one is selected.
  bool skeleton = false;
  bool wire = false;
  bool jointNames = false;
  bool heatMap = false; ///< Stretch of the mesh as colour.
  ShadeAs shadeAs = ShadeAs::exact;
  bool weights = false; ///< Weights of one joint (WeightView), as colour.
  bool ghosts = false;
  bool grid = true;
  bool viewCube = true;
  bool reference = true; ///< Images beside the clip (app::ReferenceImages).
  bool trailFrameNumbers = false;
  bool trailTicks = true;
  bool safeFrame = false;              ///< The part of the picture that every screen shows.
  bool sideBySide = false;             ///< Original beside exaggerated.
  bool trailsOnlyWhenSelected = false; ///< Else every visible trail is drawn.
  int ghostsBefore = 3;
  int ghostsAfter = 3;
  int ghostStepFrames = 2;
  bool trailWindow = false; ///< Draw only `trailWindowFrames` around the playhead.
  int trailWindowFrames = 12;
  float trailThickness = 3.0F; ///< Design pixels.
  float sphereSize = 7.0F;     ///< Radius, design pixels.
  double trailIncrement = 0.5; ///< Frames between drawn samples.

  friend bool operator==(const ViewportOverlays&, const ViewportOverlays&) = default;
};

} // namespace stretch::ui
