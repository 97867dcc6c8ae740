#pragma once

#include <filesystem>
#include <vector>

#include "core/anim/clip.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/metrics.h"

namespace stretch::skinning {

/// Reads back what a clip makes of a scene at the times of so many frames: positions in the order that the
/// scene draws them in, nothing else. Without a clip the scene stands still.
[[nodiscard]] MeshSequence framesShown(const Scene& scene, const std::vector<Clip>& clips,
                                       std::size_t frameCount, double framesPerSecond);

/// How far a file that was written from `clip` is from the source, as a reader shows it. An error when it
/// cannot be read.
[[nodiscard]] Result<SequenceMetrics> errorOfFile(const std::filesystem::path& path, const EncodedClip& clip,
                                                  const MeshSequence& source);

} // namespace stretch::skinning
