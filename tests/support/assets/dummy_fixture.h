#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "assets/dummy/glb_writer.h"

namespace stretch::assets {

/// The character as the program makes it; made once.
[[nodiscard]] const Character& madeDummy();

[[nodiscard]] std::filesystem::path committedDummyPath();
[[nodiscard]] std::vector<std::uint8_t> committedDummy();

/// Bends one joint about the axis of its own bend, straightening being negative, and moves the vertices with
/// it.
void bendJoint(SkinnedMesh& mesh, const std::vector<Joint>& skeleton, int joint, double degrees);

} // namespace stretch::assets
