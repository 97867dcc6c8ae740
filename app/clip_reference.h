#pragma once

#include <optional>
#include <string>

namespace stretch::app {

/// Places of the images of a reference in the view, the character in front of them.
enum class ReferencePlace { behind, left, right };

/// A series of images that is looked at beside the work: frames of a film, drawings, a single sheet.
struct ReferenceImages {
  std::string file = {};                      ///< First image of the series; empty: none.
  double startFrame = 0.0;                    ///< Frame of the clip that shows it.
  std::optional<double> imagesPerSecond = {}; ///< Nothing: one for each frame of the clip.
  ReferencePlace place = ReferencePlace::behind;
  double size = 1.0; ///< 1: as high as the view; beside it half as high.
  double opacity = 1.0;

  friend bool operator==(const ReferenceImages&, const ReferenceImages&) = default;
};

/// A sound that the motion is timed to.
struct ReferenceSound {
  std::string file = {};   ///< Empty: none.
  double startFrame = 0.0; ///< Frame of the clip at which it begins.
  double volume = 1.0;     ///< 0..1.

  friend bool operator==(const ReferenceSound&, const ReferenceSound&) = default;
};

/// Images and a sound beside a clip, to animate after. Kept in recipes and with the user's settings of the
/// file, never in the file itself.
struct Reference {
  int clip = 0;
  ReferenceImages images = {};
  ReferenceSound sound = {};

  friend bool operator==(const Reference&, const Reference&) = default;
};

} // namespace stretch::app
