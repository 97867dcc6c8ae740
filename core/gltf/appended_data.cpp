#include "core/gltf/appended_data.h"

#include <algorithm>
#include <cstring>

#include "core/gltf/json.h"

namespace stretch::gltf {

namespace {

constexpr int floatType = 5126;

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
  Run& run = runOf(use);
  if (!run.view) {
    run.view = journal_.append(Json::json_pointer("/bufferViews"), Json::object());
  }
  const std::size_t offset = run.bytes.size();
  run.bytes.resize(offset + values.size() * sizeof(float));
  std::memcpy(run.bytes.data() + offset, values.data(), values.size() * sizeof(float));
  Json accessor = {{"bufferView", *run.view},
                   {"byteOffset", offset},
                   {"componentType", floatType},
                   {"count", values.size() / width},
                   {"type", type}};
  if (withBounds) {
    accessor["min"] = boundsOf(values, width, true);
    accessor["max"] = boundsOf(values, width, false);
  }
  return journal_.append(Json::json_pointer("/accessors"), std::move(accessor));
}

void AppendedData::complete(const Run& run, Bytes& all) {
  if (!run.view) {
    return;
  }
  Json view = {{"buffer", buffer_}, {"byteOffset", start_ + all.size()}, {"byteLength", run.bytes.size()}};
  journal_.set(Json::json_pointer("/bufferViews") / *run.view, std::move(view));
  all.insert(all.end(), run.bytes.begin(), run.bytes.end());
}

Bytes AppendedData::finish() {
  Bytes all;
  complete(animation_, all);
  complete(inverseBind_, all);
  return all;
}

} // namespace stretch::gltf
