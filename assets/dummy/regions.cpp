#include "assets/dummy/regions.h"

#include <algorithm>
#include <cmath>

#include "assets/dummy/body_shape.h"
#include "assets/dummy/editable_mesh.h"

namespace stretch::assets {

namespace {

/// A border between regions: the zero level of `side`, where `applies`.
struct Border {
  std::function<double(const Vec3&)> side;
  std::function<bool(const Vec3&)> applies;
};

constexpr double soleHeight = 0.027;
constexpr double bootTrimHeight = 0.228;
constexpr double cuffReach = -0.008; ///< Along the glove's axis, from the wrist.
constexpr double stripeCenter = 0.0;
constexpr double stripeHalfWidth = 0.024;

bool isOuterTrunks(const Vec3& p) {
  const Layers layers = layersAt(p);
  return std::abs(p.x) > 0.09 && layers.trunks < std::min(layers.skin, layers.waistband);
}

std::vector<Border> borders() {
  const auto always = [](const Vec3&) { return true; };
  const auto layerBorder = [&](double Layers::*layer, double Layers::*under) {
    return Border{[=](const Vec3& p) {
                    const Layers layers = layersAt(p);
                    return layers.*layer - layers.*under;
                  },
                  always};
  };
  const auto boots = [](const Vec3& p) { return p.y < 0.35; };
  const auto gloves = [](const Vec3& p) { return layersAt(p).glove < layersAt(p).skin; };
  return {layerBorder(&Layers::hair, &Layers::skin),
          layerBorder(&Layers::glove, &Layers::skin),
          layerBorder(&Layers::boot, &Layers::skin),
          layerBorder(&Layers::trunks, &Layers::skin),
          layerBorder(&Layers::waistband, &Layers::skin),
          layerBorder(&Layers::waistband, &Layers::trunks),
          {[](const Vec3& p) { return gloveReach(p) - cuffReach; }, gloves},
          {[](const Vec3& p) { return p.y - soleHeight; }, boots},
          {[](const Vec3& p) { return p.y - bootTrimHeight; }, boots},
          {[](const Vec3& p) { return p.z - stripeCenter - stripeHalfWidth; }, isOuterTrunks},
          {[](const Vec3& p) { return p.z - stripeCenter + stripeHalfWidth; }, isOuterTrunks}};
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

/// The point of the border on the segment between two points on either side of it, put onto the surface.
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
  return projectToBody(0.5 * (a + b));
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
  if (nearest == layers.waistband) {
    return Region::waistband;
  }
  const bool onStripe = std::abs(point.z - stripeCenter) < stripeHalfWidth && std::abs(point.x) > 0.09;
  return onStripe ? Region::stripe : Region::trunks;
}

SurfaceMesh cutAlongRegions(const SurfaceMesh& mesh) {
  EditableMesh cut(mesh);
  std::vector<char> fixed(mesh.positions.size(), 0);
  for (const Border& border : borders()) {
    snapVertices(cut, border, fixed);
    splitEdges(cut, border, fixed);
  }
  return cut.compact();
}

} // namespace stretch::assets
