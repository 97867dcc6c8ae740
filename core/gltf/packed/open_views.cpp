#include <fmt/core.h>

#include "core/gltf/packed/meshopt_view.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_parts.h"

namespace stretch::gltf {

namespace {

constexpr const char* viewCompression = "EXT_meshopt_compression";

const Json* compressedView(const Json& view) {
  return findPath(view, {"extensions", viewCompression});
}

// What readers without the extension are given has to lie within its buffer all the same.
void checkFallback(const Json& json, std::size_t index, Problems& problems) {
  const Json& view = element(json, "bufferViews", index);
  const Json& buffer = element(json, "buffers", static_cast<std::size_t>(indexOr(view, "buffer")));
  if (wholeOr(view, "byteOffset", 0) + wholeOr(view, "byteLength", 0) > wholeOr(buffer, "byteLength", 0)) {
    problems.error(at("bufferViews", index), "reaches past the end of its buffer");
  }
}

std::optional<Bytes> decodedView(const PlainSource& plain, const Json& extension, const std::string& where,
                                 Problems& problems) {
  const std::optional<std::span<const std::uint8_t>> bytes = namedBytes(plain.source, extension);
  if (!bytes) {
    problems.error(where, "names bytes that are not there");
    return std::nullopt;
  }
  const MeshoptView view{*bytes, wholeOr(extension, "count", 0), wholeOr(extension, "byteStride", 0),
                         textOr(extension, "mode"), textOr(extension, "filter", "NONE")};
  if (view.stride != 0 && view.count > bytesLeftToDecode(plain) / view.stride) {
    problems.error(where, "decodes to more data than the program takes into memory");
    return std::nullopt;
  }
  Result<Bytes> decoded = decodeMeshopt(view);
  if (!decoded) {
    problems.error(where, decoded.error().what, decoded.error().remedy);
    return std::nullopt;
  }
  return std::move(decoded.value());
}

void pointToPlain(PlainSource& plain, std::size_t index, Bytes decoded, Problems& problems) {
  const std::size_t size = decoded.size();
  const std::size_t buffer = addPlainBuffer(plain, std::move(decoded));
  Json& view = (*plain.source.json)["bufferViews"][index];
  if (const std::uint64_t said = wholeOr(view, "byteLength", 0); said != size) {
    problems.violation(at("bufferViews", index),
                       fmt::format("says {} bytes, but its compressed data hold {}", said, size),
                       "what is decoded counts");
  }
  view["buffer"] = buffer;
  view["byteLength"] = size;
  view.erase("byteOffset");
  view["extensions"].erase(viewCompression);
}

} // namespace

bool hasCompressedViews(const Json& json) {
  for (std::size_t i = 0; i < sizeOf(json, "bufferViews"); ++i) {
    if (compressedView(element(json, "bufferViews", i)) != nullptr) {
      return true;
    }
  }
  return false;
}

void openViews(PlainSource& plain, Problems& problems) {
  const Json& json = plain.source.json;
  std::set<int> roundedViews;
  for (std::size_t i = 0; i < sizeOf(json, "bufferViews"); ++i) {
    const Json* compressed = compressedView(element(json, "bufferViews", i));
    if (compressed == nullptr) {
      continue;
    }
    checkFallback(json, i, problems);
    const std::string where = fmt::format("{}.extensions.{}", at("bufferViews", i), viewCompression);
    if (textOr(*compressed, "filter", "NONE") != "NONE") {
      roundedViews.insert(static_cast<int>(i));
    }
    if (std::optional<Bytes> decoded = decodedView(plain, *compressed, where, problems)) {
      pointToPlain(plain, i, *std::move(decoded), problems);
    }
  }
  for (std::size_t i = 0; i < sizeOf(json, "accessors"); ++i) {
    if (roundedViews.contains(indexOr(element(json, "accessors", i), "bufferView"))) {
      plain.roundedAccessors.insert(i);
    }
  }
}

} // namespace stretch::gltf
