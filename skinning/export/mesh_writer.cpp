#include "skinning/export/mesh_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/gltf/import/mesh_surface.h"

namespace stretch::skinning {
namespace {

using gltf::MeshSurface;
using gltf::SurfacePart;

/// Joints and weights that one pair of attributes holds.
constexpr std::size_t influencesOfSet = 4;

using QuantisedWeights = std::array<std::uint16_t, Influences::capacity>;

/// Weights in parts of 65535. The largest takes what rounding leaves, so that they sum to 65535 exactly.
QuantisedWeights quantised(const Influences& influences) {
  QuantisedWeights integers{};
  int left = 65535;
  for (std::size_t i = 0; i < integers.size(); ++i) {
    integers[i] = static_cast<std::uint16_t>(std::lround(influences.weights[i] * 65535.0F));
    left -= integers[i];
  }
  auto* const largest = std::max_element(integers.begin(), integers.end());
  *largest = static_cast<std::uint16_t>(*largest + left);
  return integers;
}

/// Normals of the bind mesh, one for each vertex of the sequence: of its triangles, by their area.
std::vector<glm::vec3> smoothNormals(const SkinnedSequence& sequence) {
  std::vector<Vec3> sums(sequence.bindPositions.size(), Vec3(0.0));
  for (const Triangle& t : sequence.triangles) {
    const Vec3 a(sequence.bindPositions[t[0]]);
    const Vec3 normal =
        glm::cross(Vec3(sequence.bindPositions[t[1]]) - a, Vec3(sequence.bindPositions[t[2]]) - a);
    for (const std::uint32_t corner : t) {
      sums[corner] += normal;
    }
  }
  std::vector<glm::vec3> normals;
  for (const Vec3& sum : sums) {
    const double length = glm::length(sum);
    normals.emplace_back(length > 0.0 ? sum / length : Vec3(0.0, 1.0, 0.0));
  }
  return normals;
}

/// The surface of a sequence that gives none: its vertices, in one part.
MeshSurface plainSurface(const SkinnedSequence& sequence) {
  MeshSurface surface;
  surface.places.resize(sequence.bindPositions.size());
  std::iota(surface.places.begin(), surface.places.end(), 0U);
  surface.triangles = sequence.triangles;
  surface.parts = {{sequence.name, -1, 0, sequence.triangles.size()}};
  return surface;
}

/// Vertices `first` to `first + count` of the surface, and the parts that are made of them.
struct Slice {
  std::size_t first = 0;
  std::size_t count = 0;
  std::vector<SurfacePart> parts;
};

/// A slice for each part where no two share vertices, so that each keeps its own; else one for all.
std::vector<Slice> slicesOf(const MeshSurface& surface) {
  std::vector<Slice> slices;
  std::size_t taken = 0;
  for (const SurfacePart& part : surface.parts) {
    std::size_t low = surface.places.size();
    std::size_t high = 0;
    for (std::size_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
      const auto [least, most] = std::ranges::minmax(surface.triangles[t]);
      low = std::min<std::size_t>(low, least);
      high = std::max<std::size_t>(high, most);
    }
    if (part.triangleCount == 0) {
      continue;
    }
    if (low < taken) {
      return {{0, surface.places.size(), surface.parts}};
    }
    slices.push_back({taken, high + 1 - taken, {part}});
    taken = high + 1;
  }
  if (!slices.empty()) {
    slices.back().count = surface.places.size() - slices.back().first;
  }
  return slices;
}

class MeshWriter {
public:
  MeshWriter(const SkinnedSequence& sequence, const MeshSurface& surface, const MeshEncoding& encoding,
             gltf::NewFile& file)
      : sequence_(sequence), surface_(surface), encoding_(encoding), file_(file),
        smooth_(surface.normals.empty() ? smoothNormals(sequence) : std::vector<glm::vec3>()) {}

  WrittenMeshes write() {
    addMaterials();
    for (const Slice& slice : slicesOf(surface_)) {
      const auto attributes = attributesOf(slice);
      for (const auto& [material, indices] : indicesByMaterial(slice)) {
        addPrimitive(nameOf(slice), {attributes, addIndices(indices, slice.count), named(material)});
        const auto first = surface_.places.begin() + static_cast<std::ptrdiff_t>(slice.first);
        places_.insert(places_.end(), first, first + static_cast<std::ptrdiff_t>(slice.count));
      }
    }
    for (std::size_t mesh = 0; mesh < names_.size(); ++mesh) {
      file_.setMesh(file_.addNode(names_[mesh]), mesh, 0);
    }
    return {names_.size(), std::move(places_)};
  }

private:
  void addMaterials() {
    if (surface_.materials != nullptr) {
      file_.takeMaterials(*surface_.materials);
    } else {
      file_.addMaterial(
          {.name = "body", .baseColor = {0.8, 0.8, 0.78, 1.0}, .roughness = 0.8, .isDoubleSided = true});
    }
  }

  /// The material of a part, -1 for none: a surface without materials has the one that is added for it.
  [[nodiscard]] std::optional<std::size_t> named(int material) const {
    const bool isNone = surface_.materials != nullptr && material < 0;
    return isNone ? std::nullopt : std::optional(static_cast<std::size_t>(std::max(material, 0)));
  }

  [[nodiscard]] std::string nameOf(const Slice& slice) const {
    const bool own = slice.parts.size() == 1 && !slice.parts.front().name.empty();
    return own ? slice.parts.front().name : sequence_.name;
  }

  /// Primitives of one name that follow each other belong to one mesh.
  void addPrimitive(const std::string& name, const gltf::NewPrimitive& primitive) {
    if (names_.empty() || names_.back() != name) {
      names_.push_back(name);
      file_.addMesh(name);
    }
    file_.addPrimitive(names_.size() - 1, primitive);
  }

  /// The triangles as the sequence winds them, which may have been turned outwards since they were read.
  [[nodiscard]] Triangle wound(std::size_t triangle) const {
    Triangle corners = surface_.triangles[triangle];
    const Triangle& wanted = sequence_.triangles[triangle];
    const auto start = std::ranges::find(wanted, surface_.places[corners[0]]) - wanted.begin();
    if (start < 3 && wanted[static_cast<std::size_t>(start + 1) % 3] != surface_.places[corners[1]]) {
      std::swap(corners[1], corners[2]);
    }
    return corners;
  }

  [[nodiscard]] std::map<int, std::vector<std::uint32_t>> indicesByMaterial(const Slice& slice) const {
    std::map<int, std::vector<std::uint32_t>> indices;
    for (const SurfacePart& part : slice.parts) {
      for (std::size_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
        for (const std::uint32_t corner : wound(t)) {
          indices[part.material].push_back(corner - static_cast<std::uint32_t>(slice.first));
        }
      }
    }
    return indices;
  }

  std::size_t addIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    const gltf::AccessorForm form{.target = gltf::ViewTarget::indices};
    if (vertices < 65535) {
      return file_.addAccessor(std::vector<std::uint16_t>(indices.begin(), indices.end()), form);
    }
    return file_.addAccessor(indices, form);
  }

  /// Numbers of an attribute for the vertices of a slice: `values(vertex)` answers a glm vector.
  template <typename Values>
  std::size_t addAttribute(const Slice& slice, bool bounds, const Values& values) {
    std::vector<float> numbers;
    glm::length_t width = 0;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const auto value = values(v);
      width = value.length();
      for (glm::length_t i = 0; i < width; ++i) {
        numbers.push_back(value[i]);
      }
    }
    return addVertices(numbers, {.width = static_cast<std::size_t>(width), .bounds = bounds});
  }

  template <typename Number>
  std::size_t addVertices(const std::vector<Number>& numbers, gltf::AccessorForm form) {
    form.target = gltf::ViewTarget::vertices;
    return file_.addAccessor(numbers, form);
  }

  std::map<std::string, std::size_t> attributesOf(const Slice& slice) {
    std::map<std::string, std::size_t> attributes;
    attributes["POSITION"] =
        encoding_.grid ? addPlaces(slice) : addAttribute(slice, true, [this](std::size_t v) {
          return sequence_.bindPositions[surface_.places[v]];
        });
    const auto normal = [this](std::size_t v) {
      return surface_.normals.empty() ? smooth_[surface_.places[v]] : surface_.normals[v];
    };
    attributes["NORMAL"] = encoding_.grid ? addDirections(slice, normal) : addAttribute(slice, false, normal);
    for (std::size_t set = 0; set < surface_.texCoords.size(); ++set) {
      attributes[fmt::format("TEXCOORD_{}", set)] =
          addFractions(slice, [&](std::size_t v) { return surface_.texCoords[set][v]; });
    }
    if (!surface_.colors.empty()) {
      attributes["COLOR_0"] = addFractions(slice, [this](std::size_t v) { return surface_.colors[v]; });
    }
    for (std::size_t set = 0; set < influenceSets(slice); ++set) {
      attributes[fmt::format("JOINTS_{}", set)] = addJoints(slice, set);
      attributes[fmt::format("WEIGHTS_{}", set)] = addWeights(slice, set);
    }
    return attributes;
  }

  std::size_t addPlaces(const Slice& slice) {
    std::vector<std::int16_t> numbers;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const auto place = encoding_.grid->of(Vec3(sequence_.bindPositions[surface_.places[v]]));
      numbers.insert(numbers.end(), place.begin(), place.end());
      numbers.push_back(0);
    }
    return addVertices(numbers, {.width = 3, .normalised = true, .bounds = true, .stored = 4});
  }

  template <typename Direction>
  std::size_t addDirections(const Slice& slice, const Direction& direction) {
    std::vector<std::int8_t> numbers;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const glm::vec3 value = direction(v);
      for (glm::length_t i = 0; i < 3; ++i) {
        numbers.push_back(static_cast<std::int8_t>(std::lround(std::clamp(value[i], -1.0F, 1.0F) * 127.0F)));
      }
      numbers.push_back(0);
    }
    return addVertices(numbers, {.width = 3, .normalised = true, .stored = 4});
  }

  /// Numbers in 0..1 as 16-bit integers where that is asked for; those beyond stay as they are.
  template <typename Values>
  std::size_t addFractions(const Slice& slice, const Values& values) {
    std::vector<std::uint16_t> numbers;
    std::size_t width = 0;
    bool fits = encoding_.grid.has_value();
    for (std::size_t v = slice.first; v < slice.first + slice.count && fits; ++v) {
      const auto value = values(v);
      width = static_cast<std::size_t>(value.length());
      for (glm::length_t i = 0; i < value.length(); ++i) {
        fits = fits && value[i] >= 0.0F && value[i] <= 1.0F;
        numbers.push_back(fits ? static_cast<std::uint16_t>(std::lround(value[i] * 65535.0F))
                               : std::uint16_t{0});
      }
    }
    return fits ? addVertices(numbers, {.width = width, .normalised = true})
                : addAttribute(slice, false, values);
  }

  [[nodiscard]] std::size_t influenceSets(const Slice& slice) const {
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const auto& weights = influencesOf(v).weights;
      if (std::any_of(weights.begin() + influencesOfSet, weights.end(), [](float w) { return w > 0.0F; })) {
        return Influences::capacity / influencesOfSet;
      }
    }
    return 1;
  }

  [[nodiscard]] const Influences& influencesOf(std::size_t vertex) const {
    return sequence_.influences[surface_.places[vertex]];
  }

  std::size_t addJoints(const Slice& slice, std::size_t set) {
    std::vector<std::uint16_t> joints;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const Influences& influences = influencesOf(v);
      const QuantisedWeights weights = quantised(influences);
      for (std::size_t i = set * influencesOfSet; i < (set + 1) * influencesOfSet; ++i) {
        // glTF asks for joint 0 where the weight is 0, be it so only after rounding.
        const bool used = encoding_.quantiseWeights ? weights[i] > 0 : influences.weights[i] > 0.0F;
        joints.push_back(used ? influences.bones[i] : std::uint16_t{0});
      }
    }
    if (sequence_.bones.size() <= 256) {
      return addVertices(std::vector<std::uint8_t>(joints.begin(), joints.end()), {.width = 4});
    }
    return addVertices(joints, {.width = 4});
  }

  std::size_t addWeights(const Slice& slice, std::size_t set) {
    std::vector<float> exact;
    std::vector<std::uint16_t> rounded;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const Influences& influences = influencesOf(v);
      const QuantisedWeights integers = quantised(influences);
      for (std::size_t i = set * influencesOfSet; i < (set + 1) * influencesOfSet; ++i) {
        exact.push_back(influences.weights[i]);
        rounded.push_back(integers[i]);
      }
    }
    return encoding_.quantiseWeights ? addVertices(rounded, {.width = 4, .normalised = true})
                                     : addVertices(exact, {.width = 4});
  }

  const SkinnedSequence& sequence_;
  const MeshSurface& surface_;
  const MeshEncoding& encoding_;
  gltf::NewFile& file_;
  std::vector<glm::vec3> smooth_;
  std::vector<std::string> names_; ///< Names of the meshes.
  std::vector<std::uint32_t> places_;
};

} // namespace

WrittenMeshes writeMeshes(const SkinnedSequence& sequence, const MeshEncoding& encoding,
                          gltf::NewFile& file) {
  if (sequence.surface != nullptr) {
    return MeshWriter(sequence, *sequence.surface, encoding, file).write();
  }
  return MeshWriter(sequence, plainSurface(sequence), encoding, file).write();
}

} // namespace stretch::skinning
