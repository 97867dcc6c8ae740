#include "skinning/bind/strange_patches.h"

#include <algorithm>
#include <array>
#include <utility>

#include <tbb/parallel_for.h>

#include "skinning/bind/weight_row.h"

namespace stretch::skinning {

namespace {

using SurfaceNeighbours = std::vector<std::vector<std::uint32_t>>;

SurfaceNeighbours surfaceNeighbours(const std::vector<Triangle>& triangles,
                                    const std::vector<std::uint32_t>& welded) {
  SurfaceNeighbours beside(welded.size());
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = welded[triangle[i]];
      const std::uint32_t to = welded[triangle[(i + 1) % 3]];
      if (from != to) {
        beside[from].push_back(to);
        beside[to].push_back(from);
      }
    }
  }
  return beside;
}

// Parent and child, siblings, grandparent and grandchild.
bool areRelatives(const std::vector<BindJoint>& joints, int a, int b) {
  const auto line = [&](int joint) {
    std::array<int, 3> above{joint, -1, -1};
    for (std::size_t i = 1; i < above.size() && above[i - 1] >= 0; ++i) {
      above[i] = joints[static_cast<std::size_t>(above[i - 1])].parent;
    }
    return above;
  };
  const auto lineA = line(a);
  const auto lineB = line(b);
  return lineA[0] == lineB[0] || lineA[0] == lineB[1] || lineA[0] == lineB[2] || lineA[1] == lineB[0] ||
         lineA[2] == lineB[0] || (lineA[1] >= 0 && lineA[1] == lineB[1]);
}

class Patches {
public:
  Patches(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& welded,
          const std::vector<BindJoint>& joints, std::vector<Influences>& weights)
      : welded_(welded), joints_(joints), weights_(weights), beside_(surfaceNeighbours(triangles, welded)),
        isSeen_(welded.size(), false) {}

  void takeIn() {
    for (std::uint32_t v = 0; v < welded_.size(); ++v) {
      if (welded_[v] == v && !isSeen_[v] && !beside_[v].empty()) {
        const std::vector<std::uint32_t> patch = patchFrom(v);
        if (isStrange(patch)) {
          strange_.push_back(patch);
        }
      }
    }
    std::ranges::stable_sort(strange_, {}, [](const auto& patch) { return patch.size(); });
    for (const std::vector<std::uint32_t>& patch : strange_) {
      fill(patch);
    }
    for (std::uint32_t v = 0; v < welded_.size(); ++v) {
      weights_[v] = strange_.empty() ? weights_[v] : weights_[welded_[v]];
    }
  }

private:
  [[nodiscard]] int jointOf(std::uint32_t vertex) const { return weights_[vertex].bones[0]; }

  std::vector<std::uint32_t> patchFrom(std::uint32_t first) {
    std::vector<std::uint32_t> patch{first};
    isSeen_[first] = true;
    for (std::size_t i = 0; i < patch.size(); ++i) {
      for (const std::uint32_t next : beside_[patch[i]]) {
        if (!isSeen_[next] && jointOf(next) == jointOf(first)) {
          isSeen_[next] = true;
          patch.push_back(next);
        }
      }
    }
    return patch;
  }

  // It has neighbours, and none of them is a relative.
  [[nodiscard]] bool isStrange(const std::vector<std::uint32_t>& patch) const {
    bool isAlone = true;
    for (const std::uint32_t v : patch) {
      for (const std::uint32_t next : beside_[v]) {
        if (jointOf(next) != jointOf(v)) {
          isAlone = false;
          if (areRelatives(joints_, jointOf(next), jointOf(v))) {
            return false;
          }
        }
      }
    }
    return !isAlone;
  }

  // From its border inwards.
  void fill(const std::vector<std::uint32_t>& patch) {
    const int joint = jointOf(patch.front());
    std::vector<std::uint32_t> open = patch;
    while (!open.empty()) {
      std::vector<std::pair<std::uint32_t, Influences>> reached;
      std::vector<std::uint32_t> left;
      for (const std::uint32_t v : open) {
        WeightSum around;
        for (const std::uint32_t next : beside_[v]) {
          if (jointOf(next) != joint) {
            around.add(weights_[next], 1.0);
          }
        }
        const Influences row = around.strongest(Influences::capacity);
        if (row.weights[0] > 0.0F && around.of(row.bones[0]) > 0.0) {
          reached.emplace_back(v, row);
        } else {
          left.push_back(v);
        }
      }
      if (reached.empty()) {
        return;
      }
      for (const auto& [v, row] : reached) {
        weights_[v] = row;
      }
      open = std::move(left);
    }
  }

  const std::vector<std::uint32_t>& welded_;
  const std::vector<BindJoint>& joints_;
  std::vector<Influences>& weights_;
  SurfaceNeighbours beside_;
  std::vector<bool> isSeen_;
  std::vector<std::vector<std::uint32_t>> strange_;
};

} // namespace

void dropStrangers(std::span<const glm::vec3> positions, const std::vector<BoneLine>& lines,
                   const SkeletonWays& ways, std::vector<Influences>& weights) {
  std::vector<std::vector<std::size_t>> ofJoint;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ofJoint.resize(std::max<std::size_t>(ofJoint.size(), lines[i].joint + std::size_t{1}));
    ofJoint[lines[i].joint].push_back(i);
  }
  tbb::parallel_for(std::size_t{0}, weights.size(), [&](std::size_t v) {
    Influences& row = weights[v];
    if (row.weights[1] <= 0.0F) {
      return;
    }
    const Vec3 place(positions[v]);
    const auto [own, toOwn] = nearestOnBones(lines, ofJoint[row.bones[0]], place);
    WeightSum kept;
    kept.add(row.bones[0], static_cast<double>(row.weights[0]));
    for (std::size_t i = 1; i < Influences::capacity && row.weights[i] > 0.0F; ++i) {
      const auto [other, toOther] = nearestOnBones(lines, ofJoint[row.bones[i]], place);
      kept.add(row.bones[i], static_cast<double>(row.weights[i]) * ways.kinship(own, other, toOwn + toOther));
    }
    row = kept.strongest(Influences::capacity);
  });
}

void takeInPatches(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& welded,
                   const std::vector<BindJoint>& joints, std::vector<Influences>& weights) {
  Patches(triangles, welded, joints, weights).takeIn();
}

} // namespace stretch::skinning
