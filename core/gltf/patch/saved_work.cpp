#include "core/gltf/patch/saved_work.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/base/hash.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/added_parts.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/uri.h"

namespace stretch::gltf {

namespace {

using Pointer = Json::json_pointer;

constexpr int formatVersion = 1;
constexpr const char* blockName = "stretch_engine";
// glTF allows extras of any type. Where the root's are no object, those of the asset take the work.
constexpr std::array<const char*, 2> places{"/extras", "/asset/extras"};

void addNumber(double number, Hash& sum) {
  sum.add(std::bit_cast<std::array<std::uint8_t, sizeof number>>(number == 0.0 ? 0.0 : number));
}

void addText(std::string_view text, Hash& sum) {
  addNumber(static_cast<double>(text.size()), sum);
  sum.add(text);
}

// By meaning: neither the order of keys nor the spelling of numbers counts, since other programs may change
// both.
void addJson(const Json& json, Hash& sum) {
  if (json.is_object()) {
    std::vector<const Json::object_t::value_type*> members;
    members.reserve(json.size());
    for (const auto& member : json.get_ref<const Json::object_t&>()) {
      members.push_back(&member);
    }
    std::ranges::sort(members, std::less{},
                      [](const auto* member) { return std::string_view(member->first); });
    addText("{", sum);
    for (const auto* member : members) {
      addText(member->first, sum);
      addJson(member->second, sum);
    }
    addText("}", sum);
  } else if (json.is_array()) {
    addText("[", sum);
    for (const Json& value : json) {
      addJson(value, sum);
    }
    addText("]", sum);
  } else if (json.is_number()) {
    addNumber(json.get<double>(), sum);
  } else {
    const std::string other = json.is_string() ? std::string() : json.dump();
    addText(json.is_string() ? json.get_ref<const std::string&>() : other, sum);
  }
}

std::string checksumOf(const Source& source) {
  Hash sum;
  addJson(source.json, sum);
  for (std::size_t i = 0; i < source.buffers.size(); ++i) {
    const auto length =
        static_cast<std::size_t>(wholeOr(element(source.json, "buffers", i), "byteLength", 0));
    sum.add(std::span(source.buffers[i]).first(std::min(length, source.buffers[i].size())));
  }
  return fmt::format("{:016x}", sum.value());
}

// A data URI is left out of what is stored where its bytes give it back.
bool isCanonicalDataUri(std::string_view uri, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t piece = 3 << 16; // made text of at a time, so that it does not all stand there twice
  const std::size_t comma = uri.find(',');
  const std::string_view text = uri.substr(std::min(uri.size(), comma + 1));
  bool isSame = isDataUri(uri) && comma < uri.size() && text.size() == (bytes.size() + 2) / 3 * 4;
  for (std::size_t i = 0; isSame && i < bytes.size(); i += piece) {
    isSame = text.substr(i / 3 * 4, piece / 3 * 4) ==
             encodeBase64(bytes.subspan(i, std::min(piece, bytes.size() - i)));
  }
  return isSame;
}

Json firstBufferRecord(const Source& source) {
  const Json& first = element(source.json, "buffers", 0);
  const Json* const text = find(first, "uri");
  const std::string_view uri = text == nullptr ? "" : std::string_view(text->get_ref<const std::string&>());
  const bool isEmbedded = isCanonicalDataUri(uri, source.buffers[0]);
  Json buffer = Json::object();
  for (const auto& [key, value] : first.items()) {
    buffer[key] = isEmbedded && &value == text ? Json(uri.substr(0, uri.find(',') + 1)) : value;
  }
  return {{"json", buffer}, {"bytes", source.buffers[0].size()}, {"embedded", isEmbedded}};
}

Json bufferRecord(const Source& source) {
  const std::size_t count = sizeOf(source.json, "buffers");
  Json record = {{"is_array", find(source.json, "buffers") != nullptr},
                 {"count", count},
                 {"binary_chunk", source.hasBinaryChunk}};
  if (count > 0) {
    record["first"] = firstBufferRecord(source);
  }
  return record;
}

std::optional<Pointer> freePlace(const Json& json) {
  for (const char* place : places) {
    const Pointer pointer(place);
    if (!json.contains(pointer) || json.at(pointer).is_object()) {
      return pointer;
    }
  }
  return std::nullopt;
}

const Json* findBlock(const Json& json) {
  for (const char* place : places) {
    const Pointer pointer = Pointer(place) / blockName;
    if (json.contains(pointer) && find(json.at(pointer), "restore") != nullptr) {
      return &json.at(pointer);
    }
  }
  return nullptr;
}

bool restoreFirstBuffer(Source& source, const Json& record) {
  const Json* json = find(record, "json");
  const auto bytes = static_cast<std::size_t>(wholeOr(record, "bytes", 0));
  if (json == nullptr || !json->is_object() || source.buffers.empty()) {
    return false;
  }
  Bytes& buffer = source.buffers[0];
  buffer.resize(std::min(buffer.size(), bytes));
  Json& target = (*source.json)["buffers"][0];
  target = *json;
  if (flagOr(record, "embedded", false)) {
    target["uri"] = textOr(target, "uri") + encodeBase64(buffer);
  }
  return true;
}

bool restoreBuffers(Source& source, const Json& record) {
  const auto count = static_cast<std::size_t>(wholeOr(record, "count", 0));
  const bool isArray = flagOr(record, "is_array", false);
  const Json* const described = find(source.json, "buffers");
  const bool fits =
      isArray ? described != nullptr && described->is_array() && count <= described->size() : count == 0;
  if (!fits || count > source.buffers.size()) {
    return false;
  }
  source.hasBinaryChunk = flagOr(record, "binary_chunk", false);
  source.buffers.resize(count);
  if (!isArray) {
    source.json->erase("buffers");
    return true;
  }
  Json& list = (*source.json)["buffers"];
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(count), list.end());
  const Json* first = find(record, "first");
  return count == 0 || (first != nullptr && restoreFirstBuffer(source, *first));
}

bool takeApart(Source& source, const Json& restore) {
  const Json* steps = find(restore, "steps");
  const Json* buffers = find(restore, "buffers");
  return steps != nullptr && buffers != nullptr && takeBack(source.json, *steps) &&
         restoreBuffers(source, *buffers) && checksumOf(source) == textOr(restore, "checksum");
}

} // namespace

Result<Json> withSavedWork(const Source& source, const Json& work, Journal journal, Json added) {
  const std::optional<Pointer> place = freePlace(source.json);
  if (!place) {
    return Error{"its extras are no objects, so the work finds no place in it", "extras",
                 "save without the work (clean)"};
  }
  const bool isNew = !source.json->contains(*place);
  if (isNew) {
    journal.set(*place, Json::object());
  }
  const Pointer block = *place / blockName;
  journal.set(block, nullptr); // the step that removes the block is part of the block
  Json restore = {
      {"steps", journal.undo()}, {"buffers", bufferRecord(source)}, {"checksum", checksumOf(source)}};
  if (!added.is_null()) {
    restore["added"] = std::move(added);
  }
  Json json = std::move(journal).takeJson();
  json[block] = {{"version", formatVersion}, {"work", work}, {"restore", std::move(restore)}};
  return json;
}

std::optional<Restored> restoreSource(const Source& saved, Problems& problems) {
  const Json* block = findBlock(saved.json);
  if (block == nullptr) {
    return std::nullopt;
  }
  if (indexOr(*block, "version") != formatVersion) {
    problems.warning("extras", "holds work of another version of this program; opened as an ordinary file");
    return std::nullopt;
  }
  const Json* work = find(*block, "work");
  Restored restored{saved, work == nullptr ? Json() : *work, {}};
  if (!takeApart(restored.source, *find(*block, "restore"))) {
    problems.warning("extras",
                     "another program changed the file since it was saved; opened as an ordinary file");
    return std::nullopt;
  }
  if (const Json* const added = find(*find(*block, "restore"), "added")) {
    restored.added = addedFromRecord(saved, *added, problems);
  }
  return restored;
}

} // namespace stretch::gltf
