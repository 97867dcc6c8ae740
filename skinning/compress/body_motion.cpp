#include "skinning/compress/body_motion.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "skinning/geometry/shape_diameter.h"
#include "skinning/sequence/topology.h"

namespace stretch::skinning {
namespace {

struct Member {
  std::uint32_t vertex = 0;
  double weight = 0.0;
};

/// Vertices of each segment and some way beyond its ends, where they count less and less.
std::vector<std::vector<Member>> membersOf(const BodySkeleton& skeleton) {
  std::vector<std::vector<Member>> members(skeleton.segmentCount());
  for (std::size_t s = 0; s < members.size(); ++s) {
    const double middle = 0.5 * (skeleton.stations[s] + skeleton.stations[s + 1]);
    double reach = skeleton.stations[s + 1] - skeleton.stations[s];
    for (int widened = 0; widened < 8 && members[s].size() < 12; ++widened, reach *= 1.5) {
      members[s].clear();
      for (std::uint32_t v = 0; v < skeleton.along.size(); ++v) {
        const double weight = 1.0 - std::abs(skeleton.along[v] - middle) / reach;
        if (weight > 0.0) {
          members[s].push_back({v, weight});
        }
      }
    }
  }
  return members;
}

Eigen::Vector3d toEigen(const glm::vec3& v) {
  return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

Eigen::Vector3d centroidOf(std::span<const glm::vec3> frame, const std::vector<Member>& members) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0.0;
  for (const Member& member : members) {
    sum += member.weight * toEigen(frame[member.vertex]);
    weight += member.weight;
  }
  return weight > 0.0 ? Eigen::Vector3d(sum / weight) : sum;
}

Mat3 toGlm(const Eigen::Matrix3d& m) {
  Mat3 result;
  for (Eigen::Index column = 0; column < 3; ++column) {
    for (Eigen::Index row = 0; row < 3; ++row) {
      result[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)] = m(row, column);
    }
  }
  return result;
}

/// Best affine map of the members from the first frame to another, taken apart into rotation and symmetric
/// stretch.
SegmentMotion measure(std::span<const glm::vec3> from, std::span<const glm::vec3> to,
                      const std::vector<Member>& members) {
  const Eigen::Vector3d fromCentre = centroidOf(from, members);
  const Eigen::Vector3d toCentre = centroidOf(to, members);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  for (const Member& member : members) {
    const Eigen::Vector3d x = toEigen(from[member.vertex]) - fromCentre;
    spread += member.weight * x * x.transpose();
    product += member.weight * (toEigen(to[member.vertex]) - toCentre) * x.transpose();
  }
  // A ridge along directions without extent makes the map the identity there instead of undefined.
  const Eigen::Matrix3d ridge = (1e-6 * spread.trace() + 1e-300) * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d affine = (spread + ridge).ldlt().solve((product + ridge).transpose()).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(affine, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  Eigen::Vector3d scales = svd.singularValues();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) {
    u.col(2) = -u.col(2);
    scales(2) = -scales(2);
  }
  SegmentMotion motion;
  motion.rotation = glm::normalize(glm::quat_cast(toGlm(u * svd.matrixV().transpose())));
  motion.stretch = toGlm(svd.matrixV() * scales.asDiagonal() * svd.matrixV().transpose());
  return motion;
}

/// Hands the value of a triangle to the segments that it reaches over, in proportion to how far.
void spread(const BodySkeleton& skeleton, const Triangle& triangle, double value, std::vector<double>& sums) {
  const auto [low, high] =
      std::minmax({skeleton.along[triangle[0]], skeleton.along[triangle[1]], skeleton.along[triangle[2]]});
  const std::size_t first = segmentAt(skeleton, low);
  const std::size_t last = segmentAt(skeleton, high);
  for (std::size_t s = first; s <= last; ++s) {
    const double from = s == first ? low : skeleton.stations[s];
    const double to = s == last ? high : skeleton.stations[s + 1];
    sums[s] += first == last ? value : value * (to - from) / (high - low);
  }
}

/// Volume of each segment: the flow of half the distance from the axis through the surface around it (its
/// divergence is 1; flat ends add nothing). Scaled so that the segments sum to what the whole surface
/// encloses.
std::vector<double> segmentVolumes(const MeshSequence& sequence, const BodySkeleton& skeleton) {
  std::vector<double> volumes(skeleton.segmentCount(), 0.0);
  const std::span<const glm::vec3> positions = sequence.frame(0);
  const std::vector<int> segments = segmentsOfTriangles(skeleton, sequence.triangles);
  for (std::size_t t = 0; t < sequence.triangles.size(); ++t) {
    const Triangle& triangle = sequence.triangles[t];
    const auto segment = static_cast<std::size_t>(segments[t]);
    const Vec3 a(positions[triangle[0]]);
    const Vec3 b(positions[triangle[1]]);
    const Vec3 c(positions[triangle[2]]);
    const Vec3 axis = glm::normalize(skeleton.joints[segment + 1] - skeleton.joints[segment]);
    const Vec3 out = (a + b + c) / 3.0 - skeleton.joints[segment];
    const double flow = 0.25 * glm::dot(out - glm::dot(out, axis) * axis, glm::cross(b - a, c - a));
    spread(skeleton, triangle, flow, volumes);
  }
  const double whole = enclosedVolume(positions, sequence.triangles);
  double sum = 0.0;
  for (double& volume : volumes) {
    volume = std::max(0.0, whole < 0.0 ? -volume : volume);
    sum += volume;
  }
  for (double& volume : volumes) {
    volume *= sum > 0.0 ? std::abs(whole) / sum : 0.0;
  }
  return volumes;
}

} // namespace

Result<BodyMotion> analyseBody(const MeshSequence& sequence, int segmentCount) {
  const auto diameters = shapeDiameters(sequence.frame(0), sequence.triangles);
  if (!diameters) {
    return diameters.error();
  }
  auto skeleton = skeletonOfBody(sequence.frame(0), sequence.triangles, diameters->vertices, segmentCount);
  if (!skeleton) {
    return skeleton.error();
  }
  BodyMotion body;
  body.skeleton = std::move(skeleton.value());
  body.widths = meanByGroup(sequence.frame(0), sequence.triangles, diameters->faces,
                            segmentsOfTriangles(body.skeleton, sequence.triangles), body.segmentCount());
  body.volumes = segmentVolumes(sequence, body.skeleton);
  const JointTracker tracker(body.skeleton, sequence.frame(0));
  const auto members = membersOf(body.skeleton);
  body.joints.resize(sequence.frameCount());
  body.segments.resize(sequence.frameCount() * body.segmentCount());
  tbb::parallel_for(std::size_t{0}, sequence.frameCount(), [&](std::size_t k) {
    body.joints[k] = tracker.joints(sequence.frame(k));
    for (std::size_t s = 0; s < body.segmentCount(); ++s) {
      body.segments[k * body.segmentCount() + s] = measure(sequence.frame(0), sequence.frame(k), members[s]);
    }
  });
  return body;
}

} // namespace stretch::skinning
