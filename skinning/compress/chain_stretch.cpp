#include "skinning/compress/chain_stretch.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/polyline.h"
#include "skinning/body/body_skeleton.h"
#include "skinning/fit/joint_tree.h"

namespace stretch::skinning {
namespace {

/// Part of the surface around a joint: its motion is the joint's. (The bones' own pivots are no measure:
/// where vertices hang on several bones, these may make up for each other.)
struct Ring {
  Vec3 place{0.0};                                      ///< In the bind pose.
  std::vector<std::pair<std::size_t, double>> vertices; ///< With weights that sum to 1.
};

Ring ringAround(const SkinnedSequence& skinned, const std::vector<std::size_t>& row, const Vec3& place,
                double reach) {
  constexpr std::size_t fewest = 12;
  constexpr int widenings = 8;
  constexpr float leastShare = 0.25F;
  Ring ring{place, {}};
  for (int widened = 0; widened < widenings && ring.vertices.size() < fewest; ++widened, reach *= 1.5) {
    ring.vertices.clear();
    double sum = 0.0;
    for (std::size_t v = 0; v < skinned.bindPositions.size(); ++v) {
      const double weight = 1.0 - glm::length(Vec3(skinned.bindPositions[v]) - place) / reach;
      const Influences& influences = skinned.influences[v];
      float share = 0.0F;
      for (std::size_t i = 0; i < Influences::capacity; ++i) {
        share += std::ranges::find(row, influences.bones[i]) != row.end() ? influences.weights[i] : 0.0F;
      }
      if (weight > 0.0 && share > leastShare) {
        ring.vertices.emplace_back(v, weight);
        sum += weight;
      }
    }
    for (auto& [vertex, weight] : ring.vertices) {
      weight /= sum;
    }
  }
  return ring;
}

std::vector<Ring> ringsOfRow(const SkinnedSequence& skinned, const std::vector<std::size_t>& row) {
  std::vector<Ring> rings;
  for (const std::size_t bone : row) {
    const SkinBone& b = skinned.bones[bone];
    rings.push_back(ringAround(skinned, row, b.pivot, glm::length(b.end - b.pivot)));
  }
  const SkinBone& last = skinned.bones[row.back()];
  rings.push_back(ringAround(skinned, row, last.end, glm::length(last.end - last.pivot)));
  return rings;
}

/// The joints of a row in a frame, and where its last bone ends.
std::vector<Vec3> jointsOfRow(const SkinnedSequence& skinned, const std::vector<Ring>& rings,
                              std::span<const glm::vec3> shown) {
  std::vector<Vec3> joints;
  for (const Ring& ring : rings) {
    Vec3 move(0.0);
    for (const auto& [vertex, weight] : ring.vertices) {
      move += weight * (Vec3(shown[vertex]) - Vec3(skinned.bindPositions[vertex]));
    }
    joints.push_back(ring.place + move);
  }
  return joints;
}

/// Which of a bone's axes lies nearest to it: 0, 1 or 2.
glm::length_t axisAlong(const SkinBone& bone) {
  const Vec3 along = glm::abs(glm::conjugate(bone.axes) * (bone.end - bone.pivot));
  const glm::length_t larger = along.x >= along.y ? 0 : 1;
  return along.z > along[larger] ? 2 : larger;
}

ChainStretch measuredRow(const SkinnedSequence& skinned, const MeshSequence& shown,
                         const std::vector<std::size_t>& row, LengthModel model,
                         std::size_t firstFittedFrame) {
  ChainStretch chain;
  chain.bones = row;
  std::vector<Vec3> rest;
  for (const std::size_t bone : row) {
    chain.names.push_back(nameOfBone(skinned, bone));
    rest.push_back(skinned.bones[bone].pivot);
  }
  rest.push_back(skinned.bones[row.back()].end);
  chain.restLength = polylineLength(rest);
  const std::vector<Ring> rings = ringsOfRow(skinned, row);
  for (std::size_t k = 0; k < skinned.frameCount(); ++k) {
    const std::vector<Vec3> joints = jointsOfRow(skinned, rings, shown.frame(k));
    chain.measured.push_back({totalCurvature(joints), polylineLength(joints)});
  }
  const std::size_t first = std::min(firstFittedFrame, chain.measured.size() - 1);
  chain.length =
      fitLength({chain.measured.begin() + static_cast<std::ptrdiff_t>(first), chain.measured.end()}, model);
  return chain;
}

double stretchAt(const ChainStretch& chain, std::size_t frame) {
  constexpr double shortest = 0.5;
  constexpr double longest = 2.0;
  const bool isBindPose = frame == 0;
  return isBindPose || !(chain.restLength > 0.0)
             ? 1.0
             : std::clamp(chain.length.at(chain.measured[frame].curvatureRadians) / chain.restLength,
                          shortest, longest);
}

} // namespace

std::vector<std::vector<std::size_t>> rowsOfTree(const std::vector<SkinBone>& bones) {
  std::vector<std::vector<std::size_t>> children(bones.size());
  for (std::size_t b = 0; b < bones.size(); ++b) {
    if (bones[b].parent >= 0) {
      children[static_cast<std::size_t>(bones[b].parent)].push_back(b);
    }
  }
  std::vector<std::vector<std::size_t>> rows;
  for (const std::size_t bone : orderOfTree(bones)) {
    const int parent = bones[bone].parent;
    if (parent >= 0 && children[static_cast<std::size_t>(parent)].size() == 1) {
      continue; // goes on in the row above it
    }
    std::vector<std::size_t> row{bone};
    while (children[row.back()].size() == 1) {
      row.push_back(children[row.back()].front());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<ChainStretch> stretchRows(SkinnedSequence& skinned, LengthModel model,
                                      std::size_t firstFittedFrame) {
  const MeshSequence shown = skinAllFrames(skinned);
  std::vector<ChainStretch> chains;
  for (const std::vector<std::size_t>& row : rowsOfTree(skinned.bones)) {
    chains.push_back(measuredRow(skinned, shown, row, model, firstFittedFrame));
  }
  for (ChainStretch& chain : chains) {
    for (std::size_t k = 0; k < skinned.frameCount(); ++k) {
      const double along = stretchAt(chain, k);
      chain.least = std::min(chain.least, along);
      chain.most = std::max(chain.most, along);
      for (const std::size_t bone : chain.bones) {
        Vec3 scale(1.0 / std::sqrt(along));
        scale[axisAlong(skinned.bones[bone])] = along;
        skinned.pose(k, bone).scale = scale;
        skinned.pose(k, bone).stretchAxes = skinned.bones[bone].axes;
      }
    }
  }
  return chains;
}

} // namespace stretch::skinning
