#include "core/gltf/patch/appended_data.h"

#include <algorithm>
#include <cstring>

#include "core/gltf/json/json.h"

namespace stretch::gltf {

namespace {

constexpr int floatType = 5126;
constexpr int shortType = 5123; // unsigned
constexpr int vertexTarget = 34962;

Json boundsOf(const std::vector<float>& values, std::size_t width, bool isLeast) {
  Json bounds = Json::array();
  for (std::size_t component = 0; component < width; ++component) {
    float bound = values[component];
    for (std::size_t i = component; i < values.size(); i += width) {
      bound = isLeast ? std::min(bound, values[i]) : std::max(bound, values[i]);
    }
    bounds.push_back(static_cast<double>(bound));
  }
  return bounds;
}

} // namespace

std::size_t AppendedData::add(Use use, const char* type, std::size_t width, const std::vector<float>& values,
                              bool withBounds) {
  check(!values.empty() && values.size() % width == 0, "an accessor has whole elements");
  Json accessor = {{"componentType", floatType}, {"count", values.size() / width}, {"type", type}};
  if (withBounds) {
    accessor["min"] = boundsOf(values, width, true);
    accessor["max"] = boundsOf(values, width, false);
  }
  return place(use, values.data(), values.size() * sizeof(float), std::move(accessor));
}

std::size_t AppendedData::addJoints(const std::vector<std::uint16_t>& joints) {
  check(!joints.empty() && joints.size() % 4 == 0, "each vertex names four joints");
  return place(Use::joints, joints.data(), joints.size() * sizeof(std::uint16_t),
               {{"componentType", shortType}, {"count", joints.size() / 4}, {"type", "VEC4"}});
}

std::size_t AppendedData::place(Use use, const void* values, std::size_t byteCount, Json accessor) {
  Run& run = runOf(use);
  if (!run.view) {
    run.view = journal_.append(Json::json_pointer("/bufferViews"), Json::object());
  }
  const std::size_t offset = run.bytes.size();
  run.bytes.resize(offset + byteCount);
  std::memcpy(run.bytes.data() + offset, values, byteCount);
  Json placed = {{"bufferView", *run.view}, {"byteOffset", offset}};
  placed.update(accessor);
  return journal_.append(Json::json_pointer("/accessors"), std::move(placed));
}

void AppendedData::complete(Use use, Bytes& all) {
  const Run& run = runOf(use);
  if (!run.view) {
    return;
  }
  Json view = {{"buffer", buffer_}, {"byteOffset", start_ + all.size()}, {"byteLength", run.bytes.size()}};
  if (use == Use::joints || use == Use::weights) {
    view["byteStride"] = 4 * (use == Use::joints ? sizeof(std::uint16_t) : sizeof(float));
    view["target"] = vertexTarget;
  }
  journal_.set(Json::json_pointer("/bufferViews") / *run.view, std::move(view));
  all.insert(all.end(), run.bytes.begin(), run.bytes.end());
}

Bytes AppendedData::finish() {
  Bytes all;
  for (const Use use : {Use::animation, Use::inverseBind, Use::joints, Use::weights}) {
    complete(use, all);
  }
  return all;
}

} // namespace stretch::gltf
