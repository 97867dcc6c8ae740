#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/gltf/import/accessor.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/added_skeleton.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;
using test::TemporaryFolder;

namespace {

constexpr int left = 2;
constexpr int right = 3;

// One mesh that two nodes show, the second one mirrored, under a node that scales to a tenth: two primitives
// over one list of positions, a third without indices with a morph target, and points.
GlbBuilder twoSleeves() {
  GlbBuilder glb;
  glb.json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
  const int positions = glb.floats({0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0}, "VEC3", 3);
  const int others = glb.floats({0, 0, 0, 1, 0, 0, 1, 2, 0}, "VEC3", 3);
  for (const int accessor : {positions, others}) {
    glb.json["accessors"][static_cast<std::size_t>(accessor)]["min"] = {0, 0, 0};
    glb.json["accessors"][static_cast<std::size_t>(accessor)]["max"] = {1, 2, 0};
  }
  const int first = glb.accessor(std::vector<std::uint16_t>{0, 1, 2}, 5123, "SCALAR", 1);
  const int second = glb.accessor(std::vector<std::uint16_t>{0, 2, 3}, 5123, "SCALAR", 1);
  const Json onPositions{{"POSITION", positions}};
  glb.json["meshes"] = {
      {{"name", "sleeve"},
       {"weights", {0.25}},
       {"primitives",
        {{{"attributes", onPositions}, {"indices", first}, {"targets", {onPositions}}},
         {{"attributes", onPositions}, {"indices", second}, {"targets", {onPositions}}},
         {{"attributes", onPositions}, {"mode", 0}, {"targets", {onPositions}}},
         {{"attributes", {{"POSITION", others}}}, {"targets", {{{"POSITION", others}}}}}}}}};
  glb.json["nodes"] = {{{"name", "model"}, {"scale", {0.1, 0.1, 0.1}}, {"children", {1}}},
                       {{"name", "group"}, {"rotation", {0, 1, 0, 0}}, {"children", {left, right}}},
                       {{"name", "left"}, {"mesh", 0}, {"translation", {1, 0, 0}}},
                       {{"name", "right"}, {"mesh", 0}, {"translation", {-1, 0, 0}}, {"scale", {-1, 1, 1}}}};
  return glb;
}

std::vector<gltf::SkeletonJoint> column() {
  return {{"hips", -1, Vec3(0.0), Quat(1, 0, 0, 0)},
          {"spine", 0, Vec3(0.0, 0.1, 0.02), glm::angleAxis(0.4, Vec3(0, 0, 1))}};
}

VertexInfluences both(float ofFirst) {
  VertexInfluences vertex;
  vertex.joints = {0, 1};
  vertex.weights = {ofFirst, 1.0F - ofFirst};
  return vertex;
}

std::vector<std::vector<VertexInfluences>> influences() {
  const std::vector<VertexInfluences> sheet{both(1), both(0.75F), both(0.5F), both(0)};
  return {sheet, sheet, {both(1), both(0.75F), both(0.5F)}};
}

// Both sleeves bound to a new skeleton; each has a skin of its own, since they stand elsewhere.
gltf::Edits boundSleeves(const Scene& scene, bool isRightBound = true) {
  const NodeIndex carrier = gltf::carrierOfSkeleton(scene, {NodeIndex(left), NodeIndex(right)});
  gltf::Edits edits;
  edits.addedNodes = gltf::skeletonNodes(scene, column(), carrier);
  const std::vector<Mat4> joints = gltf::skeletonWorlds(scene, column(), carrier);
  const std::vector<Mat4> worlds = frameOf(scene, restPose(scene), 0.0).worlds;
  for (const int node : {left, right}) {
    if (node == right && !isRightBound) {
      continue;
    }
    gltf::AddedSkin skin;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      skin.joints.emplace_back(scene.nodes.size() + i);
      skin.inverseBind.push_back(glm::inverse(joints[i]) * worlds[at(node)]);
    }
    edits.boundMeshes.push_back({NodeIndex(node), static_cast<int>(edits.addedSkins.size()), influences()});
    edits.addedSkins.push_back(std::move(skin));
  }
  return edits;
}

gltf::Loaded bound(const TemporaryFolder& folder, const gltf::Loaded& file, const gltf::Edits& edits,
                   const std::string& name = "bound.glb") {
  const Result<gltf::Source> changed = gltf::patched(*file.source, edits);
  if (!changed) {
    FAIL(changed.error().line());
  }
  REQUIRE(gltf::save(*changed, folder / name).ok());
  Result<gltf::Loaded> result = gltf::load(folder / name);
  if (!result) {
    FAIL(result.error().line());
  }
  return std::move(result).value();
}

// The largest distance of a vertex of the node's mesh from where it was drawn before it was bound.
double largestMove(const gltf::Loaded& before, const gltf::Loaded& after, int node) {
  const FrameState frame = frameOf(*after.scene, restPose(*after.scene), 0.0);
  const FrameState was = frameOf(*before.scene, restPose(*before.scene), 0.0);
  const Node& shown = after.scene->nodes[at(node)];
  const std::vector<Mat4> matrices = skinMatrices(after.scene->skins[at(shown.skin)], frame);
  double largest = 0.0;
  for (const Primitive& primitive : after.scene->meshes[at(shown.mesh)].primitives) {
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
      const Vec3 position(primitive.positions[i]);
      const VertexInfluences& follows = primitive.influences[i];
      Vec3 now(0.0);
      for (std::size_t k = 0; k < VertexInfluences::capacity; ++k) {
        now +=
            static_cast<double>(follows.weights[k]) * transformPoint(matrices[follows.joints[k]], position);
      }
      largest = std::max(largest, glm::distance(now, transformPoint(was.worlds[at(node)], position)));
    }
  }
  return largest;
}

} // namespace

TEST_CASE("A bound mesh stands where it stood, under scaled, turned and mirrored nodes") {
  const TemporaryFolder folder;
  const gltf::Loaded file = test::loaded(twoSleeves());
  for (const char* name : {"bound.glb", "bound.gltf"}) {
    const gltf::Loaded result = bound(folder, file, boundSleeves(*file.scene), name);
    CHECK(result.warnings.size() == file.warnings.size());
    CHECK(largestMove(file, result, left) < 1e-7);
    CHECK(largestMove(file, result, right) < 1e-7);
    const Node& spine = result.scene->nodes[5];
    CHECK(spine.name == "spine");
    CHECK(spine.parent == NodeIndex(4));
    CHECK(spine.rest.scale == Vec3(1.0));
    CHECK(result.scene->nodes[4].parent == NodeIndex(1)); // of both meshes: it carries the skeleton too
    const Vec3 place(frameOf(*result.scene, restPose(*result.scene), 0.0).worlds[5][3]);
    CHECK(glm::distance(place, Vec3(0.0, 0.1, 0.02)) < 1e-12);
  }
}

TEST_CASE("A skeleton hangs on no node that would shear or mirror it") {
  const TemporaryFolder folder;
  GlbBuilder glb = twoSleeves();
  glb.json["nodes"][1]["scale"] = {1, 2, 1};
  const gltf::Loaded file = test::loaded(glb);
  CHECK(gltf::carrierOfSkeleton(*file.scene, {NodeIndex(left), NodeIndex(right)}) == NodeIndex(0));
  CHECK(gltf::carrierOfSkeleton(*file.scene, {NodeIndex(left)}) == NodeIndex(0));
  CHECK(largestMove(file, bound(folder, file, boundSleeves(*file.scene)), right) < 1e-7);
}

TEST_CASE("Binding appends and renumbers nothing") {
  const TemporaryFolder folder;
  const gltf::Loaded file = test::loaded(twoSleeves());
  const Json before = file.source->json;
  const gltf::Loaded result = bound(folder, file, boundSleeves(*file.scene));
  const Json after = result.source->json;
  for (const char* list : {"accessors", "bufferViews"}) {
    for (std::size_t i = 0; i < before[list].size(); ++i) {
      CHECK(after[list][i] == before[list][i]);
    }
  }
  CHECK(std::equal(file.source->buffers[0].begin(), file.source->buffers[0].end(),
                   result.source->buffers[0].begin()));
  CHECK(after["meshes"][0]["weights"] == before["meshes"][0]["weights"]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& primitive = after["meshes"][0]["primitives"][i];
    CHECK(primitive["attributes"]["POSITION"] ==
          before["meshes"][0]["primitives"][i]["attributes"]["POSITION"]);
    CHECK(primitive["targets"] == before["meshes"][0]["primitives"][i]["targets"]);
  }
}

TEST_CASE("Primitives that share their vertices share what those follow, and points at places of their own "
          "follow the first joint") {
  const TemporaryFolder folder;
  GlbBuilder glb = twoSleeves();
  const bool own = GENERATE(false, true);
  if (own) {
    const int places = glb.floats({0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0}, "VEC3", 3);
    Json& accessor = glb.json["accessors"][static_cast<std::size_t>(places)];
    accessor["min"] = {0, 0, 0};
    accessor["max"] = {1, 2, 0};
    glb.json["meshes"][0]["primitives"][2]["attributes"]["POSITION"] = places;
  }
  const gltf::Loaded file = test::loaded(glb);
  const Json primitives =
      (*bound(folder, file, boundSleeves(*file.scene)).source->json)["meshes"][0]["primitives"];
  CHECK(primitives[0]["attributes"] == primitives[1]["attributes"]);
  CHECK((primitives[2]["attributes"] == primitives[0]["attributes"]) == !own);
  CHECK((primitives[2]["attributes"]["WEIGHTS_0"] == primitives[0]["attributes"]["WEIGHTS_0"]) == !own);
  CHECK(primitives[3]["attributes"]["WEIGHTS_0"] != primitives[0]["attributes"]["WEIGHTS_0"]);
}

TEST_CASE("A mesh that another node shows unbound is left to it") {
  const TemporaryFolder folder;
  const gltf::Loaded file = test::loaded(twoSleeves());
  const gltf::Loaded result = bound(folder, file, boundSleeves(*file.scene, false));
  const Json& json = result.source->json;
  CHECK(json["meshes"].size() == 2);
  CHECK(json["meshes"][0] == (*file.source->json)["meshes"][0]);
  CHECK(json["nodes"][right] == (*file.source->json)["nodes"][right]);
  CHECK(json["nodes"][left]["mesh"] == 1);
  CHECK(largestMove(file, result, left) < 1e-7);
}

TEST_CASE("A mesh that was bound follows the new weights alone") {
  const TemporaryFolder folder;
  GlbBuilder arm = test::armBuilder();
  Json& attributes = arm.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_1"] = attributes["JOINTS_0"];
  attributes["WEIGHTS_1"] = attributes["WEIGHTS_0"];
  const gltf::Loaded file = test::loaded(arm);
  gltf::Edits edits;
  VertexInfluences last;
  last.joints[0] = 2;
  last.weights[0] = 1.0F;
  edits.boundMeshes = {{NodeIndex(4), 0, {std::vector<VertexInfluences>(6, last)}}};
  const gltf::Loaded result = bound(folder, file, edits);
  CHECK_FALSE((*result.source->json)["meshes"][0]["primitives"][0]["attributes"].contains("WEIGHTS_1"));
  for (const VertexInfluences& vertex : result.scene->meshes[0].primitives[0].influences) {
    CHECK(vertex.joints[0] == 2);
    CHECK(vertex.weights[0] == 1.0F);
  }
}

TEST_CASE("A mesh that moves to an added node is bound there, and stands where it stood") {
  const TemporaryFolder folder;
  const gltf::Loaded file = test::loaded(twoSleeves());
  gltf::Edits edits = boundSleeves(*file.scene);
  const NodeIndex holder(file.scene->nodes.size() + edits.addedNodes.size());
  gltf::AddedNode& added = edits.addedNodes.emplace_back();
  added.name = "holder";
  added.meshFrom = NodeIndex(left);
  edits.boundMeshes[0].node = holder;
  const gltf::Loaded result = bound(folder, file, edits);
  CHECK(result.scene->nodes[left].mesh == -1);
  REQUIRE(result.scene->nodes[at(holder)].mesh >= 0);
  CHECK(result.scene->nodes[at(holder)].skin >= 0);
  const FrameState was = frameOf(*file.scene, restPose(*file.scene), 0.0);
  const FrameState now = frameOf(*result.scene, restPose(*result.scene), 0.0);
  const std::vector<Mat4> matrices =
      skinMatrices(result.scene->skins[at(result.scene->nodes[at(holder)].skin)], now);
  const Primitive& sleeve = result.scene->meshes[at(result.scene->nodes[at(holder)].mesh)].primitives.front();
  for (std::size_t i = 0; i < sleeve.positions.size(); ++i) {
    const Vec3 place(sleeve.positions[i]);
    const std::size_t slot = sleeve.influences[i].joints[0];
    CHECK(glm::distance(transformPoint(matrices[slot], place), transformPoint(was.worlds[left], place)) <
          1e-6);
  }
  edits.boundMeshes[0].influences[0].pop_back();
  const Result<gltf::Source> unfit = gltf::patched(*file.source, edits);
  REQUIRE_FALSE(unfit);
  CHECK_THAT(unfit.error().line(), Catch::Contains("the binding of node " + std::to_string(holder.value)));
}

TEST_CASE("A binding that does not fit the file is refused with the part that does not fit") {
  const gltf::Loaded file = test::loaded(twoSleeves());
  gltf::Edits edits = boundSleeves(*file.scene);
  const std::string first = std::to_string(edits.boundMeshes[0].node.value);
  const std::string second = std::to_string(edits.boundMeshes[1].node.value);
  std::string unfit = "the binding of node " + first;
  SECTION("a vertex too few") {
    edits.boundMeshes[0].influences[0].pop_back();
  }
  SECTION("a primitive too few") {
    edits.boundMeshes[0].influences.pop_back();
  }
  SECTION("a primitive too many") {
    edits.boundMeshes[0].influences.push_back(edits.boundMeshes[0].influences.back());
  }
  SECTION("a joint that the skin lacks") {
    edits.boundMeshes[1].influences[2][0].joints[3] = 2;
    unfit = "the binding of node " + second;
  }
  SECTION("a weight that is no number") {
    edits.boundMeshes[1].influences[0][0].weights[3] = std::numeric_limits<float>::quiet_NaN();
    unfit = "the binding of node " + second;
  }
  SECTION("a node without a mesh") {
    edits.boundMeshes[0].node = NodeIndex(0);
    unfit = "the binding of node 0";
  }
  SECTION("a skin that is not there") {
    edits.boundMeshes[0].skin = 2;
  }
  SECTION("a matrix too few") {
    edits.addedSkins[0].inverseBind.pop_back();
    unfit = "added skin '" + edits.addedSkins[0].name + "'";
  }
  SECTION("a joint of a skin that the file lacks") {
    edits.addedSkins[0].joints.back() = NodeIndex(file.scene->nodes.size() + edits.addedNodes.size());
    unfit = "added skin '" + edits.addedSkins[0].name + "'";
  }
  const auto refused = gltf::patched(*file.source, edits);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().what == "an edit does not fit the file: " + unfit);
}

TEST_CASE("A skeleton is taken out again of a file without scenes, and nothing is put in") {
  gltf::Json json =
      gltf::Json::parse(R"({"nodes":[{"children":[1]},{"name":"hips"}],"skins":[{"joints":[1]}]})");
  gltf::takeOutSkeleton(1, json);
  CHECK(json.dump() == R"({"nodes":[{}]})");
}

TEST_CASE("What a file had beside a skeleton stays when that is taken out") {
  gltf::Json json =
      gltf::Json::parse(R"({"nodes":[{"children":[1,2]},{},{"name":"hips"}],)"
                        R"("scenes":[{"nodes":[0,2]}],"skins":[{"joints":[1]},{"joints":[2]}]})");
  gltf::takeOutSkeleton(2, json);
  CHECK(json == gltf::Json::parse(R"({"nodes":[{"children":[1]},{}],"scenes":[{"nodes":[0]}],)"
                                  R"("skins":[{"joints":[1]}]})"));
}

TEST_CASE("Joints that hang on nothing stand in every scene that shows the mesh which they move") {
  const TemporaryFolder folder;
  GlbBuilder glb = twoSleeves();
  glb.json["nodes"].push_back({{"name", "lamp"}});
  const bool areThree = GENERATE(true, false);
  glb.json["scenes"] = Json::parse(areThree ? R"([{"nodes":[0]},{"nodes":[4]},{"nodes":[4,0]}])"
                                            : R"([{"nodes":[4]},{"nodes":[0]}])");
  const gltf::Loaded file = test::loaded(glb);
  const std::vector<Mat4> worlds = frameOf(*file.scene, restPose(*file.scene), 0.0).worlds;
  const std::vector<Mat4> joints = gltf::skeletonWorlds(*file.scene, column(), NodeIndex::none);
  gltf::Edits edits;
  edits.addedNodes = gltf::skeletonNodes(*file.scene, column(), NodeIndex::none);
  gltf::AddedSkin skin;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    skin.joints.emplace_back(file.scene->nodes.size() + i);
    skin.inverseBind.push_back(glm::inverse(joints[i]) * worlds[at(left)]);
  }
  edits.addedSkins = {skin};
  edits.boundMeshes = {{NodeIndex(left), 0, influences()}};
  const gltf::Loaded after = bound(folder, file, edits);
  // The first scene is the one that is shown: new roots are there anyway.
  CHECK(after.source->json->at("scenes") ==
        Json::parse(areThree ? R"([{"nodes":[0,5]},{"nodes":[4]},{"nodes":[4,0,5]}])"
                             : R"([{"nodes":[4,5]},{"nodes":[0,5]}])"));
}

TEST_CASE(
    "Parts of a mesh over the same places follow each what it is bound by, be it other joints or shares") {
  const bool haveOtherJoints = GENERATE(true, false);
  CAPTURE(haveOtherJoints);
  const TemporaryFolder folder;
  const gltf::Loaded file = test::loaded(twoSleeves());
  gltf::Edits edits = boundSleeves(*file.scene);
  VertexInfluences other = both(haveOtherJoints ? 0.75F : 0.25F);
  if (haveOtherJoints) {
    std::swap(other.joints[0], other.joints[1]);
  }
  for (gltf::BoundMesh& mesh : edits.boundMeshes) {
    mesh.influences[0].assign(4, both(0.75F));
    mesh.influences[1].assign(4, other);
  }
  const gltf::Loaded result = bound(folder, file, edits);
  for (const Mesh& mesh : result.scene->meshes) {
    REQUIRE(mesh.primitives.size() == 3);
    for (const VertexInfluences& vertex : mesh.primitives[0].influences) {
      CHECK(vertex.joints == both(0.75F).joints);
      CHECK(vertex.weights == both(0.75F).weights);
    }
    for (const VertexInfluences& vertex : mesh.primitives[1].influences) {
      CHECK(vertex.joints == other.joints);
      CHECK(vertex.weights == other.weights);
    }
  }
}

TEST_CASE(
    "What a vertex does not follow is written as the first joint, and weights that nothing names any more "
    "are emptied") {
  const auto [areNamedElsewhere, namedAt] =
      GENERATE(table<bool, const char*>({{true, "/meshes/1/primitives/0/attributes/WEIGHTS_0"},
                                         {true, "/meshes/0/extensions/VENDOR_groups/attributes/W"},
                                         {true, "/meshes/1/primitives/0/extensions/VENDOR_groups/W"},
                                         {false, ""}}));
  CAPTURE(areNamedElsewhere, namedAt);
  const TemporaryFolder folder;
  GlbBuilder arm = test::armBuilder();
  const Json before = arm.json["meshes"][0]["primitives"][0]["attributes"];
  if (areNamedElsewhere) {
    arm.json[Json::json_pointer(namedAt)] = before["WEIGHTS_0"];
  }
  const gltf::Loaded file = test::loaded(arm);
  VertexInfluences last;
  last.joints = {2, 1};
  last.weights = {1.0F, 0.0F};
  gltf::Edits edits;
  edits.boundMeshes = {{NodeIndex(4), 0, {std::vector<VertexInfluences>(6, last)}}};
  const gltf::Loaded result = bound(folder, file, edits);
  const Json& json = result.source->json;
  const int joints = json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"].get<int>();
  const std::vector<std::uint32_t> numbers = gltf::readIntegers(*result.source, joints);
  REQUIRE(numbers.size() == 24);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    CHECK(numbers[i] == (i % 4 == 0 ? 2U : 0U));
  }
  CHECK(json["accessors"][before["WEIGHTS_0"].get<std::size_t>()].contains("bufferView") ==
        areNamedElsewhere);
  CHECK(json["accessors"][before["JOINTS_0"].get<std::size_t>()].contains("bufferView"));
}
