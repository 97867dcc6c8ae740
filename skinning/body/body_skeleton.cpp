#include "skinning/body/body_skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <glm/geometric.hpp>

#include "core/math/polyline.h"
#include "skinning/body/branches.h"
#include "skinning/geometry/geodesic_distance.h"

namespace stretch::skinning {
namespace {

constexpr int curveSamples = 512;

/// Uniform cubic B-spline over [0, 1] with `size` control points.
struct SplineBasis {
  Eigen::Index first = 0;
  std::array<double, 4> values{};
};

SplineBasis splineBasis(double u, Eigen::Index size) {
  const double x = std::clamp(u, 0.0, 1.0) * static_cast<double>(size - 3);
  const auto span = std::min(static_cast<Eigen::Index>(x), size - 4);
  const double t = x - static_cast<double>(span);
  const double s = 1.0 - t;
  return {span,
          {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
           (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0, t * t * t / 6.0}};
}

/// Points of the curve that fits `points` at parameters `u` best; second differences of the control points
/// are kept small where points are missing.
std::vector<Vec3> fitCurve(const std::vector<Vec3>& points, const std::vector<double>& u,
                           Eigen::Index controls) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(controls, controls);
  Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(controls, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SplineBasis basis = splineBasis(u[i], controls);
    for (Eigen::Index a = 0; a < 4; ++a) {
      const double value = basis.values[static_cast<std::size_t>(a)];
      for (Eigen::Index b = 0; b < 4; ++b) {
        gram(basis.first + a, basis.first + b) += value * basis.values[static_cast<std::size_t>(b)];
      }
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        pull(basis.first + a, axis) += value * points[i][static_cast<glm::length_t>(axis)];
      }
    }
  }
  const double smoothing = 1e-3 * gram.trace() / static_cast<double>(controls);
  for (Eigen::Index c = 1; c + 1 < controls; ++c) {
    const Eigen::Vector3d stencil(1.0, -2.0, 1.0);
    gram.block<3, 3>(c - 1, c - 1) += smoothing * stencil * stencil.transpose();
  }
  gram.diagonal().array() += 1e-12 * gram.trace();
  const Eigen::MatrixXd solved = gram.ldlt().solve(pull);
  std::vector<Vec3> curve;
  for (int i = 0; i <= curveSamples; ++i) {
    const SplineBasis basis = splineBasis(static_cast<double>(i) / curveSamples, controls);
    Vec3 point(0.0);
    for (Eigen::Index a = 0; a < 4; ++a) {
      const auto row = solved.row(basis.first + a);
      point += basis.values[static_cast<std::size_t>(a)] * Vec3(row(0), row(1), row(2));
    }
    curve.push_back(point);
  }
  return curve;
}

/// Arc length of the point of the line nearest to `point`, looked for around the share `u` of the whole
/// length; beyond the ends the line goes on straight for a tenth of it.
double projectOn(const std::vector<Vec3>& line, const std::vector<double>& lengths, const Vec3& point,
                 double u) {
  constexpr double window = 0.15;
  constexpr double beyond = 0.1 * curveSamples;
  double best = std::clamp(u, 0.0, 1.0) * lengths.back();
  double bestSquare = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (std::abs(lengths[i] - u * lengths.back()) > window * lengths.back()) {
      continue;
    }
    const Vec3 along = line[i] - line[i - 1];
    const double square = glm::dot(along, along);
    double t = square > 0.0 ? glm::dot(point - line[i - 1], along) / square : 0.0;
    t = std::clamp(t, i == 1 ? -beyond : 0.0, i + 1 == line.size() ? beyond : 1.0);
    const Vec3 away = point - line[i - 1] - t * along;
    if (glm::dot(away, away) < bestSquare) {
      bestSquare = glm::dot(away, away);
      best = lengths[i - 1] + t * (lengths[i] - lengths[i - 1]);
    }
  }
  return best;
}

Vec3 pointAt(const std::vector<Vec3>& line, const std::vector<double>& lengths, double at) {
  const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, at);
  const auto i = static_cast<std::size_t>(above - lengths.begin());
  const double span = lengths[i] - lengths[i - 1];
  return line[i - 1] + (span > 0.0 ? (at - lengths[i - 1]) / span : 0.0) * (line[i] - line[i - 1]);
}

/// Where along the curve from `from` on the straight distance first is `chord`; beyond `last` when the curve
/// ends before.
double stepByChord(const std::vector<Vec3>& line, const std::vector<double>& lengths, double from,
                   double chord, double last) {
  const Vec3 start = pointAt(line, lengths, from);
  double low = from;
  double high = from + chord;
  while (glm::length(pointAt(line, lengths, high) - start) < chord) {
    low = high;
    high += 0.1 * chord;
    if (low > last) {
      return low;
    }
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (glm::length(pointAt(line, lengths, middle) - start) < chord ? low : high) = middle;
  }
  return high;
}

/// Cuts the curve between two places into segments of one length, measured straight.
std::vector<double> equalStations(const std::vector<Vec3>& line, const std::vector<double>& lengths,
                                  double first, double last, int segments) {
  double shortest = 0.0;
  double longest = (last - first) / segments;
  std::vector<double> stations;
  for (int i = 0; i < 60; ++i) {
    const double chord = i == 0 ? longest : 0.5 * (shortest + longest);
    std::vector<double> tried{first};
    for (int s = 0; s < segments; ++s) {
      tried.push_back(stepByChord(line, lengths, tried.back(), chord, last));
    }
    (tried.back() < last ? shortest : longest) = chord;
    stations = tried;
  }
  return stations;
}

/// A third of the area of the triangles around each vertex.
std::vector<double> vertexAreas(std::span<const glm::vec3> positions,
                                const std::vector<Triangle>& triangles) {
  std::vector<double> areas(positions.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec3 a(positions[t[0]]);
    const double area = 0.5 * glm::length(glm::cross(Vec3(positions[t[1]]) - a, Vec3(positions[t[2]]) - a));
    for (const std::uint32_t corner : t) {
      areas[corner] += area / 3.0;
    }
  }
  return areas;
}

std::vector<Vec3> movedInwards(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                               const std::vector<double>& vertexDiameters) {
  std::vector<Vec3> normals(positions.size(), Vec3(0.0));
  double volume = 0.0;
  const Vec3 centre(positions[0]);
  for (const Triangle& t : triangles) {
    const Vec3 a(positions[t[0]]);
    const Vec3 b(positions[t[1]]);
    const Vec3 c(positions[t[2]]);
    const Vec3 normal = glm::cross(b - a, c - a);
    volume += glm::dot(a - centre, normal);
    for (const std::uint32_t corner : t) {
      normals[corner] += normal;
    }
  }
  // Flat ends look all the way along the body: no vertex moves deeper than most of the body is thick.
  std::vector<double> sorted = vertexDiameters;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(positions.size() / 2),
                   sorted.end());
  const double deepest = 1.5 * sorted[positions.size() / 2];
  std::vector<Vec3> moved(positions.size(), Vec3(0.0));
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double length = glm::length(normals[v]);
    const Vec3 inwards = length > 0.0 ? normals[v] * ((volume > 0.0 ? -1.0 : 1.0) / length) : Vec3(0.0);
    moved[v] = Vec3(positions[v]) + 0.5 * std::min(vertexDiameters[v], deepest) * inwards;
  }
  return moved;
}

std::uint32_t farthest(const std::vector<double>& distances) {
  std::uint32_t best = 0;
  for (std::uint32_t v = 0; v < distances.size(); ++v) {
    if (std::isfinite(distances[v]) && (!std::isfinite(distances[best]) || distances[v] > distances[best])) {
      best = v;
    }
  }
  return best;
}

Error branches() {
  return {"the body branches: it has no linear skeleton", "",
          "use --stretch measured --weights fitted, which needs none, or give a body without limbs"};
}

/// Share of the body's length that each vertex lies at, by distance over the surface from one end.
Result<std::vector<double>> orderAlong(std::span<const glm::vec3> positions,
                                       const std::vector<Triangle>& triangles,
                                       const std::vector<double>& vertexDiameters) {
  const GeodesicSolver solver(positions, triangles);
  const std::uint32_t anyVertex = triangles.empty() ? 0 : triangles.front()[0];
  const std::uint32_t tip = farthest(solver.distances({farthest(solver.distances({anyVertex}))}));
  std::vector<double> u = solver.distances({tip});
  const double reach = u[farthest(u)];
  const auto unreached = std::count_if(u.begin(), u.end(), [](double d) { return !std::isfinite(d); });
  if (!(reach > 0.0) || static_cast<double>(unreached) > 0.05 * static_cast<double>(positions.size())) {
    return Error{"the mesh is in several parts, so it has no single centre line", "",
                 "use --stretch measured --weights fitted, which needs none, or give a body in one piece"};
  }
  if (hasLimbBeside(u, vertexDiameters, triangles)) {
    return branches();
  }
  for (double& value : u) {
    value = std::isfinite(value) ? value / reach : 0.5;
  }
  if (isBranched(u, vertexAreas(positions, triangles), triangles)) {
    return branches();
  }
  return u;
}

struct CentreLine {
  std::vector<Vec3> points;
  std::vector<double> lengths; ///< From the first point to each.
  std::vector<double> along;   ///< Where each vertex lies.
};

/// Fits the curve and the order of the vertices along it in turn. It starts with few controls: distances from
/// one end are skewed where the end is broad, and a curve that could would follow them into a hook.
CentreLine fitCentreLine(std::span<const glm::vec3> positions, const std::vector<Vec3>& inner,
                         std::vector<double> u, Eigen::Index controls) {
  constexpr int rounds = 5;
  constexpr Eigen::Index fewestControls = 6;
  CentreLine line;
  line.along.assign(inner.size(), 0.0);
  for (int round = 0; round <= rounds; ++round) {
    line.points = fitCurve(inner, u,
                           round < 2    ? fewestControls
                           : round == 2 ? (controls + fewestControls) / 2
                                        : controls);
    line.lengths = lengthsAlong(line.points);
    for (std::size_t v = 0; v < inner.size(); ++v) {
      line.along[v] =
          projectOn(line.points, line.lengths, round == rounds ? Vec3(positions[v]) : inner[v], u[v]);
    }
    const auto [low, high] = std::minmax_element(line.along.begin(), line.along.end());
    for (std::size_t v = 0; v < inner.size() && *high > *low && round < rounds; ++v) {
      u[v] = (line.along[v] - *low) / (*high - *low);
    }
  }
  return line;
}

/// Share of the surface that is farther from the centre line than the body is thick there: none of it in a
/// body that has just one cross-section everywhere.
double shareFarFrom(const CentreLine& line, std::span<const glm::vec3> positions,
                    const std::vector<Triangle>& triangles, const std::vector<double>& vertexDiameters) {
  constexpr double farthest = 1.5; // thicknesses
  const std::vector<double> areas = vertexAreas(positions, triangles);
  double whole = 0.0;
  double away = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double distance =
        glm::length(Vec3(positions[v]) - pointAt(line.points, line.lengths, line.along[v]));
    whole += areas[v];
    away += distance > farthest * vertexDiameters[v] ? areas[v] : 0.0;
  }
  return whole > 0.0 ? away / whole : 0.0;
}

} // namespace

Result<BodySkeleton> skeletonOfBody(std::span<const glm::vec3> positions,
                                    const std::vector<Triangle>& triangles,
                                    const std::vector<double>& vertexDiameters, int segmentCount) {
  if (segmentCount < 1 || positions.size() < 4 * static_cast<std::size_t>(std::max(segmentCount, 1))) {
    return Error{std::to_string(segmentCount) + " bones for " + std::to_string(positions.size()) +
                     " vertices",
                 "", "ask for at least one bone, and for at most a quarter of the vertices"};
  }
  const auto order = orderAlong(positions, triangles, vertexDiameters);
  if (!order) {
    return order.error();
  }
  const std::vector<Vec3> inner = movedInwards(positions, triangles, vertexDiameters);
  CentreLine line = fitCentreLine(positions, inner, *order, std::clamp(segmentCount / 2 + 4, 8, 40));
  constexpr double mostBesideTheLine = 0.05;
  if (shareFarFrom(line, positions, triangles, vertexDiameters) > mostBesideTheLine) {
    return branches();
  }
  const auto [low, high] = std::minmax_element(line.along.begin(), line.along.end());
  BodySkeleton skeleton;
  skeleton.stations = equalStations(line.points, line.lengths, *low, *high, segmentCount);
  for (const double station : skeleton.stations) {
    skeleton.joints.push_back(pointAt(line.points, line.lengths, station));
  }
  skeleton.along = std::move(line.along);
  skeleton.length = polylineLength(skeleton.joints);
  if (!(skeleton.length > 0.0)) {
    return Error{"the body has no length", "", "give a body with some extent"};
  }
  return skeleton;
}

JointTracker::JointTracker(const BodySkeleton& skeleton, std::span<const glm::vec3> positions)
    : parts_(skeleton.joints.size()) {
  const double spacing =
      (skeleton.stations.back() - skeleton.stations.front()) / static_cast<double>(skeleton.segmentCount());
  for (std::size_t j = 0; j < parts_.size(); ++j) {
    double reach = 0.6 * spacing;
    for (int widened = 0; widened < 8 && parts_[j].size() < 8; ++widened, reach *= 1.5) {
      parts_[j].clear();
      for (std::uint32_t v = 0; v < skeleton.along.size(); ++v) {
        const double kernel = 1.0 - std::abs(skeleton.along[v] - skeleton.stations[j]) / reach;
        if (kernel > 0.0) {
          parts_[j].push_back({v, kernel});
        }
      }
    }
    // Moving least squares: the mean is made exact for every affine map of the bind pose, so that a joint
    // begins on the curve however unevenly vertices lie around it, at the tips with all of them on one side.
    Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
    const auto offsetOf = [&](const Part& part) {
      const Vec3 away = (Vec3(positions[part.vertex]) - skeleton.joints[j]) / spacing;
      return Eigen::Vector4d(1.0, away.x, away.y, away.z);
    };
    for (const Part& part : parts_[j]) {
      moments += part.weight * offsetOf(part) * offsetOf(part).transpose();
    }
    moments.diagonal().tail<3>().array() += 1e-9 * moments.trace();
    const Eigen::Vector4d affine = moments.ldlt().solve(Eigen::Vector4d::UnitX());
    for (Part& part : parts_[j]) {
      part.weight *= affine.dot(offsetOf(part));
    }
  }
}

std::vector<Vec3> JointTracker::joints(std::span<const glm::vec3> positions) const {
  std::vector<Vec3> joints;
  for (const std::vector<Part>& parts : parts_) {
    Vec3 sum(0.0);
    double weight = 0.0;
    for (const Part& part : parts) {
      sum += part.weight * Vec3(positions[part.vertex]);
      weight += part.weight;
    }
    joints.push_back(weight != 0.0 ? sum / weight : sum);
  }
  return joints;
}

std::size_t segmentAt(const BodySkeleton& skeleton, double along) {
  const auto above = std::upper_bound(skeleton.stations.begin() + 1, skeleton.stations.end() - 1, along);
  return static_cast<std::size_t>(above - skeleton.stations.begin()) - 1;
}

std::vector<int> segmentsOfTriangles(const BodySkeleton& skeleton, const std::vector<Triangle>& triangles) {
  std::vector<int> segments;
  for (const Triangle& t : triangles) {
    const double along = (skeleton.along[t[0]] + skeleton.along[t[1]] + skeleton.along[t[2]]) / 3.0;
    segments.push_back(static_cast<int>(segmentAt(skeleton, along)));
  }
  return segments;
}

double totalCurvature(const std::vector<Vec3>& joints) {
  double sum = 0.0;
  for (std::size_t j = 2; j < joints.size(); ++j) {
    const Vec3 before = joints[j - 1] - joints[j - 2];
    const Vec3 after = joints[j] - joints[j - 1];
    sum += std::atan2(glm::length(glm::cross(before, after)), glm::dot(before, after));
  }
  return sum;
}

} // namespace stretch::skinning
