#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/reach/bind_places.h"

namespace stretch::app {

/// Parts of the mesh that stand at a limb's end in the bind pose but hang on the trunk, so that they stay
/// where they are when the limb stretches: one line each, which names them. `moved`: indexed by node, whether
/// the limb moves it; `places`: of the document's scene.
[[nodiscard]] std::vector<std::string> partsLeftBehind(const Document& document, const rig::Limb& limb,
                                                       const std::vector<bool>& moved,
                                                       const rig::BindPlaces& places);

} // namespace stretch::app
