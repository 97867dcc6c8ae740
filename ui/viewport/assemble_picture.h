#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/render/picture/picture_content.h"
#include "ui/viewport/shown/shown_controllers.h"
#include "ui/viewport/shown/shown_trails.h"

namespace stretch::ui {

// The one place that says what is drawn of a character. The window and the verb `render` both ask here, so
// that a picture on the disk shows what the window showed.

/// Subject of a picture: a moment of a document in motion.
struct PictureSubject {
  const app::Document& document;
  const rig::MotionState& motion;
  const ShownTrails& trails;
  double frame = 0.0;
  const FrameState& pose; ///< The character there: exaggerated, or as the source has it.
  SceneMeasures measures;
};

/// Everything the artist picked out, and what lies under the mouse.
struct PictureSelection {
  std::vector<std::string> limbs; ///< Limb ids.
  int trail = 0;                  ///< Trail id; 0 none.
  std::vector<double> spheres;    ///< Frames, of that trail; the last one carries the axis handles.
  bool everyTrail = false;        ///< Nobody selects: each trail is shown as the selected one is.
  std::string hoveredLimb = {};
  int hoveredTrail = 0;
  std::optional<double> hoveredSphere = std::nullopt;
  std::optional<std::size_t> hoveredAxis = std::nullopt;
  std::vector<ControllerPicture> controllers = {};
  std::optional<ControllerHandles> controllerHandles = std::nullopt;
  std::optional<HandlePart> activeHandle = std::nullopt; ///< Part of these under the mouse.
  NodeIndex weightsOf = NodeIndex::none;         ///< Joint whose weights colour the mesh; none: nothing does.
  std::optional<double> tipFrame = std::nullopt; ///< Frame of a trail's tip: the pose there is a ghost.
};

[[nodiscard]] PictureContent assemblePicture(const PictureSubject& subject, const PictureSelection& selection,
                                             const ViewportOverlays& overlays, const Palette& palette);

/// The character alone in the same look: what stands beside the work for comparison.
[[nodiscard]] PictureContent assembleBare(const PictureSubject& subject, const PictureSelection& selection,
                                          const ViewportOverlays& overlays, const Palette& palette);

/// Puts controllers or locators over it, and what they are taken by.
void addHandles(const PictureSelection& selection, PictureContent& content);

/// Axis handles at the last selected sphere; nothing when none is selected.
[[nodiscard]] std::optional<AxisHandles> handlesOf(const ShownTrails& trails, int selectedTrail,
                                                   const std::vector<double>& selectedSpheres);

[[nodiscard]] Palette paletteOf(ThemeKind theme);

/// A colour of the theme (Dear ImGui's packed sRGB) as shaders take it.
[[nodiscard]] glm::vec4 toColour(ImU32 colour);

/// The other way, opaque.
[[nodiscard]] ImU32 packed(const glm::vec4& colour);

} // namespace stretch::ui
