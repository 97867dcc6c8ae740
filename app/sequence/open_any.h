#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "app/document.h"
#include "app/sequence/sequence_document.h"

namespace stretch::app {

/// Document of the kind that a path turned out to be.
using Opened = std::variant<Document, SequenceDocument>;

/// Whether the paths can only name a mesh sequence: a folder, a mesh or a cache, or two of them.
[[nodiscard]] bool namesSequence(const std::vector<std::filesystem::path>& paths);

/// Whether a folder looks like one: several meshes, or the log of a particle simulation.
[[nodiscard]] bool holdsSequence(const std::filesystem::path& folder);

/// Opens a character or a mesh sequence. What breaks the specification and can be read all the same is a
/// warning of the document. A glTF is a sequence when all that its clips move are the morph
/// targets of meshes without a skin.
[[nodiscard]] Result<Opened> openAny(const std::vector<std::filesystem::path>& paths,
                                     const skinning::Progress& progress = {});

} // namespace stretch::app
