#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"

namespace stretch::gltf {

/// Reads the parts of one primitive of a mesh; each complains about what it cannot use.
class PrimitiveParts {
public:
  PrimitiveParts(const Source& source, const Json& json, std::string where, DecodeBudget& budget,
                 Problems& problems);

  /// Positions, normals, the texture coordinates of two sets, colours. First of all: the others compare with
  /// the positions.
  void readVertices(int texCoordSet, int emissiveSet, Primitive& made);
  /// JOINTS_0 and 1, WEIGHTS_0 and 1, weights normalised. Without joints (no skin uses the mesh) nothing is
  /// read.
  void readInfluences(std::optional<std::size_t> jointCount, Primitive& made);
  /// Indices, or the vertices in their order, strips and fans unrolled.
  void readTriangles(Primitive& made);
  /// Gives vertices whose weights are no numbers, as exporters write 0 / 0 for those without any, the
  /// influences of the nearest vertex along the triangles; a piece that has none follows its first joint.
  void spreadInfluences(Primitive& made);
  void readMorphTargets(Primitive& made);
  /// Normals that the file lacks: of the faces around a vertex, by their area. All of unit length.
  void completeNormals(Primitive& made);

  [[nodiscard]] bool failed() const { return failed_; }

private:
  /// Values of an attribute whose accessor is one of `types` ("VEC3 VEC4") and has one element for each
  /// vertex. Empty without it.
  struct Attribute {
    int accessor = -1;
    AccessorShape shape;
  };
  std::optional<Attribute> attribute(const Json& attributes, std::string_view name, std::string_view types,
                                     std::string_view place);
  void fail(std::string_view place, std::string what);
  bool isAllowedComponent(std::string_view name, const AccessorShape& shape) const;
  std::vector<glm::vec3> vectors(const Attribute& attribute) const;
  void addInfluenceSet(int set, std::size_t jointCount, Primitive& made);
  MorphTarget readMorphTarget(const Json& json, const std::string& place);
  std::vector<glm::vec2> readTexCoords(int set);
  void readColors(Primitive& made);
  void checkOtherAttributes();
  std::vector<std::uint32_t> readIndices();

  const Source& source_;
  const Json& json_;
  std::string where_;
  DecodeBudget& budget_;
  Problems& problems_;
  std::size_t vertexCount_ = 0;
  std::vector<std::uint32_t> unweighted_; // vertices whose weights are no numbers
  bool failed_ = false;
};

/// Makes the weights of every vertex sum to 1. Answers whether any was off by more than rounding.
bool normalizeWeights(std::vector<VertexInfluences>& influences);

/// Corners of triangles from those of a strip (mode 5) or fan (mode 6); a list (4) loses its incomplete last
/// triangle.
[[nodiscard]] std::vector<std::uint32_t> unrolledTriangles(const std::vector<std::uint32_t>& corners,
                                                           int mode);

} // namespace stretch::gltf
