#pragma once

#include <string>

#include "tests/support/temporary_folder.h"

namespace stretch::test {

/// The bundled boxer with three cameras in the folder: "Side" at its left, perspective, 4 m away, 0.6 radians
/// high, 16:9; "Front", likewise, which the clip's frames 0 to 27 carry from the left to the front; "Flat",
/// orthographic, 2 m high, from the front. Answers the file's path.
[[nodiscard]] std::string boxerWithCameras(const TemporaryFolder& folder);

} // namespace stretch::test
