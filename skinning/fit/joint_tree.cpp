#include "skinning/fit/joint_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <glm/geometric.hpp>

#include "core/scene/mesh_sequence.h"
#include "skinning/geometry/inside.h"

namespace stretch::skinning {
namespace {

using BonePair = std::pair<std::size_t, std::size_t>;

/// How much two bones share: sum of w_a w_b, and where on the bind mesh that is.
struct SharedSurface {
  double weight = 0.0;
  Vec3 middle{0.0}; ///< Times the weight until it is finished.
};

/// A place where one bone could hang on another.
struct JointCandidate {
  BonePair bones;
  Vec3 place{0.0};
  double quality = 0.0; ///< More is better.
};

std::map<BonePair, SharedSurface> sharedSurfaces(const SkinnedSequence& skinned) {
  std::map<BonePair, SharedSurface> shared;
  for (std::size_t v = 0; v < skinned.influences.size(); ++v) {
    const Influences& influences = skinned.influences[v];
    for (std::size_t i = 0; i < Influences::capacity && influences.weights[i] > 0.0F; ++i) {
      for (std::size_t j = 0; j < Influences::capacity && influences.weights[j] > 0.0F; ++j) {
        if (influences.bones[i] < influences.bones[j]) {
          const double weight =
              static_cast<double>(influences.weights[i]) * static_cast<double>(influences.weights[j]);
          SharedSurface& surface = shared[{influences.bones[i], influences.bones[j]}];
          surface.weight += weight;
          surface.middle += weight * Vec3(skinned.bindPositions[v]);
        }
      }
    }
  }
  return shared;
}

/// Middle and weight of what follows each bone.
std::vector<SharedSurface> ownSurfaces(const SkinnedSequence& skinned) {
  std::vector<SharedSurface> own(skinned.bones.size());
  for (std::size_t v = 0; v < skinned.influences.size(); ++v) {
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      const auto weight = static_cast<double>(skinned.influences[v].weights[i]);
      own[skinned.influences[v].bones[i]].weight += weight;
      own[skinned.influences[v].bones[i]].middle += weight * Vec3(skinned.bindPositions[v]);
    }
  }
  for (std::size_t b = 0; b < own.size(); ++b) {
    own[b].middle = own[b].weight > 0.0 ? own[b].middle / own[b].weight : skinned.bones[b].pivot;
  }
  return own;
}

Eigen::Matrix3d linearDifference(const Mat4& a, const Mat4& b) {
  Eigen::Matrix3d difference;
  for (glm::length_t column = 0; column < 3; ++column) {
    for (glm::length_t row = 0; row < 3; ++row) {
      difference(row, column) = a[column][row] - b[column][row];
    }
  }
  return difference;
}

/// The point that two bones carry to places the least apart, held a little near the middle of what they
/// share: bones that turn about an axis leave it free along that axis, those that move alike everywhere.
JointCandidate jointBetween(const std::vector<Mat4>& matrices, std::size_t boneCount, const BonePair& bones,
                            const SharedSurface& shared, double size) {
  const Vec3 near = shared.middle / shared.weight;
  const std::size_t frames = matrices.size() / boneCount;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double square = 0.0;
  for (std::size_t k = 0; k < frames; ++k) {
    const Mat4& a = matrices[k * boneCount + bones.first];
    const Mat4& b = matrices[k * boneCount + bones.second];
    const Eigen::Matrix3d linear = linearDifference(a, b);
    const Vec3 gap = Vec3(a * Vec4(near, 1.0)) - Vec3(b * Vec4(near, 1.0));
    const Eigen::Vector3d apart(gap.x, gap.y, gap.z);
    normal += linear.transpose() * linear;
    right -= linear.transpose() * apart;
    square += apart.squaredNorm();
  }
  constexpr double share = 0.02;
  constexpr double leastTurn = 0.02; // Radians that count as nothing.
  const double hold = share * normal.trace() / 3.0 + leastTurn * leastTurn * static_cast<double>(frames);
  const Eigen::Vector3d moved = (normal + hold * Eigen::Matrix3d::Identity()).ldlt().solve(right);
  const double left = std::max(0.0, square - 2.0 * moved.dot(right) + moved.dot(normal * moved));
  const double apart = std::sqrt(left / static_cast<double>(frames)) / size;
  constexpr double negligible = 0.005; // Of the body's size.
  return {bones, near + Vec3(moved.x(), moved.y(), moved.z()), shared.weight / (apart + negligible)};
}

/// Edges of the best forest, by Kruskal.
std::vector<JointCandidate> bestForest(std::vector<JointCandidate> candidates, std::size_t boneCount) {
  std::ranges::stable_sort(
      candidates, [](const JointCandidate& a, const JointCandidate& b) { return a.quality > b.quality; });
  std::vector<std::size_t> group(boneCount);
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<JointCandidate> forest;
  for (const JointCandidate& candidate : candidates) {
    const std::size_t a = group[candidate.bones.first];
    const std::size_t b = group[candidate.bones.second];
    if (a != b) {
      std::ranges::replace(group, b, a);
      forest.push_back(candidate);
    }
  }
  return forest;
}

/// Neighbours of each bone: indices of edges.
std::vector<std::vector<std::size_t>> edgesOfBones(const std::vector<JointCandidate>& forest,
                                                   std::size_t boneCount) {
  std::vector<std::vector<std::size_t>> edges(boneCount);
  for (std::size_t e = 0; e < forest.size(); ++e) {
    edges[forest[e].bones.first].push_back(e);
    edges[forest[e].bones.second].push_back(e);
  }
  return edges;
}

/// Bones of a root's tree in the order of their distance, with the edge that leads to each and the number of
/// joints on the way.
struct Visit {
  std::size_t bone = 0;
  std::size_t parent = 0;
  std::size_t edge = 0;
  std::size_t joints = 0;
};

std::vector<Visit> visitsFrom(std::size_t root, const std::vector<JointCandidate>& forest,
                              const std::vector<std::vector<std::size_t>>& edges) {
  std::vector<Visit> visits{{root, root, forest.size(), 0}};
  for (std::size_t next = 0; next < visits.size(); ++next) {
    const Visit from = visits[next];
    for (const std::size_t e : edges[from.bone]) {
      if (e != from.edge) {
        const BonePair& pair = forest[e].bones;
        const std::size_t other = pair.first == from.bone ? pair.second : pair.first;
        visits.push_back({other, from.bone, e, from.joints + 1});
      }
    }
  }
  return visits;
}

/// The root of each tree: the bone with the fewest joints between it and the whole of the surface.
std::vector<std::size_t> rootsOf(const std::vector<JointCandidate>& forest,
                                 const std::vector<std::vector<std::size_t>>& edges,
                                 const std::vector<SharedSurface>& own) {
  std::vector<std::size_t> roots;
  std::vector<bool> seen(own.size(), false);
  for (std::size_t b = 0; b < own.size(); ++b) {
    if (seen[b]) {
      continue;
    }
    std::size_t best = b;
    double least = std::numeric_limits<double>::infinity();
    for (const Visit& candidate : visitsFrom(b, forest, edges)) {
      seen[candidate.bone] = true;
      double way = 0.0;
      for (const Visit& visit : visitsFrom(candidate.bone, forest, edges)) {
        way += own[visit.bone].weight * static_cast<double>(visit.joints);
      }
      best = way < least ? candidate.bone : best;
      least = std::min(way, least);
    }
    roots.push_back(best);
  }
  return roots;
}

/// Moves the point about which a bone turns, not what the bone does to the mesh.
void movePivot(SkinnedSequence& skinned, std::size_t bone, const Vec3& pivot) {
  for (std::size_t k = 0; k < skinned.frameCount(); ++k) {
    BonePose& pose = skinned.pose(k, bone);
    pose.position = Vec3(skinMatrix(skinned.bones[bone], pose) * Vec4(pivot, 1.0));
  }
  skinned.bones[bone].pivot = pivot;
}

/// Each bone ends in the middle of what hangs on it, or as far beyond the middle of its own surface as it
/// begins before it.
void setEnds(SkinnedSequence& skinned, const std::vector<SharedSurface>& own) {
  const std::vector<std::optional<Vec3>> middles = middlesOfChildren(skinned.bones);
  for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
    SkinBone& bone = skinned.bones[b];
    bone.end = middles[b].value_or(2.0 * own[b].middle - bone.pivot);
  }
}

/// The diameter of a rod of the same volume and surface; 0 for a mesh that encloses next to nothing.
double thicknessOf(const PlacedSurface& mesh) {
  double volume = 0.0;
  double area = 0.0;
  // From the middle: of an open surface the volume depends on where it is looked at from.
  const Vec3 middle = std::accumulate(mesh.places.begin(), mesh.places.end(), Vec3(0.0)) /
                      std::max(1.0, static_cast<double>(mesh.places.size()));
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3 corner = mesh.places[triangle[0]] - middle;
    const Vec3 normal = glm::cross(mesh.places[triangle[1]] - mesh.places[triangle[0]],
                                   mesh.places[triangle[2]] - mesh.places[triangle[0]]);
    volume += glm::dot(corner, normal) / 6.0;
    area += 0.5 * glm::length(normal);
  }
  constexpr double flat = 1e-3; // of the side of a square as large
  const double thickness = area > 0.0 ? 4.0 * std::abs(volume) / area : 0.0;
  return thickness > flat * std::sqrt(area) ? thickness : 0.0;
}

bool isInside(const PlacedSurface& mesh, const Vec3& place) {
  constexpr double half = 0.5;
  return std::abs(windingNumber(mesh, place)) > half;
}

/// The place itself, or for one that sticks out of the body the nearest of its surface, where there is room a
/// quarter of the thickness deeper.
Vec3 placeInside(const PlacedSurface& mesh, double thickness, const Vec3& place) {
  constexpr double allowed = 0.05; // of the thickness
  constexpr double deeper = 0.25;
  const std::optional<SurfacePoint> nearest = isInside(mesh, place) ? std::nullopt : nearestOn(mesh, place);
  const Vec3 way = nearest ? placeOf(mesh, *nearest) - place : Vec3(0.0);
  const double length = glm::length(way);
  if (!(length > allowed * thickness)) {
    return place;
  }
  const Vec3 deep = place + way * (1.0 + deeper * thickness / length);
  return isInside(mesh, deep) ? deep : place + way;
}

} // namespace

void hangTogether(SkinnedSequence& skinned) {
  const std::size_t bones = skinned.bones.size();
  const double size = std::max(boxDiagonal(skinned.bindPositions), std::numeric_limits<double>::min());
  std::vector<Mat4> matrices;
  for (std::size_t i = 0; i < skinned.poses.size(); ++i) {
    matrices.push_back(skinMatrix(skinned.bones[i % bones], skinned.poses[i]));
  }
  std::vector<JointCandidate> candidates;
  for (const auto& [pair, shared] : sharedSurfaces(skinned)) {
    candidates.push_back(jointBetween(matrices, bones, pair, shared, size));
  }
  const std::vector<JointCandidate> forest = bestForest(std::move(candidates), bones);
  const auto edges = edgesOfBones(forest, bones);
  const std::vector<SharedSurface> own = ownSurfaces(skinned);
  for (const std::size_t root : rootsOf(forest, edges, own)) {
    for (const Visit& visit : visitsFrom(root, forest, edges)) {
      const bool isRoot = visit.bone == root;
      skinned.bones[visit.bone].parent = isRoot ? -1 : static_cast<int>(visit.parent);
      movePivot(skinned, visit.bone, isRoot ? own[root].middle : forest[visit.edge].place);
    }
  }
  setEnds(skinned, own);
}

void bringJointsInside(SkinnedSequence& skinned, const Proceed& proceed) {
  const std::vector<Vec3> places(skinned.bindPositions.begin(), skinned.bindPositions.end());
  const PlacedSurface mesh{places, skinned.triangles};
  const double thickness = thicknessOf(mesh);
  if (thickness == 0.0) {
    return;
  }
  std::vector<Vec3> inside(skinned.bones.size());
  for (std::size_t b = 0; b < inside.size(); ++b) {
    inside[b] = placeInside(mesh, thickness, skinned.bones[b].pivot);
    if (proceed && !proceed(static_cast<double>(b + 1) / static_cast<double>(inside.size()))) {
      return;
    }
  }
  for (std::size_t b = 0; b < inside.size(); ++b) {
    movePivot(skinned, b, inside[b]);
  }
  setEnds(skinned, ownSurfaces(skinned));
}

std::vector<std::size_t> orderOfTree(const std::vector<SkinBone>& bones) {
  std::vector<std::vector<std::size_t>> children(bones.size());
  std::vector<std::size_t> order;
  for (std::size_t b = 0; b < bones.size(); ++b) {
    if (bones[b].parent < 0) {
      order.push_back(b);
    } else {
      children[static_cast<std::size_t>(bones[b].parent)].push_back(b);
    }
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const std::vector<std::size_t>& below = children[order[next]];
    order.insert(order.end(), below.begin(), below.end());
  }
  return order;
}

std::vector<std::optional<Vec3>> middlesOfChildren(const std::vector<SkinBone>& bones) {
  std::vector<std::optional<Vec3>> middles(bones.size());
  std::vector<int> counts(bones.size(), 0);
  for (const SkinBone& bone : bones) {
    if (bone.parent >= 0) {
      const auto parent = static_cast<std::size_t>(bone.parent);
      middles[parent] = middles[parent].value_or(Vec3(0.0)) + bone.pivot;
      ++counts[parent];
    }
  }
  for (std::size_t b = 0; b < bones.size(); ++b) {
    if (middles[b]) {
      *middles[b] /= static_cast<double>(counts[b]);
    }
  }
  return middles;
}

} // namespace stretch::skinning
