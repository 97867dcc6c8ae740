#include "skinning/geometry/shape_diameter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "skinning/geometry/half_edge_mesh.h"
#include "skinning/sequence/topology.h"

namespace stretch::skinning {
namespace {

/// The triangles in Embree's hands; everything is released with it.
class RayScene {
public:
  RayScene(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles)
      : device_(rtcNewDevice("threads=1")), scene_(device_ != nullptr ? rtcNewScene(device_) : nullptr) {
    if (scene_ == nullptr) {
      return;
    }
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), triangles.size()));
    // The library takes the smallest numbers for 0 while it builds, and the first parallel work of a thread
    // sets what all later work there takes them for.
    tbb::parallel_for(0, 1, [](int) {});
    if (vertices != nullptr && indices != nullptr) {
      for (std::size_t v = 0; v < positions.size(); ++v) {
        vertices[3 * v] = positions[v].x;
        vertices[3 * v + 1] = positions[v].y;
        vertices[3 * v + 2] = positions[v].z;
      }
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        std::copy(triangles[t].begin(), triangles[t].end(), indices + 3 * t);
      }
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene_, geometry);
      rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
      rtcCommitScene(scene_);
      usable_ = rtcGetDeviceError(device_) == RTC_ERROR_NONE;
    }
    rtcReleaseGeometry(geometry);
  }
  ~RayScene() {
    if (scene_ != nullptr) {
      rtcReleaseScene(scene_);
    }
    if (device_ != nullptr) {
      rtcReleaseDevice(device_);
    }
  }
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  [[nodiscard]] bool usable() const { return usable_; }

  /// Length of the ray to where it leaves the body; negative when it hits nothing or enters another part from
  /// outside.
  [[nodiscard]] double lengthInside(const Vec3& origin, const Vec3& direction, double start) const {
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(origin.x);
    query.ray.org_y = static_cast<float>(origin.y);
    query.ray.org_z = static_cast<float>(origin.z);
    query.ray.dir_x = static_cast<float>(direction.x);
    query.ray.dir_y = static_cast<float>(direction.y);
    query.ray.dir_z = static_cast<float>(direction.z);
    query.ray.tnear = static_cast<float>(start);
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = 0xFFFFFFFFU;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &query);
    const Vec3 normal(static_cast<double>(query.hit.Ng_x), static_cast<double>(query.hit.Ng_y),
                      static_cast<double>(query.hit.Ng_z));
    const bool leaves = query.hit.geomID != RTC_INVALID_GEOMETRY_ID && glm::dot(normal, direction) > 0.0;
    return leaves ? static_cast<double>(query.ray.tfar) : -1.0;
  }

private:
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  bool usable_ = false;
};

struct ConeRay {
  Vec3 direction{0.0, 0.0, 1.0}; ///< Around +z.
  double weight = 1.0;           ///< 1 / angle, at most 1 / (1 degree).
};

/// One ray in the middle of each of `count` parts of equal solid angle: rings of equal height on the cap,
/// turned by the golden angle.
std::vector<ConeRay> coneRays(const ShapeDiameterSettings& settings) {
  constexpr double goldenAngle = 2.39996322972865332;
  const double lowestCosine = std::cos(settings.coneDegrees * pi / 360.0);
  const int count = std::max(settings.rays, 1);
  std::vector<ConeRay> rays;
  for (int i = 0; i < count; ++i) {
    const double cosine = 1.0 - (1.0 - lowestCosine) * (i + 0.5) / count;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double turn = goldenAngle * i;
    const double angleDegrees = std::acos(cosine) * 180.0 / pi;
    rays.push_back(
        {Vec3(sine * std::cos(turn), sine * std::sin(turn), cosine), 1.0 / std::max(angleDegrees, 1.0)});
  }
  return rays;
}

struct Length {
  double value = 0.0;
  double weight = 0.0;
};

/// Mean of the lengths within one standard deviation of their median; 0 for none.
double robustMean(std::vector<Length>& lengths) {
  if (lengths.empty()) {
    return 0.0;
  }
  std::sort(lengths.begin(), lengths.end(),
            [](const Length& a, const Length& b) { return a.value < b.value; });
  const std::size_t middle = lengths.size() / 2;
  const double median = lengths.size() % 2 == 1 ? lengths[middle].value
                                                : 0.5 * (lengths[middle - 1].value + lengths[middle].value);
  double mean = 0.0;
  for (const Length& length : lengths) {
    mean += length.value / static_cast<double>(lengths.size());
  }
  double variance = 0.0;
  for (const Length& length : lengths) {
    variance += (length.value - mean) * (length.value - mean) / static_cast<double>(lengths.size());
  }
  const double reach = std::sqrt(variance) * (1.0 + 1e-9) + 1e-12 * median;
  double sum = 0.0;
  double weight = 0.0;
  for (const Length& length : lengths) {
    if (std::abs(length.value - median) <= reach) {
      sum += length.weight * length.value;
      weight += length.weight;
    }
  }
  return weight > 0.0 ? sum / weight : median;
}

Vec3 doubleAreaNormal(std::span<const glm::vec3> positions, const Triangle& t) {
  const Vec3 a(positions[t[0]]);
  return glm::cross(Vec3(positions[t[1]]) - a, Vec3(positions[t[2]]) - a);
}

double faceDiameter(const RayScene& scene, std::span<const glm::vec3> positions, const Triangle& triangle,
                    const std::vector<ConeRay>& cone, double start) {
  const Vec3 scaledNormal = doubleAreaNormal(positions, triangle);
  const double doubleArea = glm::length(scaledNormal);
  if (!(doubleArea > 0.0)) {
    return 0.0;
  }
  const Vec3 inward = -scaledNormal / doubleArea;
  const Vec3 centre =
      (Vec3(positions[triangle[0]]) + Vec3(positions[triangle[1]]) + Vec3(positions[triangle[2]])) / 3.0;
  const Vec3 helper = std::abs(inward.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  const Vec3 side = glm::normalize(glm::cross(inward, helper));
  const Mat3 frame(side, glm::cross(inward, side), inward);
  std::vector<Length> lengths;
  lengths.reserve(cone.size());
  for (const ConeRay& ray : cone) {
    const double length = scene.lengthInside(centre, frame * ray.direction, start);
    if (length > 0.0) {
      lengths.push_back({length, ray.weight});
    }
  }
  return robustMean(lengths);
}

/// Neighbours over edges, -1 for none.
std::vector<std::array<int, 3>> faceNeighbours(std::span<const glm::vec3> positions,
                                               const std::vector<Triangle>& triangles) {
  const HalfEdgeMesh mesh = buildHalfEdges(positions, triangles);
  std::vector<std::array<int, 3>> neighbours(triangles.size(), {-1, -1, -1});
  for (const auto face : mesh.edges.faces()) {
    std::size_t slot = 0;
    for (const auto edge : mesh.edges.fh_range(face)) {
      const HalfEdges::FaceHandle beyond(mesh.edges.opposite_face_handle(edge).idx());
      if (beyond.is_valid() && slot < 3) {
        neighbours[mesh.triangle[static_cast<std::size_t>(face.idx())]][slot++] =
            static_cast<int>(mesh.triangle[static_cast<std::size_t>(beyond.idx())]);
      }
    }
  }
  return neighbours;
}

/// One round: each face becomes the mean of itself and its neighbours; only faces for which `wanted` holds
/// change.
template <typename Wanted>
void averageOnce(const std::vector<std::array<int, 3>>& neighbours, std::vector<double>& values,
                 Wanted&& wanted) {
  const std::vector<double> before = values;
  for (std::size_t f = 0; f < values.size(); ++f) {
    double sum = before[f];
    double count = before[f] > 0.0 ? 1.0 : 0.0;
    for (const int n : neighbours[f]) {
      const double value = n < 0 ? 0.0 : before[static_cast<std::size_t>(n)];
      sum += value;
      count += value > 0.0 ? 1.0 : 0.0;
    }
    if (count > 0.0 && wanted(before[f])) {
      values[f] = sum / count;
    }
  }
}

/// Faces that measured nothing take over what their neighbours have, ring by ring, and the mean where none is
/// near.
void fillGaps(const std::vector<std::array<int, 3>>& neighbours, std::vector<double>& values) {
  constexpr int mostRings = 16;
  const auto isGap = [](double value) { return value <= 0.0; };
  for (int ring = 0; ring < mostRings && std::any_of(values.begin(), values.end(), isGap); ++ring) {
    averageOnce(neighbours, values, isGap);
  }
  double sum = 0.0;
  double count = 0.0;
  for (const double value : values) {
    sum += value;
    count += value > 0.0 ? 1.0 : 0.0;
  }
  std::replace_if(values.begin(), values.end(), isGap, sum / count);
}

std::vector<double> toVertices(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                               const std::vector<double>& faces) {
  std::vector<double> sums(positions.size(), 0.0);
  std::vector<double> areas(positions.size(), 0.0);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const double area = glm::length(doubleAreaNormal(positions, triangles[f]));
    for (const std::uint32_t corner : triangles[f]) {
      sums[corner] += area * faces[f];
      areas[corner] += area;
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    sums[v] = areas[v] > 0.0 ? sums[v] / areas[v] : 0.0;
  }
  return sums;
}

} // namespace

Result<ShapeDiameters> shapeDiameters(std::span<const glm::vec3> positions,
                                      const std::vector<Triangle>& triangles,
                                      const ShapeDiameterSettings& settings) {
  const Error unmeasurable{"the shape diameter cannot be measured: no ray hits the other side of the mesh",
                           "", "give a closed surface with some thickness"};
  if (positions.empty() || triangles.empty()) {
    return unmeasurable;
  }
  std::vector<Triangle> wound = triangles;
  orientOutwards(positions, wound);
  const RayScene scene(positions, wound);
  if (!scene.usable()) {
    return Error{"the ray library does not start", "", "check the installation of Embree 3"};
  }
  const std::vector<ConeRay> cone = coneRays(settings);
  const double start = 1e-5 * boxDiagonal(positions);
  ShapeDiameters result;
  result.faces.assign(wound.size(), 0.0);
  tbb::parallel_for(std::size_t{0}, wound.size(), [&](std::size_t f) {
    result.faces[f] = faceDiameter(scene, positions, wound[f], cone, start);
  });
  result.facesWithoutHit = static_cast<std::size_t>(
      std::count_if(result.faces.begin(), result.faces.end(), [](double d) { return d <= 0.0; }));
  if (result.facesWithoutHit == result.faces.size()) {
    return unmeasurable;
  }
  const auto neighbours = faceNeighbours(positions, wound);
  fillGaps(neighbours, result.faces);
  for (int round = 0; round < settings.smoothingRounds; ++round) {
    averageOnce(neighbours, result.faces, [](double) { return true; });
  }
  result.vertices = toVertices(positions, wound, result.faces);
  return result;
}

std::vector<double> meanByGroup(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                                const std::vector<double>& faceValues, const std::vector<int>& groupOf,
                                std::size_t groupCount) {
  std::vector<double> sums(groupCount, 0.0);
  std::vector<double> areas(groupCount, 0.0);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (groupOf[f] >= 0) {
      const double area = glm::length(doubleAreaNormal(positions, triangles[f]));
      sums[static_cast<std::size_t>(groupOf[f])] += area * faceValues[f];
      areas[static_cast<std::size_t>(groupOf[f])] += area;
    }
  }
  for (std::size_t g = 0; g < groupCount; ++g) {
    sums[g] = areas[g] > 0.0 ? sums[g] / areas[g] : 0.0;
  }
  return sums;
}

} // namespace stretch::skinning
