#include "tests/support/fuzz/sequence_readers.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/gltf/import/mesh_surface.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/temporary_folder.h"

namespace stretch::test {

namespace {

std::string_view textOf(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// What is before the first zero byte, and what is behind it.
std::pair<std::string_view, std::string_view> twoTexts(std::span<const std::uint8_t> bytes) {
  const std::string_view text = textOf(bytes);
  const std::size_t middle = std::min(text.find('\0'), text.size());
  return {text.substr(0, middle), text.substr(std::min(middle + 1, text.size()))};
}

bool isFinite(const glm::vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void checkSurface(const MeshSequence& sequence) {
  const gltf::MeshSurface& surface = *sequence.surface;
  const std::size_t vertices = surface.places.size();
  check(
      std::ranges::all_of(surface.places, [&](std::uint32_t place) { return place < sequence.vertexCount; }),
      "vertices of a surface lie on those of the sequence");
  check(surface.normals.empty() || surface.normals.size() == vertices, "each vertex has a normal");
  check(std::ranges::all_of(surface.normals, isFinite), "normals are finite");
  check(surface.colors.empty() || surface.colors.size() == vertices, "each vertex has a colour");
  for (const std::vector<glm::vec2>& set : surface.texCoords) {
    check(set.size() == vertices, "each vertex has texture coordinates");
    check(std::ranges::all_of(set, [](const glm::vec2& one) { return std::isfinite(one.x + one.y); }),
          "texture coordinates are finite");
  }
  std::size_t triangles = 0;
  for (const gltf::SurfacePart& part : surface.parts) {
    triangles += part.triangleCount;
  }
  check(triangles == surface.triangles.size(), "each triangle is in a part");
}

void checkSequence(const Result<MeshSequence>& read) {
  if (!read) {
    check(!read.error().line().empty(), "what is refused is refused with a reason");
    return;
  }
  const MeshSequence& sequence = *read;
  check(sequence.vertexCount > 0 && !sequence.triangles.empty(), "a sequence has a mesh");
  check(sequence.positions.size() == sequence.vertexCount * sequence.frameCount(), "frames are whole");
  check(std::ranges::all_of(sequence.positions, isFinite), "positions are finite");
  for (const Triangle& triangle : sequence.triangles) {
    check(std::ranges::all_of(triangle, [&](std::uint32_t corner) { return corner < sequence.vertexCount; }),
          "corners exist");
  }
  if (sequence.surface != nullptr) {
    checkSurface(sequence);
  }
}

} // namespace

void readObjAnyhow(std::span<const std::uint8_t> bytes) {
  const TemporaryFolder folder;
  const auto [mesh, materials] = twoTexts(bytes);
  folder.write("frame-1.obj", mesh);
  folder.write("frame-2.obj", mesh);
  folder.write("frame.mtl", materials);
  checkSequence(skinning::readSequence({folder.path()}));
}

void readPlyAnyhow(std::span<const std::uint8_t> bytes) {
  const TemporaryFolder folder;
  folder.write("frame-1.ply", textOf(bytes));
  folder.write("frame-2.ply", textOf(bytes));
  checkSequence(skinning::readSequence({folder.path()}));
}

void readCacheAnyhow(std::span<const std::uint8_t> bytes) {
  const TemporaryFolder folder;
  const auto base = folder.write("base.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n");
  const bool isPc2 = textOf(bytes).starts_with("POINT");
  const auto cache = folder.write(isPc2 ? "cache.pc2" : "cache.mdd", textOf(bytes));
  checkSequence(skinning::readSequence({base, cache}));
}

void readLogAnyhow(std::span<const std::uint8_t> bytes) {
  const TemporaryFolder folder;
  const auto [positions, membranes] = twoTexts(bytes);
  folder.write("position_buffer.txt", positions);
  folder.write("membranes_buffer.txt", membranes);
  checkSequence(skinning::readSequence({folder.path()}));
}

} // namespace stretch::test
