#include "ui/render/overlay/overlay.h"

namespace stretch::ui {

void Overlay::add(const Overlay& other) {
  lines.insert(lines.end(), other.lines.begin(), other.lines.end());
  markers.insert(markers.end(), other.markers.begin(), other.markers.end());
  arrows.insert(arrows.end(), other.arrows.begin(), other.arrows.end());
}

} // namespace stretch::ui
