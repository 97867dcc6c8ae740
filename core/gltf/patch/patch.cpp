#include <algorithm>
#include <optional>
#include <utility>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/added_parts.h"
#include "core/gltf/patch/patch_parts.h"
#include "core/gltf/patch/saved_work.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_source.h"

namespace stretch::gltf {

namespace {

// The buffer that takes new bytes: the first, unless its own bytes could not be read, or nothing may lie
// beside them.
std::size_t growingBuffer(const Source& source) {
  const bool hasFirst = !source.buffers.empty() && !source.buffers[0].empty() &&
                        !isFallbackBuffer(element(source.json, "buffers", 0));
  return hasFirst ? 0 : source.buffers.size();
}

std::size_t aligned(std::size_t size) {
  return (size + 3) / 4 * 4;
}

// The buffers with room for so many bytes in one of them, which then grows where it is.
std::vector<Bytes> withRoom(const std::vector<Bytes>& buffers, std::size_t index, std::size_t size) {
  std::vector<Bytes> copies(buffers.size());
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    copies[i].reserve(i == index ? std::max(size, buffers[i].size()) : buffers[i].size());
    copies[i].insert(copies[i].end(), buffers[i].begin(), buffers[i].end());
  }
  return copies;
}

// Adds the bytes to the buffer, which then lives in memory: saving gives it a place (the BIN chunk, a .bin
// file).
void growBuffer(Source& source, std::size_t index, std::size_t start, const Bytes& bytes) {
  if (bytes.empty()) {
    return;
  }
  if (index == source.buffers.size()) {
    source.buffers.emplace_back();
    (*source.json)["buffers"].push_back(Json::object());
  }
  Bytes& buffer = source.buffers[index];
  buffer.resize(start);
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  Json& json = (*source.json)["buffers"][index];
  json.erase("uri");
  json["byteLength"] = buffer.size();
  source.hasBinaryChunk = source.hasBinaryChunk || index == 0;
}

} // namespace

Result<Source> patched(const Source& source, const Edits& edits) {
  const std::size_t buffer = growingBuffer(source);
  const std::size_t start = buffer < source.buffers.size() ? aligned(source.buffers[buffer].size()) : 0;
  Journal journal(source.json);
  Bytes bytes = addFiles(edits.addedFiles, buffer, start, journal);
  std::optional<Source> grown;
  if (!edits.addedFiles.empty()) {
    grown = source;
    grown->json = journal.json();
    growBuffer(*grown, buffer, start, bytes);
  }
  const Source& base = grown ? *grown : source;
  if (Status fit = validateEdits(base, edits); !fit) {
    return fit.error();
  }
  AppendedData data(journal, buffer, start + bytes.size());
  patchNodes(edits.addedNodes, journal);
  moveNodes(edits.movedNodes, journal);
  if (!edits.skinSlots.empty() || !edits.addedSlots.empty()) {
    Problems known; // of a file that was read
    const std::optional<PlainSource> plain = withPlainViews(base, known);
    patchSkins(plain ? plain->source : base, edits, journal, data);
  }
  patchBinding(edits, journal, data);
  patchClips(edits.clips, journal, data);
  const Bytes ofEdits = data.finish();
  bytes.insert(bytes.end(), ofEdits.begin(), ofEdits.end());
  Result<Json> json = edits.work.isNull() ? Result<Json>(std::move(journal).takeJson())
                                          : withSavedWork(source, edits.work, std::move(journal),
                                                          addedRecord(edits.addedFiles, buffer, start));
  if (!json) {
    return json.error();
  }
  if (!bytes.empty() && buffer < source.buffers.size()) {
    json->at("buffers")[buffer].erase("uri"); // before anything large stands beside it
  }
  Source result{source.path, std::move(json.value()), withRoom(source.buffers, buffer, start + bytes.size()),
                source.hasBinaryChunk, source.otherChunks};
  growBuffer(result, buffer, start, bytes);
  return result;
}

} // namespace stretch::gltf
