#include "rig/corners/corner_set.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "core/scene/bind_chains.h"
#include "core/scene/morphs.h"
#include "rig/corners/enclosing_corners.h"
#include "rig/rekey/stretch_frames.h"

namespace stretch::rig {

namespace {

constexpr std::size_t cornersOfTetrahedron = 4;
constexpr float wholeWeight = 0.98F; // of a vertex that its other joints hardly move

// Places of vertices that a joint moves, in its space.
struct MovedPoints {
  std::vector<Vec3> all;
  std::vector<Vec3> shared; // which another joint moves as well
};

std::map<NodeIndex, MovedPoints> pointsOf(const Scene& scene, const std::vector<MovedMesh>& meshes,
                                          const std::set<NodeIndex>& joints) {
  std::map<NodeIndex, MovedPoints> points;
  std::set<std::pair<int, int>> seen; // meshes under skins
  for (const MovedMesh& mesh : meshes) {
    const int index = scene.nodes[at(mesh.node)].mesh;
    if (mesh.skin >= 0 && !seen.emplace(index, mesh.skin).second) {
      continue;
    }
    const Mesh& shape = scene.meshes[at(index)];
    for (const Primitive& primitive : shape.primitives) {
      const std::vector<VertexInfluences> influences = influencesOf(primitive, mesh);
      for (std::size_t v = 0; v < influences.size(); ++v) {
        for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
          const std::size_t slot = influences[v].joints[i];
          const float weight = influences[v].weights[i];
          if (weight > 0.0F && slot < mesh.joints.size() && joints.contains(mesh.joints[slot])) {
            MovedPoints& moved = points[mesh.joints[slot]];
            const Vec3 place = morphedPlace(shape, primitive, scene.nodes[at(mesh.node)].morphWeights, v);
            moved.all.push_back(transformPoint(mesh.inverseBind[slot], place));
            if (weight < wholeWeight) {
              moved.shared.push_back(moved.all.back());
            }
          }
        }
      }
    }
  }
  return points;
}

// Whether the stretch only makes longer what lies along its first axis.
bool onlyLengthens(const StretchKeys& stretch) {
  constexpr double unseen = 1e-6;
  return stretch.axisIsFixed() && std::ranges::all_of(stretch.scales, [](const Vec3& scale) {
           return std::abs(scale.y - 1.0) < unseen && std::abs(scale.z - 1.0) < unseen;
         });
}

Vec3 axisOf(const StretchKeys& stretch) {
  return stretch.axes.front() * Vec3(1, 0, 0);
}

// Whether all stretches of a joint make it longer along one direction.
bool onlyLengthen(const std::vector<const StretchKeys*>& stretches, const Vec3& direction) {
  constexpr double sameDirection = 1e-6;
  return std::ranges::all_of(stretches, [&](const StretchKeys* stretch) {
    return onlyLengthens(*stretch) && glm::length(glm::cross(axisOf(*stretch), direction)) < sameDirection;
  });
}

// Points that are spread over the others as far apart from each other as they go, a little outside of them.
std::vector<Vec3> spread(const std::vector<Vec3>& points, std::size_t count) {
  constexpr double outwards = 1.1;
  Vec3 centre(0.0);
  for (const Vec3& point : points) {
    centre += point / static_cast<double>(points.size());
  }
  std::vector<double> distances;
  std::ranges::transform(points, std::back_inserter(distances),
                         [&](const Vec3& point) { return glm::length(point - centre); });
  std::vector<Vec3> chosen;
  while (chosen.size() < std::min(count, points.size())) {
    const auto farthest = std::ranges::max_element(distances) - distances.begin();
    const Vec3& next = points[static_cast<std::size_t>(farthest)];
    if (distances[static_cast<std::size_t>(farthest)] <= 0.0) {
      break;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double distance = glm::length(points[i] - next);
      distances[i] = chosen.empty() ? distance : std::min(distances[i], distance);
    }
    chosen.push_back(next);
  }
  for (Vec3& place : chosen) {
    place = centre + outwards * (place - centre);
  }
  return chosen;
}

// Whether a tetrahedron holds every point.
bool isHeldBy(const std::vector<Vec3>& corners, const std::vector<Vec3>& points) {
  constexpr double rounding = 1e-5; // of its size: places in files are single precision
  double size = 0.0;
  for (const Vec3& corner : corners) {
    size = std::max(size, glm::length(corner - corners.front()));
  }
  return std::ranges::all_of(points, [&](const Vec3& point) {
    const std::vector<double> shares = affineCoordinates(corners, point);
    Vec3 apart = -point;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      apart += shares[k] * corners[k];
    }
    return glm::length(apart) <= rounding * size;
  });
}

// The file's corners, the four first that hold every point; where no four do, its ends are.
CornerSet madeSet(const BindChain& made, const std::vector<Vec3>& points) {
  constexpr double opposite = -1.0 + 1e-6;
  CornerSet set{made.joint, {}, 0, 0, made.corners};
  std::vector<bool> isChosen(std::min(set.made.size(), cornersOfTetrahedron + furtherCorners));
  std::fill_n(isChosen.begin(), std::min(isChosen.size(), cornersOfTetrahedron), true);
  do {
    std::vector<BindCorner> corners;
    for (const bool isFirst : {true, false}) {
      for (std::size_t k = 0; k < made.corners.size(); ++k) {
        if ((k < isChosen.size() && isChosen[k]) == isFirst) {
          corners.push_back(made.corners[k]);
        }
      }
    }
    std::vector<Vec3> places;
    std::ranges::transform(corners, std::back_inserter(places), &BindCorner::place);
    if (places.size() >= cornersOfTetrahedron &&
        isHeldBy({places.begin(), places.begin() + cornersOfTetrahedron}, points)) {
      set.made = std::move(corners);
      set.enclosing = cornersOfTetrahedron;
    }
  } while (set.enclosing == 0 && std::prev_permutation(isChosen.begin(), isChosen.end()));
  std::ranges::transform(set.made, std::back_inserter(set.places), &BindCorner::place);
  if (set.enclosing == 0) {
    const bool hasTwo = set.places.size() > 1 &&
                        glm::dot(glm::normalize(set.places[0]), glm::normalize(set.places[1])) < opposite;
    set.enclosing = hasTwo ? 2 : 1;
  }
  set.offered = std::min(set.places.size(), set.enclosing + furtherCorners);
  return set;
}

CornerSet setOf(const Scene& scene, NodeIndex joint, const std::vector<const StretchKeys*>& stretches,
                const MovedPoints& points, std::size_t further) {
  CornerSet set{joint, {}, 0, 0, {}};
  if (const BindChain* const made = findBindChain(scene, joint); made != nullptr && !made->corners.empty()) {
    set = madeSet(*made, points.all);
    const bool isEnough =
        set.enclosing >= cornersOfTetrahedron || onlyLengthen(stretches, glm::normalize(set.places.front()));
    if (isEnough) {
      return set;
    }
    set = {joint, {}, 0, 0, {}, made->nodes()};
  }
  const Vec3 direction = axisOf(*stretches.front());
  const bool hasEnds = onlyLengthen(stretches, direction);
  set.places = hasEnds ? enclosingEnds(points.all, direction)
                       : enclosingTetrahedron(points.all, stretches.front()->axes.front());
  set.enclosing = set.places.size();
  const std::vector<Vec3> more = spread(points.shared, hasEnds ? 0 : further);
  set.places.insert(set.places.end(), more.begin(), more.end());
  set.offered = set.places.size();
  return set;
}

// A stretch and the times of its keys, for a corner.
class CornerMotion {
public:
  CornerMotion(const Vec3& place, const StretchKeys& stretch) : place_(place), stretch_(stretch) {
    times_.push_back(stretch.times.front());
    values_.push_back(placeAt(0));
    for (std::size_t key = 0; key + 1 < stretch.times.size(); ++key) {
      add(key, 0.0, 1.0, 0);
    }
  }

  [[nodiscard]] const std::vector<float>& times() const { return times_; }
  [[nodiscard]] const std::vector<Vec3>& values() const { return values_; }

private:
  [[nodiscard]] StretchFrame frameOf(std::size_t key) const {
    return {stretch_.axisIsFixed() ? stretch_.axes.front() : stretch_.axes[key], stretch_.scales[key]};
  }
  [[nodiscard]] Vec3 placeAt(std::size_t key) const { return frameOf(key).matrix() * place_; }
  [[nodiscard]] Vec3 placeBetween(std::size_t key, double t) const {
    return between(frameOf(key), frameOf(key + 1), t) * place_;
  }

  // Adds the part (from, to] of what lies between two keys, halved until straight lines do.
  void add(std::size_t key, double from, double to, int depth) {
    constexpr double tolerance = 1e-5;
    constexpr int deepest = 8;
    const double middle = 0.5 * (from + to);
    const Vec3 straight = 0.5 * (placeBetween(key, from) + placeBetween(key, to));
    const bool isStraight =
        stretch_.axisIsFixed() || depth == deepest ||
        glm::length(placeBetween(key, middle) - straight) <= tolerance * glm::length(place_);
    if (!isStraight) {
      add(key, from, middle, depth + 1);
      add(key, middle, to, depth + 1);
      return;
    }
    const float time =
        to < 1.0
            ? static_cast<float>(stretch_.times[key] +
                                 to * (static_cast<double>(stretch_.times[key + 1]) - stretch_.times[key]))
            : stretch_.times[key + 1];
    if (time > times_.back() && (to >= 1.0 || time < stretch_.times[key + 1])) {
      times_.push_back(time);
      values_.push_back(placeBetween(key, to));
    }
  }

  const Vec3& place_;
  const StretchKeys& stretch_;
  std::vector<float> times_;
  std::vector<Vec3> values_;
};

} // namespace

CornerSet madeSet(const Scene& scene, const BindChain& made) {
  return madeSet(made, pointsOf(scene, meshesOf(scene, {made.joint}), {made.joint})[made.joint].all);
}

std::vector<MovedMesh> meshesOf(const Scene& scene, const std::vector<NodeIndex>& joints) {
  const std::set<NodeIndex> wanted(joints.begin(), joints.end());
  std::vector<MovedMesh> meshes;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (node.mesh >= 0 && node.skin >= 0) {
      const Skin& skin = scene.skins[at(node.skin)];
      if (std::ranges::any_of(skin.joints, [&](NodeIndex joint) { return wanted.contains(joint); })) {
        meshes.push_back({NodeIndex(i), node.skin, skin.joints, skin.inverseBind});
      }
    } else if (node.mesh >= 0 && wanted.contains(NodeIndex(i))) {
      meshes.push_back({NodeIndex(i), -1, {NodeIndex(i)}, {Mat4(1.0)}});
    }
  }
  return meshes;
}

std::vector<VertexInfluences> influencesOf(const Primitive& primitive, const MovedMesh& mesh) {
  if (mesh.skin >= 0) {
    return primitive.influences;
  }
  VertexInfluences whole;
  whole.weights[0] = 1.0F;
  std::vector<VertexInfluences> all(primitive.positions.size(), whole);
  return all;
}

std::map<NodeIndex, CornerSet> cornerSets(const Scene& scene, const std::vector<ClipStretches>& clips,
                                          const std::vector<MovedMesh>& meshes, std::size_t further) {
  std::map<NodeIndex, std::vector<const StretchKeys*>> stretches;
  std::set<NodeIndex> joints;
  for (const ClipStretches& clip : clips) {
    for (const StretchKeys& stretch : clip.stretches) {
      stretches[stretch.node].push_back(&stretch);
      joints.insert(stretch.node);
    }
  }
  const std::map<NodeIndex, MovedPoints> points = pointsOf(scene, meshes, joints);
  std::map<NodeIndex, CornerSet> sets;
  for (const auto& [joint, ofJoint] : stretches) {
    if (const auto moved = points.find(joint); moved != points.end()) {
      sets.emplace(joint, setOf(scene, joint, ofJoint, moved->second, further));
    }
  }
  return sets;
}

Track cornerTrack(NodeIndex node, const Vec3& place, const StretchKeys& stretch) {
  const CornerMotion motion(place, stretch);
  Track track;
  track.node = node;
  track.channel = Channel::translation;
  track.times = motion.times();
  for (const Vec3& value : motion.values()) {
    for (const double number : {value.x, value.y, value.z}) {
      track.values.push_back(static_cast<float>(number));
    }
  }
  return track;
}

} // namespace stretch::rig
