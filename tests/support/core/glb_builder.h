#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "core/gltf/json/json.h"
#include "core/gltf/source/source.h"
#include "tests/support/temporary_folder.h"

namespace stretch::test {

/// A glTF file made in code: JSON that tests change at will, and the bytes its accessors lie in.
struct GlbBuilder {
  gltf::Json json;
  gltf::Bytes binary;

  /// Appends the numbers as an accessor in a buffer view of its own; answers its index.
  template <typename Number>
  int accessor(const std::vector<Number>& numbers, int componentType, const std::string& type,
               std::size_t width) {
    const std::size_t offset = (binary.size() + 3) / 4 * 4;
    binary.resize(offset + numbers.size() * sizeof(Number));
    std::memcpy(binary.data() + offset, numbers.data(), numbers.size() * sizeof(Number));
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", numbers.size() * sizeof(Number)}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", componentType},
                                 {"count", numbers.size() / width},
                                 {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int floats(const std::vector<float>& numbers, const std::string& type, std::size_t width) {
    return accessor(numbers, 5126, type, width);
  }

  /// The bytes of the .glb; its first buffer is `binary`, others stay as the JSON has them.
  [[nodiscard]] gltf::Bytes bytes() const;
  void write(const std::filesystem::path& path) const;
};

/// An arm of three joints in a column along +Y (nodes "root", "upper", "lower" at heights 0, 1, 2) that skins
/// a strip of four triangles, a rigid prop under "lower" (node 3), a camera, unknown properties and
/// extensions, and two clips: "wave" (LINEAR rotation and CUBICSPLINE translation of "lower", STEP scale of
/// "upper") and "still" (one key).
[[nodiscard]] GlbBuilder armBuilder();

void writeBytes(const std::filesystem::path& path, const gltf::Bytes& bytes);
[[nodiscard]] gltf::Bytes readBytes(const std::filesystem::path& path);

/// Loads the bytes as a file.
[[nodiscard]] Result<gltf::Loaded> loadBytes(const gltf::Bytes& bytes,
                                             gltf::Tolerance tolerance = gltf::Tolerance::refuse);

/// The file as it loads; fails the test with the error's line where it does not.
[[nodiscard]] gltf::Loaded loaded(const GlbBuilder& glb);

/// Whether one of the file's warnings holds these words.
[[nodiscard]] bool warnsOf(const gltf::Loaded& file, const std::string& words);

} // namespace stretch::test
