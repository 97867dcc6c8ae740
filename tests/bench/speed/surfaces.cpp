#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "skinning/geometry/geodesic_distance.h"
#include "skinning/geometry/shape_diameter.h"
#include "skinning/linear_blend_skinning.h"
#include "skinning/surface_part.h"
#include "tests/bench/speed/cgal_peer.h"
#include "tests/bench/speed/rows.h"

namespace stretch::bench {

namespace {

struct Body {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// A knobbly torus with a grid of so many vertices: closed, smooth, no two triangles alike.
Body knobblyTorus(std::uint32_t around, std::uint32_t across) {
  Body body;
  const auto corner = [&](std::uint32_t i, std::uint32_t j) { return (i % around) * across + j % across; };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2.0 * pi * i / around;
      const double v = 2.0 * pi * j / across;
      const double thick = 0.4 * (1.0 + 0.15 * std::sin(7.0 * u) * std::cos(3.0 * v));
      const double out = 1.0 + thick * std::cos(v);
      body.positions.emplace_back(out * std::cos(u), thick * std::sin(v), out * std::sin(u));
      body.triangles.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j)});
      body.triangles.push_back({corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)});
    }
  }
  return body;
}

/// The least that linear blend skinning takes: one primitive after the other, single precision, four
/// influences, no morph targets.
void skinByHand(const Scene& scene, const FrameState& frame, std::vector<glm::vec3>& out) {
  out.clear();
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    const Node& holder = scene.nodes[at(node)];
    std::vector<glm::mat4x3> joints;
    if (holder.skin >= 0) {
      for (const Mat4& matrix : skinMatrices(scene.skins[at(holder.skin)], frame)) {
        joints.emplace_back(glm::mat4(matrix));
      }
    }
    const glm::mat4x3 rigid(glm::mat4(meshMatrix(frame, node)));
    for (const Primitive& primitive : scene.meshes[at(holder.mesh)].primitives) {
      const std::size_t first = out.size();
      out.resize(first + primitive.positions.size());
      for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        glm::mat4x3 sum = rigid;
        if (!joints.empty() && !primitive.influences.empty()) {
          const VertexInfluences& influences = primitive.influences[i];
          sum = influences.weights[0] * joints[influences.joints[0]];
          for (std::size_t k = 1; k < 4 && influences.weights[k] != 0.0F; ++k) {
            sum += influences.weights[k] * joints[influences.joints[k]];
          }
        }
        out[first + i] = sum * glm::vec4(primitive.positions[i], 1.0F);
      }
    }
  }
}

Comparison skinningOnce(const SpeedInput& input) {
  const FrameState frame = app::evaluateOriginal(input.document, 0, 0.0);
  const Scene& scene = *input.document.scene;
  std::vector<glm::vec3> out;
  const Pair cost = measureInTurn(
      input.repetitions, [&] { static_cast<void>(skinning::skinnedPositions(scene, frame)); },
      [&] { skinByHand(scene, frame, out); });
  return {fmt::format("skin {} vertices once", vertexCount(scene)),
          "a loop by hand, single precision",
          cost.ours,
          cost.other,
          1.25,
          "double precision, morph targets"};
}

// As warnings and remedies look at a mesh, frame after frame.
Comparison skinningOnManyFrames(const SpeedInput& input) {
  const FrameState frame = app::evaluateOriginal(input.document, 0, 0.0);
  const Scene& scene = *input.document.scene;
  const skinning::SurfacePart all(scene, std::vector<bool>(scene.nodes.size(), true));
  std::vector<glm::vec3> part;
  std::vector<glm::vec3> out;
  const Pair cost = measureInTurn(
      input.repetitions, [&] { all.positions(frame, part); }, [&] { skinByHand(scene, frame, out); });
  return {fmt::format("skin {} vertices frame after frame, as warnings do", part.size()),
          "the same loop",
          cost.ours,
          cost.other,
          1.25,
          "an influence at a time"};
}

Comparison thickness(const SpeedInput& input) {
  const Body body = knobblyTorus(100, 50);
  const Pair cost = measureInTurn(
      std::max(3, input.repetitions / 5),
      [&] { static_cast<void>(skinning::shapeDiameters(body.positions, body.triangles)); },
      [&] { cgalThickness(body.positions, body.triangles); });
  return {fmt::format("thickness of {} faces, 64 rays each", body.triangles.size()),
          "CGAL's sdf_values, 64 rays",
          cost.ours,
          hasCgal() ? cost.other : 0.0,
          1.0 / 20.0,
          "rays one by one"};
}

Comparison distances(const SpeedInput& input) {
  constexpr std::uint32_t sources = 30;
  const Body body = knobblyTorus(500, 100);
  const auto count = static_cast<std::uint32_t>(body.positions.size());
  std::vector<std::uint32_t> starts(sources);
  for (std::uint32_t i = 0; i < sources; ++i) {
    starts[i] = i * (count / sources);
  }
  const Pair cost = measureInTurn(
      std::max(1, input.repetitions / 20),
      [&] {
        const skinning::GeodesicSolver solver(body.positions, body.triangles);
        for (const std::uint32_t start : starts) {
          static_cast<void>(solver.distances({start}));
        }
      },
      [&] { cgalDistances(body.positions, body.triangles, starts); });
  return {fmt::format("geodesics of {} sources, {} vertices, with the build", sources, count),
          "CGAL's heat method with its build",
          cost.ours,
          hasCgal() ? cost.other : 0.0,
          0.2,
          "marching"};
}

} // namespace

std::vector<Comparison> surfaceComparisons(const SpeedInput& input) {
  return {skinningOnce(input), skinningOnManyFrames(input), thickness(input), distances(input)};
}

} // namespace stretch::bench
