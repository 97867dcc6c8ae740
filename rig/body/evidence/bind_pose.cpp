#include "rig/body/evidence/bind_pose.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/anim/sampling.h"
#include "core/math/bounds.h"
#include "core/math/finite.h"
#include "core/math/median.h"

namespace stretch::rig {

namespace body {

namespace {

using Binds = std::vector<std::optional<Mat4>>;

// `reach`: of the skin's joints, in the units of its binds; a character may be far smaller than one.
bool isNearIdentity(const Mat4& matrix, double reach) {
  constexpr double tolerance = 1e-4;
  const Mat4 difference = matrix - Mat4(1.0);
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) {
      if (std::abs(difference[column][row]) > tolerance * (column == 3 ? std::min(1.0, reach) : 1.0)) {
        return false;
      }
    }
  }
  return true;
}

bool isInvertible(const Mat4& matrix) {
  constexpr double smallest = 1e-30;
  return isFinite(matrix) && std::abs(glm::determinant(matrix)) > smallest;
}

struct Placer {
  const Scene& scene;
  std::vector<NodeIndex> order; // nodes, parents first
  std::vector<int> depth;       // per node
  std::vector<Mat4> locals;     // rest, per node
  Binds bound;                  // world bind matrix of the joints placed so far, per node

  explicit Placer(const Scene& source)
      : scene(source), order(parentsFirst(source)), depth(source.nodes.size(), 0),
        bound(source.nodes.size()) {
    const Pose rest = restPose(scene);
    locals.reserve(scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      locals.push_back(localMatrix(scene, rest, NodeIndex(i)));
    }
    for (const NodeIndex node : order) {
      const NodeIndex parent = scene.nodes[at(node)].parent;
      depth[at(node)] = !parent.exists() ? 0 : depth[at(parent)] + 1;
    }
  }

  // Where a node stands: bound, else at rest under its parent.
  [[nodiscard]] Mat4 world(NodeIndex node) const {
    Mat4 below(1.0);
    for (; node.exists(); node = scene.nodes[at(node)].parent) {
      const auto index = at(node);
      if (bound[index]) {
        return *bound[index] * below;
      }
      below = locals[index] * below;
    }
    return below;
  }

  // Where all nodes stand, at once: a chain of many is walked once.
  [[nodiscard]] std::vector<Mat4> worlds() const {
    std::vector<Mat4> all(scene.nodes.size(), Mat4(1.0));
    for (const NodeIndex node : order) {
      const auto index = at(node);
      const NodeIndex parent = scene.nodes[index].parent;
      all[index] = bound[index]      ? *bound[index]
                   : parent.exists() ? all[at(parent)] * locals[index]
                                     : locals[index];
    }
    return all;
  }
};

// Model-space bind matrices of a skin's joints, per node; empty where the file's matrix cannot be one.
Binds modelBinds(const Scene& scene, const Skin& skin) {
  Binds binds(scene.nodes.size());
  for (std::size_t i = 0; i < skin.joints.size() && i < skin.inverseBind.size(); ++i) {
    const NodeIndex joint = skin.joints[i];
    if (joint.exists() && at(joint) < binds.size() && isInvertible(skin.inverseBind[i])) {
      binds[at(joint)] = glm::inverse(skin.inverseBind[i]);
    }
  }
  return binds;
}

double reachOf(const Binds& binds) {
  Bounds bounds;
  for (const auto& bind : binds) {
    if (bind) {
      bounds.add(positionOf(*bind));
    }
  }
  return bounds.empty() ? 0.0 : bounds.largestExtent();
}

// Joints that rest at different places cannot be bound at one: identities that stand for nothing, as
// exporters write them for helper joints between those that move vertices.
bool areFalseIdentities(const Placer& placer, const Binds& binds) {
  constexpr double samePlace = 0.01; // of how far the skin's joints reach
  const std::vector<Mat4> worlds = placer.worlds();
  const double reach = reachOf(binds);
  Bounds all;
  Bounds identities;
  bool isOnlyIdentities = true;
  for (std::size_t node = 0; node < binds.size(); ++node) {
    if (!binds[node]) {
      continue;
    }
    const Vec3 place = positionOf(worlds[node]);
    all.add(place);
    if (isNearIdentity(*binds[node], reach)) {
      identities.add(place);
    } else {
      isOnlyIdentities = false;
    }
  }
  return !isOnlyIdentities && !identities.empty() &&
         identities.largestExtent() > samePlace * all.largestExtent();
}

void dropFalseIdentities(const Placer& placer, Binds& binds) {
  const bool areFalse = areFalseIdentities(placer, binds);
  const double reach = reachOf(binds);
  std::vector<NodeIndex> nearest(binds.size()); // bound node at or above each
  for (const NodeIndex node : placer.order) {
    auto& bind = binds[at(node)];
    const NodeIndex parent = placer.scene.nodes[at(node)].parent;
    const NodeIndex above = parent.exists() ? nearest[at(parent)] : NodeIndex::none;
    const bool isUnderOther = above.exists() && !isNearIdentity(*binds[at(above)], reach);
    if (bind && isNearIdentity(*bind, reach) && (areFalse || isUnderOther)) {
      bind.reset();
    }
    nearest[at(node)] = bind ? node : above;
  }
}

// Whether a skin binds all its joints alike, though they rest apart, as one without matrices does: its
// vertices are told from each joint, and no pose is.
bool tellsNoPose(const Placer& placer, const Binds& binds) {
  constexpr double tolerance = 1e-6;
  const auto first = std::ranges::find_if(binds, [](const auto& bind) { return bind.has_value(); });
  if (first == binds.end()) {
    return false;
  }
  const std::vector<Mat4> worlds = placer.worlds();
  Bounds rest;
  for (std::size_t node = 0; node < binds.size(); ++node) {
    if (binds[node]) {
      rest.add(positionOf(worlds[node]));
    }
  }
  return rest.largestExtent() > 0.0 && std::ranges::all_of(binds, [&](const auto& bind) {
           return !bind || isNearIdentity(glm::inverse(**first) * *bind, tolerance);
         });
}

// The joint that a skin is placed by: one that stands already, else the topmost one with the most joints
// below it.
NodeIndex anchorOf(const Placer& placer, const Binds& binds) {
  NodeIndex anchor;
  std::vector<int> below(binds.size(), 0);
  for (auto node = placer.order.rbegin(); node != placer.order.rend(); ++node) {
    const auto index = at(*node);
    below[index] += binds[index] ? 1 : 0;
    const NodeIndex parent = placer.scene.nodes[index].parent;
    if (parent.exists()) {
      below[at(parent)] += below[index];
    }
  }
  for (const NodeIndex node : placer.order) {
    const auto index = at(node);
    if (!binds[index]) {
      continue;
    }
    if (placer.bound[index]) {
      return node;
    }
    const bool higher = !anchor.exists() || placer.depth[index] < placer.depth[at(anchor)];
    const bool level = anchor.exists() && placer.depth[index] == placer.depth[at(anchor)];
    if (higher || (level && below[index] > below[at(anchor)])) {
      anchor = node;
    }
  }
  return anchor;
}

// How much longer bones are at rest than where a placement puts the binds: the median over all bones.
// Exporters write inverse binds in other units than the scene's. Nothing where no bone can be measured.
std::optional<double> unitsOf(const Placer& placer, const Binds& binds, const Mat4& placement) {
  std::vector<NodeIndex> nearest(binds.size()); // bound node at or above each
  std::vector<Mat4> rests(binds.size(), Mat4(1.0));
  std::vector<double> ratios;
  for (const NodeIndex node : placer.order) {
    const NodeIndex parent = placer.scene.nodes[at(node)].parent;
    rests[at(node)] = (parent.exists() ? rests[at(parent)] : Mat4(1.0)) * placer.locals[at(node)];
    const NodeIndex above = parent.exists() ? nearest[at(parent)] : NodeIndex::none;
    nearest[at(node)] = binds[at(node)] ? node : above;
    if (!binds[at(node)] || !above.exists()) {
      continue;
    }
    const double atRest = glm::distance(positionOf(rests[at(node)]), positionOf(rests[at(above)]));
    const double bound =
        glm::distance(positionOf(placement * *binds[at(node)]), positionOf(placement * *binds[at(above)]));
    if (atRest > 0.0 && bound > 0.0 && std::isfinite(atRest / bound)) {
      ratios.push_back(atRest / bound);
    }
  }
  return ratios.empty() ? std::nullopt : std::optional(medianOf(std::move(ratios), 1.0));
}

// Bones that a pose stretches are within a factor of two.
bool areOfScene(double units) {
  return units > 0.5 && units < 2.0;
}

// The placement scaled about a point, where it is in other units than the scene.
Mat4 inUnitsOfScene(const Placer& placer, const Binds& binds, const Mat4& placement, const Vec3& about) {
  const double units = unitsOf(placer, binds, placement).value_or(1.0);
  if (areOfScene(units)) {
    return placement;
  }
  return glm::translate(Mat4(1.0), about) * glm::scale(Mat4(1.0), Vec3(units)) *
         glm::translate(Mat4(1.0), -about) * placement;
}

Mat4 placementBy(const Placer& placer, const Binds& binds, NodeIndex anchor) {
  return placer.world(anchor) * glm::inverse(*binds[at(anchor)]);
}

// An identity above all other joints by which these come out in other units than the scene, though the next
// joint below places them in the scene's: it stands for nothing, and its axes may be others as well.
void dropIdentityInOtherUnits(const Placer& placer, Binds& binds) {
  const NodeIndex top = anchorOf(placer, binds);
  if (!top.exists() || placer.bound[at(top)] || !isNearIdentity(*binds[at(top)], reachOf(binds)) ||
      areOfScene(unitsOf(placer, binds, placementBy(placer, binds, top)).value_or(1.0))) {
    return;
  }
  Binds others = binds;
  others[at(top)].reset();
  const NodeIndex next = anchorOf(placer, others);
  if (next.exists() && areOfScene(unitsOf(placer, others, placementBy(placer, others, next)).value_or(0.0))) {
    binds = std::move(others);
  }
}

Mat4 placeSkin(Placer& placer, Binds binds) {
  dropFalseIdentities(placer, binds);
  dropIdentityInOtherUnits(placer, binds);
  const NodeIndex anchor = anchorOf(placer, binds);
  if (!anchor.exists()) {
    return Mat4(1.0);
  }
  const Mat4 anchored = placementBy(placer, binds, anchor);
  const bool isPlacedAlready = placer.bound[at(anchor)].has_value();
  const Mat4 placement =
      isPlacedAlready ? anchored : inUnitsOfScene(placer, binds, anchored, positionOf(placer.world(anchor)));
  if (!isFinite(placement)) {
    return Mat4(1.0);
  }
  for (std::size_t node = 0; node < binds.size(); ++node) {
    if (binds[node] && !placer.bound[node]) {
      placer.bound[node] = placement * *binds[node];
    }
  }
  return placement;
}

} // namespace

BindPose placeBindPose(const Scene& scene) {
  Placer placer(scene);
  std::vector<std::size_t> largestFirst(scene.skins.size());
  std::iota(largestFirst.begin(), largestFirst.end(), std::size_t{0});
  std::ranges::stable_sort(largestFirst, std::ranges::greater{},
                           [&](std::size_t skin) { return scene.skins[skin].joints.size(); });
  BindPose pose;
  pose.placements.resize(scene.skins.size(), Mat4(1.0));
  pose.areAtRest.resize(scene.skins.size(), false);
  for (const std::size_t skin : largestFirst) {
    Binds binds = modelBinds(scene, scene.skins[skin]);
    pose.areAtRest[skin] = tellsNoPose(placer, binds);
    if (!pose.areAtRest[skin]) {
      pose.placements[skin] = placeSkin(placer, std::move(binds));
    }
  }
  pose.worlds = placer.worlds();
  return pose;
}

} // namespace body

std::vector<Mat4> bindPoseWorlds(const Scene& scene) {
  return body::placeBindPose(scene).worlds;
}

} // namespace stretch::rig
