#pragma once

#include "app/document.h"

namespace stretch::bench {

/// The character with one clip of this many frames, keyed at each of them: its first clip there and back,
/// again and again. Opened from a file, as an artist's would be.
[[nodiscard]] app::Document withLongClip(const app::Document& document, int frames);

/// A connected trail of a limb over [start, end], frames.
void addTrail(app::Document& document, std::size_t limb, double start, double end);

} // namespace stretch::bench
