#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/corners/bind_corners.h"
#include "rig/corners/corner_set.h"
#include "rig/corners/enclosing_corners.h"
#include "rig/corners/few_weights.h"
#include "rig/rekey/stretch_frames.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

// A forearm: points in a tube along a slanted axis, some behind the joint.
std::vector<Vec3> tube(const Quat& axes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> along(-0.05, 0.3);
  std::uniform_real_distribution<double> across(-0.04, 0.04);
  constexpr int count = 200;
  std::vector<Vec3> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i) {
    points.push_back(axes * Vec3(along(random), across(random), across(random)));
  }
  return points;
}

const Quat slanted = axisAngle(glm::normalize(Vec3(1.0, 2.0, -0.5)), 0.8);

Vec3 mixed(const std::vector<Vec3>& corners, const std::vector<double>& shares) {
  Vec3 sum(0.0);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    sum += shares[k] * corners[k];
  }
  return sum;
}

StretchKeys turningStretch() {
  StretchKeys keys;
  keys.node = NodeIndex(0);
  keys.times = {0.0F, 0.5F, 1.0F};
  keys.axes = {Quat(1, 0, 0, 0), axisAngle(Vec3(0, 0, 1), 0.9), axisAngle(Vec3(0, 1, 0), 0.4)};
  keys.scales = {Vec3(1.0), Vec3(3.0, 0.6, 0.6), Vec3(1.5, 0.8, 0.8)};
  return keys;
}

// A skinned joint 0 whose vertices stand along x.
Scene forearm(std::vector<glm::vec3> positions) {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[1].mesh = 0;
  scene.nodes[1].skin = 0;
  scene.roots = {NodeIndex(0), NodeIndex(1)};
  scene.skins.push_back({"skin", {NodeIndex(0)}, {Mat4(1.0)}});
  Primitive primitive;
  VertexInfluences whole;
  whole.weights[0] = 1.0F;
  primitive.influences.assign(positions.size(), whole);
  primitive.positions = std::move(positions);
  scene.meshes.push_back({"mesh", {primitive}, {}});
  return scene;
}

// A ring around the place where three joints meet, each vertex on all three of them.
Scene ringOnThreeJoints(int count) {
  std::vector<glm::vec3> positions;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * pi * i / count;
    positions.emplace_back(Vec3(0.1 + 0.01 * i, 0.04 * std::cos(angle), 0.04 * std::sin(angle)));
  }
  Scene scene = forearm(std::move(positions));
  scene.nodes.resize(4); // the joints 0, 2 and 3
  scene.roots = {NodeIndex(0), NodeIndex(1), NodeIndex(2), NodeIndex(3)};
  scene.skins[0] = {"skin", {NodeIndex(0), NodeIndex(2), NodeIndex(3)}, {Mat4(1.0), Mat4(1.0), Mat4(1.0)}};
  for (VertexInfluences& vertex : scene.meshes[0].primitives[0].influences) {
    vertex.joints = {0, 1, 2};
    vertex.weights = {0.5F, 0.3F, 0.2F};
  }
  return scene;
}

StretchKeys longer(const Vec3& factors) {
  StretchKeys keys;
  keys.node = NodeIndex(0);
  keys.times = {0.0F, 1.0F};
  keys.axes = {Quat(1, 0, 0, 0)};
  keys.scales = {Vec3(1.0), factors};
  return keys;
}

} // namespace

TEST_CASE("A tetrahedron of corners holds every point: affine coordinates are none below 0 and give the "
          "point back") {
  const std::vector<Vec3> points = tube(slanted);
  const std::vector<Vec3> corners = enclosingTetrahedron(points, slanted);
  REQUIRE(corners.size() == 4);
  for (const Vec3& point : points) {
    const std::vector<double> shares = affineCoordinates(corners, point);
    CHECK(*std::ranges::min_element(shares) >= 0.0);
    CHECK(std::accumulate(shares.begin(), shares.end(), 0.0) == Approx(1.0));
    CHECK(glm::length(mixed(corners, shares) - point) < 1e-9);
  }
}

TEST_CASE("The tetrahedron is no larger than one around the tube has to be") {
  const std::vector<Vec3> corners = enclosingTetrahedron(tube(slanted), slanted);
  double farthest = 0.0;
  for (const Vec3& corner : corners) {
    farthest = std::max(farthest, glm::length(corner));
  }
  CHECK(farthest < 3.0 * 0.3);
}

TEST_CASE("Corners of points in a plane, on a line and of a single point still hold them") {
  for (const std::vector<Vec3>& points : {std::vector<Vec3>{Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                          {Vec3(0.1, 0, 0), Vec3(0.4, 0, 0)},
                                          {Vec3(0.2)}}) {
    const std::vector<Vec3> corners = enclosingTetrahedron(points, Quat(1, 0, 0, 0));
    for (const Vec3& point : points) {
      CHECK(glm::length(mixed(corners, affineCoordinates(corners, point)) - point) < 1e-9);
    }
  }
}

TEST_CASE("A bone that only lengthens has an end on each side of the joint that holds vertices") {
  const Vec3 along(1.0, 0.0, 0.0);
  const std::vector<Vec3> both = enclosingEnds({Vec3(-0.1, 0.2, 0.0), Vec3(0.5, 0.0, 0.1)}, along);
  REQUIRE(both.size() == 2);
  CHECK(glm::length(both[0] - Vec3(-0.1, 0, 0)) < 1e-12);
  CHECK(glm::length(both[1] - Vec3(0.5, 0, 0)) < 1e-12);
  CHECK(enclosingEnds({Vec3(0.1, 0.2, 0.0), Vec3(0.5, 0.0, 0.1)}, along).size() == 1);
  const std::vector<double> shares = affineCoordinates(both, Vec3(0.25, 7.0, 0.0));
  CHECK(shares[0] == Approx(0.0));
  CHECK(shares[1] == Approx(0.5));
}

TEST_CASE("A few weights of many candidates miss least, none of them below 0 and together 1") {
  // Candidates are places, and 0 is wanted: a segment through it, and places far away.
  const std::vector<Vec3> places{Vec3(-1, 0, 0), Vec3(3, 0, 0), Vec3(0, 5, 0), Vec3(4, 4, 4), Vec3(0, 0, 9)};
  MissProducts products{places.size(), {}};
  for (const Vec3& a : places) {
    for (const Vec3& b : places) {
      products.products.push_back(glm::dot(a, b));
    }
  }
  const std::vector<double> weights = fewWeights(products, {0, 1, 2, 3, 4}, 2);
  CHECK(weights[0] == Approx(0.75).margin(1e-6));
  CHECK(weights[1] == Approx(0.25).margin(1e-6));
  CHECK(std::ranges::count_if(weights, [](double w) { return w > 0.0; }) == 2);
  const std::vector<double> one = fewWeights(products, {0, 2, 3}, 1);
  CHECK(one[0] == Approx(1.0));
}

TEST_CASE("A corner goes where the stretch takes it, between keys too, however the axes turn") {
  const StretchKeys keys = turningStretch();
  const Vec3 place(0.3, -0.1, 0.2);
  const Track track = cornerTrack(NodeIndex(5), place, keys);
  CHECK(track.node == NodeIndex(5));
  CHECK(track.channel == Channel::translation);
  CHECK(track.times.front() == 0.0F);
  CHECK(track.times.back() == 1.0F);
  CHECK(track.times.size() > 3);
  for (double time = 0.0; time <= 1.0; time += 0.01) {
    const std::size_t key = time < 0.5 ? 0 : 1;
    const double t = (time - keys.times[key]) / 0.5;
    const Vec3 exact =
        between({keys.axes[key], keys.scales[key]}, {keys.axes[key + 1], keys.scales[key + 1]}, t) * place;
    std::array<double, 3> sampled{};
    sampleTrack(track, time, sampled.data());
    CHECK(glm::length(Vec3(sampled[0], sampled[1], sampled[2]) - exact) < 2e-5 * glm::length(place));
  }
}

TEST_CASE("Axes that stand still need no keys beside those of the stretch") {
  CHECK(cornerTrack(NodeIndex(5), Vec3(0.3, 0.1, 0.0), longer(Vec3(2.0, 0.7, 0.7))).times.size() == 2);
}

TEST_CASE("Corners without weight are left out, and those of a bone that only lengthens are ends") {
  const Scene scene = forearm({{0.1F, 0.0F, 0.0F}, {0.3F, 0.02F, 0.0F}, {0.2F, 0.0F, 0.03F}});
  gltf::Edits edits;
  const CornerFit fit = addBindCorners(scene, {{0, {longer(Vec3(2.0, 1.0, 1.0))}}}, {}, edits);
  CHECK(fit.corners == 1); // nothing stands behind the joint
  REQUIRE(edits.addedNodes.size() == 1);
  CHECK(edits.addedNodes[0].isBindCorner);
  CHECK(edits.addedNodes[0].parent == NodeIndex(0));
  REQUIRE(edits.boundMeshes.size() == 1);
  const VertexInfluences& third = edits.boundMeshes[0].influences[0][0];
  CHECK(third.weights[0] == Approx(2.0 / 3.0).margin(1e-6)); // it stands a third of the way out
  CHECK(third.joints[0] == 0);
  CHECK(third.joints[1] == 1);
  REQUIRE(edits.addedSlots.size() == 1);
  CHECK(edits.addedSlots[0].node == NodeIndex(2));
}

TEST_CASE(
    "Corners are split for where the weights at rest put a vertex, and a clip's other weights are told") {
  std::vector<glm::vec3> positions;
  for (const Vec3& point : tube(Quat(1, 0, 0, 0))) {
    positions.emplace_back(point);
  }
  const Scene plain = forearm(positions);
  Scene morphed = plain;
  Primitive& primitive = morphed.meshes[0].primitives[0];
  const glm::vec3 swollen(0.05F, 0.0F, 0.0F);
  primitive.morphTargets = {{std::vector<glm::vec3>(positions.size(), swollen), {}}};
  for (glm::vec3& position : primitive.positions) {
    position -= swollen;
  }
  morphed.meshes[0].morphWeights = {1.0F};
  const StretchKeys stretch = longer(Vec3(3.0, 0.6, 0.6));
  CornerOptions options;
  options.height = 2.0;
  FrameState frame = frameOf(morphed, restPose(morphed), 0.0);
  frame.stretch.assign(2, Mat3(1.0));
  frame.stretch[0] = StretchFrame{Quat(1, 0, 0, 0), Vec3(3.0, 0.6, 0.6)}.matrix();
  options.moments.push_back(frame);
  gltf::Edits wanted;
  addBindCorners(plain, {{0, {stretch}}}, options, wanted);
  gltf::Edits edits;
  const CornerFit still = addBindCorners(morphed, {{0, {stretch}}}, options, edits);
  REQUIRE(edits.addedNodes.size() == wanted.addedNodes.size());
  for (std::size_t corner = 0; corner < edits.addedNodes.size(); ++corner) {
    CHECK(glm::length(edits.addedNodes[corner].rest.translation -
                      wanted.addedNodes[corner].rest.translation) < 1e-6);
  }
  for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
    const VertexInfluences& found = edits.boundMeshes[0].influences[0][vertex];
    const VertexInfluences& exact = wanted.boundMeshes[0].influences[0][vertex];
    CHECK(found.weights[0] == Approx(exact.weights[0]).margin(1e-4));
  }
  CHECK(still.worst < 1e-9);
  options.moments.back().pose.weights[1] = {0.4F};
  gltf::Edits again;
  const CornerFit moved = addBindCorners(morphed, {{0, {stretch}}}, options, again);
  CHECK(moved.worst == Approx(0.6 * 0.05 * (3.0 - 1.0) / options.height)); // what it sinks in is not
                                                                           // stretched
}

TEST_CASE(
    "A bone that keeps its volume has four corners, and a limit of influences is kept and its miss told") {
  std::vector<glm::vec3> positions;
  for (const Vec3& point : tube(Quat(1, 0, 0, 0))) {
    positions.emplace_back(point);
  }
  const Scene scene = forearm(positions);
  const StretchKeys stretch = longer(Vec3(3.0, 0.6, 0.6));
  CornerOptions options;
  for (const double s : {1.0, 2.0, 3.0}) {
    FrameState frame = frameOf(scene, restPose(scene), 0.0);
    frame.stretch.assign(2, Mat3(1.0));
    frame.stretch[0] =
        StretchFrame{Quat(1, 0, 0, 0), Vec3(s, 1.0 - 0.2 * (s - 1.0), 1.0 - 0.2 * (s - 1.0))}.matrix();
    options.moments.push_back(frame);
  }
  gltf::Edits exact;
  const CornerFit eight = addBindCorners(scene, {{0, {stretch}}}, options, exact);
  CHECK(eight.corners == 4);
  CHECK(eight.fitted == 0);
  CHECK(eight.vertices == positions.size());
  options.mostInfluences = 2;
  gltf::Edits fewer;
  const CornerFit two = addBindCorners(scene, {{0, {stretch}}}, options, fewer);
  CHECK(two.fitted > 100);
  CHECK(two.worst > two.percentile99 * 0.999);
  CHECK(two.percentile99 > two.median);
  for (const VertexInfluences& vertex : fewer.boundMeshes[0].influences[0]) {
    CHECK(vertex.weights[2] == 0.0F);
    CHECK(vertex.weights[0] + vertex.weights[1] == Approx(1.0));
  }
}

TEST_CASE(
    "A vertex on three stretched joints follows corners of its own where no eight of the others do: it is "
    "where the stretches have it") {
  const Scene scene = ringOnThreeJoints(12);
  const std::array<int, 3> joints{0, 2, 3};
  std::vector<StretchKeys> stretches;
  std::array<Mat3, 4> stretchOf{};
  CornerOptions options;
  options.moments.assign(3, frameOf(scene, restPose(scene), 0.0));
  for (std::size_t moment = 0; moment < 3; ++moment) {
    options.moments[moment].stretch.assign(4, Mat3(1.0));
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    StretchKeys keys = longer(Vec3(2.0 + static_cast<double>(i), 0.6, 0.6));
    keys.node = NodeIndex(joints[i]);
    keys.axes = {axisAngle(Vec3(0, 0, 1), 0.5 * static_cast<double>(i))};
    stretchOf[at(keys.node)] = StretchFrame{keys.axes.front(), keys.scales.back()}.matrix();
    for (std::size_t moment = 1; moment < 3; ++moment) { // one of them alone, and together with the others
      options.moments[moment].stretch[at(keys.node)] =
          i == 0 || moment == 2 ? stretchOf[at(keys.node)] : Mat3(1.0);
    }
    stretches.push_back(keys);
  }
  gltf::Edits edits;
  const CornerFit fit = addBindCorners(scene, {{0, stretches}}, options, edits);
  CHECK(fit.worst <= 5e-6);
  CHECK(fit.corners > 12); // those around all of it do not do
  const auto& positions = scene.meshes[0].primitives[0].positions;
  double worst = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 place(positions[v]);
    const VertexInfluences& vertex = edits.boundMeshes[0].influences[0][v];
    const Vec3 exact = 0.5 * stretchOf[0] * place + 0.3 * stretchOf[2] * place + 0.2 * stretchOf[3] * place;
    Vec3 moved(0.0);
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      Vec3 offset(0.0);
      if (vertex.joints[i] >= joints.size() && vertex.weights[i] > 0.0F) {
        const NodeIndex node = edits.addedSlots[vertex.joints[i] - joints.size()].node;
        const gltf::AddedNode& corner = edits.addedNodes[at(node) - scene.nodes.size()];
        offset = stretchOf[at(corner.parent)] * corner.rest.translation - corner.rest.translation;
      }
      moved += static_cast<double>(vertex.weights[i]) * (place + offset);
    }
    worst = std::max(worst, glm::length(moved - exact));
  }
  CHECK(worst < 6e-6);
}

TEST_CASE("A skin that lists a stretched joint twice has its vertices fitted by either of the two, and a "
          "vertex that stays on too many joints gets no corners") {
  Scene scene = ringOnThreeJoints(40);
  scene.skins[0].joints = {NodeIndex(0), NodeIndex(2), NodeIndex(0)};
  const bool areFew = GENERATE(false, true);
  StretchKeys first = longer(Vec3(2.0, 0.6, 0.6));
  StretchKeys second = longer(Vec3(4.0, 0.6, 0.6));
  second.node = NodeIndex(2);
  second.axes = {axisAngle(Vec3(0, 0, 1), 0.7)};
  CornerOptions options;
  options.moments.assign(2, frameOf(scene, restPose(scene), 0.0));
  options.moments[0].stretch.assign(4, Mat3(1.0));
  options.moments[1].stretch.assign(4, Mat3(1.0));
  options.moments[1].stretch[0] = StretchFrame{first.axes.front(), first.scales.back()}.matrix();
  options.moments[1].stretch[2] = StretchFrame{second.axes.front(), second.scales.back()}.matrix();
  options.mostInfluences = areFew ? 2 : 4;
  gltf::Edits edits;
  const CornerFit fit = addBindCorners(scene, {{0, {first, second}}}, options, edits);
  CHECK(fit.corners <= (areFew ? 32 : 48)); // two influences hold no vertex on three slots
  for (const VertexInfluences& vertex : edits.boundMeshes[0].influences[0]) {
    CHECK(std::accumulate(vertex.weights.begin(), vertex.weights.end(), 0.0F) == Approx(1.0));
  }
  // Those that enclose stand first under each joint.
  for (const int joint : {0, 2}) {
    const auto& nodes = edits.addedNodes;
    const auto of = std::ranges::find(nodes, NodeIndex(joint), &gltf::AddedNode::parent);
    REQUIRE(of != nodes.end());
    CHECK(of->name == "_corner_1");
  }
}

TEST_CASE("The file's corners that hold every vertex are known among the others, wherever they stand") {
  const std::vector<Vec3> points = tube(slanted);
  std::vector<Vec3> places = enclosingTetrahedron(points, slanted);
  Scene scene = forearm({points.begin(), points.end()});
  const std::size_t before = GENERATE(0U, 1U, 3U);
  places.insert(places.begin(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(before));
  BindChain chain{NodeIndex(0), NodeIndex::none, NodeIndex::none};
  for (const Vec3& place : places) {
    chain.corners.push_back({NodeIndex(static_cast<int>(chain.corners.size()) + 2), place, {}});
  }
  const CornerSet set = madeSet(scene, chain);
  REQUIRE(set.enclosing == 4);
  CHECK(std::ranges::equal(set.enclosingPlaces(), std::vector<Vec3>(places.end() - 4, places.end())));
  CHECK(set.made.front().node == NodeIndex(static_cast<int>(before) + 2));
  for (const bool hasTwo : {false, true}) { // ends, and a vertex's own
    chain.corners.resize(0);
    for (const Vec3& place : {Vec3(0.3, 0, 0), hasTwo ? Vec3(-0.1, 0, 0) : points[0], points[1], points[2]}) {
      chain.corners.push_back({NodeIndex(2), place, {}});
    }
    CHECK(madeSet(scene, chain).enclosing == (hasTwo ? 2 : 1));
  }
}

TEST_CASE("A mesh that hangs on a stretched joint rigidly becomes a skinned one at the top of the scene") {
  Scene scene = forearm({{0.1F, 0.0F, 0.0F}, {0.3F, 0.02F, 0.0F}});
  scene.nodes[1].mesh = -1;
  scene.nodes[0].mesh = 0;
  scene.skins.clear();
  gltf::Edits edits;
  addBindCorners(scene, {{0, {longer(Vec3(2.0, 1.0, 1.0))}}}, {}, edits);
  REQUIRE(edits.addedSkins.size() == 1);
  CHECK(edits.addedSkins[0].joints.front() == NodeIndex(0));
  REQUIRE(edits.boundMeshes.size() == 1);
  const auto holder = static_cast<std::size_t>(edits.boundMeshes[0].node.value) - scene.nodes.size();
  CHECK(edits.addedNodes[holder].meshFrom == NodeIndex(0));
  CHECK_FALSE(edits.addedNodes[holder].parent.exists());
}

TEST_CASE("The node that a rigid mesh moves to is mirrored where the mesh was, and only there") {
  const double mirror = GENERATE(1.0, -1.0);
  Scene scene = forearm({{0.1F, 0.0F, 0.0F}, {0.3F, 0.02F, 0.0F}});
  scene.nodes[1].mesh = -1;
  scene.nodes[0].mesh = 0;
  scene.nodes[0].rest.scale = Vec3(1.0, mirror, 1.0);
  scene.skins.clear();
  gltf::Edits edits;
  addBindCorners(scene, {{0, {longer(Vec3(2.0, 1.0, 1.0))}}}, {}, edits);
  REQUIRE(edits.boundMeshes.size() == 1);
  const auto holder = static_cast<std::size_t>(edits.boundMeshes[0].node.value) - scene.nodes.size();
  const Vec3 scale = edits.addedNodes.at(holder).rest.scale; // which tells what side of a triangle is outside
  CHECK(scale.x * scale.y * scale.z == mirror);
}

TEST_CASE("Corners grow with what they hold, also around one point or a flat piece") {
  const double size = GENERATE(0.01, 30.0);
  for (const std::vector<Vec3>& points :
       {tube(slanted), {Vec3(0.4, -0.2, 0.1)}, {Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0)}}) {
    std::vector<Vec3> grown = points;
    std::ranges::for_each(grown, [&](Vec3& point) { point *= size; });
    const std::vector<Vec3> corners = enclosingTetrahedron(points, slanted);
    const std::vector<Vec3> others = enclosingTetrahedron(grown, slanted);
    REQUIRE(others.size() == corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      CHECK(glm::length(others[i] - size * corners[i]) < 1e-6 * size);
    }
  }
}

TEST_CASE("The ends of a bone hold what lies along any direction, and nothing at the joint itself") {
  const Vec3 along = glm::normalize(Vec3(1.0, 2.0, -2.0));
  const std::vector<Vec3> ends =
      enclosingEnds({0.3 * along + Vec3(2, -1, 0), -0.2 * along, 0.1 * along}, along);
  REQUIRE(ends.size() == 2);
  CHECK(glm::length(ends[0] + 0.2 * along) < 1e-9);
  CHECK(glm::length(ends[1] - 0.3 * along) < 1e-9);
  CHECK(enclosingEnds({Vec3(0.0)}, along).empty());
  const std::vector<Vec3> behind = enclosingEnds({-0.5 * along}, along);
  REQUIRE(behind.size() == 1);
  CHECK(glm::length(behind[0] + 0.5 * along) < 1e-9);
  CHECK(affineCoordinates(behind, -0.25 * along) == std::vector<double>{0.5});
  CHECK(affineCoordinates(behind, 0.25 * along) == std::vector<double>{0.0}); // on the other side
  CHECK(affineCoordinates(behind, -2.0 * along) == std::vector<double>{1.0}); // farther out
}
