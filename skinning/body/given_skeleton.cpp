#include "skinning/body/given_skeleton.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/gltf/load/load_as_it_stands.h"
#include "skinning/fit/joint_tree.h"

namespace stretch::skinning {
namespace {

/// Which bone a node stands for, by index of the skin's joints.
using BoneNodes = std::map<NodeIndex, int>;

/// The node that a joint stands for: itself, or the one above a leaf that only carries a stretch, as files of
/// this program have them below every bone that others hang on.
NodeIndex standsFor(const Scene& scene, const Skin& skin, NodeIndex joint) {
  const NodeIndex above = scene.nodes[at(joint)].parent;
  const bool isLeaf = std::ranges::none_of(scene.nodes, [&](const Node& n) { return n.parent == joint; });
  const bool isJoint = std::ranges::find(skin.joints, above) != skin.joints.end();
  const bool isInPlace = glm::length(scene.nodes[at(joint)].rest.translation) <= 0.0;
  return isLeaf && isInPlace && above.exists() && !isJoint ? above : joint;
}

/// The nearest bone above a node; -1 without one.
int boneAbove(const Scene& scene, const BoneNodes& bones, NodeIndex node) {
  for (NodeIndex above = scene.nodes[at(node)].parent; above.exists();
       above = scene.nodes[at(above)].parent) {
    if (const auto found = bones.find(above); found != bones.end()) {
      return found->second;
    }
  }
  return -1;
}

bool isInvertible(const Mat4& matrix) {
  const double determinant = glm::determinant(Mat3(matrix));
  return std::isfinite(determinant) && std::abs(determinant) > 1e-30;
}

Quat turnOf(const Mat4& bind) {
  const Mat3 axes(glm::normalize(Vec3(bind[0])), glm::normalize(Vec3(bind[1])),
                  glm::normalize(Vec3(bind[2])));
  return glm::normalize(glm::quat_cast(glm::determinant(axes) < 0.0 ? -axes : axes));
}

void addEnds(std::vector<SkinBone>& bones) {
  const std::vector<std::optional<Vec3>> middles = middlesOfChildren(bones);
  for (std::size_t b = 0; b < bones.size(); ++b) {
    SkinBone& bone = bones[b];
    const Vec3 before = bone.parent >= 0 ? bones[static_cast<std::size_t>(bone.parent)].pivot : bone.pivot;
    bone.end = middles[b].value_or(bone.pivot + 0.5 * (bone.pivot - before));
  }
}

struct Box {
  Vec3 low{0.0};
  Vec3 high{0.0};

  [[nodiscard]] double diagonal() const { return glm::length(high - low); }
  [[nodiscard]] bool holds(const Vec3& p, double margin) const {
    return glm::all(glm::greaterThanEqual(p, low - Vec3(margin))) &&
           glm::all(glm::lessThanEqual(p, high + Vec3(margin)));
  }
};

template <typename Points>
Box boxOf(const Points& points) {
  Box box{points.front(), points.front()};
  for (const Vec3& p : points) {
    box = {glm::min(box.low, p), glm::max(box.high, p)};
  }
  return box;
}

} // namespace

Result<std::vector<SkinBone>> readSkeleton(const std::filesystem::path& path) {
  const auto loaded = gltf::loadAsItStands(path, gltf::Pictures::headers);
  if (!loaded) {
    return loaded.error();
  }
  const Scene& scene = *loaded->scene;
  const auto skin = std::ranges::max_element(
      scene.skins, [](const Skin& a, const Skin& b) { return a.joints.size() < b.joints.size(); });
  if (skin == scene.skins.end() || skin->joints.empty()) {
    return Error{"the file holds no skin, so there are no bones to take", path.string(),
                 "give a .glb whose mesh has a skin"};
  }
  BoneNodes slots;
  for (std::size_t j = 0; j < skin->joints.size(); ++j) {
    slots.emplace(standsFor(scene, *skin, skin->joints[j]), static_cast<int>(j));
  }
  std::vector<SkinBone> bones;
  for (std::size_t j = 0; j < skin->joints.size(); ++j) {
    const Node& node = scene.nodes[at(skin->joints[j])];
    if (!isInvertible(skin->inverseBind[j])) {
      return Error{fmt::format("the bind matrix of '{}' cannot be inverted", node.name), path.string(),
                   "export the skeleton again"};
    }
    const Mat4 bind = glm::inverse(skin->inverseBind[j]);
    SkinBone bone;
    bone.pivot = Vec3(bind[3]);
    bone.axes = turnOf(bind);
    const NodeIndex place = standsFor(scene, *skin, skin->joints[j]);
    bone.parent = boneAbove(scene, slots, place);
    bone.name = node.name.starts_with("stretch_") ? scene.nodes[at(place)].name : node.name;
    bones.push_back(bone);
  }
  addEnds(bones);
  return bones;
}

Status checkSkeleton(const std::vector<SkinBone>& bones, const MeshSequence& sequence) {
  constexpr double least = 0.25;
  constexpr double most = 4.0;
  constexpr double margin = 0.1;
  std::vector<Vec3> pivots;
  pivots.reserve(bones.size());
  for (const SkinBone& bone : bones) {
    pivots.push_back(bone.pivot);
  }
  const std::span<const glm::vec3> positions = sequence.frame(0);
  const Box mesh = boxOf(std::vector<Vec3>(positions.begin(), positions.end()));
  const double size = boxOf(pivots).diagonal();
  if (bones.size() > 1 && (size < least * mesh.diagonal() || size > most * mesh.diagonal())) {
    return Error{fmt::format("its bones span {:.3g} units and the mesh {:.3g}", size, mesh.diagonal()),
                 "--skeleton", "give a skeleton in the units of the mesh"};
  }
  const auto inside = std::ranges::count_if(
      pivots, [&](const Vec3& pivot) { return mesh.holds(pivot, margin * mesh.diagonal()); });
  if (2 * static_cast<std::size_t>(inside) < pivots.size()) {
    return Error{fmt::format("only {} of its {} bones lie in the mesh", inside, pivots.size()), "--skeleton",
                 "give a skeleton that stands where the first frame of the mesh does"};
  }
  return Success{};
}

} // namespace stretch::skinning
