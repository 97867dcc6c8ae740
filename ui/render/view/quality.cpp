#include "ui/render/view/quality.h"

#include <algorithm>
#include <array>

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

bool isSoftwareRenderer(std::string_view renderer) {
  constexpr std::array<std::string_view, 5> names{"llvmpipe", "softpipe", "SWR", "swrast", "Software"};
  return std::ranges::any_of(
      names, [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

bool drawsInSoftware() {
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return text != nullptr && isSoftwareRenderer(text);
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
