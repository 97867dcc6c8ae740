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

#include "core/gltf/json.h"
#include "core/gltf/material_library.h"
#include "core/gltf/mesh_surface.h"

namespace stretch::skinning {
namespace {

using gltf::Json;
using gltf::MeshSurface;
using gltf::SurfacePart;

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
  MeshWriter(const SkinnedSequence& sequence, const MeshSurface& surface, bool quantise, Json& json,
             GltfBuffers& buffers)
      : sequence_(sequence), surface_(surface), quantise_(quantise), json_(json), buffers_(buffers),
        smooth_(surface.normals.empty() ? smoothNormals(sequence) : std::vector<glm::vec3>()) {}

  std::size_t write() {
    addMaterials();
    for (const Slice& slice : slicesOf(surface_)) {
      const Json attributes = attributesOf(slice);
      for (const auto& [material, indices] : indicesByMaterial(slice)) {
        addPrimitive(nameOf(slice), attributes, addIndices(indices, slice.count), material);
      }
    }
    for (std::size_t mesh = 0; mesh < json_["meshes"].size(); ++mesh) {
      json_["nodes"].push_back({{"name", json_["meshes"][mesh]["name"]}, {"mesh", mesh}, {"skin", 0}});
    }
    return json_["meshes"].size();
  }

private:
  void addMaterials() {
    if (surface_.materials != nullptr) {
      gltf::putMaterials(*surface_.materials, json_,
                         [this](std::span<const std::uint8_t> image) { return buffers_.addView(image); });
      return;
    }
    json_["materials"] = Json::array(
        {{{"name", "body"},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {0.8, 0.8, 0.78, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}},
          {"doubleSided", true}}});
  }

  [[nodiscard]] std::string nameOf(const Slice& slice) const {
    const bool own = slice.parts.size() == 1 && !slice.parts.front().name.empty();
    return own ? slice.parts.front().name : sequence_.name;
  }

  /// Primitives of one name that follow each other belong to one mesh.
  void addPrimitive(const std::string& name, const Json& attributes, std::size_t indices, int material) {
    Json primitive{{"attributes", attributes}, {"indices", indices}};
    if (surface_.materials == nullptr || material >= 0) {
      primitive["material"] = std::max(material, 0);
    }
    Json& meshes = json_["meshes"];
    if (meshes.empty() || meshes.back()["name"] != name) {
      meshes.push_back({{"name", name}, {"primitives", Json::array()}});
    }
    meshes.back()["primitives"].push_back(std::move(primitive));
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
    if (vertices < 65535) {
      const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
      return buffers_.addIntegers(narrow, "SCALAR", 1, GltfBuffers::Target::indices, false);
    }
    return buffers_.addIntegers(indices, "SCALAR", 1, GltfBuffers::Target::indices, false);
  }

  /// Numbers of an attribute for the vertices of a slice: `values(vertex)` answers a glm vector.
  template <typename Values>
  std::size_t addAttribute(const Slice& slice, const char* type, bool bounds, const Values& values) {
    std::vector<float> numbers;
    glm::length_t width = 0;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const auto value = values(v);
      width = value.length();
      for (glm::length_t i = 0; i < width; ++i) {
        numbers.push_back(value[i]);
      }
    }
    return buffers_.addFloats(numbers, type, static_cast<std::size_t>(width), GltfBuffers::Target::vertices,
                              bounds);
  }

  Json attributesOf(const Slice& slice) {
    Json attributes;
    attributes["POSITION"] = addAttribute(
        slice, "VEC3", true, [this](std::size_t v) { return sequence_.bindPositions[surface_.places[v]]; });
    attributes["NORMAL"] = addAttribute(slice, "VEC3", false, [this](std::size_t v) {
      return surface_.normals.empty() ? smooth_[surface_.places[v]] : surface_.normals[v];
    });
    for (std::size_t set = 0; set < surface_.texCoords.size(); ++set) {
      attributes[fmt::format("TEXCOORD_{}", set)] =
          addAttribute(slice, "VEC2", false, [&](std::size_t v) { return surface_.texCoords[set][v]; });
    }
    if (!surface_.colors.empty()) {
      attributes["COLOR_0"] =
          addAttribute(slice, "VEC4", false, [this](std::size_t v) { return surface_.colors[v]; });
    }
    attributes["JOINTS_0"] = addJoints(slice);
    attributes["WEIGHTS_0"] = addWeights(slice);
    return attributes;
  }

  [[nodiscard]] const Influences& influencesOf(std::size_t vertex) const {
    return sequence_.influences[surface_.places[vertex]];
  }

  std::size_t addJoints(const Slice& slice) {
    std::vector<std::uint16_t> joints;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const Influences& influences = influencesOf(v);
      const QuantisedWeights weights = quantised(influences);
      for (std::size_t i = 0; i < Influences::capacity; ++i) {
        // glTF asks for joint 0 where the weight is 0, be it so only after rounding.
        const bool used = quantise_ ? weights[i] > 0 : influences.weights[i] > 0.0F;
        joints.push_back(used ? influences.bones[i] : std::uint16_t{0});
      }
    }
    if (sequence_.bones.size() <= 256) {
      const std::vector<std::uint8_t> narrow(joints.begin(), joints.end());
      return buffers_.addIntegers(narrow, "VEC4", 4, GltfBuffers::Target::vertices, false);
    }
    return buffers_.addIntegers(joints, "VEC4", 4, GltfBuffers::Target::vertices, false);
  }

  std::size_t addWeights(const Slice& slice) {
    std::vector<float> exact;
    std::vector<std::uint16_t> rounded;
    for (std::size_t v = slice.first; v < slice.first + slice.count; ++v) {
      const Influences& influences = influencesOf(v);
      const QuantisedWeights integers = quantised(influences);
      exact.insert(exact.end(), influences.weights.begin(), influences.weights.end());
      rounded.insert(rounded.end(), integers.begin(), integers.end());
    }
    return quantise_ ? buffers_.addIntegers(rounded, "VEC4", 4, GltfBuffers::Target::vertices, true)
                     : buffers_.addFloats(exact, "VEC4", 4, GltfBuffers::Target::vertices, false);
  }

  const SkinnedSequence& sequence_;
  const MeshSurface& surface_;
  bool quantise_;
  Json& json_;
  GltfBuffers& buffers_;
  std::vector<glm::vec3> smooth_;
};

} // namespace

std::size_t writeMeshes(const SkinnedSequence& sequence, bool quantise, gltf::Json& json,
                        GltfBuffers& buffers) {
  if (sequence.surface != nullptr) {
    return MeshWriter(sequence, *sequence.surface, quantise, json, buffers).write();
  }
  const MeshSurface plain = plainSurface(sequence);
  return MeshWriter(sequence, plain, quantise, json, buffers).write();
}

} // namespace stretch::skinning
