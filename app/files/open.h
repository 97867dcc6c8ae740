#pragma once

#include <filesystem>

#include "app/document.h"

namespace stretch::app {

/// Opens a file, finds its limbs, and takes up the work that a file of ours carries.
[[nodiscard]] Result<Document> openDocument(const std::filesystem::path& path,
                                            gltf::Tolerance tolerance = gltf::Tolerance::refuse);

} // namespace stretch::app
