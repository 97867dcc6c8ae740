#include "skinning/export/gltf_buffers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/gltf/json/json.h"

namespace stretch::skinning {
namespace {

constexpr int floatType = 5126;

template <typename T>
constexpr int componentTypeOf() {
  if constexpr (std::is_same_v<T, std::uint8_t>) {
    return 5121;
  } else if constexpr (std::is_same_v<T, std::int8_t>) {
    return 5120;
  } else if constexpr (std::is_same_v<T, std::int16_t>) {
    return 5122;
  } else if constexpr (std::is_same_v<T, std::uint16_t>) {
    return 5123;
  } else {
    static_assert(std::is_same_v<T, std::uint32_t>);
    return 5125;
  }
}

} // namespace

std::size_t GltfBuffers::addView(const void* data, std::size_t size, Target target) {
  while (bytes_.size() % 4 != 0) {
    bytes_.push_back(0);
  }
  const std::size_t offset = bytes_.size();
  bytes_.resize(offset + size);
  if (size > 0) {
    std::memcpy(bytes_.data() + offset, data, size);
  }
  gltf::Json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
  if (target != Target::none) {
    view["target"] = static_cast<int>(target);
  }
  json_["bufferViews"].push_back(view);
  return json_["bufferViews"].size() - 1;
}

std::size_t GltfBuffers::addView(std::span<const std::uint8_t> bytes) {
  return addView(bytes.data(), bytes.size(), Target::none);
}

std::size_t GltfBuffers::add(const void* data, std::size_t size, std::size_t elements, int componentType,
                             const char* type, Target target, bool normalised) {
  const std::size_t view = addView(data, size, target);
  gltf::Json accessor{{"bufferView", view}, {"componentType", componentType}};
  if (normalised) {
    accessor["normalized"] = true;
  }
  accessor["count"] = elements;
  accessor["type"] = type;
  json_["accessors"].push_back(accessor);
  const std::size_t index = json_["accessors"].size() - 1;
  sizes_[index] = size;
  return index;
}

std::size_t GltfBuffers::addFloats(const std::vector<float>& values, const char* type, std::size_t width,
                                   Target target, bool bounds) {
  const std::size_t index = add(values.data(), values.size() * sizeof(float), values.size() / width,
                                floatType, type, target, false);
  if (bounds) {
    addBounds(index, values, width, width);
  }
  return index;
}

template <typename T>
void GltfBuffers::addBounds(std::size_t accessor, const std::vector<T>& values, std::size_t width,
                            std::size_t stored) {
  if (values.empty()) {
    return;
  }
  std::vector<T> low(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width));
  std::vector<T> high = low;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % stored < width) {
      low[i % stored] = std::min(low[i % stored], values[i]);
      high[i % stored] = std::max(high[i % stored], values[i]);
    }
  }
  json_["accessors"][accessor]["min"] = low;
  json_["accessors"][accessor]["max"] = high;
}

template <typename T>
std::size_t GltfBuffers::addPadded(const std::vector<T>& values, const char* type, std::size_t width,
                                   std::size_t stored, bool bounds) {
  const std::size_t index = add(values.data(), values.size() * sizeof(T), values.size() / stored,
                                componentTypeOf<T>(), type, Target::vertices, true);
  json_["bufferViews"].back()["byteStride"] = stored * sizeof(T);
  if (bounds) {
    addBounds(index, values, width, stored);
  }
  return index;
}

template std::size_t GltfBuffers::addPadded(const std::vector<std::int8_t>&, const char*, std::size_t,
                                            std::size_t, bool);
template std::size_t GltfBuffers::addPadded(const std::vector<std::int16_t>&, const char*, std::size_t,
                                            std::size_t, bool);

std::size_t GltfBuffers::addNormalised(const std::vector<float>& values, const char* type,
                                       std::size_t width) {
  std::vector<std::int16_t> integers;
  integers.reserve(values.size());
  for (const float value : values) {
    integers.push_back(static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32767.0F)));
  }
  return addIntegers(integers, type, width, Target::none, true);
}

template <typename T>
std::size_t GltfBuffers::addIntegers(const std::vector<T>& values, const char* type, std::size_t width,
                                     Target target, bool normalised) {
  return add(values.data(), values.size() * sizeof(T), values.size() / width, componentTypeOf<T>(), type,
             target, normalised);
}

template std::size_t GltfBuffers::addIntegers(const std::vector<std::uint8_t>&, const char*, std::size_t,
                                              Target, bool);
template std::size_t GltfBuffers::addIntegers(const std::vector<std::int16_t>&, const char*, std::size_t,
                                              Target, bool);
template std::size_t GltfBuffers::addIntegers(const std::vector<std::uint16_t>&, const char*, std::size_t,
                                              Target, bool);
template std::size_t GltfBuffers::addIntegers(const std::vector<std::uint32_t>&, const char*, std::size_t,
                                              Target, bool);

} // namespace stretch::skinning
