#pragma once

#include <string>

#include "core/base/result.h"
#include "core/gltf/patch/edits.h"

namespace stretch::test {

/// All that was read of a file, or why it was refused, under a title: of long lists how many numbers they
/// hold and what they add up to, each by its place.
[[nodiscard]] std::string contentsText(const std::string& title, const Result<gltf::Loaded>& file);

} // namespace stretch::test
