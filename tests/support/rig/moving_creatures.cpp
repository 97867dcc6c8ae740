#include "tests/support/rig/moving_creatures.h"

#include <array>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/creatures.h"

namespace stretch::test {

namespace {

// Degrees about an axis at the quarters of a second, on top of the rest rotation.
void addSwing(MovingBiped& creature, const std::string& key, const Vec3& axis,
              const std::array<double, 5>& degrees) {
  const NodeIndex node = creature.node.at(key);
  RotationKeys keys;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    keys.emplace_back(0.25 * static_cast<double>(i), axisAngle(axis, degrees[i] * pi / 180.0) *
                                                         creature.scene.nodes[at(node)].rest.rotation);
  }
  creature.clip.tracks.emplace_back(rotationTrack(node, Interpolation::linear, keys));
}

Vec3 placeOf(const Scene& scene, NodeIndex node) {
  Vec3 place(0.0);
  for (; node.exists(); node = scene.nodes[at(node)].parent) {
    place += scene.nodes[at(node)].rest.translation;
  }
  return place;
}

// Two pyramids on one square, the points at the ends of a bone; every three vertices are a triangle.
void addBone(const Vec3& from, const Vec3& to, std::uint16_t joint, Primitive& flesh) {
  const Vec3 along = to - from;
  const double length = glm::length(along);
  if (length <= 0.0) {
    return;
  }
  const Vec3 aside = std::abs(along.x) < 0.9 * length ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 across = 0.12 * length * glm::normalize(glm::cross(along, aside));
  const Vec3 other = 0.12 * length * glm::normalize(glm::cross(along, across));
  const Vec3 middle = from + 0.25 * along;
  const std::array<Vec3, 4> square{middle + across, middle + other, middle - across, middle - other};
  for (std::size_t i = 0; i < square.size(); ++i) {
    const Vec3& here = square[i];
    const Vec3& next = square[(i + 1) % square.size()];
    for (const Vec3& corner : {from, next, here, to, here, next}) {
      flesh.positions.emplace_back(corner);
      VertexInfluences influences;
      influences.joints[0] = joint;
      influences.weights[0] = 1.0F;
      flesh.influences.push_back(influences);
    }
  }
}

} // namespace

MovingBiped pawingHorse() {
  SyntheticBiped body = makeHorse();
  nameByKeys(body);
  MovingBiped horse = still(body);
  horse.clip.endSeconds = 1.0;
  const Vec3 sideways(1, 0, 0);
  addSwing(horse, "thigh.l", sideways, {30, 0, -30, 0, 30});
  addSwing(horse, "scapula.l", sideways, {-30, 0, 30, 0, -30});
  addSwing(horse, "tail0", sideways, {10, 40, 10, -10, 10});
  addSwing(horse, "neck0", sideways, {0, 10, 0, -10, 0});
  return horse;
}

MovingBiped strikingSnake() {
  SyntheticBiped body;
  body.joints.push_back({"behindHead", "", {0.0, 0.1, 1.0}});
  body.joints.push_back({"head", "behindHead", {0.0, 0.12, 1.06}});
  body.joints.push_back({"jaw", "behindHead", {0.0, 0.06, 1.06}});
  std::string parent = "behindHead";
  for (int i = 0; i < 14; ++i) {
    const std::string key = "segment" + std::to_string(i);
    body.joints.push_back({key, parent, {0.0, 0.08, 0.95 - 0.15 * i}});
    parent = key;
  }
  nameByKeys(body);
  MovingBiped snake = still(body);
  snake.clip.endSeconds = 1.0;
  const Vec3 rest = snake.scene.nodes[at(snake.node.at("behindHead"))].rest.translation;
  const Vec3 forwards(0.1, 0.0, 0.3);
  snake.clip.tracks.emplace_back(
      vectorTrack(snake.node.at("behindHead"), Channel::translation, Interpolation::linear,
                  {{0.0, rest}, {0.25, rest + 0.3 * forwards}, {0.5, rest + forwards}, {1.0, rest}}));
  addSwing(snake, "segment2", {0, 1, 0}, {0, 15, 30, 15, 0});
  addSwing(snake, "segment7", {0, 1, 0}, {0, -15, -30, -15, 0});
  return snake;
}

GlbBuilder creatureFile(const MovingBiped& creature) {
  Scene scene = creature.scene;
  Primitive flesh;
  const Skin& skin = scene.skins.front();
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const Node& joint = scene.nodes[at(skin.joints[i])];
    for (const NodeIndex child : joint.children) {
      addBone(placeOf(scene, skin.joints[i]), placeOf(scene, child), static_cast<std::uint16_t>(i), flesh);
    }
  }
  scene.meshes.front().primitives = {std::move(flesh)};
  Clip clip = creature.clip;
  clip.name = "creature";
  return characterFile(scene, {clip});
}

} // namespace stretch::test
