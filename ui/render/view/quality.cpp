#include "ui/render/view/quality.h"

#include <algorithm>
#include <string_view>

#include <epoxy/gl.h>

namespace stretch::ui {

Quality qualityOf(int level) {
  switch (level) {
  case 0:
    return {1, 0, 0, 0};
  case 1:
    return {1, 192, 1, 0};
  case 2:
    return {4, 256, 2, 0};
  default:
    return {};
  }
}

bool drawsInSoftware() {
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = text == nullptr ? std::string_view{} : std::string_view(text);
  for (const std::string_view name : {"llvmpipe", "softpipe", "SWR", "swrast", "Software"}) {
    if (renderer.find(name) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

int startingQualityLevel() {
  return drawsInSoftware() ? 1 : highestQualityLevel;
}

int QualityGovernor::frameTook(double seconds) {
  constexpr double slowSeconds = 1.0 / 24.0;
  constexpr double fastSeconds = 1.0 / 90.0;
  constexpr int slowFramesToLower = 6;
  constexpr int fastFramesToRaise = 90;
  slowFrames_ = seconds > slowSeconds ? slowFrames_ + 1 : 0;
  fastFrames_ = seconds < fastSeconds ? fastFrames_ + 1 : 0;
  if (slowFrames_ >= slowFramesToLower && level_ > 0) {
    ceiling_ = --level_;
    slowFrames_ = 0;
  } else if (fastFrames_ >= fastFramesToRaise && level_ < ceiling_) {
    ++level_;
    fastFrames_ = 0;
  }
  return level_;
}

} // namespace stretch::ui
