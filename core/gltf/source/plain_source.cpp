#include "core/gltf/source/plain_source.h"

#include <algorithm>

#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_parts.h"

namespace stretch::gltf {

std::size_t addPlainBuffer(PlainSource& plain, Bytes bytes) {
  Json& buffers = (*plain.source.json)["buffers"];
  buffers.push_back({{"byteLength", bytes.size()}});
  plain.decodedBytes += bytes.size();
  plain.source.buffers.resize(buffers.size());
  plain.source.buffers.back() = std::move(bytes);
  return buffers.size() - 1;
}

// The same packed bytes may be named again and again: what comes out of them is bounded by the file's size.
std::size_t bytesLeftToDecode(const PlainSource& plain) {
  constexpr std::size_t mostOfAnyFile = std::size_t{3} << 29U; // 1.5 GiB
  constexpr std::size_t mostOfSmallFile = std::size_t{1} << 22U;
  constexpr std::size_t bytesFromOne = 256;
  const std::size_t most = std::min(mostOfAnyFile, mostOfSmallFile + bytesFromOne * plain.packedBytes);
  return most - std::min(plain.decodedBytes, most);
}

namespace {

PlainSource copyToOpen(const Source& source) {
  PlainSource plain{source, {}, 0, 0};
  for (const Bytes& buffer : source.buffers) {
    plain.packedBytes += buffer.size();
  }
  return plain;
}

} // namespace

std::optional<std::span<const std::uint8_t>> namedBytes(const Source& source, const Json& object) {
  const int buffer = indexOr(object, "buffer");
  if (buffer < 0 || static_cast<std::size_t>(buffer) >= source.buffers.size()) {
    return std::nullopt;
  }
  const std::span<const std::uint8_t> bytes(source.buffers[static_cast<std::size_t>(buffer)]);
  const std::uint64_t start = wholeOr(object, "byteOffset", 0);
  const std::uint64_t length = wholeOr(object, "byteLength", 0);
  if (length == 0 || start > bytes.size() || length > bytes.size() - start) {
    return std::nullopt;
  }
  return bytes.subspan(start, length);
}

std::optional<PlainSource> withPlainViews(const Source& source, Problems& problems) {
  if (!hasCompressedViews(source.json)) {
    return std::nullopt;
  }
  PlainSource plain = copyToOpen(source);
  openViews(plain, problems);
  return plain;
}

std::optional<PlainSource> plainSource(const Source& source, Problems& problems) {
  std::optional<PlainSource> plain = withPlainViews(source, problems);
  if (!hasCompressedMeshes(source.json)) {
    return plain;
  }
  if (!plain) {
    plain = copyToOpen(source);
  }
  if (!problems.hasErrors()) {
    openMeshes(*plain, problems);
  }
  return plain;
}

bool isFallbackBuffer(const Json& buffer) {
  const Json* extension = findPath(buffer, {"extensions", "EXT_meshopt_compression"});
  return extension != nullptr && flagOr(*extension, "fallback", false);
}

} // namespace stretch::gltf
