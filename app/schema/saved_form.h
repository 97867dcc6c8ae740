#pragma once

#include "rig/rekey/key_places.h"

namespace stretch::app {

/// How a stretch is told in a file (docs/rig.md, Bind leaves and Corners).
enum class StretchForm {
  scale,       ///< By the scale of bind leaves.
  translation, ///< By translations alone: the limb keeps its thickness, the list of joints stays.
  volume       ///< By translations of corners: the places that scale gives.
};

struct SavedForm {
  StretchForm form = StretchForm::scale;
  int influences = 8; ///< Most of a vertex, where the form is volume.
  rig::KeyPlaces keys = rig::KeyPlaces::needed;

  friend bool operator==(const SavedForm&, const SavedForm&) = default;
};

} // namespace stretch::app
