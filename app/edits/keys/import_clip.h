#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/retarget/retarget_figures.h"
#include "app/schema/import_settings.h"
#include "core/base/result.h"

namespace stretch::app {

/// Which clips of another file are wanted.
struct ClipRequest {
  std::filesystem::path file;
  std::string clip; ///< By name, "#index" or the index alone; empty: all of them.
  std::string name; ///< Name that the one clip is to have; empty: the one in its file.
  ImportSettings settings = {};
};

/// A clip of another file, brought to this character.
struct NewClip {
  Clip clip;
  std::string from;                          ///< Its name in the other file, "#2" without one.
  bool isRetargeted = false;                 ///< Else its tracks were copied: the other skeleton is the same.
  std::vector<std::string> left;             ///< Joints, or parts of the body, that the character lacks.
  std::optional<RetargetReport> report = {}; ///< How it moves beside the source, where it is retargeted.
  std::vector<std::string> notes = {};       ///< Lines on what else is left out, of NewClips::warnings.
};

struct NewClips {
  std::vector<NewClip> clips;        ///< At least one.
  std::vector<std::string> warnings; ///< One line each.
};

/// Reads the clips and brings them to the character: copied where joints of the same names stand alike, else
/// retargeted by limbs (docs/import_clip.md). The document is not changed: withNewClips does that, with
/// this one or one that was edited since. An error, one line, for a file that cannot be read, holds no clip
/// or no skeleton, or whose skeleton the character cannot follow. `proceed` is told the share that is done,
/// 0..1, and answers whether to go on: else an error.
[[nodiscard]] Result<NewClips> clipsFromFile(const Document& document, const ClipRequest& request,
                                             const std::function<bool(double)>& proceed = {});

/// Lines that tell of them, the gravest first: in what they are worse than their sources (of
/// several clips with the name, the worst of each before the others), then the warnings.
[[nodiscard]] std::vector<std::string> newsOf(const NewClips& brought);

/// The document with the clips behind its own, under names that no other clip has.
[[nodiscard]] Result<Document> withNewClips(const Document& document, const std::vector<Clip>& clips);

} // namespace stretch::app
