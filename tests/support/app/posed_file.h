#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "core/gltf/json/json.h"
#include "core/math/types.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

namespace stretch::test {

// From a recipe on the command line to the saved file, read back.

inline constexpr const char* posedCharacter = STRETCH_SOURCE_DIR "/assets/dummy.glb";

/// A pose of the library: the left hand raised to the front.
inline constexpr const char* raisedHandPose = R"({"version": 1, "name": "Guard", "controllers": [
    {"controller": "left-hand", "place": [0.3, 1.6, 0.4], "turn": [0, 0, 0, 1], "from_base": [0.2, 0.3, 0.7]}]})";

struct Posed {
  VerbAnswer answer;
  std::string path;
};

/// The verb `pose` with a recipe, on the bundled character or on another file.
[[nodiscard]] Posed pose(const TemporaryFolder& folder, const gltf::Json& recipe,
                         const std::vector<std::string>& more = {}, const std::string& file = posedCharacter);

/// A file that opens without an error.
[[nodiscard]] app::Document openedFile(const std::string& path);

/// Where the file's own clip, the first, has a limb's end and a node at a frame.
[[nodiscard]] Vec3 endOf(const app::Document& document, const std::string& limb, double frame);
[[nodiscard]] Vec3 nodeOf(const app::Document& document, NodeIndex node, double frame);
[[nodiscard]] Mat4 worldOf(const app::Document& document, NodeIndex node, double frame);

} // namespace stretch::test
