#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "app/session.h"

namespace stretch::app {

[[nodiscard]] bool hasClip(const Document& document, int clip);

/// The clip's last frame, >= 0; 0 without such a clip.
[[nodiscard]] double lastFrame(const Document& document, int clip);

/// Frames at which these limbs' joints have keys, in order, each once; those of all tracks when no limb is
/// named.
[[nodiscard]] std::vector<double> keyFrames(const Document& document, int clip,
                                            const std::vector<std::string>& limbIds);
/// Frames of keys of the viewed clip as it is shown: with the keys of applied trails.
[[nodiscard]] std::vector<double> shownKeyFrames(Session& session, const std::vector<std::string>& limbIds);

} // namespace stretch::app
