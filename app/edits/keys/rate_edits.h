#pragma once

#include "app/document.h"

namespace stretch::app {

// The rate in which the frames of a clip are counted: its own, or one of the user's choice. Keys stay where
// they are, and trails where they were in time; only the numbers of frames are others.

/// The document with a clip worked on at this rate, which is above 0: ranges, spheres and releases of its
/// trails, and ranges of its weight, are counted in it. Its own rate forgets the choice.
[[nodiscard]] Document workAtRate(const Document& document, int clip, double framesPerSecond);

/// The rate that the clip's keys suggest.
[[nodiscard]] double ownRate(const Document& document, int clip);

/// Works on every clip at this rate: the option --fps.
void setFramesPerSecond(Document& document, double framesPerSecond);

/// For reading: the clips that have a rate of the user's choice are counted in it, and what is in the
/// document is left alone.
void countInChosenRates(Document& document);

} // namespace stretch::app
