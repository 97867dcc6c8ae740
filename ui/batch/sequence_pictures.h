#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
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

} // namespace stretch::ui
