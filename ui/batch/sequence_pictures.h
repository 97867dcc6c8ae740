#pragma once

#include <memory>
#include <vector>

#include "app/document.h"
#include "core/base/result.h"
#include "rig/motion/motion.h"
#include "ui/panels/state/overlays.h"
#include "ui/render/picture/picture.h"
#include "ui/viewport/sequence_picture.h"
#include "ui/viewport/shown/shown_reference.h"

namespace stretch::ui {

/// Frames of a mesh sequence for the maker of pictures: one scene, and each picture a shape of it.
struct SequencePictures {
  std::shared_ptr<const SequencePicture> drawing; ///< Holds the scene.
  std::vector<PictureFrame> pictures;             ///< One for each frame that was asked for.
  Camera camera;                                  ///< Sees all of them.
};

/// Extras that are drawn of a sequence, beyond the look.
struct SequenceExtras {
  bool bones = false;    ///< Over the mesh; the content then needs its analysis.
  std::string name = {}; ///< Begins the label of each picture; may be empty.
};

/// An error when the frames of a result are not those of the sequence, or when a frame is not there.
[[nodiscard]] Result<SequencePictures> picturesOfSequence(const SequenceContent& content,
                                                          const app::SequenceView& view,
                                                          const SequenceExtras& extras,
                                                          const std::vector<double>& frames,
                                                          const PictureOptions& options);

/// The four stages of the method beside each other, a row for each frame: the mesh as it was simulated, its
/// skeleton, the segments by their weights, the mesh as the stretched bones move it. The content has a
/// result.
[[nodiscard]] Result<Image> drawStages(const SequenceContent& content, const std::vector<double>& frames,
                                       const PictureOptions& options);

/// Looks of a character in pictures, beyond its trails.
struct CharacterLook {
  bool skeleton = false;
  bool trails = true;                    ///< Drawn; what they do to the character is seen either way.
  int ghosts = 0;                        ///< Before and after.
  NodeIndex weightsOf = NodeIndex::none; ///< Joint whose weights colour the mesh.
  bool labelled = false;
  ShadeAs shadeAs = ShadeAs::exact;
  const SceneCamera* camera = nullptr; ///< One of the file, looked through; null: none.
  Backdrops backdrops = {};            ///< Reference images behind the character; empty: none.
};

/// Pictures of the window at these frames, every trail as if it were selected.
[[nodiscard]] std::vector<PictureFrame>
picturesOfCharacter(const app::Document& document, const std::shared_ptr<const rig::MotionState>& motion,
                    const std::vector<double>& frames, const CharacterLook& look);

} // namespace stretch::ui
