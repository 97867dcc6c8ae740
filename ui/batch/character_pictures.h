#pragma once

#include <memory>
#include <vector>

#include "app/document.h"
#include "rig/motion/motion.h"
#include "ui/render/picture.h"

namespace stretch::ui {

/// What pictures of a character show beyond its trails.
struct CharacterLook {
  bool skeleton = false;
  int ghosts = 0; ///< Before and after.
  bool labelled = false;
};

/// What the window shows at these frames, every trail as if it were selected.
[[nodiscard]] std::vector<PictureFrame>
picturesOfCharacter(const app::Document& document, const std::shared_ptr<const rig::MotionState>& motion,
                    const std::vector<double>& frames, const CharacterLook& look);

} // namespace stretch::ui
