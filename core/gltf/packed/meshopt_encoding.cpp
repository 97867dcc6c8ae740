#include "core/gltf/packed/meshopt_encoding.h"

#include <optional>
#include <span>
#include <string>

#include <meshoptimizer.h>

#include "core/gltf/json/json.h"

namespace stretch::gltf {

namespace {

constexpr const char* extensionName = "EXT_meshopt_compression";
constexpr int indexTarget = 34963;

std::size_t componentBytes(int type) {
  return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : 4;
}

std::size_t componentsOf(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

/// What the extension has to know of a view.
struct Elements {
  std::size_t stride = 0;
  std::size_t count = 0;
  bool triangles = false;
};

Elements elementsOf(const Json& view, const Json& accessor) {
  Elements elements;
  elements.stride = componentBytes(accessor["componentType"].get<int>()) *
                    componentsOf(accessor["type"].get_ref<const std::string&>());
  elements.stride = view.value("byteStride", elements.stride);
  elements.count = accessor["count"].get<std::size_t>();
  elements.triangles = view.value("target", 0) == indexTarget;
  return elements;
}

Bytes encoded(std::span<const std::uint8_t> raw, const Elements& elements) {
  Bytes bytes;
  if (elements.triangles) {
    std::vector<std::uint32_t> indices(elements.count);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      for (std::size_t byte = 0; byte < elements.stride; ++byte) {
        indices[i] |= static_cast<std::uint32_t>(raw[i * elements.stride + byte]) << (8U * byte);
      }
    }
    std::uint32_t largest = 0;
    for (const std::uint32_t index : indices) {
      largest = std::max(largest, index);
    }
    bytes.resize(meshopt_encodeIndexBufferBound(indices.size(), largest + 1));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
    return bytes;
  }
  bytes.resize(meshopt_encodeVertexBufferBound(elements.count, elements.stride));
  bytes.resize(
      meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), raw.data(), elements.count, elements.stride));
  return bytes;
}

bool canHold(const Elements& elements) {
  return elements.triangles
             ? (elements.stride == 2 || elements.stride == 4) && elements.count % 3 == 0 && elements.count > 0
             : elements.stride % 4 == 0 && elements.stride <= 256 && elements.count > 0;
}

class Compressor {
public:
  explicit Compressor(const Source& source) : source_(source), result_(source) {}

  Source run() {
    // The versions of the codec that EXT_meshopt_compression names.
    meshopt_encodeVertexVersion(0);
    meshopt_encodeIndexVersion(1);
    const std::vector<std::optional<Elements>> elements = elementsOfViews();
    result_.buffers = {{}, {}};
    for (std::size_t view = 0; view < elements.size(); ++view) {
      place(view, elements[view]);
    }
    Json& json = result_.json;
    pad();
    json["buffers"] = Json::array({{{"byteLength", result_.buffers[0].size()}},
                                   {{"byteLength", source_.buffers[0].size()},
                                    {"extensions", {{extensionName, {{"fallback", true}}}}}}});
    json["extensionsUsed"].push_back(extensionName);
    json["extensionsRequired"].push_back(extensionName);
    return std::move(result_);
  }

private:
  [[nodiscard]] std::vector<std::optional<Elements>> elementsOfViews() const {
    const Json& json = source_.json;
    std::vector<std::optional<Elements>> elements(json["bufferViews"].size());
    for (const Json& accessor : json["accessors"]) {
      const auto view = accessor["bufferView"].get<std::size_t>();
      elements[view] = elementsOf(json["bufferViews"][view], accessor);
    }
    return elements;
  }

  void pad() {
    while (result_.buffers[0].size() % 4 != 0) {
      result_.buffers[0].push_back(0);
    }
  }

  void place(std::size_t index, const std::optional<Elements>& elements) {
    pad();
    Json& view = (*result_.json)["bufferViews"][index];
    const std::span<const std::uint8_t> raw(source_.buffers[0].data() +
                                                view.value("byteOffset", std::size_t{0}),
                                            view["byteLength"].get<std::size_t>());
    Bytes& bytes = result_.buffers[0];
    const std::size_t offset = bytes.size();
    if (!elements || !canHold(*elements)) {
      bytes.insert(bytes.end(), raw.begin(), raw.end());
      view["byteOffset"] = offset;
      return;
    }
    const Bytes compressed = encoded(raw, *elements);
    bytes.insert(bytes.end(), compressed.begin(), compressed.end());
    view["buffer"] = 1;
    view["extensions"][extensionName] = {{"buffer", 0},
                                         {"byteOffset", offset},
                                         {"byteLength", compressed.size()},
                                         {"byteStride", elements->stride},
                                         {"mode", elements->triangles ? "TRIANGLES" : "ATTRIBUTES"},
                                         {"count", elements->count}};
  }

  const Source& source_;
  Source result_;
};

} // namespace

Source withMeshopt(const Source& source) {
  return Compressor(source).run();
}

std::size_t storedBytes(const Json& json, std::size_t accessor) {
  const Json& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()];
  const bool compressed = view.contains("extensions") && view["extensions"].contains(extensionName);
  const Json& stored = compressed ? view["extensions"][extensionName] : view;
  return stored["byteLength"].get<std::size_t>();
}

} // namespace stretch::gltf
