#include "skinning/export/read_back.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/anim/frame_state.h"
#include "core/anim/sampling.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "skinning/linear_blend_skinning.h"
#include "skinning/sequence/topology.h"

namespace stretch::skinning {

MeshSequence framesShown(const Scene& scene, const std::vector<Clip>& clips, std::size_t frameCount,
                         double framesPerSecond) {
  std::vector<std::vector<Vec3>> positions(frameCount);
  tbb::parallel_for(std::size_t{0}, frameCount, [&](std::size_t k) {
    const double seconds = static_cast<double>(k) / framesPerSecond;
    Pose pose = clips.empty() ? restPose(scene) : samplePose(scene, clips.front(), seconds);
    positions[k] = skinnedPositions(scene, frameOf(scene, std::move(pose), seconds));
  });
  MeshSequence sequence;
  sequence.framesPerSecond = framesPerSecond;
  sequence.vertexCount = positions.empty() ? 0 : positions.front().size();
  for (const std::vector<Vec3>& frame : positions) {
    sequence.positions.insert(sequence.positions.end(), frame.begin(), frame.end());
  }
  return sequence;
}

Result<SequenceMetrics> errorOfFile(const std::filesystem::path& path, const EncodedClip& clip,
                                    const MeshSequence& source) {
  const auto loaded = gltf::loadAsItStands(path, gltf::Pictures::headers);
  if (!loaded) {
    return loaded.error();
  }
  const MeshSequence shown =
      framesShown(*loaded->scene, loaded->clips, source.frameCount(), source.framesPerSecond);
  if (shown.vertexCount != clip.places.size()) {
    return Error{
        fmt::format("{} vertices were written and {} are read", clip.places.size(), shown.vertexCount),
        path.string(), "report this"};
  }
  const std::vector<std::uint32_t> used = usedVertices(source.triangles);
  MeshSequence inOrder = source; // What no triangle draws stays as it is.
  for (std::size_t v = 0; v < clip.places.size(); ++v) {
    const std::uint32_t place = clip.places[v];
    const bool isDrawn = std::ranges::binary_search(used, place);
    for (std::size_t k = 0; isDrawn && k < source.frameCount(); ++k) {
      inOrder.frame(k)[place] = shown.frame(k)[v];
    }
  }
  return distancesOf(source, inOrder);
}

} // namespace stretch::skinning
