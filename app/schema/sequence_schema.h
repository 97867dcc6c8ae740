#pragma once

#include "app/schema/schema.h"
#include "skinning/compress/compress.h"
#include "skinning/export/encode_gltf.h"

namespace stretch::app {

/// How a mesh sequence is compressed, but for the moduli of segments and a given skeleton, which have shapes
/// of their own.
[[nodiscard]] const Schema<skinning::CompressSettings>& sequenceSchema();

/// How the clip that was made of it is written.
[[nodiscard]] const Schema<skinning::EncodeSettings>& clipSchema();

} // namespace stretch::app
