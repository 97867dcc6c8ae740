#pragma once

#include <memory>
#include <vector>

#include "app/document.h"
#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "rig/motion/motion.h"
#include "ui/render/picture.h"

namespace stretch::ui {

/// Frames of a mesh sequence for the maker of pictures: one scene, whose morph targets are the frames.
struct SequencePictures {
  Scene scene;
  std::vector<PictureFrame> pictures; ///< One for each frame that was asked for.
  Camera camera;                      ///< Sees all of them.
};

/// `over`: a second sequence that is drawn over the first one, which is then red and the second green; null
/// for none. An error when it does not have the same vertices and frames, or when a frame is not there.
[[nodiscard]] Result<SequencePictures> picturesOfSequence(const MeshSequence& sequence,
                                                          const MeshSequence* over,
                                                          const std::vector<double>& frames,
                                                          const PictureOptions& options);

/// What pictures of a character show beyond its trails.
struct CharacterLook {
  bool skeleton = false;
  int ghosts = 0; ///< Before and after.
  bool labelled = false;
};

/// What the window shows at these frames, every trail as if it were selected.
[[nodiscard]] std::vector<PictureFrame>
picturesOfCharacter(const app::Document& document, const std::shared_ptr<const rig::MotionState>& motion,
                    const std::vector<double>& frames, const CharacterLook& look);

} // namespace stretch::ui
