#pragma once

namespace stretch::app {

/// How clips of other files are brought to a character (docs/import_clip.md).
struct ImportSettings {
  double touch = 1.0; ///< 0..1: how far hands are brought to what the source's touch.

  friend bool operator==(const ImportSettings&, const ImportSettings&) = default;
};

} // namespace stretch::app
