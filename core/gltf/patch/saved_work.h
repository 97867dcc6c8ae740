#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/gltf/patch/journal.h"
#include "core/gltf/source/problems.h"

namespace stretch::gltf {

/// Puts the program's own data into the extras of a patched file, with everything that gives the source back.
/// `journal` has seen all changes but those of the buffers, which `source` still shows as they were. Answers
/// the JSON. Error: the file's own extras leave no place.
/// `added`: the record of files that were added to the source; null without them.
[[nodiscard]] Result<Json> withSavedWork(const Source& source, const Json& work, Journal journal, Json added);

/// A file of ours taken apart again.
struct Restored {
  Source source;
  Json work;
  std::vector<AddedFile> added;
};

/// Nothing for a file without saved work, and, with a warning, for one that another program changed since.
/// The structure has to be validated, the buffers read; what comes back is as untrusted as the file.
[[nodiscard]] std::optional<Restored> restoreSource(const Source& saved, Problems& problems);

} // namespace stretch::gltf
