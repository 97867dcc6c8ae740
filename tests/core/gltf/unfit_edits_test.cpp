// Edits that do not fit their file: every number of each kind of edit, beside the nearest that fits.
#include <functional>
#include <limits>

#include <catch2/catch.hpp>

#include "core/gltf/patch/edits.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/refusal.h"

using namespace stretch;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// "" where the file takes them.
std::string unfitOf(const gltf::Loaded& file, const gltf::Edits& edits) {
  const auto patched = gltf::patched(*file.source, edits);
  const std::string told = patched ? std::string() : patched.error().what;
  const std::string before = "an edit does not fit the file: ";
  CHECK((told.empty() || told.starts_with(before)));
  return told.substr(std::min(told.size(), before.size()));
}

gltf::Edits withNode(int parent, int meshFrom, const Transform& rest = {}) {
  gltf::Edits edits;
  edits.addedNodes = {{"new", NodeIndex(parent), rest, NodeIndex(meshFrom), true}};
  return edits;
}

Track trackOf(int node, Channel channel, int width, std::vector<float> times, std::size_t values) {
  Track track;
  track.node = NodeIndex(node);
  track.channel = channel;
  track.width = width;
  track.times = std::move(times);
  track.values.assign(values, 0.5F);
  return track;
}

std::string unfitTrack(const gltf::Loaded& file, const Track& track) {
  gltf::Edits edits;
  edits.clips = {{0, {track}, 0.0}};
  return unfitOf(file, edits);
}

} // namespace

TEST_CASE("A node that is added hangs on one before it and takes the mesh of one of the file, or none") {
  const gltf::Loaded file = test::loaded(test::armBuilder());
  const auto nodes = static_cast<int>(file.scene->nodes.size());
  CHECK(unfitOf(file, withNode(-1, -1)).empty());
  CHECK(unfitOf(file, withNode(0, -1)).empty());
  CHECK(unfitOf(file, withNode(nodes - 1, 3)).empty());
  for (const auto& [parent, mesh] : {std::pair{nodes, -1}, {-2, -1}, {0, nodes}, {0, -2}}) {
    CHECK(unfitOf(file, withNode(parent, mesh)) == "added node 'new'");
  }
  gltf::Edits two = withNode(0, -1);
  two.addedNodes.push_back({"second", NodeIndex(nodes), {}, NodeIndex::none, true});
  CHECK(unfitOf(file, two).empty());
  two.addedNodes[1].parent = NodeIndex(nodes + 1);
  CHECK(unfitOf(file, two) == "added node 'second'");
}

TEST_CASE("No number of a node's place may be none: each of the ten is looked at") {
  const gltf::Loaded file = test::loaded(test::armBuilder());
  const std::vector<std::function<double&(Transform&)>> numbers{
      [](Transform& t) -> double& { return t.translation.x; },
      [](Transform& t) -> double& { return t.translation.y; },
      [](Transform& t) -> double& { return t.translation.z; },
      [](Transform& t) -> double& { return t.rotation.x; },
      [](Transform& t) -> double& { return t.rotation.y; },
      [](Transform& t) -> double& { return t.rotation.z; },
      [](Transform& t) -> double& { return t.rotation.w; },
      [](Transform& t) -> double& { return t.scale.x; },
      [](Transform& t) -> double& { return t.scale.y; },
      [](Transform& t) -> double& { return t.scale.z; }};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const double no : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite}) {
      CAPTURE(i, no);
      Transform rest;
      numbers[i](rest) = no;
      CHECK(unfitOf(file, withNode(0, -1, rest)) == "added node 'new'");
      gltf::Edits moved;
      moved.movedNodes = {{NodeIndex(1), rest}};
      CHECK(unfitOf(file, moved) == "the new place of node 1");
    }
  }
}

TEST_CASE("A node that is moved, a slot and a joint that a skin gets are of the file") {
  const gltf::Loaded file = test::loaded(test::armBuilder());
  const auto nodes = static_cast<int>(file.scene->nodes.size());
  const auto joints = static_cast<int>(file.scene->skins[0].joints.size());
  const auto skins = static_cast<int>(file.scene->skins.size());
  const auto moved = [&](int node) {
    gltf::Edits edits;
    edits.movedNodes = {{NodeIndex(node), {}}};
    return unfitOf(file, edits);
  };
  CHECK(moved(nodes - 1).empty());
  CHECK(moved(nodes) == "the new place of node " + std::to_string(nodes));
  CHECK(moved(-1) == "the new place of node -1");
  Mat4 broken(1.0);
  broken[2][1] = infinite;
  const auto slot = [&](int skin, int place, int node, const Mat4& matrix = Mat4(1.0)) {
    gltf::Edits edits;
    edits.skinSlots = {{skin, place, NodeIndex(node), matrix}};
    return unfitOf(file, edits);
  };
  CHECK(slot(0, joints - 1, nodes - 1).empty());
  CHECK(slot(skins, 0, 0) == "slot 0 of skin " + std::to_string(skins));
  CHECK(slot(-1, 0, 0) == "slot 0 of skin -1");
  CHECK(slot(0, joints, 0) == "slot " + std::to_string(joints) + " of skin 0");
  CHECK(slot(0, -1, 0) == "slot -1 of skin 0");
  CHECK(slot(0, 0, nodes) == "slot 0 of skin 0");
  CHECK(slot(0, 0, -1) == "slot 0 of skin 0");
  CHECK(slot(0, 0, 0, broken) == "slot 0 of skin 0");
  const auto joint = [&](int skin, int node, const Mat4& matrix = Mat4(1.0)) {
    gltf::Edits edits;
    edits.addedSlots = {{skin, NodeIndex(node), matrix}};
    return unfitOf(file, edits);
  };
  CHECK(joint(skins - 1, nodes - 1).empty());
  CHECK(joint(skins, 0) == "a joint that skin " + std::to_string(skins) + " gets");
  CHECK(joint(-1, 0) == "a joint that skin -1 gets");
  CHECK(joint(0, nodes) == "a joint that skin 0 gets");
  CHECK(joint(0, -1) == "a joint that skin 0 gets");
  CHECK(joint(0, 0, broken) == "a joint that skin 0 gets");
}

TEST_CASE("A skin that is added has joints of the file, each with a matrix of numbers") {
  const gltf::Loaded file = test::loaded(test::armBuilder());
  const auto nodes = static_cast<int>(file.scene->nodes.size());
  const auto skin = [&](const std::vector<int>& joints, std::size_t matrices, const Mat4& last = Mat4(1.0)) {
    gltf::Edits edits;
    gltf::AddedSkin added{"new", {}, std::vector<Mat4>(matrices, Mat4(1.0))};
    for (const int node : joints) {
      added.joints.emplace_back(node);
    }
    if (matrices > 0) {
      added.inverseBind.back() = last;
    }
    edits.addedSkins = {added};
    return unfitOf(file, edits);
  };
  Mat4 broken(1.0);
  broken[3][0] = infinite;
  CHECK(skin({0, nodes - 1}, 2).empty());
  CHECK(skin({}, 0) == "added skin 'new'");
  CHECK(skin({0, 1}, 1) == "added skin 'new'");
  CHECK(skin({0, 1}, 3) == "added skin 'new'");
  CHECK(skin({0, nodes}, 2) == "added skin 'new'");
  CHECK(skin({0, -1}, 2) == "added skin 'new'");
  CHECK(skin({0, 1}, 2, broken) == "added skin 'new'");
}

TEST_CASE("Tracks have keys that grow, and for each of them as many numbers as their property has") {
  const gltf::Loaded file = test::loaded(test::armBuilder());
  const auto nodes = static_cast<int>(file.scene->nodes.size());
  const std::string told = "a track of node 1 in clip 0";
  for (const Channel channel : {Channel::translation, Channel::scale, Channel::rotation}) {
    const int width = channel == Channel::rotation ? 4 : 3;
    const auto numbers = static_cast<std::size_t>(width);
    CHECK(unfitTrack(file, trackOf(1, channel, width, {0, 1}, 2 * numbers)).empty());
    CHECK(unfitTrack(file, trackOf(1, channel, 7 - width, {0, 1}, 2 * (7 - numbers))) == told);
    CHECK(unfitTrack(file, trackOf(1, channel, width, {0, 1}, 2 * numbers - 1)) == told);
    CHECK(unfitTrack(file, trackOf(1, channel, width, {0, 1}, 2 * numbers + 1)) == told);
    CHECK(unfitTrack(file, trackOf(1, channel, width, {}, 0)) == told);
    CHECK(unfitTrack(file, trackOf(1, channel, width, {0, 0}, 2 * numbers)) == told);
    CHECK(unfitTrack(file, trackOf(1, channel, width, {0, 2, 1}, 3 * numbers)) == told);
    Track cubic = trackOf(1, channel, width, {0, 1}, 6 * numbers);
    cubic.interpolation = Interpolation::cubicSpline;
    CHECK(unfitTrack(file, cubic).empty());
    cubic.values.resize(2 * numbers);
    CHECK(unfitTrack(file, cubic) == told);
    Track broken = trackOf(1, channel, width, {0, 1}, 2 * numbers);
    broken.values.back() = std::numeric_limits<float>::quiet_NaN();
    CHECK(unfitTrack(file, broken) == told);
    broken.values.back() = 0.0F;
    broken.times.back() = std::numeric_limits<float>::infinity();
    CHECK(unfitTrack(file, broken) == told);
  }
  CHECK(unfitTrack(file, trackOf(1, Channel::weights, 0, {0}, 0)) == told);
  const std::string last = std::to_string(nodes - 1);
  CHECK(unfitTrack(file, trackOf(nodes - 1, Channel::scale, 3, {0}, 3)).empty());
  CHECK(unfitTrack(file, trackOf(nodes, Channel::scale, 3, {0}, 3)) ==
        "a track of node " + std::to_string(nodes) + " in clip 0");
  CHECK(unfitTrack(file, trackOf(-1, Channel::scale, 3, {0}, 3)) == "a track of node -1 in clip 0");
  gltf::Edits edits;
  edits.clips = {{static_cast<int>(file.clips.size()), {}, 0.0}};
  CHECK(unfitOf(file, edits) == "clip " + std::to_string(file.clips.size()));
  edits.clips[0].clip = -1;
  CHECK(unfitOf(file, edits) == "clip -1");
  edits.clips[0].clip = static_cast<int>(file.clips.size()) - 1;
  CHECK(unfitOf(file, edits).empty());
}
