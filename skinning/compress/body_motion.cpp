#include "skinning/compress/body_motion.h"

#include <algorithm>
#include <cmath>

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

Eigen::Vector3d centroidOf(const glm::vec3* frame, const std::vector<Member>& members) {
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
SegmentMotion measure(const glm::vec3* from, const glm::vec3* to, const std::vector<Member>& members) {
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

/// Volume of each segment as a cylinder of its mean width, scaled so that they sum to what the surface
/// encloses.
std::vector<double> segmentVolumes(const MeshSequence& sequence, const BodySkeleton& skeleton,
                                   const std::vector<double>& widths) {
  std::vector<double> volumes(skeleton.segmentCount());
  double sum = 0.0;
  for (std::size_t s = 0; s < volumes.size(); ++s) {
    const double length = glm::length(skeleton.joints[s + 1] - skeleton.joints[s]);
    volumes[s] = 0.25 * pi * widths[s] * widths[s] * length;
    sum += volumes[s];
  }
  const double whole = std::abs(enclosedVolume(sequence.frame(0), sequence.triangles));
  for (double& volume : volumes) {
    volume *= sum > 0.0 && whole > 0.0 ? whole / sum : 1.0;
  }
  return volumes;
}

} // namespace

Result<BodyMotion> analyseBody(const MeshSequence& sequence, int segmentCount) {
  const auto diameters = shapeDiameters(sequence.frame(0), sequence.vertexCount, sequence.triangles);
  if (!diameters) {
    return diameters.error();
  }
  auto skeleton = skeletonOfBody(sequence.frame(0), sequence.vertexCount, sequence.triangles,
                                 diameters->vertices, segmentCount);
  if (!skeleton) {
    return skeleton.error();
  }
  BodyMotion body;
  body.skeleton = std::move(skeleton.value());
  body.faceDiameters = diameters->faces;
  body.widths = meanByGroup(sequence.frame(0), sequence.triangles, diameters->faces,
                            segmentsOfTriangles(body.skeleton, sequence.triangles), body.segmentCount());
  body.volumes = segmentVolumes(sequence, body.skeleton, body.widths);
  const JointTracker tracker(body.skeleton);
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
