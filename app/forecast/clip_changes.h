#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/document.h"
#include "core/anim/frame_state.h"
#include "core/gltf/json/json_document.h"
#include "skinning/surface_part.h"

namespace stretch::app {

class EvaluationCache;

/// A clip that is looked at: its frames, its tracks.
struct WatchedClip {
  const Scene* scene = nullptr;
  Clip clip;
  std::function<FrameState(double timeSeconds)> at;
  std::shared_ptr<const skinning::SurfacePart> surface = {}; ///< All of the mesh (wholeSurface).
};

/// All of the mesh, for looking at many frames; null where morph targets may move it.
[[nodiscard]] std::shared_ptr<const skinning::SurfacePart> wholeSurface(const Scene& scene);

/// One thing that an edit made worse than the source.
struct ClipChange {
  std::string id; ///< "foot-slide"; see docs/engines.md, Before and after.
  std::string clip;
  std::string limb = {}; ///< Empty: none in particular.
  double source = 0.0;
  double result = 0.0;
  std::string unit; ///< "% of the height", "degrees", "% of the height per second", "keys"
};

/// Changes for the worse by an edit: where the source loops the seam (place, turn, speed); feet that
/// slide while the source's stand; the deepest vertex below the floor; neighbouring keys of rotations in
/// opposite hemispheres. `body`: the document whose limbs, height and floor count; nodes stand under the same
/// indices in both.
[[nodiscard]] std::vector<ClipChange> worseThanSource(const Document& body, int clip,
                                                      const WatchedClip& source, const WatchedClip& result);

/// The clips of a document that these edited tracks change, against what the source has; `cache`: of the
/// document's motion.
[[nodiscard]] std::vector<ClipChange>
worseThanSource(const Document& document, const std::vector<std::pair<int, std::vector<Track>>>& edited,
                EvaluationCache& cache);

/// Clips of a file against those of the same name in the file that it was made from.
struct FileChanges {
  std::vector<ClipChange> worse;
  std::vector<std::string> compared; ///< Names of the clips that both files have.
  std::vector<std::string> added;    ///< Names of clips of the result alone: not compared.
  std::vector<std::string> gone;     ///< Likewise of the source alone.
};

/// Compares the clips of two files. Error: the one is not made from the other; no clip is in both.
[[nodiscard]] Result<FileChanges> worseThanFile(const Document& result, const Document& source);

[[nodiscard]] gltf::Json changesToJson(const std::vector<ClipChange>& changes);
/// Prints them as lines of text.
void printChanges(const gltf::Json& changes);

} // namespace stretch::app
