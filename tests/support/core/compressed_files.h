#pragma once

#include "tests/support/core/glb_builder.h"

namespace stretch::test {

/// The arm of armBuilder under a tube with 24 rings of 12 vertices, as triangles with normals and texture
/// coordinates: enough for codecs to have something to pack. Its normals are normalised bytes and its
/// rotations normalised shorts (KHR_mesh_quantization).
[[nodiscard]] GlbBuilder tubeBuilder();

/// Whether values are rounded for the packing, as exporters do, or kept as they are.
enum class Filters { none, all };

/// Every buffer view packed by EXT_meshopt_compression, before a fallback buffer without bytes; nothing else
/// is left in the binary.
[[nodiscard]] GlbBuilder packedByMeshopt(const GlbBuilder& plain, Filters filters);

/// Sequential keeps the order of the vertices.
enum class DracoMethod { sequential, edgebreaker };

/// The first mesh of a tubeBuilder packed by KHR_draco_mesh_compression, its data behind all others.
[[nodiscard]] GlbBuilder packedByDraco(const GlbBuilder& plain, DracoMethod method);

} // namespace stretch::test
