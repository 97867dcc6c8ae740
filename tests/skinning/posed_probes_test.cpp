// How far vertices of a clip move when its properties have other values: against a mesh that is posed by
// hand.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/math/transform.h"
#include "skinning/export/posed_probes.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

constexpr std::size_t framesOfClip = 5;
constexpr std::size_t vertices = 60;

/// A root, a chain of two joints below it and one beside them, below a node that is no joint; a mesh whose
/// vertices hang on up to three joints.
Scene probedScene() {
  Scene scene;
  const NodeIndex base = test::addNode(scene, "base", NodeIndex::none, Vec3(0.5, 0.0, -1.0));
  const NodeIndex root = test::addNode(scene, "root", base, Vec3(1.0, 0.0, 0.0));
  const NodeIndex arm = test::addNode(scene, "arm", root, Vec3(0.0, 2.0, 0.0));
  const NodeIndex hand = test::addNode(scene, "hand", arm, Vec3(0.0, 1.5, 0.5));
  const NodeIndex side = test::addNode(scene, "side", base, Vec3(-2.0, 0.0, 0.0));
  const NodeIndex drawn = test::addNode(scene, "mesh", NodeIndex::none, Vec3(0.0));
  scene.nodes[at(side)].rest.rotation = glm::angleAxis(0.4, Vec3(0.0, 0.0, 1.0));
  Skin skin;
  skin.joints = {root, arm, hand, side};
  for (std::size_t j = 0; j < 4; ++j) {
    Transform bind;
    bind.translation = Vec3(-0.3 * static_cast<double>(j), -1.0 * static_cast<double>(j), 0.2);
    skin.inverseBind.push_back(toMatrix(bind));
  }
  scene.skins.push_back(skin);
  std::mt19937 chance(7);
  Primitive primitive;
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto number = [&] { return 0.02F * static_cast<float>(chance() % 100) - 1.0F; };
    primitive.positions.emplace_back(number(), 3.0F * number(), number());
    VertexInfluences row;
    const auto first = static_cast<std::uint16_t>(v % 4);
    row.joints = {first, static_cast<std::uint16_t>((first + 1) % 4),
                  static_cast<std::uint16_t>((first + 2) % 4)};
    row.weights = {0.6F, v % 3 == 0 ? 0.1F : 0.3F, v % 3 == 0 ? 0.3F : 0.1F};
    primitive.influences.push_back(row);
  }
  primitive.indices = {0, 1, 2};
  Mesh mesh;
  mesh.primitives.push_back(std::move(primitive));
  scene.meshes.push_back(std::move(mesh));
  scene.nodes[at(drawn)].mesh = 0;
  scene.nodes[at(drawn)].skin = 0;
  return scene;
}

Vec4 turnOf(double angle, const Vec3& axis) {
  const Quat turn = glm::angleAxis(angle, glm::normalize(axis));
  return {turn.x, turn.y, turn.z, turn.w};
}

/// The arm turns, root and side move together, the hand is scaled.
std::vector<ClipCourse> coursesOfClip() {
  std::vector<ClipCourse> courses{
      {Channel::rotation, {2}, {}}, {Channel::translation, {1, 4}, {}}, {Channel::scale, {3}, {}}};
  for (std::size_t k = 0; k < framesOfClip; ++k) {
    const auto frame = static_cast<double>(k);
    courses[0].values.push_back(turnOf(0.3 * frame, Vec3(1.0, 2.0, 0.5)));
    courses[1].values.emplace_back(0.1 * frame, -0.2, 0.05 * frame * frame, 0.0);
    courses[2].values.emplace_back(1.0 + 0.2 * frame, 1.0, 1.0 - 0.1 * frame, 0.0);
  }
  return courses;
}

/// All vertices of a frame, every matrix multiplied out.
std::vector<Vec3> posedByHand(const Scene& scene, const std::vector<ClipCourse>& courses,
                              const std::vector<Vec4>& values) {
  std::vector<Transform> locals;
  for (const Node& node : scene.nodes) {
    locals.push_back(node.rest);
  }
  for (std::size_t c = 0; c < courses.size(); ++c) {
    for (const std::size_t node : courses[c].nodes) {
      const Vec4& value = values[c];
      if (courses[c].channel == Channel::rotation) {
        locals[node].rotation = glm::normalize(Quat(value.w, value.x, value.y, value.z));
      } else {
        (courses[c].channel == Channel::scale ? locals[node].scale : locals[node].translation) = Vec3(value);
      }
    }
  }
  std::vector<Mat4> skins;
  for (std::size_t j = 0; j < 4; ++j) {
    Mat4 world(1.0);
    for (NodeIndex node = scene.skins[0].joints[j]; node.exists(); node = scene.nodes[at(node)].parent) {
      world = toMatrix(locals[at(node)]) * world;
    }
    skins.push_back(world * scene.skins[0].inverseBind[j]);
  }
  std::vector<Vec3> places;
  const Primitive& mesh = scene.meshes[0].primitives[0];
  for (std::size_t v = 0; v < vertices; ++v) {
    Vec4 place(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      place += static_cast<double>(mesh.influences[v].weights[i]) *
               (skins[mesh.influences[v].joints[i]] * Vec4(Vec3(mesh.positions[v]), 1.0));
    }
    places.emplace_back(place);
  }
  return places;
}

std::vector<Vec4> valuesOf(const std::vector<ClipCourse>& courses, std::size_t frame) {
  std::vector<Vec4> values;
  values.reserve(courses.size());
  for (const ClipCourse& course : courses) {
    values.push_back(course.values[frame]);
  }
  return values;
}

double farthestOf(const std::vector<Vec3>& a, const std::vector<Vec3>& b,
                  const std::set<std::size_t>& among) {
  double most = 0.0;
  for (const std::size_t v : among) {
    most = std::max(most, glm::distance(a[v], b[v]));
  }
  return most;
}

std::vector<std::size_t> everyVertex() {
  std::vector<std::size_t> all(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    all[v] = v;
  }
  return all;
}

/// Of each joint's vertices those farthest out to the faces, edges and corners of a cube, the first of equal
/// ones: only what hangs on it by more than a fifth.
std::set<std::size_t> outmost(const Scene& scene) {
  const Primitive& mesh = scene.meshes[0].primitives[0];
  std::set<std::size_t> taken;
  for (std::uint16_t joint = 0; joint < 4; ++joint) {
    for (int way = 0; way < 27; ++way) {
      const Vec3 direction(way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1);
      std::optional<std::size_t> best;
      for (std::size_t v = 0; v < vertices && way != 13; ++v) {
        bool follows = false;
        for (std::size_t i = 0; i < 3; ++i) {
          follows =
              follows || (mesh.influences[v].joints[i] == joint && mesh.influences[v].weights[i] > 0.2F);
        }
        const auto reach = [&](std::size_t of) { return glm::dot(direction, Vec3(mesh.positions[of])); };
        if (follows && (!best || reach(v) > reach(*best) + 1e-9)) {
          best = v;
        }
      }
      if (best) {
        taken.insert(*best);
      }
    }
  }
  return taken;
}

} // namespace

TEST_CASE("A property of another value moves vertices as far as a mesh posed by hand tells, in every frame") {
  const Scene scene = probedScene();
  const std::vector<ClipCourse> courses = coursesOfClip();
  const PosedProbes all(scene, courses, framesOfClip, everyVertex());
  const PosedProbes few(scene, courses, framesOfClip, {});
  const std::set<std::size_t> seen = outmost(scene);
  const std::vector<std::size_t> every = everyVertex();
  REQUIRE(seen.size() < vertices);
  CHECK(all.frameCount() == framesOfClip);
  CHECK(all.courses().size() == 3);
  const std::vector<std::vector<std::size_t>> groups{{0}, {1}, {2}, {0, 2}, {2, 1, 0}};
  for (const std::vector<std::size_t>& group : groups) {
    for (std::size_t k = 0; k < framesOfClip; ++k) {
      std::vector<Vec4> values = valuesOf(courses, k);
      std::vector<Vec4> given;
      for (const std::size_t c : group) {
        values[c] = c == 0 ? turnOf(0.3 * static_cast<double>(k) + 0.2, Vec3(1.0, 2.0, 0.5))
                           : values[c] + Vec4(0.1, -0.05, 0.2, 0.0);
        given.push_back(values[c]);
      }
      const std::vector<Vec3> before = posedByHand(scene, courses, valuesOf(courses, k));
      const std::vector<Vec3> now = posedByHand(scene, courses, values);
      CAPTURE(group, k);
      CHECK(all.farthest(k, all.groupOf(group), given, 1e9) ==
            Approx(farthestOf(before, now, {every.begin(), every.end()})).margin(1e-6));
      CHECK(few.farthest(k, few.groupOf(group), given, 1e9) ==
            Approx(farthestOf(before, now, seen)).margin(1e-6));
    }
  }
}

TEST_CASE("What was set stays, in its frame alone, and distances are told from how it was at first") {
  const Scene scene = probedScene();
  const std::vector<ClipCourse> courses = coursesOfClip();
  PosedProbes probes(scene, courses, framesOfClip, everyVertex());
  const std::vector<std::size_t> every = everyVertex();
  const std::set<std::size_t> among(every.begin(), every.end());
  const PosedProbes::Group arm = probes.groupOf({0});
  const PosedProbes::Group moves = probes.groupOf({1});
  const Vec4 turned = turnOf(1.1, Vec3(0.0, 1.0, 1.0));
  probes.set(2, arm, {turned});
  for (const std::size_t k : {1U, 2U}) {
    std::vector<Vec4> values = valuesOf(courses, k);
    const std::vector<Vec3> before = posedByHand(scene, courses, values);
    values[0] = k == 2 ? turned : values[0];
    values[1] += Vec4(0.3, 0.0, 0.1, 0.0);
    CHECK(probes.farthest(k, moves, {values[1]}, 1e9) ==
          Approx(farthestOf(before, posedByHand(scene, courses, values), among)).margin(1e-6));
  }
}

TEST_CASE("Past what is enough a distance is looked for no farther, and the same value moves nothing") {
  const Scene scene = probedScene();
  const std::vector<ClipCourse> courses = coursesOfClip();
  const PosedProbes probes(scene, courses, framesOfClip, everyVertex());
  const PosedProbes::Group arm = probes.groupOf({0});
  const Vec4 turned = turnOf(2.0, Vec3(0.0, 1.0, 1.0));
  const double whole = probes.farthest(3, arm, {turned}, 1e9);
  const double first = probes.farthest(3, arm, {turned}, 0.0);
  CHECK(first > 0.0);
  CHECK(first < whole);
  CHECK(probes.farthest(3, arm, {turned}, 0.5 * whole) > 0.5 * whole);
  CHECK(probes.farthest(3, arm, {turned}, whole) == whole);
  for (std::size_t k = 0; k < framesOfClip; ++k) {
    CHECK(probes.farthest(k, arm, {courses[0].values[k]}, 0.0) < 1e-12);
  }
}

TEST_CASE("What hangs on nodes that change follows them: nodes parents first, joints and their vertices") {
  const Scene scene = probedScene();
  const PosedProbes probes(scene, coursesOfClip(), framesOfClip, everyVertex());
  const PosedProbes::Group arm = probes.groupOf({0});
  CHECK(arm.courses == std::vector<std::size_t>{0});
  CHECK(arm.followers.nodes == std::vector<std::size_t>{2, 3});
  CHECK(arm.followers.joints == std::vector<std::size_t>{1, 2});
  const PosedProbes::Group hand = probes.groupOf({2});
  CHECK(hand.followers.nodes == std::vector<std::size_t>{3});
  std::vector<std::size_t> onHand;
  for (std::size_t v = 0; v < vertices; ++v) {
    const VertexInfluences& row = scene.meshes[0].primitives[0].influences[v];
    if (row.joints[0] == 2 || row.joints[1] == 2 || row.joints[2] == 2) {
      onHand.push_back(v);
    }
  }
  CHECK(hand.followers.probes == onHand);
  const PosedProbes::Group moves = probes.groupOf({1});
  CHECK(moves.followers.nodes == std::vector<std::size_t>{1, 4, 2, 3}); // by generations
  CHECK(moves.followers.joints == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(moves.followers.probes == everyVertex());
  CHECK(probes.groupOf({}).followers.nodes.empty());
}
