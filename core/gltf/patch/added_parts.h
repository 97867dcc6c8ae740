#pragma once

#include <vector>

#include "core/gltf/patch/journal.h"
#include "core/gltf/source/problems.h"

namespace stretch::gltf {

// Parts that saving and restoring need of the files that were added to a source.

/// Appends the files through the journal; answers their bytes, which belong into that buffer from `start`, a
/// multiple of 4, and are a multiple of 4 themselves.
[[nodiscard]] Bytes addFiles(const std::vector<AddedFile>& files, std::size_t buffer, std::size_t start,
                             Journal& journal);

/// Record that gives the files back from a source that holds them: all but their bytes, and where those lie.
/// Null without files.
[[nodiscard]] Json addedRecord(const std::vector<AddedFile>& files, std::size_t buffer, std::size_t start);

/// The files of a record, out of the source that holds them. One that is damaged is left out, with a warning.
[[nodiscard]] std::vector<AddedFile> addedFromRecord(const Source& saved, const Json& record,
                                                     Problems& problems);

} // namespace stretch::gltf
