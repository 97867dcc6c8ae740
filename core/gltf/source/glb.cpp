#include "core/gltf/source/glb.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

namespace stretch::gltf {

namespace {

constexpr std::size_t headerSize = 12;
constexpr std::size_t chunkHeaderSize = 8;
constexpr std::uint32_t magic = 0x46546C67; // "glTF"

std::uint32_t readUint32(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8U |
         static_cast<std::uint32_t>(bytes[offset + 2]) << 16U |
         static_cast<std::uint32_t>(bytes[offset + 3]) << 24U;
}

void appendUint32(Bytes& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

Error malformed(std::string what) {
  return {std::move(what), "GLB", "the file is damaged: copy or export it again"};
}

Result<std::span<const std::uint8_t>> chunksOf(std::span<const std::uint8_t> bytes, Glb& glb) {
  if (bytes.size() < headerSize) {
    return malformed("ends within its header");
  }
  if (const std::uint32_t version = readUint32(bytes, 4); version != 2) {
    return Error{fmt::format("version {} is not supported", version), "GLB", "export it as glTF 2.0"};
  }
  const std::uint32_t length = readUint32(bytes, 8);
  if (length < headerSize + chunkHeaderSize || length > bytes.size()) {
    return malformed(fmt::format("its header says {} bytes, the file has {}", length, bytes.size()));
  }
  if (length < bytes.size()) {
    glb.warnings.push_back(
        fmt::format("{} bytes after the end of the GLB are left out", bytes.size() - length));
  }
  return bytes.subspan(headerSize, length - headerSize);
}

Status take(Glb& glb, GlbChunk chunk, bool isFirst) {
  if (isFirst != (chunk.type == GlbChunk::jsonType)) {
    return malformed(isFirst ? "its first chunk is not JSON" : "has two JSON chunks");
  }
  if (isFirst) {
    glb.json.assign(chunk.bytes.begin(), chunk.bytes.end());
    if (glb.json.empty()) {
      return malformed("its JSON chunk is empty");
    }
    return Success{};
  }
  if (chunk.type != GlbChunk::binaryType) {
    glb.others.push_back(std::move(chunk));
    return Success{};
  }
  if (glb.hasBinary) {
    return malformed("has two BIN chunks");
  }
  glb.hasBinary = true;
  glb.binary = std::move(chunk.bytes);
  return Success{};
}

void trimJsonPadding(Glb& glb) {
  if (!glb.json.ends_with('\0')) {
    return;
  }
  glb.json.erase(glb.json.find_last_not_of('\0') + 1);
  glb.warnings.emplace_back("the JSON chunk is padded with zeros instead of spaces");
}

std::size_t padded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

void appendChunk(Bytes& out, std::uint32_t type, std::span<const std::uint8_t> bytes, std::uint8_t padding) {
  const std::size_t length = padded(bytes.size());
  appendUint32(out, static_cast<std::uint32_t>(length));
  appendUint32(out, type);
  out.insert(out.end(), bytes.begin(), bytes.end());
  out.insert(out.end(), length - bytes.size(), padding);
}

} // namespace

bool isGlb(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 4 && readUint32(bytes, 0) == magic;
}

Result<Glb> readGlb(std::span<const std::uint8_t> bytes) {
  Glb glb;
  const auto chunks = chunksOf(bytes, glb);
  if (!chunks) {
    return chunks.error();
  }
  for (std::size_t offset = 0; offset < chunks->size();) {
    if (chunks->size() - offset < chunkHeaderSize) {
      return malformed("ends within the header of a chunk");
    }
    const std::size_t length = readUint32(*chunks, offset);
    const std::uint32_t type = readUint32(*chunks, offset + 4);
    if (length > chunks->size() - offset - chunkHeaderSize) {
      return malformed("a chunk reaches past the end");
    }
    if (length % 4 != 0) {
      glb.warnings.emplace_back("a chunk is not padded to 4 bytes");
    }
    const auto content = chunks->subspan(offset + chunkHeaderSize, length);
    if (Status taken = take(glb, {type, Bytes(content.begin(), content.end())}, offset == 0); !taken) {
      return taken.error();
    }
    offset += chunkHeaderSize + length;
  }
  trimJsonPadding(glb);
  return glb;
}

Result<std::vector<Bytes>> glbInPieces(Glb glb) {
  std::size_t size = headerSize + chunkHeaderSize + padded(glb.json.size());
  size += glb.hasBinary ? chunkHeaderSize + padded(glb.binary.size()) : 0;
  for (const GlbChunk& chunk : glb.others) {
    size += chunkHeaderSize + padded(chunk.bytes.size());
  }
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    return Error{"is larger than the 4 GiB that a GLB can hold", "GLB", "save it as .gltf"};
  }
  Bytes front;
  appendUint32(front, magic);
  appendUint32(front, 2);
  appendUint32(front, static_cast<std::uint32_t>(size));
  const auto* const json = reinterpret_cast<const std::uint8_t*>(glb.json.data());
  appendChunk(front, GlbChunk::jsonType, {json, glb.json.size()}, ' ');
  Bytes end;
  if (glb.hasBinary) {
    const std::size_t length = padded(glb.binary.size());
    appendUint32(front, static_cast<std::uint32_t>(length));
    appendUint32(front, GlbChunk::binaryType);
    end.resize(length - glb.binary.size());
  }
  for (const GlbChunk& chunk : glb.others) {
    appendChunk(end, chunk.type, chunk.bytes, 0);
  }
  std::vector<Bytes> pieces{std::move(front)};
  if (glb.hasBinary) {
    pieces.push_back(std::move(glb.binary));
  }
  pieces.push_back(std::move(end));
  return pieces;
}

Result<Bytes> writeGlb(Glb glb) {
  const Result<std::vector<Bytes>> pieces = glbInPieces(std::move(glb));
  if (!pieces) {
    return pieces.error();
  }
  std::size_t size = 0;
  for (const Bytes& piece : *pieces) {
    size += piece.size();
  }
  Bytes out;
  out.reserve(size);
  for (const Bytes& piece : *pieces) {
    out.insert(out.end(), piece.begin(), piece.end());
  }
  return out;
}

} // namespace stretch::gltf
