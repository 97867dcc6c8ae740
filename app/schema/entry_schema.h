#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/schema/schema_json.h"

namespace stretch::app {

// Entries of lists in files (a pin, a key of offsets, a locator) described once: a table of their keys, from
// which they are written and read.

/// One key of an entry `T`.
template <typename T>
struct EntryMember {
  std::string key;
  std::function<gltf::Json(const T&)> write;
  std::function<Status(const gltf::Json&, T&)> read; ///< Errors name the key.
  bool isNeeded = false;
  std::function<bool(const T&)> isWritten = {}; ///< Empty: always.
};

/// The keys of an entry, in the order in which they are written; they are read in any.
template <typename T>
using EntrySchema = std::vector<EntryMember<T>>;

/// A value by its type; `unit`: of the numbers of a vector. Errors name `key`.
template <typename Value>
[[nodiscard]] gltf::Json entryValue(const Value& value, double unit) {
  if constexpr (std::is_same_v<Value, Vec2>) {
    return gltf::Json::array({value.x, value.y});
  } else if constexpr (std::is_same_v<Value, Vec3>) {
    return vectorToJson(value / unit);
  } else if constexpr (std::is_same_v<Value, Quat>) {
    return quaternionToJson(value);
  } else {
    return value;
  }
}
[[nodiscard]] Status readValue(const gltf::Json& json, const std::string& key, double unit,
                               std::string& text);
[[nodiscard]] Status readValue(const gltf::Json& json, const std::string& key, double unit, double& number);
[[nodiscard]] Status readValue(const gltf::Json& json, const std::string& key, double unit, bool& flag);
[[nodiscard]] Status readValue(const gltf::Json& json, const std::string& key, double unit, Vec2& pair);
[[nodiscard]] Status readValue(const gltf::Json& json, const std::string& key, double unit, Vec3& vector);
[[nodiscard]] Status readValue(const gltf::Json& json, const std::string& key, double unit, Quat& turn);

/// A key by the type of its value. `members` lead to it one after the other, from one of the entry's own:
/// `&rig::Pin::time, &rig::HoldTime::blendFrames`.
template <typename T, typename First, typename... Rest>
[[nodiscard]] EntryMember<T> entryMember(const std::string& key, double unit, First T::*first,
                                         Rest... members) {
  return {key, [=](const T& entry) { return entryValue(((entry.*first).*....*members), unit); },
          [=](const gltf::Json& json, T& entry) {
            return readValue(json, key, unit, ((entry.*first).*....*members));
          }};
}

template <typename T>
[[nodiscard]] EntryMember<T> needed(EntryMember<T> member) {
  member.isNeeded = true;
  return member;
}

template <typename T, typename IsWritten>
[[nodiscard]] EntryMember<T> writtenWhere(IsWritten isWritten, EntryMember<T> member) {
  member.isWritten = std::move(isWritten);
  return member;
}

template <typename T>
[[nodiscard]] gltf::Json writeEntry(const EntrySchema<T>& schema, const T& entry) {
  gltf::Json json = gltf::Json::object();
  for (const EntryMember<T>& member : schema) {
    if (!member.isWritten || member.isWritten(entry)) {
      json[member.key] = member.write(entry);
    }
  }
  return json;
}

/// Advice that names all keys of an entry.
template <typename T>
[[nodiscard]] std::string keysOf(const EntrySchema<T>& schema) {
  std::string names;
  for (const EntryMember<T>& member : schema) {
    names += (names.empty() ? "" : ", ") + member.key;
  }
  return "give an object with " + names;
}

/// Reads the keys of an object; what is missing keeps its value. `unknown` answers for a key that the schema
/// does not have. A wrong value, one that is needed and missing, and what is no object are errors.
template <typename T, typename Unknown>
[[nodiscard]] Status readEntry(const gltf::Json& json, const EntrySchema<T>& schema, const Unknown& unknown,
                               T& entry) {
  if (!json.is_object()) {
    return Error{json.dump() + " is not an object", "", keysOf(schema)};
  }
  for (const EntryMember<T>& member : schema) {
    if (member.isNeeded && !json.contains(member.key)) {
      return Error{"is missing", member.key, keysOf(schema)};
    }
  }
  for (const auto& [key, value] : json.items()) {
    const auto known = std::ranges::find(schema, key, &EntryMember<T>::key);
    if (Status read = known != schema.end() ? known->read(value, entry) : unknown(key); !read) {
      return read;
    }
  }
  return Success{};
}

} // namespace stretch::app
