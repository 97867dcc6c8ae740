#include "assets/dummy/props.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "assets/dummy/paint.h"

namespace stretch::assets {

namespace {

constexpr unsigned woodHex = 0xD9A866;
constexpr unsigned gripHex = 0xF0E9DA;
constexpr unsigned blockHex = 0x8C939E;
constexpr unsigned blockTopHex = 0xE0A43A;

/// A ring of a turned shape: its height above the knob's end, its radius, the colour from here upwards.
struct Ring {
  double height;
  double radius;
  unsigned color;
};

constexpr std::array<Ring, 14> batRings{{{0.000, 0.001, gripHex},
                                         {0.003, 0.024, gripHex},
                                         {0.012, 0.029, gripHex},
                                         {0.022, 0.026, gripHex},
                                         {0.034, 0.016, gripHex},
                                         {0.050, 0.0145, gripHex},
                                         {0.330, 0.0165, woodHex},
                                         {0.450, 0.0215, woodHex},
                                         {0.560, 0.0300, woodHex},
                                         {0.650, 0.0365, woodHex},
                                         {0.840, 0.0380, woodHex},
                                         {0.866, 0.0330, woodHex},
                                         {0.877, 0.0200, woodHex},
                                         {batLength, 0.001, woodHex}}};

/// Outward normal of the turned shape between two rings, in the plane of a cut through its axis.
Vec2 cutNormal(const Ring& below, const Ring& above) {
  return glm::normalize(Vec2(above.height - below.height, below.radius - above.radius));
}

/// The vertices of a ring, with the colour of the piece that they belong to.
void addRing(SkinnedMesh& mesh, const Ring& ring, const Vec2& normal, unsigned color, int sides) {
  for (int side = 0; side < sides; ++side) {
    const double angle = 2.0 * pi * side / sides;
    const Vec3 outward(std::cos(angle), 0.0, std::sin(angle));
    mesh.vertices.push_back({ring.radius * outward + Vec3(0.0, ring.height - batGripHeight, 0.0),
                             normal.x * outward + Vec3(0.0, normal.y, 0.0),
                             linearColor(color),
                             {}});
  }
}

void joinRings(SkinnedMesh& mesh, int below, int above, int sides) {
  for (int side = 0; side < sides; ++side) {
    const int next = (side + 1) % sides;
    mesh.triangles.push_back({below + side, above + side, above + next});
    mesh.triangles.push_back({below + side, above + next, below + next});
  }
}

/// The face of a box about the origin, of these half sides, that looks along an axis.
void addFace(SkinnedMesh& mesh, const Vec3& half, int axis, double sign, unsigned color) {
  const int other = (axis + 1) % 3;
  const int third = (axis + 2) % 3;
  Vec3 normal(0.0);
  normal[axis] = sign;
  Vec3 right(0.0);
  right[other] = half[other];
  Vec3 up(0.0);
  up[third] = sign * half[third];
  const Vec3 middle = half[axis] * normal;
  const int first = static_cast<int>(mesh.vertices.size());
  for (const Vec3& corner :
       {middle - right - up, middle + right - up, middle + right + up, middle - right + up}) {
    mesh.vertices.push_back({corner, normal, linearColor(color), {}});
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

} // namespace

Prop makeBat() {
  constexpr int sides = 20;
  SkinnedMesh mesh;
  for (std::size_t piece = 0; piece + 1 < batRings.size(); ++piece) {
    const auto normalAt = [&](std::size_t ring) {
      const std::size_t before = ring == 0 ? 0 : ring - 1;
      const std::size_t after = std::min(ring + 1, batRings.size() - 1);
      return glm::normalize(cutNormal(batRings[before], batRings[std::max(ring, before + 1)]) +
                            cutNormal(batRings[std::min(ring, after - 1)], batRings[after]));
    };
    const int below = static_cast<int>(mesh.vertices.size());
    addRing(mesh, batRings[piece], normalAt(piece), batRings[piece].color, sides);
    addRing(mesh, batRings[piece + 1], normalAt(piece + 1), batRings[piece].color, sides);
    joinRings(mesh, below, below + sides, sides);
  }
  return {{"Bat", 0.45, mesh}, {0.0, 0.0, 0.0}};
}

Prop makeBlock(const std::string& name, const Vec3& low, const Vec3& high) {
  SkinnedMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      addFace(mesh, 0.5 * (high - low), axis, sign, axis == 1 && sign > 0.0 ? blockTopHex : blockHex);
    }
  }
  return {{name, 0.8, mesh}, 0.5 * (low + high)};
}

} // namespace stretch::assets
