#pragma once

#include <cstdint>
#include <iterator>
#include <random>

#include "core/gltf/json/json.h"

namespace stretch::test {

/// One of the values in it becomes another one that is just as good JSON: numbers out of range, another kind.
[[nodiscard]] inline gltf::Json withOtherValue(gltf::Json json, std::mt19937& random) {
  const gltf::Json flat = json.flatten();
  auto entry = flat.begin();
  std::advance(entry, static_cast<std::ptrdiff_t>(random() % flat.size()));
  const gltf::Json values = {-1,
                             0,
                             1,
                             7,
                             255,
                             65536,
                             4294967295U,
                             9007199254740991U,
                             0.5,
                             1e300,
                             "text",
                             nullptr,
                             gltf::Json::array(),
                             gltf::Json::object()};
  json[gltf::Json::json_pointer(entry.key())] = values[random() % values.size()];
  return json;
}

} // namespace stretch::test
