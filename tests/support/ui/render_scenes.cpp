#include "render_scenes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/support/nodes.h"

namespace stretch::test {

namespace {

Material plainColor(float red, float green, float blue) {
  Material material;
  material.baseColor = {red, green, blue, 1.0F};
  return material;
}

struct Bone {
  int parent;
  Vec3 from;
  Vec3 to;
  double halfWidth;
  int material;
};

// A point of a box around a bone; rounded towards its ends and bent half-way by the parent near its start.
void addBoxVertex(Primitive& primitive, const Bone& bone, int joint, const Vec3& position, const Vec3& normal,
                  double along) {
  primitive.positions.emplace_back(position);
  primitive.normals.emplace_back(normal);
  VertexInfluences influences;
  const double parentShare = bone.parent >= 0 ? 0.5 * std::clamp(1.0 - 5.0 * along, 0.0, 1.0) : 0.0;
  influences.joints[0] = static_cast<std::uint16_t>(joint);
  influences.joints[1] = static_cast<std::uint16_t>(std::max(bone.parent, 0));
  influences.weights[0] = static_cast<float>(1.0 - parentShare);
  influences.weights[1] = static_cast<float>(parentShare);
  primitive.influences.push_back(influences);
}

void addTube(Primitive& primitive, const Bone& bone, int joint) {
  constexpr std::uint32_t rings = 9;
  constexpr std::uint32_t sides = 16;
  const Vec3 along = glm::normalize(bone.to - bone.from);
  const Vec3 across =
      glm::normalize(glm::cross(std::abs(along.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(0, 1, 0), along));
  const Vec3 over = glm::cross(along, across);
  const auto base = static_cast<std::uint32_t>(primitive.positions.size());
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const double share = static_cast<double>(ring) / (rings - 1);
    const double round = std::sqrt(std::max(0.0, 1.0 - std::pow(std::abs(2.0 * share - 1.0), 6.0)));
    for (std::uint32_t side = 0; side < sides; ++side) {
      const double angle = 2.0 * pi * side / sides;
      const Vec3 out = std::cos(angle) * across + std::sin(angle) * over;
      const Vec3 normal = glm::normalize(out + std::pow(2.0 * share - 1.0, 5.0) * along);
      addBoxVertex(primitive, bone, joint,
                   bone.from + share * (bone.to - bone.from) + round * bone.halfWidth * out, normal, share);
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t a = base + ring * sides + side;
      const std::uint32_t b = base + ring * sides + (side + 1) % sides;
      primitive.indices.insert(primitive.indices.end(), {a, b, b + sides, a, b + sides, a + sides});
    }
  }
}

std::vector<Bone> bipedBones() {
  std::vector<Bone> bones{{-1, {0, 0.92, 0}, {0, 1.12, 0}, 0.16, 1},
                          {0, {0, 1.08, 0}, {0, 1.5, 0}, 0.19, 0},
                          {1, {0, 1.5, 0}, {0, 1.82, 0}, 0.13, 2}};
  for (const double side : {1.0, -1.0}) {
    const auto first = static_cast<int>(bones.size());
    bones.push_back({1, {0.17 * side, 1.42, 0}, {0.36 * side, 1.2, 0.02}, 0.07, 0});
    bones.push_back({first, {0.35 * side, 1.21, 0.02}, {0.46 * side, 0.98, 0.1}, 0.055, 2});
    bones.push_back({first + 1, {0.455 * side, 0.99, 0.1}, {0.49 * side, 0.88, 0.14}, 0.06, 2});
    bones.push_back({0, {0.11 * side, 0.94, 0}, {0.13 * side, 0.5, 0.03}, 0.1, 1});
    bones.push_back({first + 3, {0.13 * side, 0.52, 0.03}, {0.14 * side, 0.07, 0}, 0.075, 1});
    bones.push_back({first + 4, {0.14 * side, 0.05, -0.08}, {0.15 * side, 0.05, 0.2}, 0.05, 2});
  }
  return bones;
}

// Repeatable numbers in -1..1 without a generator.
double wobble(double seed) {
  return std::sin(12.9898 * seed + 4.1414 * seed * seed);
}

} // namespace

Scene triangleScene() {
  Scene scene;
  Primitive primitive;
  primitive.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  primitive.normals.assign(3, {0, 0, 1});
  primitive.indices = {0, 1, 2};
  primitive.material = 0;
  scene.meshes.push_back({"triangle", {primitive}, {}});
  scene.materials.push_back(plainColor(1.0F, 1.0F, 1.0F));
  scene.materials[0].unlit = true;
  Node node;
  node.mesh = 0;
  scene.nodes.push_back(node);
  scene.roots.emplace_back(0);
  return scene;
}

Scene bipedScene() {
  Scene scene;
  const std::vector<Bone> bones = bipedBones();
  std::vector<Primitive> byMaterial(3);
  Skin skin;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const Bone& bone = bones[i];
    const Vec3 parentPlace = bone.parent >= 0 ? bones[static_cast<std::size_t>(bone.parent)].from : Vec3(0.0);
    skin.joints.push_back(addNode(scene, {}, NodeIndex(bone.parent), bone.from - parentPlace));
    Mat4 inverseBind(1.0);
    inverseBind[3] = Vec4(-bone.from, 1.0);
    skin.inverseBind.push_back(inverseBind);
    addTube(byMaterial[static_cast<std::size_t>(bone.material)], bone, static_cast<int>(i));
  }
  for (std::size_t i = 0; i < byMaterial.size(); ++i) {
    byMaterial[i].material = static_cast<int>(i);
  }
  scene.materials = {plainColor(0.80F, 0.33F, 0.08F), plainColor(0.10F, 0.20F, 0.45F),
                     plainColor(0.75F, 0.55F, 0.42F)};
  scene.skins.push_back(skin);
  scene.meshes.push_back({"body", byMaterial, {}});
  const NodeIndex body = addNode(scene, {}, NodeIndex::none, Vec3(0.0));
  scene.nodes[at(body)].mesh = 0;
  scene.nodes[at(body)].skin = 0;
  return scene;
}

FrameState wavingFrame(const Scene& biped) {
  const BipedNodes nodes;
  Pose pose = restPose(biped);
  pose.locals[at(nodes.leftUpperArm)].rotation = glm::angleAxis(0.9, Vec3(0, 0, 1));
  pose.locals[at(nodes.leftForearm)].rotation = glm::angleAxis(1.1, Vec3(0, 0, 1));
  return frameOf(biped, std::move(pose), 0.0);
}

Scene manyJointsScene() {
  constexpr std::uint32_t side = 40;
  constexpr int joints = 200;
  Scene scene;
  Skin skin;
  for (int joint = 0; joint < joints; ++joint) {
    const Vec3 place(0.1 * wobble(joint), 0.05, 0.1 * wobble(joint + 0.5));
    skin.joints.push_back(addNode(scene, {}, NodeIndex(joint % 10 == 0 ? -1 : joint - 1), place));
    Mat4 inverseBind(1.0);
    inverseBind[3] = Vec4(-0.4 * place, 1.0);
    skin.inverseBind.push_back(inverseBind);
  }
  Primitive primitive;
  primitive.morphTargets.resize(2);
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const double seed = i;
    const std::uint32_t row = i / side;
    primitive.positions.emplace_back(0.05 * (i % side), 0.05 * row, 0.2 * wobble(seed));
    primitive.normals.emplace_back(glm::normalize(Vec3(wobble(seed + 0.1), wobble(seed + 0.2), 1.5)));
    VertexInfluences influences;
    for (std::size_t k = 0; k < VertexInfluences::capacity; ++k) {
      influences.joints[k] = static_cast<std::uint16_t>((i * 7 + k * 31) % joints);
      influences.weights[k] = (k == 0 ? 0.3F : 0.1F);
    }
    primitive.influences.push_back(influences);
    for (MorphTarget& target : primitive.morphTargets) {
      target.positions.emplace_back(0.1 * wobble(seed + 0.3), 0.1 * wobble(seed + 0.4), 0.05);
      target.normals.emplace_back(0.1 * wobble(seed + 0.6), 0.0, 0.1);
    }
    if (i % side + 1 < side && i / side + 1 < side) {
      primitive.indices.insert(primitive.indices.end(), {i, i + 1, i + side});
    }
  }
  scene.skins.push_back(skin);
  scene.meshes.push_back({"cloth", {primitive}, {0.0F, 0.0F}});
  const NodeIndex cloth = addNode(scene, {}, NodeIndex::none, Vec3(5.0, 5.0, 5.0));
  scene.nodes[at(cloth)].mesh = 0;
  scene.nodes[at(cloth)].skin = 0;
  return scene;
}

FrameState twistedFrame(const Scene& manyJoints) {
  Pose pose = restPose(manyJoints);
  for (std::size_t i = 0; i < pose.locals.size(); ++i) {
    const auto seed = static_cast<double>(i);
    const Vec3 axis = glm::normalize(Vec3(wobble(seed), 1.1, wobble(seed + 0.7)));
    pose.locals[i].rotation = glm::angleAxis(0.6 * wobble(seed + 0.3), axis);
    pose.locals[i].scale = {1.0 + 0.2 * wobble(seed + 0.1), 1.0, i == 50 ? -1.0 : 1.0};
  }
  pose.weights.resize(pose.locals.size());
  pose.weights.back() = {0.7F, -0.4F};
  FrameState frame = frameOf(manyJoints, std::move(pose), 0.0);
  for (std::size_t i = 0; i < frame.worlds.size(); ++i) {
    Mat3 stretch(1.0);
    stretch[1][1] = 1.0 + 0.8 * std::abs(wobble(static_cast<double>(i) + 0.9));
    stretch[0][1] = 0.2;
    frame.stretch.push_back(stretch);
  }
  return frame;
}

} // namespace stretch::test
