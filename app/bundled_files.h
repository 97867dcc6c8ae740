#pragma once

#include <array>

namespace stretch::app {

/// A clip that comes with the program.
struct BundledClip {
  const char* file;    ///< In the bundled folder.
  const char* picture; ///< Beside it.
  const char* name;
  const char* line;      ///< Line that says what can be tried on it.
  const char* commandId; ///< Opens it.
};

[[nodiscard]] const std::array<BundledClip, 3>& bundledClips();

} // namespace stretch::app
