#include "core/interchange/glb_parts.h"

#include <algorithm>

#include "core/gltf/json/json.h"
#include "core/gltf/source/glb.h"

namespace stretch::interchange {

namespace {

using gltf::Json;

constexpr int floatComponent = 5126;
constexpr int unsignedShortComponent = 5123;
constexpr int unsignedIntComponent = 5125;

std::size_t widthOf(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

template <typename T>
std::span<const std::uint8_t> asBytes(const std::vector<T>& values) {
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

} // namespace

GlbParts::GlbParts() : json_(Json{{"asset", {{"version", "2.0"}, {"generator", "Stretch-Engine"}}}}) {}

std::size_t GlbParts::add(const char* list, const Json& entry) {
  Json& entries = (*json_)[list];
  entries.push_back(entry);
  return entries.size() - 1;
}

std::size_t GlbParts::addBytes(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t alignment = 4;
  bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
  const std::size_t view =
      add("bufferViews", {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return view;
}

std::size_t GlbParts::addAccessor(std::span<const std::uint8_t> bytes, Json accessor) {
  accessor["bufferView"] = addBytes(bytes);
  return add("accessors", accessor);
}

std::size_t GlbParts::addFloats(const std::vector<float>& values, const std::string& type, bool withBounds) {
  const bool areTimes = type == "SCALAR" && withBounds;
  if (const auto known = times_.find(values); areTimes && known != times_.end()) {
    return known->second;
  }
  const std::size_t width = widthOf(type);
  Json accessor{{"componentType", floatComponent}, {"count", values.size() / width}, {"type", type}};
  if (withBounds) {
    std::vector<float> least(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width));
    std::vector<float> greatest = least;
    for (std::size_t i = width; i < values.size(); ++i) {
      least[i % width] = std::min(least[i % width], values[i]);
      greatest[i % width] = std::max(greatest[i % width], values[i]);
    }
    accessor["min"] = least;
    accessor["max"] = greatest;
  }
  const std::size_t index = addAccessor(asBytes(values), std::move(accessor));
  if (areTimes) {
    times_[values] = index;
  }
  return index;
}

std::size_t GlbParts::addJoints(const std::vector<std::uint16_t>& joints) {
  return addAccessor(
      asBytes(joints),
      {{"componentType", unsignedShortComponent}, {"count", joints.size() / 4}, {"type", "VEC4"}});
}

std::size_t GlbParts::addIndices(const std::vector<std::uint32_t>& indices) {
  return addAccessor(
      asBytes(indices),
      {{"componentType", unsignedIntComponent}, {"count", indices.size()}, {"type", "SCALAR"}});
}

Result<Bytes> GlbParts::finish() {
  if (!bytes_.empty()) {
    (*json_)["buffers"] = Json::array({Json{{"byteLength", bytes_.size()}}});
  }
  return gltf::writeGlb({json_->dump(-1, ' ', false, Json::error_handler_t::replace),
                         !bytes_.empty(),
                         std::move(bytes_),
                         {},
                         {}});
}

} // namespace stretch::interchange
