#pragma once

#include <string>

#include "app/document.h"

namespace stretch::test {

struct WantedTrail {
  std::string limb = "left-arm";
  double startFrame = 0.0;
  double endFrame = 10.0;
  double scale = 2.0;
  bool connected = true;
};

/// The document with an exaggerated trail more.
[[nodiscard]] app::Document withNewTrail(const app::Document& document, const WantedTrail& wanted);

} // namespace stretch::test
