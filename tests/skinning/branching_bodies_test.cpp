#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/gltf/patch/edits.h"
#include "skinning/body/body_skeleton.h"
#include "skinning/body/given_skeleton.h"
#include "skinning/compress/chain_stretch.h"
#include "skinning/compress/compress.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/fit/joint_tree.h"
#include "skinning/fit/motion_clusters.h"
#include "skinning/geometry/inside.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

CompressSettings measuredWith(int bones) {
  CompressSettings settings;
  settings.bones = bones;
  settings.stretch = StretchOption::measured;
  return settings;
}

CompressedSequence compressedBody(const CompressSettings& settings) {
  auto result = compress(skinAllFrames(test::armedBody(24)), settings);
  REQUIRE(result);
  return std::move(result).value();
}

/// Of the bones in a frame, the largest distance between where a bone and its parent put their joint.
double largestGap(const SkinnedSequence& skinned) {
  double gap = 0.0;
  for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
    for (std::size_t k = 0; k < skinned.frameCount() && skinned.bones[b].parent >= 0; ++k) {
      const auto parent = static_cast<std::size_t>(skinned.bones[b].parent);
      const Mat4 above = skinMatrix(skinned.bones[parent], skinned.pose(k, parent));
      const Vec3 carried(above * Vec4(skinned.bones[b].pivot, 1.0));
      gap = std::max(gap, glm::length(carried - skinned.pose(k, b).position));
    }
  }
  return gap;
}

double distanceToNearest(const Vec3& place, const std::vector<SkinBone>& bones) {
  double nearest = 1e9;
  for (const SkinBone& bone : bones) {
    nearest = std::min(nearest, glm::length(bone.pivot - place));
  }
  return nearest;
}

/// A tube that waves in two directions and swells, so that no bone moves any of it as it does.
MeshSequence jellyTube() {
  MeshSequence tube = test::shorteningTube(16, 0.0, 0.0, 0.0);
  for (std::size_t k = 0; k < tube.frameCount(); ++k) {
    const auto time = static_cast<float>(k);
    for (glm::vec3& p : tube.frame(k)) {
      const float swelling = 1.0F + 0.3F * std::sin(1.7F * p.x + 0.8F * time);
      p = {p.x + 0.2F * std::sin(p.y + 0.5F * time),
           swelling * p.y + 0.4F * std::sin(1.3F * p.x + 0.5F * time),
           swelling * p.z + 0.4F * std::cos(0.7F * p.x - 0.4F * time)};
    }
  }
  return tube;
}

/// A vertex of a body at rest whose arms, beyond half a unit from its middle, are bent up into arcs by an
/// angle in all and get shorter by it.
glm::vec3 armThatShortens(const glm::vec3& rest, double angle, double shortening) {
  constexpr double shoulder = 0.5;
  constexpr double length = 3.0;
  const double out = std::abs(static_cast<double>(rest.x)) - shoulder;
  if (out <= 0.0 || angle <= 1e-6) {
    return rest;
  }
  const double turned = angle * std::min(out, length) / length;
  const double radius = length * (1.0 - shortening * angle) / angle;
  const double beyond = std::max(0.0, out - length);
  const auto up = static_cast<double>(rest.y);
  const double x = shoulder + (radius - up) * std::sin(turned) + beyond * std::cos(turned);
  const double y = radius - (radius - up) * std::cos(turned) + beyond * std::sin(turned);
  return {static_cast<float>(std::copysign(x, static_cast<double>(rest.x))), static_cast<float>(y), rest.z};
}

/// A body whose arms swing, and shorten as they do.
MeshSequence bodyWithArmsThatShorten() {
  constexpr double shortening = 0.05;
  MeshSequence body = skinAllFrames(test::armedBody(24));
  for (std::size_t k = 0; k < body.frameCount(); ++k) {
    const double angle = 0.9 * std::sin(pi * static_cast<double>(k) / 23.0);
    for (std::size_t v = 0; v < body.vertexCount; ++v) {
      body.frame(k)[v] = armThatShortens(body.frame(0)[v], angle, shortening);
    }
  }
  return body;
}

/// Moves the point about which a bone turns by a way, not what the bone does to the mesh.
void moveJoint(SkinnedSequence& skinned, std::size_t bone, const Vec3& way) {
  for (std::size_t k = 0; k < skinned.frameCount(); ++k) {
    BonePose& pose = skinned.pose(k, bone);
    pose.position = Vec3(skinMatrix(skinned.bones[bone], pose) * Vec4(skinned.bones[bone].pivot + way, 1.0));
  }
  skinned.bones[bone].pivot += way;
}

/// How far the joint that sticks out of the bind mesh farthest is from its surface; 0 where all lie inside.
double farthestOut(const SkinnedSequence& skinned) {
  const std::vector<Vec3> places(skinned.bindPositions.begin(), skinned.bindPositions.end());
  const PlacedSurface mesh{places, skinned.triangles};
  double far = 0.0;
  for (const SkinBone& bone : skinned.bones) {
    far =
        std::abs(windingNumber(mesh, bone.pivot)) > 0.5 ? far : std::max(far, distanceFrom(mesh, bone.pivot));
  }
  return far;
}

/// Writes the bones and reads the file's skin again.
std::vector<SkinBone> bonesOfFile(const SkinnedSequence& skinned) {
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(encodeGltf(skinned).source, folder.path() / "body.glb"));
  auto bones = readSkeleton(folder.path() / "body.glb");
  REQUIRE(bones);
  return std::move(bones).value();
}

} // namespace

TEST_CASE("a body with arms is measured by parts that move alike, and comes back") {
  const CompressedSequence result = compressedBody(measuredWith(6));
  CHECK(result.skinned.bones.size() == 6);
  CHECK(result.metrics.rmsePercent < 0.1);
}

TEST_CASE("bones of a body with arms hang together where its joints are") {
  const SkinnedSequence truth = test::armedBody(24);
  const SkinnedSequence skinned = compressedBody(measuredWith(6)).skinned;
  const auto roots = std::ranges::count_if(skinned.bones, [](const SkinBone& b) { return b.parent < 0; });
  CHECK(roots == 1);
  CHECK(largestGap(skinned) < 0.1);
  for (std::size_t b = 1; b < truth.bones.size(); ++b) {
    INFO(truth.bones[b].name);
    CHECK(distanceToNearest(truth.bones[b].pivot, skinned.bones) < 0.5);
  }
}

TEST_CASE("a tree of bones that were split and moved is found again") {
  const SkinnedSequence truth = test::armedBody(24);
  SkinnedSequence loose = truth;
  for (std::size_t b = 0; b < loose.bones.size(); ++b) {
    moveJoint(loose, b, Vec3(0.5, 1.0, 0.25));
    loose.bones[b].parent = -1;
  }
  hangTogether(loose);
  CHECK(distancesOf(skinAllFrames(truth), skinAllFrames(loose)).largestPercent < 1e-4);
  for (std::size_t b = 0; b < truth.bones.size(); ++b) {
    INFO(truth.bones[b].name);
    CHECK(loose.bones[b].parent == truth.bones[b].parent);
    const bool isRoot = truth.bones[b].parent < 0;
    const Vec3 away = loose.bones[b].pivot - truth.bones[b].pivot;
    CHECK((isRoot || glm::length(Vec3(away.x, away.y, 0.0)) < 0.1));
  }
}

TEST_CASE("bones stand side by side where that is asked for, the file shows the same either way") {
  CompressSettings settings = measuredWith(8);
  const SkinnedSequence tree = compressedBody(settings).skinned;
  settings.joints = JointOption::free;
  const SkinnedSequence free = compressedBody(settings).skinned;
  CHECK(std::ranges::all_of(free.bones, [](const SkinBone& bone) { return bone.parent < 0; }));
  CHECK(distancesOf(skinAllFrames(tree), skinAllFrames(free)).largestPercent < 1e-4);
  const std::vector<SkinBone> written = bonesOfFile(tree);
  REQUIRE(written.size() == tree.bones.size());
  for (std::size_t b = 0; b < written.size(); ++b) {
    CHECK(written[b].parent == tree.bones[b].parent);
    CHECK(glm::length(written[b].pivot - tree.bones[b].pivot) < 1e-4);
  }
}

TEST_CASE("a joint that sticks out of a body is brought into it, nothing else changes") {
  const SkinnedSequence truth = test::armedBody(12);
  SkinnedSequence out = truth;
  moveJoint(out, 3, Vec3(0.0, 4.0, 0.0)); // three above an arm that is two thick
  bringJointsInside(out, {});
  CHECK(out.bones[3].pivot.x == Approx(truth.bones[3].pivot.x));
  CHECK(out.bones[3].pivot.y == Approx(1.5).margin(0.2)); // a quarter of the thickness below its upper side
  CHECK(distancesOf(skinAllFrames(truth), skinAllFrames(out)).largestPercent < 1e-4);
  for (const std::size_t b : {1, 2, 4, 5}) {
    INFO(truth.bones[b].name);
    CHECK(out.bones[b].pivot == truth.bones[b].pivot);
  }
  const std::vector<std::optional<Vec3>> middles = middlesOfChildren(out.bones);
  for (std::size_t b = 0; b < middles.size(); ++b) { // Bones go on to where what hangs on them was brought.
    CHECK((!middles[b] || glm::length(out.bones[b].end - *middles[b]) < 1e-9));
  }
  moveJoint(out, 3, Vec3(0.0, 4.0, 0.0));
  const SkinnedSequence open = [&] { // a mesh that encloses nothing has no inside
    SkinnedSequence points = out;
    points.triangles.clear();
    return points;
  }();
  SkinnedSequence asked = open;
  bringJointsInside(asked, {});
  CHECK(asked.bones == open.bones);
}

TEST_CASE("joints of bones that are found in a body lie in it") {
  const MeshSequence body = bodyWithArmsThatShorten();
  for (const StretchOption stretch : {StretchOption::measured, StretchOption::elastic}) {
    for (const int bones : {3, 6}) {
      CompressSettings settings = measuredWith(bones);
      settings.stretch = stretch;
      const auto result = compress(body, settings);
      REQUIRE(result);
      CAPTURE(bones);
      CHECK(farthestOut(result->skinned) < 0.2); // a tenth of the arms' thickness
    }
  }
}

TEST_CASE("bodies in several parts have a root each") {
  SkinnedSequence two = test::armedBody(12);
  const SkinnedSequence one = two;
  const auto bones = static_cast<std::uint16_t>(one.bones.size());
  const auto count = static_cast<std::uint32_t>(one.bindPositions.size());
  for (const Triangle& t : one.triangles) {
    two.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  for (std::size_t v = 0; v < count; ++v) {
    two.bindPositions.push_back(one.bindPositions[v] + glm::vec3(0.0F, 0.0F, 8.0F));
    Influences influences = one.influences[v];
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      influences.bones[i] =
          static_cast<std::uint16_t>(influences.bones[i] + (influences.weights[i] > 0.0F ? bones : 0));
    }
    two.influences.push_back(influences);
  }
  two.poses.clear();
  for (std::size_t k = 0; k < one.frameCount(); ++k) {
    for (std::size_t b = 0; b < 2 * one.bones.size(); ++b) {
      two.poses.push_back(one.pose(k, b % one.bones.size()));
    }
  }
  two.bones.insert(two.bones.end(), one.bones.begin(), one.bones.end());
  hangTogether(two);
  CHECK(two.bones[0].parent == -1);
  CHECK(two.bones[bones].parent == -1);
  CHECK(std::ranges::count_if(two.bones, [](const SkinBone& b) { return b.parent < 0; }) == 2);
}

TEST_CASE("the fewest bones that meet a tolerance are found") {
  CompressSettings settings = measuredWith(1);
  settings.tolerancePercent = 0.5;
  const CompressedSequence result = compressedBody(settings);
  CHECK(result.metrics.rmsePercent <= 0.5);
  const auto bones = static_cast<int>(result.skinned.bones.size());
  REQUIRE(bones > 1);
  CHECK(compressedBody(measuredWith(bones - 1)).metrics.rmsePercent > 0.5);
}

TEST_CASE("asked for the error that some bones have, no more than these are taken") {
  for (const int bones : {3, 6, 11}) {
    CompressSettings settings = measuredWith(bones);
    const auto known = compress(jellyTube(), settings);
    REQUIRE(known);
    settings.tolerancePercent = known->metrics.rmsePercent;
    const auto found = compress(jellyTube(), settings);
    REQUIRE(found);
    CHECK(found->skinned.bones.size() <= static_cast<std::size_t>(bones));
    CHECK(found->metrics.rmsePercent <= *settings.tolerancePercent);
  }
}

TEST_CASE("a tolerance that no number of bones meets is told") {
  CompressSettings settings;
  settings.stretch = StretchOption::none;
  settings.weights = WeightOption::geodesic;
  settings.tolerancePercent = 0.01;
  const auto result = compress(test::shorteningTube(8, 2.0, 0.06, 0.1), settings);
  REQUIRE(result);
  // It is given up where twice as many are hardly any better, long before the most that are tried.
  REQUIRE_FALSE(result->warnings.empty());
  CHECK(result->warnings[0] ==
        "0.01 % of the diagonal is not met: 16 bones are off by 2.1 %, and more, up to 128, do not help");
}

TEST_CASE("vertices hang on up to eight bones where that is asked for, and the file has them all") {
  CompressSettings settings = measuredWith(16);
  const auto most = [](const SkinnedSequence& skinned) {
    std::ptrdiff_t influences = 0;
    for (const Influences& i : skinned.influences) {
      influences = std::max(influences, std::ranges::count_if(i.weights, [](float w) { return w > 0.0F; }));
    }
    return influences;
  };
  const MeshSequence tube = jellyTube();
  const auto four = compress(tube, settings);
  settings.influences = InfluenceLimit::eight;
  const auto eight = compress(tube, settings);
  REQUIRE(four);
  REQUIRE(eight);
  CHECK(most(four->skinned) == 4);
  CHECK(most(eight->skinned) > 4);
  CHECK(eight->metrics.mse < four->metrics.mse);
  const test::TemporaryFolder folder;
  for (const bool quantise : {false, true}) {
    EncodeSettings encoding;
    encoding.quantise = quantise;
    REQUIRE(gltf::save(encodeGltf(eight->skinned, encoding).source, folder.path() / "tube.glb"));
    const auto read = readAnimatedGltf(folder.path() / "tube.glb");
    REQUIRE(read);
    CHECK(distancesOf(skinAllFrames(eight->skinned), *read).largestPercent < (quantise ? 0.01 : 0.001));
  }
}

TEST_CASE("of a row the better weights are taken unless others are asked for") {
  const MeshSequence tube = test::shorteningTube(12, 2.0, 0.06, 0.1);
  for (const StretchOption stretch : {StretchOption::none, StretchOption::elastic}) {
    CompressSettings settings;
    settings.bones = 10;
    settings.stretch = stretch;
    const auto best = compress(tube, settings);
    settings.weights = WeightOption::geodesic;
    const auto geodesic = compress(tube, settings);
    settings.weights = WeightOption::fitted;
    const auto fitted = compress(tube, settings);
    REQUIRE(best);
    REQUIRE(geodesic);
    REQUIRE(fitted);
    CHECK(best->metrics.mse == std::min(geodesic->metrics.mse, fitted->metrics.mse));
    const bool geodesicIsBetter = geodesic->metrics.mse < fitted->metrics.mse;
    CHECK(best->weights.used == (geodesicIsBetter ? WeightOption::geodesic : WeightOption::fitted));
    REQUIRE(best->weights.geodesicPercent);
    CHECK(*best->weights.geodesicPercent == Approx(geodesic->metrics.rmsePercent));
    CHECK(*best->weights.fittedPercent == Approx(fitted->metrics.rmsePercent));
    CHECK_FALSE(geodesic->weights.fittedPercent);
  }
}

TEST_CASE("a given skeleton keeps its names, parents and places") {
  const SkinnedSequence truth = test::armedBody(24);
  CompressSettings settings = measuredWith(1);
  settings.skeleton = bonesOfFile(truth);
  REQUIRE(settings.skeleton.size() == truth.bones.size());
  const CompressedSequence result = compressedBody(settings);
  CHECK(result.metrics.rmsePercent < 0.2);
  const std::vector<SkinBone> written = bonesOfFile(result.skinned);
  REQUIRE(written.size() == truth.bones.size());
  for (std::size_t b = 0; b < truth.bones.size(); ++b) {
    INFO(truth.bones[b].name);
    CHECK(written[b].name == truth.bones[b].name);
    CHECK(written[b].parent == truth.bones[b].parent);
    CHECK(glm::length(written[b].pivot - truth.bones[b].pivot) < 1e-4);
  }
}

TEST_CASE("a skeleton that cannot be used is refused in one line") {
  const SkinnedSequence truth = test::armedBody(3);
  const MeshSequence sequence = skinAllFrames(truth);
  CompressSettings settings = measuredWith(6);
  settings.skeleton = truth.bones;
  for (SkinBone& bone : settings.skeleton) {
    bone.pivot *= 100.0;
  }
  CHECK_THAT(compress(sequence, settings).error().line(), Catch::Contains("in the units of the mesh"));
  settings.skeleton = truth.bones;
  for (SkinBone& bone : settings.skeleton) {
    bone.pivot.y += 50.0;
  }
  CHECK_THAT(compress(sequence, settings).error().line(), Catch::Contains("lie in the mesh"));
  const test::TemporaryFolder folder;
  CHECK_FALSE(readSkeleton(folder.path() / "none.glb"));
}

TEST_CASE("bones that are stretched out of proportion are told with their frames") {
  SkinnedSequence truth = test::armedBody(12);
  for (std::size_t k = 0; k < truth.frameCount(); ++k) {
    truth.pose(k, 1).scale = Vec3(1.0, k == 7 ? 3.0 : 1.0, 1.0);
  }
  const auto result = compress(skinAllFrames(truth), measuredWith(6));
  REQUIRE(result);
  CHECK(std::ranges::any_of(result->warnings, [](const std::string& warning) {
    return warning.find("scaled") != std::string::npos && warning.find('7') != std::string::npos;
  }));
}

TEST_CASE("scales stay within the limit that is given, at a price that is told") {
  SkinnedSequence truth = test::armedBody(12);
  for (std::size_t k = 0; k < truth.frameCount(); ++k) {
    truth.pose(k, 1).scale = Vec3(1.0, k == 7 ? 3.0 : 1.0, 1.0);
  }
  const MeshSequence sequence = skinAllFrames(truth);
  CompressSettings settings = measuredWith(6);
  settings.fit.largestScale = 1.5;
  const auto limited = compress(sequence, settings);
  const auto free = compress(sequence, measuredWith(6));
  REQUIRE(limited);
  REQUIRE(free);
  for (std::size_t b = 0; b < limited->skinned.bones.size(); ++b) {
    const ScaleRange range = scaleRangeOf(limited->skinned, b);
    CHECK(range.most <= 1.5 + 1e-9);
    CHECK(range.least >= 1.0 / 1.5 - 1e-9);
  }
  CHECK(limited->metrics.rmsePercent > free->metrics.rmsePercent);
}

TEST_CASE("a small piece that moves by itself has a bone of its own") {
  // A tube at rest, from the side of which a button of a few vertices is pushed out.
  MeshSequence tube = test::shorteningTube(8, 0.0, 0.0, 0.0);
  std::vector<std::size_t> button;
  for (std::size_t v = 0; v < tube.vertexCount; ++v) {
    const glm::vec3 place = tube.frame(0)[v];
    if (std::abs(place.x - 3.0F) < 0.6F && place.y > 0.3F) {
      button.push_back(v);
    }
  }
  REQUIRE(button.size() >= 4);
  REQUIRE(button.size() < tube.vertexCount / 16);
  for (std::size_t k = 1; k < tube.frameCount(); ++k) {
    for (const std::size_t v : button) {
      tube.frame(k)[v].y += 0.1F * static_cast<float>(k);
    }
  }
  const SkinnedSequence parts = clustersOfMotion(tube, 2, 0);
  REQUIRE(parts.bones.size() == 2);
  const std::uint16_t own = parts.influences[button.front()].bones[0];
  for (std::size_t v = 0; v < tube.vertexCount; ++v) {
    const bool isButton = std::ranges::find(button, v) != button.end();
    CHECK((parts.influences[v].bones[0] == own) == isButton);
  }
}

TEST_CASE("parts are told by the last frame where it is said to begin behind it") {
  const MeshSequence tube = test::shorteningTube(6, 1.5, 0.0, 0.0);
  CHECK(clustersOfMotion(tube, 3, 99).influences == clustersOfMotion(tube, 3, 5).influences);
}

TEST_CASE("where fewer bones follow the mesh exactly, no more are made, and that is told") {
  const auto result = compress(skinAllFrames(test::armedBody(1)), measuredWith(20));
  REQUIRE(result);
  CHECK(result->skinned.bones.size() == 1);
  CHECK(std::ranges::any_of(result->warnings, [](const std::string& warning) {
    return warning.find("1 bones instead of 20") != std::string::npos;
  }));
}

TEST_CASE("a skeleton falls into rows between its branchings") {
  const SkinnedSequence body = test::armedBody(3);
  const auto rows = rowsOfTree(body.bones);
  std::size_t bones = 0;
  for (const std::vector<std::size_t>& row : rows) {
    bones += row.size();
    for (std::size_t i = 1; i < row.size(); ++i) {
      CHECK(body.bones[row[i]].parent == static_cast<int>(row[i - 1]));
    }
  }
  CHECK(bones == body.bones.size());
  REQUIRE(rows.size() == 4); // trunk, head, two arms
  CHECK(rows.front().size() == 1);
  CHECK(std::ranges::count_if(rows, [](const auto& row) { return row.size() == 2; }) == 2);
}

TEST_CASE("rows of a given skeleton shorten by their own curvature") {
  constexpr double shortening = 0.05;
  const MeshSequence tube = test::shorteningTube(24, 2.4, shortening, 0.0);
  const auto measured = compress(tube, measuredWith(3));
  REQUIRE(measured);
  CompressSettings settings;
  settings.skeleton = bonesOfFile(measured->skinned);
  settings.stretch = StretchOption::elastic;
  const auto elastic = compress(tube, settings);
  REQUIRE(elastic);
  REQUIRE(elastic->chains.size() == 1);
  const ChainStretch& row = elastic->chains.front();
  CHECK(row.bones.size() == 3);
  CHECK(row.length.line.rSquared > 0.9);
  CHECK(row.least < 0.95);
  CHECK(row.most == Approx(1.0).margin(0.02));
  CHECK(elastic->metrics.rmsePercent < 1.0);
  for (std::size_t b = 1; b < elastic->skinned.bones.size(); ++b) {
    CHECK(elastic->skinned.pose(20, b).scale == elastic->skinned.pose(20, 0).scale);
  }
}

TEST_CASE("limbs of a body that branches shorten by their own curvature, with bones that are found in it") {
  const MeshSequence body = bodyWithArmsThatShorten();
  CompressSettings settings = measuredWith(6);
  const auto rigid = compress(body, [&] {
    CompressSettings none = settings;
    none.stretch = StretchOption::none;
    return none;
  }());
  settings.stretch = StretchOption::elastic;
  const auto elastic = compress(body, settings);
  REQUIRE(rigid);
  REQUIRE(elastic);
  CHECK_FALSE(elastic->chains.empty());
  CHECK(elastic->metrics.rmsePercent < rigid->metrics.rmsePercent);
  std::size_t bones = 0;
  for (const ChainStretch& row : elastic->chains) {
    bones += row.bones.size();
    for (const std::size_t b : row.bones) { // The same stretch for a row, volume kept.
      const Vec3& scale = elastic->skinned.pose(12, b).scale;
      CHECK(scale.x * scale.y * scale.z == Approx(1.0).margin(1e-9));
      CHECK(scale.x == Approx(elastic->skinned.pose(12, row.bones.front()).scale.x).margin(1e-12));
    }
  }
  CHECK(bones == elastic->skinned.bones.size());
}
