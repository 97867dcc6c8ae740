#include "skinning/compress/usable_mesh.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "skinning/sequence/topology.h"

namespace stretch::skinning {
namespace {

/// The mesh and motion of some of the vertices alone.
MeshSequence withVertices(const MeshSequence& sequence, const std::vector<std::uint32_t>& vertices) {
  MeshSequence part;
  part.name = sequence.name;
  part.clipName = sequence.clipName;
  part.frameNames = sequence.frameNames;
  part.framesPerSecond = sequence.framesPerSecond;
  part.vertexCount = vertices.size();
  part.triangles = sequence.triangles;
  for (Triangle& triangle : part.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), corner) -
                                          vertices.begin());
    }
  }
  part.positions.reserve(vertices.size() * sequence.frameCount());
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    const std::span<const glm::vec3> frame = sequence.frame(k);
    for (const std::uint32_t vertex : vertices) {
      part.positions.push_back(frame[vertex]);
    }
  }
  return part;
}

} // namespace

UsableMesh usableMesh(const MeshSequence& sequence) {
  UsableMesh usable;
  usable.vertices = usedVertices(sequence.triangles);
  const std::size_t loose = sequence.vertexCount - usable.vertices.size();
  const bool unlike = inspectTopology(sequence.frame(0), sequence.triangles).unlikeEdges > 0;
  if (loose == 0 && !unlike) {
    return usable;
  }
  usable.changed = withVertices(sequence, usable.vertices);
  if (loose > 0) {
    usable.warnings.push_back(
        fmt::format("{} vertices of no triangle count in no fit and in no error", loose));
  }
  if (unlike) {
    const std::size_t turned = orientOutwards(usable.changed->frame(0), usable.changed->triangles);
    usable.warnings.push_back(
        fmt::format("neighbouring triangles are wound against each other: {} of {} have been turned outwards",
                    turned, sequence.triangles.size()));
  }
  return usable;
}

void giveBackVertices(const UsableMesh& usable, const MeshSequence& sequence, SkinnedSequence& skinned) {
  if (!usable.changed) {
    return;
  }
  const std::span<const glm::vec3> bind = sequence.frame(0);
  Influences first;
  first.weights[0] = 1.0F;
  std::vector<Influences> influences(sequence.vertexCount, first);
  for (std::size_t i = 0; i < usable.vertices.size(); ++i) {
    influences[usable.vertices[i]] = skinned.influences[i];
  }
  skinned.influences = std::move(influences);
  skinned.bindPositions.assign(bind.begin(), bind.end());
  skinned.surface = sequence.surface;
  for (Triangle& triangle : skinned.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = usable.vertices[corner];
    }
  }
}

} // namespace stretch::skinning
