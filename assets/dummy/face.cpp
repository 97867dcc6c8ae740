#include "assets/dummy/face.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "assets/dummy/body_shape.h"
#include "assets/dummy/head_shape.h"
#include "assets/dummy/paint.h"
#include "assets/dummy/skeleton.h"

namespace stretch::assets {

namespace {

constexpr int segments = 18; ///< Around an eye.

/// A point in front of the face, put onto it.
Vec3 onFace(double x, double y) {
  return projectToBody(headToModel({x, y, 0.125}));
}

struct Band {
  double from; ///< Polar angle about the ellipsoid's third axis, radians.
  double to;
  int rings;
  unsigned hex;
};

/// An ellipsoid coloured in bands about its third axis. `axes` holds its half-axes as columns.
void addBandedEllipsoid(SkinnedMesh& mesh, const Vec3& center, const Mat3& axes,
                        const std::vector<Band>& bands) {
  const Mat3 normals = glm::transpose(glm::inverse(axes));
  for (const Band& band : bands) {
    for (int ring = 0; ring <= band.rings; ++ring) {
      const double polar = band.from + (band.to - band.from) * ring / band.rings;
      for (int segment = 0; segment < segments; ++segment) {
        const double turn = 2.0 * pi * segment / segments;
        const Vec3 unit(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
        mesh.vertices.push_back(
            {center + axes * unit, glm::normalize(normals * unit), linearColor(band.hex), {}});
        const int corner = static_cast<int>(mesh.vertices.size()) - 1;
        const int next = segment + 1 < segments ? corner + 1 : corner + 1 - segments;
        if (ring == 0) {
          continue;
        }
        const double before = band.from + (band.to - band.from) * (ring - 1) / band.rings;
        if (polar < pi - 1e-9) {
          mesh.triangles.push_back({corner - segments, corner, next});
        }
        if (before > 1e-9) {
          mesh.triangles.push_back({corner - segments, next, next - segments});
        }
      }
    }
  }
}

/// Upper lid: the upper part of a slightly larger ellipsoid, tilted down towards the nose; its open side ends
/// inside the eye.
void addLid(SkinnedMesh& mesh, const Vec3& center, const Mat3& eye, double side) {
  const double tilt = -side * 0.22;
  const Vec3 pole = glm::normalize(Vec3(std::sin(tilt), std::cos(tilt), 0.30));
  const Vec3 across = glm::normalize(glm::cross(Vec3(0.0, 0.0, 1.0), pole));
  const Mat3 turned(across, glm::cross(pole, across), pole);
  addBandedEllipsoid(mesh, center, 1.11 * eye * turned, {{0.0, 0.84, 5, lidHex}});
  const int first = static_cast<int>(mesh.vertices.size()) - segments;
  for (int segment = 1; segment + 1 < segments; ++segment) {
    mesh.triangles.push_back({first, first + segment + 1, first + segment});
  }
}

void addEye(SkinnedMesh& mesh, double side) {
  const Vec3 seat = onFace(side * 0.045, 1.612);
  const Vec3 forward = glm::normalize(0.5 * bodyNormal(seat) + Vec3(0.0, 0.0, 1.0));
  const Vec3 right = glm::normalize(glm::cross(Vec3(0.0, 1.0, 0.0), forward));
  const Vec3 up = glm::cross(forward, right);
  const Vec3 center = seat - 0.004 * forward;
  addBandedEllipsoid(mesh, center, {0.030 * right, 0.038 * up, 0.017 * forward}, {{0.62, pi, 8, 0xFDFBF5}});
  addLid(mesh, center, {0.030 * right, 0.038 * up, 0.017 * forward}, side);
  const Vec3 gaze = center - side * 0.003 * right;
  addBandedEllipsoid(mesh, gaze, {0.0304 * right, 0.0385 * up, 0.0180 * forward},
                     {{0.0, 0.36, 2, 0x1A1412}, {0.36, 0.64, 2, 0x3D6E8C}, {0.64, 0.72, 1, 0x24201F}});
  addBandedEllipsoid(mesh, gaze + 0.007 * right + 0.010 * up + 0.0155 * forward,
                     {0.0045 * right, 0.0055 * up, 0.002 * forward},
                     {{0.0, 1.6, 3, 0xFFFFFF}, {1.6, pi, 1, 0xFFFFFF}});
}

/// A tube along points, thick in the middle; `flat` squeezes it towards the surface.
struct Stroke {
  std::vector<Vec3> points;
  double startRadius;
  double middleRadius;
  double endRadius;
  double flat;
  unsigned hex;
};

double radiusAt(const Stroke& stroke, double t) {
  const double end = t < 0.5 ? stroke.startRadius : stroke.endRadius;
  const double bulge = 1.0 - (2.0 * t - 1.0) * (2.0 * t - 1.0);
  return end + (stroke.middleRadius - end) * bulge;
}

void addStroke(SkinnedMesh& mesh, const Stroke& stroke) {
  constexpr int sides = 8;
  const int first = static_cast<int>(mesh.vertices.size());
  const int count = static_cast<int>(stroke.points.size());
  const auto at = [&](int i) { return stroke.points[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < count; ++i) {
    const Vec3 along = glm::normalize(at(i + 1 < count ? i + 1 : i) - at(i > 0 ? i - 1 : i));
    const Vec3 out = bodyNormal(at(i));
    const Vec3 across = glm::normalize(glm::cross(out, along));
    const double radius = radiusAt(stroke, static_cast<double>(i) / (count - 1));
    for (int segment = 0; segment < sides; ++segment) {
      const double turn = 2.0 * pi * segment / sides;
      const Vec3 offset = std::cos(turn) * across + stroke.flat * std::sin(turn) * out;
      const Vec3 normal = glm::normalize(std::cos(turn) * across + std::sin(turn) / stroke.flat * out);
      mesh.vertices.push_back({at(i) + radius * offset, normal, linearColor(stroke.hex), {}});
      const int corner = first + i * sides + segment;
      const int next = first + i * sides + (segment + 1) % sides;
      if (i > 0) {
        mesh.triangles.push_back({corner - sides, next - sides, next});
        mesh.triangles.push_back({corner - sides, next, corner});
      }
    }
  }
  const int last = first + (count - 1) * sides;
  for (int segment = 1; segment + 1 < sides; ++segment) {
    mesh.triangles.push_back({first, first + segment + 1, first + segment});
    mesh.triangles.push_back({last, last + segment, last + segment + 1});
  }
}

void addBrow(SkinnedMesh& mesh, double side) {
  Stroke brow{{}, 0.0055, 0.0085, 0.0035, 0.6, hairHex};
  for (int i = 0; i <= 8; ++i) {
    const double t = i / 8.0;
    const double arch = 1.0 - (2.0 * t - 1.1) * (2.0 * t - 1.1);
    brow.points.push_back(onFace(side * (0.018 + 0.058 * t), 1.652 + 0.006 * t + 0.009 * arch));
  }
  addStroke(mesh, brow);
}

void addMouth(SkinnedMesh& mesh) {
  Stroke mouth{{}, 0.0014, 0.0034, 0.0016, 0.6, 0x7A2E2A};
  for (int i = 0; i <= 12; ++i) {
    const double t = 2.0 * i / 12.0 - 1.0;
    mouth.points.push_back(onFace(0.004 + 0.040 * t, 1.529 + 0.015 * t * t + 0.003 * t));
  }
  addStroke(mesh, mouth);
}

} // namespace

SkinnedMesh makeFace(int head) {
  SkinnedMesh face;
  for (const double side : {1.0, -1.0}) {
    addEye(face, side);
    addBrow(face, side);
  }
  addMouth(face);
  for (SkinnedVertex& vertex : face.vertices) {
    vertex.influences.joints[0] = head;
  }
  return face;
}

} // namespace stretch::assets
