#pragma once

#include <string>

#include "tests/support/core/glb_builder.h"

namespace stretch::test {

/// A picture of one red pixel, as a URI.
inline constexpr const char* onePixelUri =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";

/// Two sheets of two triangles each, apart, with a morph target that lifts one edge, moved up and down by the
/// clip "flutter": "sail" of unlit cloth with the picture and two sets of texture coordinates, "flag" painted
/// by vertices.
[[nodiscard]] GlbBuilder twoSheets(const std::string& pictureUri = onePixelUri);

} // namespace stretch::test
