#include "core/gltf/source/fields.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/gltf/json/json.h"

namespace stretch::gltf {

const Json* find(const Json& object, std::string_view key) {
  const auto* members = object.get_ptr<const Json::object_t*>();
  if (members == nullptr) {
    return nullptr;
  }
  // Opening a file asks this for each thing in it: most names differ in their length or their first letter
  // already.
  const auto isKey = [key](const auto& member) {
    const std::string& name = member.first;
    return name.size() == key.size() && (key.empty() || name.front() == key.front()) && name == key;
  };
  const auto found = std::ranges::find_if(*members, isKey);
  return found == members->end() ? nullptr : &found->second;
}

const Json* findPath(const Json& object, std::initializer_list<std::string_view> keys) {
  const Json* current = &object;
  for (const std::string_view key : keys) {
    current = find(*current, key);
    if (current == nullptr) {
      return nullptr;
    }
  }
  return current;
}

std::optional<std::uint64_t> wholeNumber(const Json& value) {
  if (!value.is_number()) {
    return std::nullopt;
  }
  const auto number = value.get<double>();
  if (number < 0.0 || number > largestWhole || number != std::floor(number)) {
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(number);
}

std::uint64_t wholeOr(const Json& object, std::string_view key, std::uint64_t fallback) {
  const Json* value = find(object, key);
  return value == nullptr ? fallback : wholeNumber(*value).value_or(fallback);
}

int indexOr(const Json& object, std::string_view key, int fallback) {
  const std::uint64_t whole = wholeOr(object, key, std::numeric_limits<std::uint64_t>::max());
  return whole <= static_cast<std::uint64_t>(std::numeric_limits<int>::max()) ? static_cast<int>(whole)
                                                                              : fallback;
}

double numberOr(const Json& object, std::string_view key, double fallback) {
  const Json* value = find(object, key);
  return value != nullptr && value->is_number() ? value->get<double>() : fallback;
}

std::string textOr(const Json& object, std::string_view key, std::string_view fallback) {
  const Json* value = find(object, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string(fallback);
}

std::string shownName(const Json& object) {
  std::string name = textOr(object, "name");
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(name[i]);
    const auto next = static_cast<std::uint8_t>(i + 1 < name.size() ? name[i + 1] : '\0');
    const bool isLong = byte == 0xC2 && next >= 0x80 && next < 0xA0; // U+0080 to U+009F
    if (byte < 0x20 || byte == 0x7F || isLong) {
      name.replace(i, isLong ? 2 : 1, " ");
    }
  }
  return name;
}

bool flagOr(const Json& object, std::string_view key, bool fallback) {
  const Json* value = find(object, key);
  return value != nullptr && value->is_boolean() ? value->get<bool>() : fallback;
}

std::vector<double> numbersOf(const Json& object, std::string_view key) {
  const Json* value = find(object, key);
  const bool isNumbers =
      value != nullptr && value->is_array() &&
      std::all_of(value->begin(), value->end(), [](const Json& one) { return one.is_number(); });
  return isNumbers ? value->get<std::vector<double>>() : std::vector<double>();
}

std::vector<int> indicesOf(const Json& object, std::string_view key) {
  std::vector<int> indices;
  for (const double number : numbersOf(object, key)) {
    indices.push_back(number >= 0.0 && number <= static_cast<double>(std::numeric_limits<int>::max())
                          ? static_cast<int>(number)
                          : -1);
  }
  return indices;
}

std::size_t sizeOf(const Json& object, std::string_view key) {
  const Json* value = find(object, key);
  return value != nullptr && value->is_array() ? value->size() : 0;
}

const Json& element(const Json& object, std::string_view key, std::size_t index) {
  const Json* const list = find(object, key);
  check(list != nullptr && list->is_array() && index < list->size(),
        "an index that was validated points into its list");
  return (*list)[index];
}

bool listsText(const Json& object, std::string_view key, std::string_view text) {
  const Json* list = find(object, key);
  return list != nullptr && list->is_array() && std::any_of(list->begin(), list->end(), [&](const Json& one) {
           return one.is_string() && one.get_ref<const std::string&>() == text;
         });
}

} // namespace stretch::gltf
