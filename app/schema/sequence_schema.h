#pragma once

#include "app/schema/schema.h"
#include "skinning/compress/compress.h"

namespace stretch::app {

/// How a mesh sequence is compressed, but for the moduli of segments, which have a shape of their own.
[[nodiscard]] const Schema<skinning::CompressSettings>& sequenceSchema();

} // namespace stretch::app
