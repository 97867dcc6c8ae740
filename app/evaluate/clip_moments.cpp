#include "app/evaluate/clip_moments.h"

namespace stretch::app {

std::vector<rig::Moment> momentsOf(const Document& document, int clip) {
  return rig::momentsOf(*document.scene, clipOf(document, clip), document.body, document.chains);
}

} // namespace stretch::app
