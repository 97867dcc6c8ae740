#pragma once

#include "assets/dummy/glb_writer.h"

namespace stretch::assets {

/// The bundled character: a toon boxer with the clip of a one-two punch.
[[nodiscard]] Character makeDummy();

} // namespace stretch::assets
