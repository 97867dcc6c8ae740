#include "skinning/sequence/mesh_file.h"

#include <cmath>

#include <fmt/format.h>

#include "core/base/number.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

Result<glm::vec3> parsePosition(std::string_view words, const std::string& place) {
  glm::vec3 position(0.0F);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const auto number = parseNumber(nextWord(words));
    if (!number || std::abs(*number) > largestCoordinate) {
      return Error{fmt::format("a vertex needs three finite numbers of at most {:g}", largestCoordinate),
                   place, "export the frame again"};
    }
    position[axis] = static_cast<float>(*number);
  }
  return position;
}

/// Adds the polygon of one `f` line. Indices are left unchecked against vertices that come later in the
/// file.
Status parseFace(std::string_view words, const std::string& place, std::size_t vertexCount,
                 Polygons& polygons) {
  std::vector<std::uint32_t>& corners = polygons.corners;
  for (std::string_view word = nextWord(words); !word.empty(); word = nextWord(words)) {
    const auto index = parseNumber<long long>(word.substr(0, word.find('/')));
    const auto count = static_cast<long long>(vertexCount);
    const long long vertex = index ? (*index < 0 ? count + *index : *index - 1) : -1;
    if (vertex < 0 || vertex >= static_cast<long long>(UINT32_MAX)) {
      return Error{"a face names a vertex that does not exist", place, "export the frame again"};
    }
    corners.push_back(static_cast<std::uint32_t>(vertex));
  }
  if (corners.size() < 3 + (polygons.ends.empty() ? 0 : polygons.ends.back())) {
    return Error{"a face has fewer than three corners", place, "export the frame again"};
  }
  polygons.ends.push_back(corners.size());
  return Success{};
}

} // namespace

Result<MeshFile> parseObj(std::string_view text, std::string_view name) {
  MeshFile mesh;
  std::string_view line;
  for (std::size_t number = 1; nextLine(text, line); ++number) {
    const std::string_view keyword = nextWord(line);
    if (keyword == "v") {
      const auto position = parsePosition(line, placeOf(name, number));
      if (!position) {
        return position.error();
      }
      mesh.positions.push_back(*position);
    } else if (keyword == "f") {
      const auto added = parseFace(line, placeOf(name, number), mesh.positions.size(), mesh.polygons);
      if (!added) {
        return added.error();
      }
    }
  }
  if (mesh.polygons.ends.empty()) {
    return Error{"the file holds no faces", std::string(name), "give a mesh with triangles or polygons"};
  }
  for (const std::uint32_t corner : mesh.polygons.corners) {
    if (corner >= mesh.positions.size()) {
      return Error{"a face names vertex " + std::to_string(corner + 1) + " of " +
                       std::to_string(mesh.positions.size()),
                   std::string(name), "export the frame again"};
    }
  }
  cutIntoTriangles(mesh);
  return mesh;
}

} // namespace stretch::skinning
