#include "tests/support/app/mesh_file.h"

#include <cstring>

#include "core/base/check.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/math/bounds.h"

namespace stretch::test {

namespace {

template <typename Value>
void append(Bytes& bytes, const Value& value) {
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof(value));
  std::memcpy(bytes.data() + end, &value, sizeof(value));
}

gltf::Json corner(const Vec3& point) {
  const glm::vec3 single(point);
  return {single.x, single.y, single.z};
}

} // namespace

void writeMeshFile(const std::filesystem::path& path, const std::vector<Vec3>& positions,
                   const std::vector<Triangle>& triangles) {
  Bytes bytes;
  Bounds box;
  for (const Vec3& position : positions) {
    box.add(position);
    append(bytes, glm::vec3(position));
  }
  const std::size_t split = bytes.size();
  for (const Triangle& triangle : triangles) {
    append(bytes, triangle);
  }
  const std::string binary = path.stem().string() + ".bin";
  const gltf::Json json{
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"name", "Body"}, {"mesh", 0}}}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
      {"buffers", {{{"byteLength", bytes.size()}, {"uri", binary}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteLength", split}},
        {{"buffer", 0}, {"byteOffset", split}, {"byteLength", bytes.size() - split}}}},
      {"accessors",
       {{{"bufferView", 0},
         {"componentType", 5126},
         {"count", positions.size()},
         {"type", "VEC3"},
         {"min", corner(box.low)},
         {"max", corner(box.high)}},
        {{"bufferView", 1}, {"componentType", 5125}, {"count", 3 * triangles.size()}, {"type", "SCALAR"}}}}};
  check(writeFile(path.parent_path() / binary, bytes).ok(), "the buffer is written");
  check(writeText(path, json.dump()).ok(), "the file is written");
}

} // namespace stretch::test
