#include "assets/dummy/regions.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "assets/dummy/body_shape.h"
#include "assets/dummy/distance_field.h"
#include "assets/dummy/editable_mesh.h"
#include "assets/dummy/slivers.h"

namespace stretch::assets {

namespace {

/// A border between regions: the zero level of `side`, where `applies`.
struct Border {
  std::function<double(const Vec3&)> side;
  std::function<bool(const Vec3&)> applies;
};

constexpr double soleHeight = 0.025;
constexpr double bootTrimHeight = 0.226;
constexpr double cuffReach = -0.012; ///< Along the glove's axis, from the wrist.
constexpr double bandHeight = 0.985; ///< Lower edge of the waistband.
constexpr double stripeHalfWidth = 0.024;

bool isTrunks(const Vec3& p) {
  const Layers layers = layersAt(p);
  return std::min(layers.trunks, layers.waistband) < layers.skin;
}

bool isBoot(const Vec3& p) {
  const Layers layers = layersAt(p);
  return layers.boot < layers.skin;
}

bool isGlove(const Vec3& p) {
  const Layers layers = layersAt(p);
  return layers.glove < layers.skin;
}

bool isOuterTrunks(const Vec3& p) {
  return std::abs(p.x) > 0.09 && p.y < bandHeight && isTrunks(p);
}

Border layerBorder(double Layers::*layer) {
  return {[=](const Vec3& p) {
            const Layers layers = layersAt(p);
            return layers.*layer - layers.skin;
          },
          [](const Vec3&) { return true; }};
}

/// A level of height above the ground.
Border heightBorder(double height, bool (*applies)(const Vec3&)) {
  return {[=](const Vec3& p) { return p.y - height; }, applies};
}

Border gloveBorder(double reach) {
  return {[=](const Vec3& p) { return gloveReach(p) - reach; }, isGlove};
}

Border stripeBorder(double z) {
  return {[=](const Vec3& p) { return p.z - z; }, isOuterTrunks};
}

/// Colour borders, and the rims of boots, cuffs and trunks: they look ragged unless edges run around them.
std::vector<Border> borders() {
  const Border trunks{[](const Vec3& p) {
                        const Layers layers = layersAt(p);
                        return std::min(layers.trunks, layers.waistband) - layers.skin;
                      },
                      [](const Vec3&) { return true; }};
  return {layerBorder(&Layers::hair),
          layerBorder(&Layers::glove),
          layerBorder(&Layers::boot),
          trunks,
          heightBorder(bandHeight, isTrunks),
          heightBorder(bandHeight + 0.008, isTrunks),
          heightBorder(bandHeight + 0.039, isTrunks),
          gloveBorder(cuffReach),
          heightBorder(soleHeight, isBoot),
          heightBorder(bootTrimHeight, isBoot),
          heightBorder(bootHem - 0.010, isBoot),
          heightBorder(bootHem - 0.003, isBoot),
          gloveBorder(cuffEnd + 0.010),
          gloveBorder(cuffEnd + 0.003),
          heightBorder(trunksHem + 0.010, isTrunks),
          heightBorder(trunksHem + 0.003, isTrunks),
          stripeBorder(-stripeHalfWidth),
          stripeBorder(stripeHalfWidth)};
}

/// Edges that the border crosses, as the fraction from the first end at which it does.
std::vector<std::pair<Edge, double>> crossedEdges(const EditableMesh& mesh, const Border& border) {
  std::vector<double> sides(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
    const double side = border.side(mesh.position(vertex));
    sides[static_cast<std::size_t>(vertex)] = std::abs(side) < 2e-4 ? 0.0 : side;
  }
  std::vector<std::pair<Edge, double>> crossed;
  for (const Edge& edge : mesh.edges()) {
    const double a = sides[static_cast<std::size_t>(edge[0])];
    const double b = sides[static_cast<std::size_t>(edge[1])];
    if (a * b < 0.0 && border.applies(0.5 * (mesh.position(edge[0]) + mesh.position(edge[1])))) {
      crossed.emplace_back(edge, a / (a - b));
    }
  }
  return crossed;
}

/// The point of the border between two points on either side of it, on the surface: the segment's, moved
/// along the border's own level so that rims stay where they are.
Vec3 borderPoint(const Border& border, Vec3 a, Vec3 b) {
  double sideA = border.side(a);
  for (int step = 0; step < 24; ++step) {
    const Vec3 middle = 0.5 * (a + b);
    const double side = border.side(middle);
    if ((side < 0.0) == (sideA < 0.0)) {
      a = middle;
      sideA = side;
    } else {
      b = middle;
    }
  }
  Vec3 point = 0.5 * (a + b);
  for (int step = 0; step < 8; ++step) {
    const Vec3 across = gradientOf(border.side, point);
    point -= across * (border.side(point) / std::max(glm::dot(across, across), 0.25));
    const Vec3 outward = gradientOf(bodyDistance, point);
    const Vec3 along =
        outward - across * (glm::dot(outward, across) / std::max(glm::dot(across, across), 0.25));
    point -= along * (bodyDistance(point) / std::max(glm::dot(along, along), 0.09));
  }
  return projectToBody(point);
}

/// Moves vertices that lie close to the border onto it, those on an earlier border excepted.
void snapVertices(EditableMesh& mesh, const Border& border, std::vector<char>& fixed) {
  constexpr double close = 0.3;
  for (const auto& [edge, fraction] : crossedEdges(mesh, border)) {
    const std::size_t near = fraction < 0.5 ? 0 : 1;
    const int vertex = edge[near];
    const int other = edge[1 - near];
    if (std::min(fraction, 1.0 - fraction) > close || fixed[static_cast<std::size_t>(vertex)] != 0) {
      continue;
    }
    mesh.setPosition(vertex, borderPoint(border, mesh.position(vertex), mesh.position(other)));
    fixed[static_cast<std::size_t>(vertex)] = 1;
  }
}

void splitEdges(EditableMesh& mesh, const Border& border, std::vector<char>& fixed) {
  for (const auto& crossing : crossedEdges(mesh, border)) {
    const Edge& edge = crossing.first;
    mesh.split(edge, borderPoint(border, mesh.position(edge[0]), mesh.position(edge[1])));
    fixed.push_back(1);
  }
}

} // namespace

Region regionAt(const Vec3& point) {
  const Layers layers = layersAt(point);
  const double nearest =
      std::min({layers.skin, layers.hair, layers.glove, layers.boot, layers.trunks, layers.waistband});
  if (nearest == layers.skin) {
    return Region::skin;
  }
  if (nearest == layers.hair) {
    return Region::hair;
  }
  if (nearest == layers.glove) {
    return gloveReach(point) < cuffReach ? Region::cuff : Region::glove;
  }
  if (nearest == layers.boot) {
    return point.y < soleHeight ? Region::sole : (point.y > bootTrimHeight ? Region::bootTrim : Region::boot);
  }
  if (point.y > bandHeight) {
    return Region::waistband;
  }
  return isOuterTrunks(point) && std::abs(point.z) < stripeHalfWidth ? Region::stripe : Region::trunks;
}

Vec3 regionNormal(Region region, const Vec3& point) {
  switch (region) {
  case Region::skin:
    return layerNormal(&Layers::skin, point);
  case Region::hair:
    return layerNormal(&Layers::hair, point);
  case Region::glove:
  case Region::cuff:
    return layerNormal(&Layers::glove, point);
  case Region::boot:
  case Region::sole:
  case Region::bootTrim:
    return layerNormal(&Layers::boot, point);
  case Region::trunks:
  case Region::stripe:
  case Region::waistband:
    break;
  }
  const Layers layers = layersAt(point);
  return layerNormal(layers.trunks < layers.waistband ? &Layers::trunks : &Layers::waistband, point);
}

SurfaceMesh cutAlongRegions(const SurfaceMesh& mesh) {
  EditableMesh cut(mesh);
  std::vector<char> fixed(mesh.positions.size(), 0);
  for (const Border& border : borders()) {
    snapVertices(cut, border, fixed);
    splitEdges(cut, border, fixed);
  }
  mergeCoincident(cut);
  flipSlivers(cut, [](const Vec3& p) { return static_cast<int>(regionAt(p)); });
  return cut.compact();
}

} // namespace stretch::assets
