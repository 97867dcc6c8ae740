#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/file.h"

namespace stretch::gltf {

using stretch::Bytes;

/// A part of a binary glTF file.
struct GlbChunk {
  static constexpr std::uint32_t jsonType = 0x4E4F534A;   ///< "JSON"
  static constexpr std::uint32_t binaryType = 0x004E4942; ///< "BIN"

  std::uint32_t type = 0;
  Bytes bytes;

  friend bool operator==(const GlbChunk&, const GlbChunk&) = default;
};

/// The parts of a binary glTF file (glTF 2.0 specification, chapter 4).
struct Glb {
  std::string json;
  bool hasBinary = false;
  Bytes binary;                 ///< Bytes of the BIN chunk, its padding included.
  std::vector<GlbChunk> others; ///< Chunks of unknown type, in their order.
  std::vector<std::string> warnings;
};

/// Whether the bytes start as a binary glTF file does.
[[nodiscard]] bool isGlb(std::span<const std::uint8_t> bytes);

/// Error: wrong version, lengths that do not fit the bytes, JSON not first or empty, a chunk of JSON or BIN
/// twice.
[[nodiscard]] Result<Glb> readGlb(std::span<const std::uint8_t> bytes);

/// The file of these parts; chunks are padded to 4 bytes. Error: longer than the 4 GiB that the format can
/// say.
[[nodiscard]] Result<Bytes> writeGlb(Glb glb);
/// The same file in pieces that follow each other; the bytes of the BIN chunk are not copied.
[[nodiscard]] Result<std::vector<Bytes>> glbInPieces(Glb glb);

} // namespace stretch::gltf
