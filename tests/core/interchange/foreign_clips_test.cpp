#include <limits>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/sampling.h"
#include "tests/support/core/foreign_scene.h"

using namespace stretch;
using test::ForeignScene;
using test::MadeOfForeign;

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// A scene of a "hip" at (0, 4, 0) with a "knee" 3 below it, and a clip "walk" of 10 ticks a second.
struct Legs {
  Legs() : clip(scene.addClip("walk", 10.0)) {}

  ForeignScene scene;
  aiNode& hip = scene.addNode(scene.root(), "hip", Vec3(0.0, 4.0, 0.0));
  aiNode& knee = scene.addNode(hip, "knee", Vec3(0.0, -3.0, 0.0));
  aiAnimation& clip;
};

Quat about(const Vec3& axis, double degrees) {
  return glm::angleAxis(glm::radians(degrees), axis);
}

const Track& trackOf(const MadeOfForeign& made, const std::string& node, Channel channel) {
  const Scene& scene = *made.file.scene;
  const auto found = std::ranges::find(scene.nodes, node, &Node::name);
  REQUIRE(found != scene.nodes.end());
  const int track =
      findTrack(made.file.clips.at(0), NodeIndex(static_cast<int>(found - scene.nodes.begin())), channel);
  REQUIRE(track >= 0);
  return *made.file.clips[0].tracks[static_cast<std::size_t>(track)];
}

Vec3 worldAt(const MadeOfForeign& made, std::size_t node, double seconds) {
  const Scene& scene = *made.file.scene;
  return positionOf(worldMatrices(scene, samplePose(scene, made.file.clips.at(0), seconds)).at(node));
}

} // namespace

TEST_CASE("A clip that a program named bears the file's name where it is the only one") {
  Legs legs;
  const auto moving = [&](aiAnimation& clip, const char* name) {
    clip.mName = aiString(name);
    test::setPlaces(legs.scene.addChannel(clip, "hip"), {{0.0, Vec3(0.0)}, {10.0, Vec3(1.0)}});
  };
  const auto names = [&] {
    std::vector<std::string> all;
    for (const Clip& clip : test::madeOfForeign(legs.scene).file.clips) {
      all.push_back(clip.name);
    }
    return all;
  };
  moving(legs.clip, "Take 001");
  CHECK(names() == std::vector<std::string>{"figure"});
  for (const char* const passedOn :
       {"Armature|mixamo.com|Layer0", "Armature|Take 001|BaseLayer", "Armature|Take 001"}) {
    legs.clip.mName = aiString(passedOn);
    CHECK(names() == std::vector<std::string>{"figure"});
  }
  for (const char* const given : {"", "Motion", "Take 01", "Default Take", "Unreal Take", "Animation"}) {
    CAPTURE(given);
    legs.clip.mName = aiString(given);
    CHECK(names() == std::vector<std::string>{"figure"});
  }
  legs.clip.mName = aiString("Armature|Jab|Layer0");
  CHECK(names() == std::vector<std::string>{"Armature|Jab|Layer0"});
  legs.clip.mName = aiString("Take 001");
  moving(legs.scene.addClip("", 10.0), "Motion");
  CHECK(names() == std::vector<std::string>{"Take 001", "Motion"}); // The file's name would tell neither from
                                                                    // the other.
}

TEST_CASE("Keys of a foreign clip are kept at their times, in seconds") {
  Legs legs;
  aiNodeAnim& hip = legs.scene.addChannel(legs.clip, "hip");
  test::setPlaces(hip, {{0.0, Vec3(0.0, 4.0, 0.0)}, {5.0, Vec3(1.0, 4.0, 0.0)}, {20.0, Vec3(1.0, 8.0, 2.0)}});
  test::setTurns(hip, {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {10.0, Quat(0.0, 0.0, 1.0, 0.0)}});
  test::setScales(hip, {{0.0, Vec3(1.0)}, {10.0, Vec3(1.0, 2.0, 3.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  REQUIRE(made.file.clips.size() == 1);
  CHECK(made.clips.clips == 1);
  CHECK(made.file.clips[0].name == "walk");
  CHECK(made.file.clips[0].framesPerSecond == 10.0);
  CHECK(made.file.clips[0].tracks.size() == 3);
  const Track& places = trackOf(made, "hip", Channel::translation);
  CHECK(places.times == std::vector<float>{0.0F, 0.5F, 2.0F});
  CHECK(places.values == std::vector<float>{0, 4, 0, 1, 4, 0, 1, 8, 2});
  CHECK(trackOf(made, "hip", Channel::rotation).times == std::vector<float>{0.0F, 1.0F});
  CHECK(trackOf(made, "hip", Channel::rotation).values == std::vector<float>{0, 0, 0, 1, 0, 1, 0, 0});
  CHECK(trackOf(made, "hip", Channel::scale).values == std::vector<float>{1, 1, 1, 1, 2, 3});
  CHECK(made.clips.hasGaps);
  CHECK_FALSE(made.clips.hasUnevenShed);
}

TEST_CASE("A clip without a rate has 25 ticks a second, and one in thousandths of a second notes no rate") {
  const auto [ticks, last, rate] = GENERATE(table<double, double, double>({{0.0, 1.0, 25.0},
                                                                           {-1.0, 1.0, 25.0},
                                                                           {29.97, 1.0 / 29.97 * 25.0, 29.97},
                                                                           {24.0001, 1.0, 24.0},
                                                                           {1000.0, 1.0, 0.0},
                                                                           {999.0, 1.0, 999.0}}));
  CAPTURE(ticks, last);
  Legs legs;
  legs.clip.mTicksPerSecond = ticks;
  test::setPlaces(legs.scene.addChannel(legs.clip, "hip"), {{0.0, Vec3(0.0)}, {25.0, Vec3(1.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  if (rate == 0.0) {
    CHECK_FALSE(made.json["animations"][0].contains("extras"));
  } else {
    CHECK(made.json["animations"][0]["extras"]["stretch_engine"]["frames_per_second"].get<double>() ==
          Approx(rate).epsilon(1e-9));
  }
  CHECK(made.file.clips[0].endSeconds == Approx(ticks > 0.0 ? 25.0 / ticks : 1.0));
}

TEST_CASE("A clip that begins before 0 is brought to 0 with all its tracks, one that begins later stays") {
  const double first = GENERATE(-20.0, 5.0);
  Legs legs;
  test::setPlaces(legs.scene.addChannel(legs.clip, "hip"), {{0.0, Vec3(0.0)}, {10.0, Vec3(1.0)}});
  test::setTurns(legs.scene.addChannel(legs.clip, "knee"),
                 {{first, about({1, 0, 0}, 0.0)}, {first + 30.0, about({1, 0, 0}, 90.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  const float start = first < 0.0 ? 2.0F : 0.0F;
  CHECK(trackOf(made, "hip", Channel::translation).times == std::vector<float>{start, start + 1.0F});
  CHECK(trackOf(made, "knee", Channel::rotation).times ==
        std::vector<float>{first < 0.0 ? 0.0F : 0.5F, first < 0.0 ? 3.0F : 3.5F});
}

TEST_CASE("Keys that are no numbers, or do not come after the one before, are left out") {
  Legs legs;
  aiNodeAnim& hip = legs.scene.addChannel(legs.clip, "hip");
  test::setPlaces(hip, {{0.0, Vec3(0.0, 4.0, 0.0)},
                        {noNumber, Vec3(9.0)},
                        {1.0, Vec3(noNumber)},
                        {2.0, Vec3(1.0)},
                        {2.0, Vec3(9.0)},
                        {1.5, Vec3(9.0)},
                        {3.0, Vec3(2.0)}});
  test::setTurns(
      hip,
      {{0.0, Quat(0.0, 0.0, 0.0, 0.0)}, {1.0, Quat(0.0, 2.0, 0.0, 0.0)}, {2.0, Quat(-3.0, 0.0, 0.0, 0.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  const Track& places = trackOf(made, "hip", Channel::translation);
  CHECK(places.times == std::vector<float>{0.0F, 0.2F, 0.3F});
  CHECK(places.values == std::vector<float>{0, 4, 0, 1, 1, 1, 2, 2, 2});
  const Track& turns = trackOf(made, "hip", Channel::rotation);
  CHECK(turns.times == std::vector<float>{0.1F, 0.2F});
  CHECK(turns.values == std::vector<float>{1, 0, 0, 0, 0, 0, 0, -1}); // of unit length
  // Without one good key a part stays as it rests.
  Legs odd;
  test::setPlaces(odd.scene.addChannel(odd.clip, "knee"), {{0.0, Vec3(noNumber)}});
  const MadeOfForeign still = test::madeOfForeign(odd.scene);
  const Track& rest = trackOf(still, "knee", Channel::translation);
  CHECK(rest.times == std::vector<float>{0.0F});
  CHECK(rest.values == std::vector<float>{0, -3, 0});
}

TEST_CASE("Turns take the shorter way from key to key") {
  Legs legs;
  test::setTurns(
      legs.scene.addChannel(legs.clip, "hip"),
      {{0.0, about({0, 0, 1}, 0.0)}, {1.0, -about({0, 0, 1}, 60.0)}, {2.0, about({0, 0, 1}, 120.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  const Track& turns = trackOf(made, "hip", Channel::rotation);
  REQUIRE(turns.values.size() == 12);
  CHECK(turns.values[7] == Approx(std::cos(glm::radians(30.0))));
  CHECK(turns.values[11] == Approx(0.5));
}

TEST_CASE("What does not move is one key, and a scale that stays at rest is none") {
  Legs legs;
  aiNodeAnim& hip = legs.scene.addChannel(legs.clip, "hip");
  test::setPlaces(hip, {{0.0, Vec3(1.0, 2.0, 3.0)}, {10.0, Vec3(1.0, 2.0, 3.0)}});
  test::setTurns(hip, {{0.0, about({0, 1, 0}, 90.0)}, {10.0, about({0, 1, 0}, 90.0)}});
  test::setScales(hip, {{0.0, Vec3(1.0)}, {10.0, Vec3(1.0)}});
  aiNodeAnim& knee = legs.scene.addChannel(legs.clip, "knee");
  test::setScales(knee, {{0.0, Vec3(2.0)}, {10.0, Vec3(2.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  CHECK(trackOf(made, "hip", Channel::translation).values == std::vector<float>{1, 2, 3});
  CHECK(trackOf(made, "hip", Channel::rotation).times.size() == 1);
  CHECK(findTrack(made.file.clips[0], NodeIndex(0), Channel::scale) == -1);
  CHECK(trackOf(made, "knee", Channel::scale).values == std::vector<float>{2, 2, 2}); // but not as it rests
  CHECK_FALSE(made.clips.hasGaps);
}

TEST_CASE("A clip that moves nobody is left out") {
  Legs legs;
  test::setPlaces(legs.scene.addChannel(legs.clip, "somebody else"), {{0.0, Vec3(0.0)}, {1.0, Vec3(1.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  CHECK(made.file.clips.empty());
  CHECK(made.clips.clips == 0);
}

TEST_CASE("Of two nodes with one name the clip moves the first, of two channels the first counts") {
  Legs legs;
  legs.scene.addNode(legs.scene.addNode(legs.scene.root(), "other"), "knee");
  test::setPlaces(legs.scene.addChannel(legs.clip, "knee"), {{0.0, Vec3(0.0)}, {1.0, Vec3(1.0)}});
  test::setPlaces(legs.scene.addChannel(legs.clip, "knee"), {{0.0, Vec3(0.0)}, {2.0, Vec3(5.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  CHECK(trackOf(made, "knee", Channel::translation).node == NodeIndex(1));
  CHECK(trackOf(made, "knee", Channel::translation).times == std::vector<float>{0.0F, 0.1F});
}

TEST_CASE("Keys that stand wider apart than a frame and a half and move are noted") {
  const auto [wide, moved, isGap] = GENERATE(table<double, double, bool>(
      {{1.4, 1.0, false}, {1.6, 1.0, true}, {1.6, 5e-5, false}, {1.6, 2e-4, true}}));
  CAPTURE(wide, moved);
  for (const bool turns : {false, true}) {
    Legs legs;
    aiNodeAnim& hip = legs.scene.addChannel(legs.clip, "hip");
    if (turns) {
      test::setTurns(hip,
                     {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {wide, glm::normalize(Quat(1.0, moved, 0.0, 0.0))}});
    } else {
      test::setPlaces(hip, {{0.0, Vec3(0.0)}, {wide, Vec3(moved, 0.0, 0.0)}});
    }
    CHECK(test::madeOfForeign(legs.scene).clips.hasGaps == isGap);
  }
  // The same turn written with the other sign is no motion.
  Legs legs;
  test::setTurns(legs.scene.addChannel(legs.clip, "hip"),
                 {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {9.0, Quat(-1.0, 0.0, 0.0, 0.0)}});
  CHECK_FALSE(test::madeOfForeign(legs.scene).clips.hasGaps);
}

TEST_CASE(
    "Pivots around a turn make the joint swing as they say, at every time and in keys on whole frames") {
  ForeignScene scene;
  const auto moved = [](double y) {
    return toMatrix({Vec3(0.0, y, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  };
  aiNode& place = scene.addNode(scene.root(), "arm_$AssimpFbx$_Translation", moved(5.0));
  aiNode& pivot = scene.addNode(place, "arm_$AssimpFbx$_RotationPivot", moved(2.0));
  aiNode& turn = scene.addNode(pivot, "arm_$AssimpFbx$_Rotation");
  aiNode& back = scene.addNode(turn, "arm_$AssimpFbx$_RotationPivotInverse", moved(-2.0));
  scene.addNode(back, "arm");
  aiAnimation& clip = scene.addClip("swing", 10.0);
  test::setTurns(scene.addChannel(clip, "arm_$AssimpFbx$_Rotation"),
                 {{0.0, about({0, 0, 1}, 0.0)}, {10.0, about({0, 0, 1}, 90.0)}});
  const MadeOfForeign made = test::madeOfForeign(scene);
  REQUIRE(made.file.scene->nodes.size() == 1);
  CHECK(made.file.scene->nodes[0].name == "arm");
  CHECK(made.file.scene->nodes[0].rest.translation == Vec3(0.0, 5.0, 0.0));
  for (int step = 0; step <= 40; ++step) {
    const double angle = glm::radians(90.0 * step / 40.0);
    const Vec3 wanted(2.0 * std::sin(angle), 7.0 - 2.0 * std::cos(angle), 0.0);
    INFO(step);
    // A figure without any extent counts as one metre high.
    CHECK(glm::length(worldAt(made, 0, step / 40.0) - wanted) < 1.1e-4);
  }
  const Track& places = trackOf(made, "arm", Channel::translation);
  CHECK(places.times.size() > 11);
  CHECK(places.times.front() == 0.0F);
  CHECK(places.times.back() == 1.0F);
  // Between two frames at most three halvings lie.
  for (const float time : places.times) {
    const double eighths = time * 10.0 * 8.0;
    CHECK(std::abs(eighths - std::round(eighths)) < 1e-4);
  }
}

TEST_CASE("A turn behind a pivot's is put together with it, and the keys stay as they are") {
  ForeignScene scene;
  const Mat4 before = toMatrix({Vec3(0.0, 5.0, 0.0), about({0, 0, 1}, 90.0), Vec3(2.0)});
  aiNode& first = scene.addNode(scene.root(), "arm_$AssimpFbx$_PreRotation", before);
  scene.addNode(first, "arm_$AssimpFbx$_Rotation").addChildren(0, nullptr);
  aiNode& turn = *first.mChildren[0];
  scene.addNode(turn, "arm");
  aiAnimation& clip = scene.addClip("swing", 10.0);
  aiNodeAnim& channel = scene.addChannel(clip, "arm_$AssimpFbx$_Rotation");
  test::setTurns(channel, {{0.0, about({0, 0, 1}, 0.0)}, {10.0, about({0, 0, 1}, 60.0)}});
  test::setPlaces(channel, {{0.0, Vec3(0.0)}, {4.0, Vec3(1.0, 0.0, 0.0)}});
  test::setScales(channel, {{0.0, Vec3(1.0)}, {6.0, Vec3(3.0)}});
  const MadeOfForeign made = test::madeOfForeign(scene);
  const Track& turns = trackOf(made, "arm", Channel::rotation);
  REQUIRE(turns.times == std::vector<float>{0.0F, 1.0F});
  const Quat last = about({0, 0, 1}, 150.0);
  CHECK(std::abs(turns.values[6] * last.z + turns.values[7] * last.w) == Approx(1.0));
  const Track& places = trackOf(made, "arm", Channel::translation);
  CHECK(places.times == std::vector<float>{0.0F, 0.4F});
  CHECK(glm::length(Vec3(places.values[3], places.values[4], places.values[5]) - Vec3(0.0, 7.0, 0.0)) < 1e-5);
  CHECK(trackOf(made, "arm", Channel::scale).values[5] == Approx(6.0));
}

TEST_CASE("Weights of morph targets move the mesh of their name, target by target") {
  ForeignScene scene;
  aiMesh& mesh = scene.addTriangle("face", {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)});
  scene.addTarget(mesh, "smile", {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 2.0, 0.0)});
  scene.addTarget(mesh, "frown", {Vec3(0.0), Vec3(2.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)});
  scene.addTriangle("plain", {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)});
  scene.show(scene.addNode(scene.root(), "plain holder"), 1);
  scene.show(scene.addNode(scene.root(), "head"), 0);
  aiAnimation& clip = scene.addClip("talk", 10.0);
  const std::string name = GENERATE("face*0", "face", "head", "plain", "nobody");
  CAPTURE(name);
  clip.mNumMorphMeshChannels = 1;
  clip.mMorphMeshChannels = std::make_unique<aiMeshMorphAnim*[]>(1).release();
  clip.mMorphMeshChannels[0] = std::make_unique<aiMeshMorphAnim>().release();
  aiMeshMorphAnim& channel = *clip.mMorphMeshChannels[0];
  channel.mName = name;
  struct Said {
    double time;
    std::vector<std::pair<unsigned, double>> weights;
  };
  const std::vector<Said> said{{-5.0, {{0, 9.0}}},           {0.0, {{0, 0.25}, {1, 0.5}}},
                               {2.0, {{1, 0.75}, {2, 9.0}}}, {2.0, {{0, 9.0}}},
                               {noNumber, {{0, 9.0}}},       {10.0, {{1, noNumber}, {0, 1.0}}}};
  channel.mNumKeys = static_cast<unsigned>(said.size());
  channel.mKeys = std::make_unique<aiMeshMorphKey[]>(said.size()).release();
  for (std::size_t k = 0; k < said.size(); ++k) {
    aiMeshMorphKey& key = channel.mKeys[k];
    key.mTime = said[k].time;
    key.mNumValuesAndWeights = static_cast<unsigned>(said[k].weights.size());
    key.mValues = std::make_unique<unsigned[]>(said[k].weights.size()).release();
    key.mWeights = std::make_unique<double[]>(said[k].weights.size()).release();
    for (std::size_t v = 0; v < said[k].weights.size(); ++v) {
      std::tie(key.mValues[v], key.mWeights[v]) = said[k].weights[v];
    }
  }
  const MadeOfForeign made = test::madeOfForeign(scene);
  if (name == "plain" || name == "nobody") {
    CHECK(made.file.clips.empty());
    return;
  }
  const Track& weights = trackOf(made, "head", Channel::weights);
  CHECK(weights.times == std::vector<float>{0.0F, 0.2F, 1.0F});
  CHECK(weights.values == std::vector<float>{0.25F, 0.5F, 0.0F, 0.75F, 1.0F, 0.0F});
}

TEST_CASE("Times that equal the weights of an earlier track say their first and last all the same") {
  interchange::GlbParts parts;
  const std::vector<float> numbers{0.0F, 1.0F};
  const std::size_t weights = parts.addFloats(numbers, "SCALAR");
  const std::size_t times = parts.addFloats(numbers, "SCALAR", true);
  CHECK(parts.addFloats(numbers, "SCALAR", true) == times); // written once
  parts.add("nodes", {{"name", "one"}});
  const auto glb = parts.finish();
  REQUIRE(glb);
  const gltf::Json json = *test::loadBytes(*glb, gltf::Tolerance::warn).value().source->json;
  CHECK(json["accessors"][times]["min"] == gltf::Json{0});
  CHECK(json["accessors"][times]["max"] == gltf::Json{1});
  CHECK(json["accessors"][weights]["count"] == 2);
}

TEST_CASE("A mesh with a single target plays its weights, too") {
  ForeignScene scene;
  aiMesh& mesh = scene.addTriangle("face", {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)});
  scene.addTarget(mesh, "smile", {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 2.0, 0.0)});
  scene.show(scene.addNode(scene.root(), "head"), 0);
  aiAnimation& clip = scene.addClip("talk", 10.0);
  clip.mNumMorphMeshChannels = 1;
  clip.mMorphMeshChannels = std::make_unique<aiMeshMorphAnim*[]>(1).release();
  clip.mMorphMeshChannels[0] = std::make_unique<aiMeshMorphAnim>().release();
  clip.mMorphMeshChannels[0]->mName = "face";
  clip.mMorphMeshChannels[0]->mNumKeys = 1;
  clip.mMorphMeshChannels[0]->mKeys = std::make_unique<aiMeshMorphKey[]>(1).release();
  aiMeshMorphKey& key = clip.mMorphMeshChannels[0]->mKeys[0];
  key.mTime = 5.0;
  key.mNumValuesAndWeights = 1;
  key.mValues = std::make_unique<unsigned[]>(1).release();
  key.mWeights = std::make_unique<double[]>(1).release();
  key.mWeights[0] = 0.75;
  const MadeOfForeign made = test::madeOfForeign(scene);
  CHECK(trackOf(made, "head", Channel::weights).values == std::vector<float>{0.75F});
  CHECK(trackOf(made, "head", Channel::weights).times == std::vector<float>{0.5F});
}

TEST_CASE(
    "How far a joint has to move before it has keys is a share of the figure's height, in its own lengths") {
  // A ten millionth of 1000, and under a parent a hundred times as large the hundredth part of that.
  const auto [isLarge, way, keys] = GENERATE(table<bool, double, std::size_t>(
      {{false, 5e-5, 1}, {false, 2e-4, 2}, {true, 5e-7, 1}, {true, 2e-6, 2}}));
  CAPTURE(isLarge, way);
  ForeignScene scene;
  scene.addNode(scene.root(), "far", Vec3(0.0, 1000.0, 0.0));
  aiNode& parent = scene.addNode(scene.root(), "parent", Mat4(Mat3(isLarge ? 100.0 : 1.0)));
  scene.addNode(parent, "tip");
  test::setPlaces(scene.addChannel(scene.addClip("creep", 10.0), "tip"),
                  {{0.0, Vec3(0.0)}, {10.0, Vec3(way, 0.0, 0.0)}});
  const MadeOfForeign made = test::madeOfForeign(scene);
  CHECK(trackOf(made, "tip", Channel::translation).times.size() == keys);
}

TEST_CASE("Two pivots that scale, or turn about two axes, make the joint do at every frame what they say "
          "together") {
  const bool isTurned = GENERATE(true, false);
  CAPTURE(isTurned);
  ForeignScene scene;
  aiNode& first = scene.addNode(scene.root(), "arm_$AssimpFbx$_Rotation");
  aiNode& second = scene.addNode(first, "arm_$AssimpFbx$_PostRotation");
  scene.addNode(second, "arm");
  aiAnimation& clip = scene.addClip("swing", 10.0);
  aiNodeAnim& ofFirst = scene.addChannel(clip, "arm_$AssimpFbx$_Rotation");
  aiNodeAnim& ofSecond = scene.addChannel(clip, "arm_$AssimpFbx$_PostRotation");
  if (isTurned) {
    test::setTurns(ofFirst, {{0.0, about({1, 0, 0}, 0.0)}, {10.0, about({1, 0, 0}, 90.0)}});
    test::setTurns(ofSecond, {{0.0, about({0, 1, 0}, 0.0)}, {10.0, about({0, 1, 0}, 90.0)}});
  } else {
    test::setScales(ofFirst, {{0.0, Vec3(1.0)}, {10.0, Vec3(3.0)}});
    test::setScales(ofSecond, {{0.0, Vec3(1.0)}, {10.0, Vec3(3.0)}});
  }
  const MadeOfForeign made = test::madeOfForeign(scene);
  const Scene& figure = *made.file.scene;
  REQUIRE(figure.nodes.size() == 1);
  for (int frame = 0; frame <= 10; ++frame) {
    INFO(frame);
    const Transform local = samplePose(figure, made.file.clips.at(0), 0.1 * frame).locals[0];
    if (isTurned) {
      const Quat wanted = about({1, 0, 0}, 9.0 * frame) * about({0, 1, 0}, 9.0 * frame);
      CHECK(std::abs(glm::dot(local.rotation, wanted)) > 1.0 - 1e-7);
    } else {
      const double each = 1.0 + 0.2 * frame;
      CHECK(local.scale.x == Approx(each * each).margin(2e-4));
    }
  }
}

TEST_CASE("Of keys that fall on one time in single precision the first is kept") {
  Legs legs;
  test::setPlaces(
      legs.scene.addChannel(legs.clip, "hip"),
      {{0.0, Vec3(0.0, 4.0, 0.0)}, {1e6, Vec3(1.0, 4.0, 0.0)}, {1e6 + 1e-4, Vec3(9.0, 4.0, 0.0)}});
  const MadeOfForeign made = test::madeOfForeign(legs.scene);
  const Track& places = trackOf(made, "hip", Channel::translation);
  CHECK(places.times == std::vector<float>{0.0F, 1e5F});
  CHECK(places.values == std::vector<float>{0, 4, 0, 1, 4, 0});
}
