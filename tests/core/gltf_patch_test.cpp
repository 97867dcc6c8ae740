#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <random>

#include "core/anim/frame_state.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/gltf/load/report.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/uri.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::armBuilder;
using test::GlbBuilder;
using test::TemporaryFolder;

namespace {

constexpr int upper = 1;
constexpr int lower = 2;
constexpr int prop = 3;
constexpr int firstAdded = 6;
constexpr int wave = 0;

gltf::Loaded opened(const std::filesystem::path& path) {
  Result<gltf::Loaded> file = gltf::load(path);
  if (!file) {
    FAIL(file.error().line());
  }
  return std::move(file.value());
}

gltf::Loaded arm(const TemporaryFolder& folder, const GlbBuilder& glb = armBuilder()) {
  glb.write(folder / "source.glb");
  return opened(folder / "source.glb");
}

gltf::Source patchedOrFail(const gltf::Source& source, const gltf::Edits& edits) {
  Result<gltf::Source> result = gltf::patched(source, edits);
  if (!result) {
    FAIL(result.error().line());
  }
  return std::move(result.value());
}

gltf::Loaded reopened(const TemporaryFolder& folder, const gltf::Source& source,
                      const std::string& name = "out.glb") {
  if (const Status saved = gltf::save(source, folder / name); !saved) {
    FAIL(saved.error().line());
  }
  return opened(folder / name);
}

Track scaleTrack(NodeIndex node, std::vector<float> times, std::vector<float> values) {
  return {node, Channel::scale, Interpolation::linear, 3, std::move(times), std::move(values), -1};
}

Track turnTrack(NodeIndex node) {
  return {node, Channel::rotation, Interpolation::linear, 4, {0, 1}, {0, 0, 0, 1, 0, 0, 0.6F, 0.8F}, -1};
}

// What a stretched "upper" looks like: a leaf with the joint's place in the skin and a scale of its own.
gltf::Edits stretchEdits(const gltf::Loaded& file) {
  gltf::Edits edits;
  edits.addedNodes = {{"upper_bind",
                       NodeIndex(upper),
                       {{}, glm::angleAxis(0.3, Vec3(0, 0, 1)), Vec3(1.0)},
                       NodeIndex::none,
                       true}};
  const Mat4 aligned = glm::inverse(toMatrix(edits.addedNodes[0].rest)) * file.scene->skins[0].inverseBind[1];
  edits.skinSlots = {{0, 1, NodeIndex(firstAdded), aligned}};
  edits.clips = {
      {wave, {scaleTrack(NodeIndex(firstAdded), {0, 1}, {1, 1, 1, 3, 1, 1}), turnTrack(NodeIndex(lower))}}};
  return edits;
}

std::vector<Vec3> skinned(const gltf::Loaded& file, int clip, double timeSeconds) {
  const FrameState frame =
      frameOf(*file.scene, samplePose(*file.scene, file.clips[static_cast<std::size_t>(clip)], timeSeconds),
              timeSeconds);
  const std::vector<Mat4> matrices = skinMatrices(file.scene->skins[0], frame);
  const Primitive& primitive = file.scene->meshes[0].primitives[0];
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    Vec4 sum(0.0);
    for (std::size_t k = 0; k < VertexInfluences::capacity; ++k) {
      const VertexInfluences& influence = primitive.influences[i];
      sum += static_cast<double>(influence.weights[k]) *
             (matrices[influence.joints[k]] * Vec4(Vec3(primitive.positions[i]), 1.0));
    }
    vertices.emplace_back(sum);
  }
  return vertices;
}

} // namespace

TEST_CASE("A patch without edits is the source") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  const gltf::Source same = patchedOrFail(*file.source, {});
  CHECK(same.json->dump() == file.source->json->dump());
  CHECK(same.buffers == file.source->buffers);
}

TEST_CASE("A bind leaf at scale one leaves the skinning as it was") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Edits edits = stretchEdits(file);
  edits.clips.clear();
  const gltf::Loaded result = reopened(folder, patchedOrFail(*file.source, edits));
  CHECK(result.warnings.empty());
  CHECK(result.scene->nodes[firstAdded].isBindLeaf);
  CHECK_FALSE(result.scene->nodes[upper].isBindLeaf);
  CHECK(result.scene->nodes[firstAdded].parent == NodeIndex(upper));
  // The joint stays in the list, behind the slots that vertices name.
  CHECK((*result.source->json)["skins"][0]["joints"] == Json{0, firstAdded, 2, upper});
  CHECK(result.scene->skins[0].joints == std::vector{NodeIndex(0), NodeIndex(upper), NodeIndex(2)});
  REQUIRE(result.scene->bindChains.size() == 1);
  CHECK(result.scene->bindChains[0].leaf == NodeIndex(firstAdded));
  for (const double time : {0.0, 0.3, 0.5, 1.0}) {
    const std::vector<Vec3> before = skinned(file, wave, time);
    const std::vector<Vec3> after = skinned(result, wave, time);
    for (std::size_t i = 0; i < before.size(); ++i) {
      CHECK(glm::length(before[i] - after[i]) < 1e-6);
    }
  }
}

TEST_CASE("Re-keyed tracks replace those of the clip, everything else stays where it was") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  const gltf::Source changed = patchedOrFail(*file.source, stretchEdits(file));
  const gltf::Loaded result = reopened(folder, changed);
  const Clip& clip = result.clips[wave];
  REQUIRE(clip.tracks.size() == 4);
  CHECK(clip.tracks[0]->times == std::vector<float>{0, 1});
  CHECK(clip.tracks[0]->values.back() == 0.8F);
  CHECK(clip.tracks[1]->values == file.clips[wave].tracks[1]->values);
  CHECK(clip.tracks[3]->node == NodeIndex(firstAdded));
  CHECK(clip.tracks[3]->values[3] == 3.0F);
  CHECK(result.clips[1] == file.clips[1]);
  // The source's samplers and bytes are still there, at their places.
  const Json& samplers = (*changed.json)["animations"][0]["samplers"];
  CHECK(samplers.size() == 5);
  CHECK(samplers[0] == (*file.source->json)["animations"][0]["samplers"][0]);
  CHECK(samplers[3]["input"] == samplers[4]["input"]); // equal times are stored once
  CHECK(
      std::equal(file.source->buffers[0].begin(), file.source->buffers[0].end(), changed.buffers[0].begin()));
}

TEST_CASE("An animated node gives up its matrix for translation, rotation and scale") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  constexpr int camera = 5;
  REQUIRE(file.scene->nodes[camera].matrix.has_value());
  gltf::Edits edits;
  edits.clips = {{wave, {turnTrack(NodeIndex(camera))}}};
  const gltf::Loaded result = reopened(folder, patchedOrFail(*file.source, edits));
  CHECK_FALSE(result.scene->nodes[camera].matrix.has_value());
  CHECK(glm::length(result.scene->nodes[camera].rest.translation - Vec3(0, 1, 0)) < 1e-12);
  CHECK(glm::length(result.scene->nodes[camera].rest.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)) < 1e-9);
}

TEST_CASE("Accessors of animation inputs say their bounds, those of outputs none, and no new view is strided "
          "or targeted") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  const Json changed = patchedOrFail(*file.source, stretchEdits(file)).json;
  const Json& input =
      changed["accessors"][changed["animations"][0]["samplers"][3]["input"].get<std::size_t>()];
  CHECK(input["min"] == Json::array({0.0}));
  CHECK(input["max"] == Json::array({1.0}));
  for (const std::size_t added : {3U, 4U}) {
    const Json& output =
        changed["accessors"][changed["animations"][0]["samplers"][added]["output"].get<std::size_t>()];
    CHECK_FALSE((output.contains("min") || output.contains("max")));
  }
  for (std::size_t i = (*file.source->json)["bufferViews"].size(); i < changed["bufferViews"].size(); ++i) {
    CHECK_FALSE(changed["bufferViews"][i].contains("byteStride"));
    CHECK_FALSE(changed["bufferViews"][i].contains("target"));
    CHECK(changed["bufferViews"][i]["byteOffset"].get<std::size_t>() % 4 == 0);
  }
}

TEST_CASE("A rigid mesh moves to its bind leaf") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Edits edits;
  edits.addedNodes = {{"prop_bind", NodeIndex(prop), {}, NodeIndex(prop), true}};
  const gltf::Loaded result = reopened(folder, patchedOrFail(*file.source, edits));
  CHECK_FALSE((*result.source->json)["nodes"][prop].contains("mesh"));
  CHECK((*result.source->json)["nodes"][firstAdded]["mesh"] == 1);
  CHECK(result.scene->nodes[prop].mesh == 1);
}

TEST_CASE("A root that is added stands in the scene that is shown, the first one where the file names none") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["scenes"] = {{{"nodes", {5}}}, {{"nodes", {0}}}};
  glb.json["scene"] = 1;
  std::size_t shown = 1;
  SECTION("the second is named") {}
  SECTION("none is named") {
    glb.json.erase("scene");
    shown = 0;
  }
  const gltf::Loaded file = arm(folder, glb);
  gltf::Edits edits;
  edits.addedNodes = {{"ball", NodeIndex::none, {}, NodeIndex::none, false}};
  const Json scenes = (*patchedOrFail(*file.source, edits).json)["scenes"];
  CHECK(scenes[shown]["nodes"].back() == firstAdded);
  CHECK(scenes[1 - shown] == glb.json["scenes"][1 - shown]);
}

TEST_CASE("What VRM says of a mesh's node follows the mesh") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["extensions"]["VRMC_vrm"] = Json::parse(R"({
    "firstPerson": {"meshAnnotations": [{"node": 4, "type": "both"}, {"node": 3, "type": "auto"}]},
    "expressions": {"preset": {"happy": {"morphTargetBinds": [{"node": 3, "index": 0, "weight": 1}]}}}})");
  const gltf::Loaded file = arm(folder, glb);
  gltf::Edits edits;
  edits.addedNodes = {{"prop_bind", NodeIndex(prop), {}, NodeIndex(prop), true}};
  edits.work = Json{{"scale", 2}};
  const gltf::Source changed = patchedOrFail(*file.source, edits);
  const Json& vrm = (*changed.json)["extensions"]["VRMC_vrm"];
  CHECK(vrm["firstPerson"]["meshAnnotations"][0]["node"] == 4);
  CHECK(vrm["firstPerson"]["meshAnnotations"][1]["node"] == firstAdded);
  CHECK(vrm["expressions"]["preset"]["happy"]["morphTargetBinds"][0]["node"] == firstAdded);
  CHECK(reopened(folder, changed).source->json->dump() == file.source->json->dump());
}

TEST_CASE("Every skin gets inverse bind matrices of its own") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["skins"].push_back(glb.json["skins"][0]);
  glb.json["skins"].push_back({{"joints", {1, 2}}});
  const gltf::Loaded file = arm(folder, glb);
  gltf::Edits edits;
  edits.addedNodes = {{"leaf", NodeIndex(upper), {}, NodeIndex::none, true}};
  const Mat4 matrix(2.0, 0, 0, 0, 0, 3.0, 0, 0, 0, 0, 4.0, 0, 5.0, 6.0, 7.0, 1.0);
  edits.skinSlots = {{0, 1, NodeIndex(firstAdded), matrix}, {2, 0, NodeIndex(firstAdded), matrix}};
  const gltf::Loaded result = reopened(folder, patchedOrFail(*file.source, edits));
  CHECK(result.scene->skins[0].inverseBind[1] == matrix);
  CHECK(result.scene->skins[0].inverseBind[2] == file.scene->skins[0].inverseBind[2]);
  CHECK(result.scene->skins[1].inverseBind == file.scene->skins[1].inverseBind);
  CHECK(result.scene->skins[2].inverseBind == std::vector<Mat4>{matrix, Mat4(1.0)});
}

TEST_CASE("Edits that do not fit the file are refused") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Edits edits;
  std::string unfit = "a track of node 1 in clip " + std::to_string(wave);
  SECTION("parent") {
    unfit = "added node 'leaf'";
    edits.addedNodes = {{"leaf", NodeIndex(6), {}, NodeIndex::none, true}};
  }
  SECTION("slot") {
    unfit = "slot 3 of skin 0";
    edits.skinSlots = {{0, 3, NodeIndex(1), Mat4(1.0)}};
  }
  SECTION("clip") {
    unfit = "clip 2";
    edits.clips = {{2, {}}};
  }
  SECTION("node") {
    unfit = "a track of node 6 in clip " + std::to_string(wave);
    edits.clips = {{wave, {turnTrack(NodeIndex(6))}}};
  }
  SECTION("values") {
    edits.clips = {{wave, {scaleTrack(NodeIndex(1), {0, 1}, {1, 1, 1})}}};
  }
  SECTION("times") {
    edits.clips = {{wave, {scaleTrack(NodeIndex(1), {1, 0}, {1, 1, 1, 1, 1, 1})}}};
  }
  SECTION("not finite") {
    edits.clips = {{wave, {scaleTrack(NodeIndex(1), {0}, {1, std::numeric_limits<float>::infinity(), 1})}}};
  }
  CHECK_THAT(test::refusal(gltf::patched(*file.source, edits)),
             Catch::StartsWith("an edit does not fit the file: " + unfit + ";"));
}

namespace {

// Edits of every kind, as far as the file has what they change.
gltf::Edits randomEdits(const gltf::Loaded& file, std::mt19937& random) {
  gltf::Edits edits;
  const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  const int nodes = static_cast<int>(file.scene->nodes.size());
  const int added = number(4);
  for (int i = 0; i < added; ++i) {
    const bool takesMesh = number(3) == 0;
    edits.addedNodes.push_back({"leaf",
                                NodeIndex(number(nodes + i + 1) - 1),
                                {Vec3(number(5)), Quat(1, 0, 0, 0), Vec3(1)},
                                takesMesh ? NodeIndex(prop) : NodeIndex::none,
                                true});
  }
  if (added > 0 && number(2) == 0) {
    edits.skinSlots = {{0, number(3), NodeIndex(nodes + number(added)), Mat4(1.0)}};
  }
  for (int i = number(4); i > 0; --i) {
    edits.clips.push_back(
        {number(2),
         {turnTrack(NodeIndex(number(nodes + added))),
          scaleTrack(NodeIndex(number(nodes + added)), {0, .25F, 1}, {1, 1, 1, 2, 2, 2, 1, 1, 1})}});
  }
  edits.work = Json{{"seed", random()}, {"text", "ö"}, {"list", {1, 2.5, nullptr}}};
  return edits;
}

void checkRestored(const gltf::Loaded& result, const gltf::Loaded& source, const Json& work) {
  CHECK(result.warnings == source.warnings);
  CHECK(result.savedWork == work);
  CHECK(result.source->json->dump() == source.source->json->dump());
  CHECK(result.source->buffers == source.source->buffers);
  CHECK(result.source->hasBinaryChunk == source.source->hasBinaryChunk);
  CHECK(result.scene->nodes.size() == source.scene->nodes.size());
}

} // namespace

TEST_CASE("A saved file gives its source and the work back, whatever was edited") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    const gltf::Edits edits = randomEdits(file, random);
    const std::string name = round % 2 == 0 ? "out.glb" : "out.gltf";
    const gltf::Source changed = patchedOrFail(*file.source, edits);
    checkRestored(reopened(folder, changed, name), file, edits.work);
  }
}

TEST_CASE("Work saved again and again does not pile up") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  const gltf::Loaded once = reopened(folder, patchedOrFail(*file.source, edits), "out.glb");
  const std::size_t size = test::readBytes(folder / "out.glb").size();
  const gltf::Loaded twice = reopened(folder, patchedOrFail(*once.source, edits), "out.glb");
  CHECK(test::readBytes(folder / "out.glb").size() == size);
  checkRestored(twice, file, edits.work);
}

TEST_CASE("A .gltf with its data in a URI or beside it comes back through a GLB with work in it") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  SECTION("beside") {
    glb.binary.resize(glb.binary.size() + GENERATE(0U, 1U, 2U, 3U), 7); // four need not divide its length
    glb.json["buffers"] = {{{"uri", "data.bin"}, {"name", "kept"}, {"byteLength", glb.binary.size()}}};
    test::writeBytes(folder / "data.bin", glb.binary);
  }
  SECTION("in the URI") {
    const std::string uri = "data:application/octet-stream;base64," + gltf::encodeBase64(glb.binary);
    glb.json["buffers"] = {{{"uri", uri}, {"name", "kept"}, {"byteLength", glb.binary.size()}}};
  }
  const std::string text = glb.json.dump();
  test::writeBytes(folder / "source.gltf", {text.begin(), text.end()});
  const gltf::Loaded file = opened(folder / "source.gltf");
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  const gltf::Source changed = patchedOrFail(*file.source, edits);
  const std::vector<Track>& tracks = edits.clips[0].tracks;
  for (const char* const name : {"out.glb", "out.gltf"}) {
    checkRestored(reopened(folder, changed, name), file, edits.work);
    // What other programs see, without the work.
    Result<gltf::Loaded> shown = gltf::loadAsItStands(folder / name);
    REQUIRE(shown);
    REQUIRE(shown->clips[wave].tracks.size() == 4);
    CHECK(shown->clips[wave].tracks[3]->values == tracks[0].values);
    CHECK(shown->clips[wave].tracks[0]->values == tracks[1].values);
  }
}

TEST_CASE("Data in a URI are stored once in a file with work, not as bytes and as text") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.binary.resize(400000); // text in several pieces
  const std::string text = gltf::encodeBase64(glb.binary);
  const bool isPlain = GENERATE(true, false);
  const std::string type =
      isPlain ? "data:application/octet-stream;base64," : "data:application/gltf-buffer;base64,";
  glb.json["buffers"] = {{{"uri", type + text}, {"byteLength", glb.binary.size()}}};
  const std::string json = glb.json.dump();
  test::writeBytes(folder / "source.gltf", {json.begin(), json.end()});
  const gltf::Loaded file = opened(folder / "source.gltf");
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  const gltf::Loaded again = reopened(folder, patchedOrFail(*file.source, edits), "out.glb");
  CHECK(std::filesystem::file_size(folder / "out.glb") < 2 * json.size() - text.size() / 4);
  CHECK(std::filesystem::file_size(folder / "out.glb") < glb.binary.size() + 20000);
  CHECK((*again.source->json)["buffers"][0]["uri"] == type + text);
}

TEST_CASE("Extras that are there already survive the work") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["extras"] = GENERATE(Json("a text"), Json({{"mine", 1}}), Json(nullptr));
  const gltf::Loaded file = arm(folder, glb);
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  const gltf::Source changed = patchedOrFail(*file.source, edits);
  if (glb.json["extras"].is_object()) {
    CHECK((*changed.json)["extras"]["mine"] == 1);
  } else {
    CHECK((*changed.json)["extras"] == glb.json["extras"]);
  }
  checkRestored(reopened(folder, changed), file, edits.work);
}

TEST_CASE("Work finds a place in the asset's extras where the root's are no object, and is refused where "
          "neither is") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["extras"] = "a text";
  glb.json["asset"]["extras"] = Json({{"mine", 1}});
  const gltf::Loaded file = arm(folder, glb);
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  const gltf::Source changed = patchedOrFail(*file.source, edits);
  CHECK((*changed.json)["asset"]["extras"].contains("stretch_engine"));
  CHECK((*changed.json)["asset"]["extras"]["mine"] == 1);
  checkRestored(reopened(folder, changed), file, edits.work);

  glb.json["asset"]["extras"] = 7;
  const gltf::Loaded closed = arm(folder, glb);
  CHECK(test::refusal(gltf::patched(*closed.source, edits)) ==
        "extras: its extras are no objects, so the work finds no place in it; save without the work (clean)");
  edits.work = {};
  CHECK(gltf::patched(*closed.source, edits));
}

TEST_CASE("A file that another program changed opens as an ordinary one, with a warning") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  gltf::Source changed = patchedOrFail(*file.source, edits);
  SECTION("JSON") {
    (*changed.json)["nodes"][0]["name"] = "renamed";
  }
  SECTION("bytes") {
    changed.buffers[0][0] ^= 1U;
  }
  SECTION("undo broken") {
    const Json step =
        GENERATE(Json({"cut", "/nowhere", 3}), Json({"cut", "/nodes", "3"}), Json({"cut", "/nodes", -1}),
                 Json({"cut", "/nodes", 99}), Json({"cut", "/nodes"}), Json({"cut", "/asset", 0}),
                 Json({"set", "", 3}), Json({"set", "/asset"}), Json({"remove", "/nodes/0"}),
                 Json({"else", "/asset"}), Json("cut"), Json(3));
    (*changed.json)["extras"]["stretch_engine"]["restore"]["steps"][0] = step;
  }
  Json& restore = (*changed.json)["extras"]["stretch_engine"]["restore"];
  SECTION("buffers that are no list") {
    restore["buffers"]["is_array"] = 0.5;
  }
  SECTION("more buffers than the file has") {
    restore["buffers"]["count"] = 2;
    changed.buffers.push_back(changed.buffers[0]);
    (*changed.json)["buffers"].push_back((*changed.json)["buffers"][0]);
    restore["steps"].push_back({"cut", "/buffers", 1});
  }
  SECTION("a list of buffers that its steps take away") {
    restore["steps"].push_back({"remove", "/buffers"});
  }
  const gltf::Loaded result = reopened(folder, changed);
  CHECK(result.savedWork.isNull());
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings[0].find("another program") != std::string::npos);
  CHECK(result.scene->nodes.size() == 7);
  CHECK(result.scene->nodes[firstAdded].isBindLeaf);
}

TEST_CASE("A file with work of another version opens as an ordinary one, with a warning") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  for (const Json& version : {Json(0), Json(2), Json("1"), Json()}) {
    gltf::Source changed = patchedOrFail(*file.source, edits);
    (*changed.json)["extras"]["stretch_engine"]["version"] = version;
    const gltf::Loaded result = reopened(folder, changed);
    CHECK(result.savedWork.isNull());
    CHECK(result.warnings ==
          std::vector<std::string>{"extras: holds work of another version of this program; "
                                   "opened as an ordinary file"});
  }
}

TEST_CASE("A stretched file whose inverse bind matrices are broken is refused, not folded") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Source changed = patchedOrFail(*file.source, stretchEdits(file));
  (*changed.json)["skins"][0]["inverseBindMatrices"] = 0; // positions
  REQUIRE(gltf::save(changed, folder / "out.glb"));
  const std::vector<gltf::Problem> problems = gltf::diagnose(folder / "out.glb").problems;
  CHECK(std::ranges::count(problems, "skins[0].inverseBindMatrices", &gltf::Problem::where) == 1);
}

TEST_CASE("A program that only reorders keys and respells numbers does not cost the work") {
  const TemporaryFolder folder;
  const gltf::Loaded file = arm(folder);
  gltf::Edits edits = stretchEdits(file);
  edits.work = Json{{"scale", 2}};
  gltf::Source changed = patchedOrFail(*file.source, edits);
  changed.json = Json::parse(nlohmann::json::parse(changed.json->dump()).dump()); // sorted keys
  const gltf::Loaded result = reopened(folder, changed);
  CHECK(result.savedWork == edits.work);
  CHECK(result.source->json == Json::parse(nlohmann::json::parse(file.source->json->dump()).dump()));
}

TEST_CASE("A node that gives up its matrix keeps its scale, whether it is keyed or moved") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  constexpr int camera = 5;
  glb.json["nodes"][camera]["matrix"] = {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 0, 1, 0, 1};
  const gltf::Loaded file = arm(folder, glb);
  gltf::Edits edits;
  SECTION("keyed by a turn") {
    edits.clips = {{wave, {turnTrack(NodeIndex(camera))}}};
  }
  SECTION("keyed by a scale") {
    edits.clips = {{wave, {scaleTrack(NodeIndex(camera), {0, 1}, {1, 1, 1, 3, 1, 1})}}};
  }
  SECTION("moved") {
    edits.movedNodes = {{NodeIndex(camera), file.scene->nodes[camera].rest}};
  }
  const gltf::Loaded result = reopened(folder, patchedOrFail(*file.source, edits));
  const Node& node = result.scene->nodes[camera];
  CHECK_FALSE(node.matrix.has_value());
  CHECK(glm::length(node.rest.scale - Vec3(2, 3, 4)) < 1e-6);
  CHECK(glm::length(node.rest.translation - Vec3(0, 1, 0)) < 1e-9);
  CHECK(glm::length(node.rest.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)) < 1e-6);
}

TEST_CASE("Channels of morph weights follow a mesh to its leaf, by node or by pointer, others stay") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  Json& primitive = glb.json["meshes"][1]["primitives"][0];
  primitive["targets"] = {{{"POSITION", primitive["attributes"]["POSITION"]}}};
  glb.json["nodes"][prop]["weights"] = {0.25};
  Json& animation = glb.json["animations"][0];
  const int weights = glb.floats({0.0F, 1.0F, 0.5F}, "SCALAR", 1);
  animation["samplers"].push_back({{"input", animation["samplers"][0]["input"]}, {"output", weights}});
  const std::size_t sampler = animation["samplers"].size() - 1;
  const auto pointer = [](int node) {
    return Json{{"path", "pointer"},
                {"extensions",
                 {{"KHR_animation_pointer", {{"pointer", "/nodes/" + std::to_string(node) + "/weights"}}}}}};
  };
  const std::size_t first = animation["channels"].size();
  animation["channels"].push_back({{"sampler", sampler}, {"target", pointer(prop)}});
  glb.json["animations"][1]["channels"].push_back(
      {{"sampler", 0}, {"target", {{"node", prop}, {"path", "translation"}}}});
  glb.json["animations"].push_back(
      {{"samplers", {{{"input", animation["samplers"][0]["input"]}, {"output", weights}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", prop}, {"path", "weights"}}}}}}});
  glb.json["animations"][1]["channels"].erase(1);
  glb.json["extensionsUsed"].push_back("KHR_animation_pointer");
  const gltf::Loaded file = arm(folder, glb);
  gltf::Edits edits;
  edits.addedNodes = {{"prop_bind", NodeIndex(prop), {}, NodeIndex(prop), true}};
  const Json changed = patchedOrFail(*file.source, edits).json;
  CHECK(changed["animations"][0]["channels"][first]["target"] == pointer(firstAdded));
  CHECK(changed["animations"][2]["channels"][0]["target"] ==
        Json({{"node", firstAdded}, {"path", "weights"}}));
  CHECK(changed["nodes"][firstAdded]["weights"] == Json::array({0.25}));
  CHECK_FALSE(changed["nodes"][prop].contains("weights"));
  CHECK(changed["animations"][0]["channels"][0]["target"]["node"] == lower);
}
