#include "skinning/sequence/obj_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/math/srgb.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

using gltf::MeshSurface;

/// A corner of a face: places in the file's lists, -1 for none.
struct ObjCorner {
  long long position = -1;
  long long texCoord = -1;
  long long normal = -1;

  friend auto operator<=>(const ObjCorner&, const ObjCorner&) = default;
};

template <typename Vector>
Vector numbersOfLine(std::string_view words) {
  Vector numbers(0.0F);
  for (glm::length_t i = 0; i < Vector::length(); ++i) {
    const double number = parseNumber(nextWord(words)).value_or(0.0);
    numbers[i] = std::abs(number) <= largestCoordinate ? static_cast<float>(number) : 0.0F;
  }
  return numbers;
}

/// An index from 1, or negative from the end of what came before; -1 for none. What it names may come later.
long long indexOf(std::string_view text, std::size_t count) {
  const auto index = parseNumber<long long>(text);
  const bool isNone = !index || *index == 0 || *index < -static_cast<long long>(count);
  return isNone ? -1 : *index < 0 ? static_cast<long long>(count) + *index : *index - 1;
}

void dropMissing(long long& place, std::size_t count) {
  place = place < static_cast<long long>(count) ? place : -1;
}

/// Reads the lines of an OBJ that parseObj leaves aside.
class ObjSurfaceReader {
public:
  void read(std::string_view text) {
    std::string_view line;
    while (nextLine(text, line)) {
      readLine(nextWord(line), line);
    }
    for (ObjCorner& corner : corners_) {
      dropMissing(corner.position, positions_);
      dropMissing(corner.texCoord, texCoords_.size());
      dropMissing(corner.normal, normals_.size());
    }
  }

  [[nodiscard]] bool isPlain() const {
    return texCoords_.empty() && normals_.empty() && names_.empty() && !hasColors();
  }
  [[nodiscard]] const std::vector<std::string>& libraries() const { return libraries_; }
  [[nodiscard]] const std::vector<std::string>& materialNames() const { return names_; }

  /// The surface without its materials; nothing when the faces are not those of the mesh.
  [[nodiscard]] std::optional<MeshSurface> surface(const MeshFile& mesh) const {
    const bool isWhole =
        std::ranges::all_of(corners_, [](const ObjCorner& corner) { return corner.position >= 0; });
    if (corners_.size() != mesh.polygons.corners.size() || positions_ != mesh.positions.size() || !isWhole) {
      return std::nullopt;
    }
    const std::vector<ObjCorner> vertices = verticesOf(mesh.positions.size());
    MeshSurface surface;
    surface.parts = parts_;
    for (const ObjCorner& vertex : vertices) {
      surface.places.push_back(static_cast<std::uint32_t>(vertex.position));
    }
    for (const Triangle& cut : mesh.cuts) {
      surface.triangles.push_back({numberOf(vertices, corners_[cut[0]]), numberOf(vertices, corners_[cut[1]]),
                                   numberOf(vertices, corners_[cut[2]])});
    }
    addTexCoords(vertices, surface);
    addNormals(vertices, surface);
    for (std::size_t i = 0; i < vertices.size() && hasColors(); ++i) {
      surface.colors.push_back(colors_[surface.places[i]]);
    }
    return surface;
  }

private:
  void readLine(std::string_view keyword, std::string_view words) {
    if (keyword == "v") {
      ++positions_;
      readColor(words);
    } else if (keyword == "vt") {
      const auto coordinate = numbersOfLine<glm::vec2>(words);
      texCoords_.emplace_back(coordinate.x, 1.0F - coordinate.y); // glTF counts v downwards.
    } else if (keyword == "vn") {
      normals_.push_back(numbersOfLine<glm::vec3>(words));
    } else if (keyword == "f") {
      readFace(words);
    } else if (keyword == "usemtl") {
      material_ = materialOf(std::string(trimmed(words)));
    } else if (keyword == "mtllib") {
      libraries_.emplace_back(trimmed(words));
    } else if (keyword == "o" || keyword == "g") {
      name_ = trimmed(words);
    }
  }

  /// Red, green and blue from 0 to 1 behind the place, encoded as sRGB.
  void readColor(std::string_view words) {
    for (int axis = 0; axis < 3; ++axis) {
      static_cast<void>(nextWord(words));
    }
    glm::vec4 color(1.0F);
    for (glm::length_t i = 0; i < 3; ++i) {
      const auto part = parseNumber(nextWord(words));
      if (!part) {
        return;
      }
      color[i] = static_cast<float>(linearFromSrgb(std::clamp(*part, 0.0, 1.0)));
    }
    colors_.push_back(color);
  }

  [[nodiscard]] bool hasColors() const { return positions_ > 0 && colors_.size() == positions_; }

  int materialOf(const std::string& name) {
    const auto [known, isNew] = numbers_.try_emplace(name, static_cast<int>(names_.size()));
    if (isNew) {
      names_.push_back(name);
    }
    return known->second;
  }

  void readFace(std::string_view words) {
    std::size_t count = 0;
    for (std::string_view word = nextWord(words); !word.empty(); word = nextWord(words)) {
      corners_.push_back(cornerOf(word));
      ++count;
    }
    countTriangles(std::max<std::size_t>(count, 2) - 2);
  }

  /// "7", "7/2", "7//5" or "7/2/5".
  [[nodiscard]] ObjCorner cornerOf(std::string_view word) const {
    std::array<std::string_view, 3> indices;
    for (std::string_view& index : indices) {
      const std::size_t slash = word.find('/');
      index = word.substr(0, slash);
      word = slash == std::string_view::npos ? std::string_view() : word.substr(slash + 1);
    }
    return {indexOf(indices[0], positions_), indexOf(indices[1], texCoords_.size()),
            indexOf(indices[2], normals_.size())};
  }

  void countTriangles(std::size_t count) {
    if (parts_.empty() || parts_.back().material != material_ || parts_.back().name != name_) {
      parts_.push_back({name_, material_, triangles_, 0});
    }
    parts_.back().triangleCount += count;
    triangles_ += count;
  }

  /// Each corner once, by place; a vertex that no face has stands alone, so that none is lost.
  [[nodiscard]] std::vector<ObjCorner> verticesOf(std::size_t positions) const {
    std::vector<bool> used(positions, false);
    for (const ObjCorner& corner : corners_) {
      used[static_cast<std::size_t>(corner.position)] = true;
    }
    std::vector<ObjCorner> vertices = corners_;
    for (std::size_t v = 0; v < positions; ++v) {
      if (!used[v]) {
        vertices.push_back({static_cast<long long>(v), -1, -1});
      }
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  static std::uint32_t numberOf(const std::vector<ObjCorner>& vertices, const ObjCorner& corner) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, corner) - vertices.begin());
  }

  void addTexCoords(const std::vector<ObjCorner>& vertices, MeshSurface& surface) const {
    if (texCoords_.empty()) {
      return;
    }
    std::vector<glm::vec2> set;
    set.reserve(vertices.size());
    for (const ObjCorner& vertex : vertices) {
      set.push_back(vertex.texCoord < 0 ? glm::vec2(0.0F)
                                        : texCoords_[static_cast<std::size_t>(vertex.texCoord)]);
    }
    surface.texCoords.push_back(std::move(set));
  }

  /// All or none: a mesh whose normals are given in part is shaded by its triangles.
  void addNormals(const std::vector<ObjCorner>& vertices, MeshSurface& surface) const {
    const bool complete =
        std::ranges::none_of(corners_, [](const ObjCorner& corner) { return corner.normal < 0; });
    for (const ObjCorner& vertex : vertices) {
      const glm::vec3 normal = !complete || vertex.normal < 0
                                   ? glm::vec3(0.0F)
                                   : normals_[static_cast<std::size_t>(vertex.normal)];
      const float length = glm::length(normal);
      surface.normals.push_back(length > 0.0F ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F));
    }
    if (!complete) {
      surface.normals.clear();
    }
  }

  std::size_t positions_ = 0;
  std::vector<glm::vec4> colors_; ///< Of the places that have one.
  std::vector<glm::vec2> texCoords_;
  std::vector<glm::vec3> normals_;
  std::vector<ObjCorner> corners_; ///< Of all faces, one after the other.
  std::size_t triangles_ = 0;
  std::vector<gltf::SurfacePart> parts_;
  std::vector<std::string> names_;
  std::map<std::string, int> numbers_; ///< Of the names, their places.
  std::vector<std::string> libraries_;
  std::string name_;
  int material_ = -1;
};

/// The MTL files that an OBJ names, beside it or below: a line may hold one name with blanks, or several.
std::vector<std::filesystem::path> libraryFiles(const std::vector<std::string>& lines,
                                                const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const std::string& line : lines) {
    std::error_code problem;
    if (std::filesystem::is_regular_file(folder / std::filesystem::path(line).filename(), problem)) {
      files.push_back(folder / std::filesystem::path(line).filename());
      continue;
    }
    std::string_view words = line;
    for (std::string_view word = nextWord(words); !word.empty(); word = nextWord(words)) {
      files.push_back(folder / std::filesystem::path(word).filename());
    }
  }
  return files;
}

/// The surface of a PLY: its vertices are those of the mesh.
std::shared_ptr<const MeshSurface> surfaceOfVertices(const MeshFile& mesh) {
  if (mesh.normals.empty() && mesh.texCoords.empty() && mesh.colors.empty()) {
    return nullptr;
  }
  MeshSurface surface;
  surface.places.resize(mesh.positions.size());
  std::iota(surface.places.begin(), surface.places.end(), 0U);
  surface.normals = mesh.normals;
  surface.colors = mesh.colors;
  if (!mesh.texCoords.empty()) {
    surface.texCoords = {mesh.texCoords};
    for (glm::vec2& coordinate : surface.texCoords.front()) {
      coordinate.y = 1.0F - coordinate.y; // glTF counts v downwards.
    }
  }
  surface.triangles = mesh.triangles;
  surface.parts = {{"", -1, 0, mesh.triangles.size()}};
  return std::make_shared<const MeshSurface>(std::move(surface));
}

} // namespace

std::shared_ptr<const gltf::MeshSurface> surfaceOfMeshFile(const std::filesystem::path& path,
                                                           const MeshFile& mesh,
                                                           std::vector<std::string>& warnings) {
  if (lowerExtension(path) == ".ply") {
    return surfaceOfVertices(mesh);
  }
  const Result<std::string> text = readText(path);
  return text ? surfaceOfObj(*text, mesh, path, warnings) : nullptr;
}

std::shared_ptr<const gltf::MeshSurface> surfaceOfObj(std::string_view text, const MeshFile& mesh,
                                                      const std::filesystem::path& path,
                                                      std::vector<std::string>& warnings) {
  ObjSurfaceReader reader;
  reader.read(text);
  if (reader.isPlain()) {
    return nullptr;
  }
  std::optional<MeshSurface> surface = reader.surface(mesh);
  if (!surface) {
    return nullptr;
  }
  if (!reader.materialNames().empty()) {
    surface->materials = std::make_shared<const gltf::Source>(materialsOfMtl(
        libraryFiles(reader.libraries(), path.parent_path()), reader.materialNames(), warnings));
  }
  return std::make_shared<const MeshSurface>(*std::move(surface));
}

} // namespace stretch::skinning
