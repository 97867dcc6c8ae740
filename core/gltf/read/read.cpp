#include "core/gltf/read/read.h"

#include <fmt/core.h>

#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/json_text.h"
#include "core/gltf/source/plain_source.h"
#include "core/gltf/source/uri.h"
#include "core/interchange/foreign_file.h"

namespace stretch::gltf {

namespace {

std::optional<Json> parsed(std::string_view text, Problems& problems) {
  Result<Json> json = parseJson(text);
  if (!json) {
    problems.error(json.error().where, json.error().what, json.error().remedy);
    return std::nullopt;
  }
  return std::move(json.value());
}

// A BIN chunk belongs to the first buffer if that has no uri; else nothing refers to it and it is kept as it
// is.
void placeBinary(Glb& glb, Source& source) {
  const bool isFirstBuffer =
      sizeOf(source.json, "buffers") > 0 && find(element(source.json, "buffers", 0), "uri") == nullptr;
  if (isFirstBuffer) {
    source.hasBinaryChunk = true;
    source.buffers.push_back(std::move(glb.binary));
  } else {
    source.otherChunks.push_back({GlbChunk::binaryType, std::move(glb.binary)});
  }
}

std::optional<Source> fromGlb(const Bytes& bytes, Problems& problems) {
  Result<Glb> glb = readGlb(bytes);
  if (!glb) {
    problems.error(glb.error().where, glb.error().what, glb.error().remedy);
    return std::nullopt;
  }
  for (std::string& warning : glb->warnings) {
    problems.warning("GLB", std::move(warning));
  }
  std::optional<Json> json = parsed(glb->json, problems);
  if (!json) {
    return std::nullopt;
  }
  Source source;
  source.json = *std::move(json);
  if (glb->hasBinary) {
    placeBinary(*glb, source);
  }
  source.otherChunks.insert(source.otherChunks.end(), glb->others.begin(), glb->others.end());
  return source;
}

std::optional<Source> fromText(const Bytes& bytes, Problems& problems) {
  std::optional<Json> json = parsed({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, problems);
  if (!json) {
    return std::nullopt;
  }
  Source source;
  source.json = *std::move(json);
  return source;
}

// A file of another program is made into glTF first (core/interchange).
std::optional<Source> fromForeign(const std::filesystem::path& path, interchange::Format format,
                                  std::size_t bytes, Problems& problems) {
  Result<interchange::Converted> made = interchange::convertedInProcess(path, format, bytes);
  if (!made) {
    problems.error(made.error().where, made.error().what, made.error().remedy);
    return std::nullopt;
  }
  for (std::string& warning : made->warnings) {
    problems.warning(interchange::nameOf(format), std::move(warning));
  }
  return fromGlb(made->glb, problems);
}

std::optional<Source> fromBytes(const std::filesystem::path& path, const Bytes& bytes, Problems& problems) {
  if (bytes.empty()) {
    problems.error("", "is empty", "export the file again");
    return std::nullopt;
  }
  if (isGlb(bytes)) {
    return fromGlb(bytes, problems);
  }
  if (const std::optional<interchange::Format> format = interchange::formatOf(bytes)) {
    return fromForeign(path, *format, bytes.size(), problems);
  }
  if (const std::optional<Error> other = interchange::otherKind(bytes)) {
    problems.error(other->where, other->what, other->remedy);
    return std::nullopt;
  }
  return fromText(bytes, problems);
}

Bytes fromDataUri(const std::string& uri, const std::string& where, Problems& problems) {
  std::optional<DataUri> data = decodeDataUri(uri);
  if (!data) {
    problems.error(where + ".uri", "is a malformed data URI");
    return {};
  }
  if (data->mediaType != "application/octet-stream" && data->mediaType != "application/gltf-buffer") {
    problems.violation(where + ".uri",
                       fmt::format("has the media type '{}', not application/octet-stream", data->mediaType));
  }
  return std::move(data->bytes);
}

Bytes fromFileBeside(const Source& source, const std::string& uri, const std::string& where,
                     Problems& problems) {
  const std::optional<std::filesystem::path> relative = relativePath(uri);
  if (!relative) {
    problems.violation(where + ".uri", fmt::format("'{}' is no relative path and is not read", uri));
    return {};
  }
  if (escapesFolder(*relative)) {
    problems.warning(where + ".uri", fmt::format("'{}' lies outside the file's folder and is not read", uri));
    return {};
  }
  Result<Bytes> bytes = readFile(source.path.parent_path() / *relative);
  if (!bytes) {
    problems.warning(where + ".uri", fmt::format("'{}' cannot be read", uri));
    return {};
  }
  return std::move(bytes.value());
}

// Buffers that a compression extension fills have no bytes in the file.
Bytes readBuffer(const Source& source, const Json& buffer, const std::string& where, Problems& problems) {
  const Json* uri = find(buffer, "uri");
  if (uri == nullptr && isFallbackBuffer(buffer)) {
    return {};
  }
  if (uri == nullptr) {
    problems.warning(where, "has neither a uri nor a BIN chunk; its values are taken as zeros");
    return {};
  }
  const auto& text = uri->get_ref<const std::string&>();
  return isDataUri(text) ? fromDataUri(text, where, problems) : fromFileBeside(source, text, where, problems);
}

void checkLength(const Bytes& bytes, const Json& buffer, bool isBinaryChunk, const std::string& where,
                 Problems& problems) {
  const std::uint64_t length = wholeOr(buffer, "byteLength", 0);
  if (!bytes.empty() && bytes.size() < length) {
    problems.error(where, fmt::format("says {} bytes, but there are only {}", length, bytes.size()));
  } else if (isBinaryChunk && bytes.size() > length + 3) {
    problems.warning(where, fmt::format("says {} bytes, but the BIN chunk has {}", length, bytes.size()));
  }
}

} // namespace

std::optional<Source> readSource(const std::filesystem::path& path, Problems& problems) {
  const Result<Bytes> bytes = readFile(path);
  if (!bytes) {
    problems.error(bytes.error().where, bytes.error().what, bytes.error().remedy);
    return std::nullopt;
  }
  std::optional<Source> source = fromBytes(path, *bytes, problems);
  if (source) {
    source->path = path;
  }
  return source;
}

void readBuffers(Source& source, Problems& problems) {
  const std::size_t count = sizeOf(source.json, "buffers");
  source.buffers.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool isBinaryChunk = i == 0 && source.hasBinaryChunk;
    const Json& buffer = element(source.json, "buffers", i);
    const std::string where = at("buffers", i);
    if (!isBinaryChunk) {
      source.buffers[i] = readBuffer(source, buffer, where, problems);
    }
    checkLength(source.buffers[i], buffer, isBinaryChunk, where, problems);
  }
}

} // namespace stretch::gltf
