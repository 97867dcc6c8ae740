#include "app/evaluate/keyed_clip.h"

#include <vector>

namespace stretch::app {

rig::RekeyOptions keyingOptions(const Document& document) {
  constexpr double toleranceOfHeight = 1e-4;
  rig::RekeyOptions options;
  // Joints and the stretch of a bone may each miss by this, so a vertex by both; and key times and values are
  // rounded to single precision on their way into the file.
  options.tolerance = 0.33 * toleranceOfHeight * document.body.height;
  return options;
}

Document appliedOnly(Document document) {
  std::erase_if(document.trails, [](const rig::Trail& trail) { return !trail.applied; });
  document.weights.clear();
  return document;
}

} // namespace stretch::app
