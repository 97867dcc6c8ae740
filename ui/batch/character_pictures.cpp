#include "ui/batch/character_pictures.h"

#include <fmt/core.h>

#include "app/evaluate/evaluate.h"
#include "ui/viewport/assemble_picture.h"

namespace stretch::ui {

std::vector<PictureFrame> picturesOfCharacter(const app::Document& document,
                                              const std::shared_ptr<const rig::MotionState>& motion,
                                              const std::vector<double>& frames, const CharacterLook& look) {
  ViewportOverlays overlays;
  overlays.skeleton = look.skeleton;
  overlays.ghosts = look.ghosts > 0;
  overlays.ghostsBefore = look.ghosts;
  overlays.ghostsAfter = look.ghosts;
  PictureSelection selection;
  selection.everyTrail = true;
  const ShownTrails trails =
      shownTrails(motion, motion->trails.empty() ? std::vector<app::TrailPaths>{}
                                                 : app::trailPaths(document, *motion, pathSamplesPerFrame));
  const SceneMeasures measures = measuresOf(*document.scene, BoundsSampler(*document.scene));
  std::vector<PictureFrame> pictures;
  for (const double frame : frames) {
    const FrameState pose = app::evaluate(document, *motion, frame / motion->framesPerSecond);
    pictures.push_back({assemblePicture({document, *motion, trails, frame, pose, measures}, selection,
                                        overlays, paletteOf(ThemeKind::dark)),
                        look.labelled ? fmt::format("frame {:g}", frame) : std::string()});
  }
  return pictures;
}

} // namespace stretch::ui
