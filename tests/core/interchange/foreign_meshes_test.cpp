#include <algorithm>
#include <limits>

#include <catch2/catch.hpp>

#include "tests/support/core/foreign_scene.h"

using namespace stretch;
using gltf::Json;
using test::ForeignScene;
using test::MadeOfForeign;

namespace {

const std::vector<Vec3> corners{Vec3(0.0), Vec3(2.0, 0.0, 0.0), Vec3(0.0, 3.0, 0.0)};
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

/// A scene with a node "body" that shows the triangle "skin".
struct Body {
  Body() : mesh(scene.addTriangle("skin", corners)), node(scene.addNode(scene.root(), "body")) {
    scene.show(node, 0);
  }

  ForeignScene scene;
  aiMesh& mesh;
  aiNode& node;
};

const Primitive& firstOf(const MadeOfForeign& made) {
  return made.file.scene->meshes.at(0).primitives.at(0);
}

aiVector3D* vectors(const std::vector<aiVector3D>& from) {
  auto all = std::make_unique<aiVector3D[]>(from.size());
  std::ranges::copy(from, all.get());
  return all.release();
}

/// Weights of a vertex by the names of the joints.
std::map<std::string, float> weightsOf(const MadeOfForeign& made, std::size_t vertex, std::size_t mesh = 0) {
  const Scene& scene = *made.file.scene;
  std::map<std::string, float> found;
  const VertexInfluences& influences = scene.meshes.at(mesh).primitives.at(0).influences.at(vertex);
  const auto holder = std::ranges::find(scene.nodes, static_cast<int>(mesh), &Node::mesh);
  const Skin& skin = scene.skins.at(static_cast<std::size_t>(holder->skin));
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    if (influences.weights[i] > 0.0F) {
      found[scene.nodes[at(skin.joints.at(influences.joints[i]))].name] += influences.weights[i];
    }
  }
  return found;
}

} // namespace

TEST_CASE("A foreign mesh comes with its places, normals, colours and every set of texture coordinates") {
  Body body;
  body.mesh.mNormals = vectors({{0, 0, 2}, {0, 0, 0}, {notANumber, 0, 0}});
  body.mesh.mTextureCoords[0] = vectors({{0.25F, 0.5F, 7}, {1, 0, 7}, {notANumber, 1, 7}});
  body.mesh.mTextureCoords[1] = vectors({{0.75F, 0.125F, 0}, {0, 0, 0}, {0, 0, 0}});
  auto colours = std::make_unique<aiColor4D[]>(3);
  colours[0] = {0.5F, 0.25F, 0.125F, 1.0F};
  colours[1] = {notANumber, 1.0F, 1.0F, 1.0F};
  body.mesh.mColors[0] = colours.release();
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  const Primitive& skin = firstOf(made);
  CHECK(skin.positions == std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}});
  // Of unit length; one that has no direction points up.
  CHECK(skin.normals == std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {0, 1, 0}});
  CHECK(skin.colors == std::vector<glm::vec4>{{0.5F, 0.25F, 0.125F, 1}, {0, 1, 1, 1}, {0, 0, 0, 0}});
  CHECK(skin.indices == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(made.file.scene->meshes[0].name == "skin");
  CHECK(made.file.scene->nodes[0].mesh == 0);
  CHECK(made.file.scene->nodes[0].skin == -1);
  CHECK(made.meshes.nodeOfMesh == std::vector<int>{0});
  const Json& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
  CHECK(attributes.contains("TEXCOORD_1"));
  CHECK_FALSE(attributes.contains("TEXCOORD_2"));
  const Json& places = made.json["accessors"][attributes["POSITION"].get<std::size_t>()];
  CHECK(places["min"] == Json{0, 0, 0});
  CHECK(places["max"] == Json{2, 3, 0});
  CHECK(places["count"] == 3);
  const auto pairAt = [&](const char* name, std::size_t number) {
    const Json& accessor = made.json["accessors"][attributes[name].get<std::size_t>()];
    const Json& view = made.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    float value = 0.0F;
    std::memcpy(&value,
                made.file.source->buffers[0].data() + view["byteOffset"].get<std::size_t>() + 4 * number, 4);
    return value;
  };
  CHECK(pairAt("TEXCOORD_0", 0) == 0.25F);
  CHECK(pairAt("TEXCOORD_0", 1) == 0.5F);
  CHECK(pairAt("TEXCOORD_0", 2) == 1.0F);
  CHECK(pairAt("TEXCOORD_0", 4) == 0.0F); // no number
  CHECK(pairAt("TEXCOORD_0", 5) == 1.0F);
  CHECK(pairAt("TEXCOORD_1", 0) == 0.75F);
  CHECK(pairAt("TEXCOORD_1", 1) == 0.125F);
}

TEST_CASE("Bounds of a foreign mesh are the least and the greatest of its places, wherever these come") {
  std::vector<Vec3> places{Vec3(2.0, -1.0, 0.0), Vec3(-3.0, 4.0, 1.0), Vec3(0.0, 0.5, -5.0)};
  std::rotate(places.begin(), places.begin() + GENERATE(0, 1, 2), places.end());
  ForeignScene scene;
  scene.addTriangle("skin", places);
  scene.show(scene.addNode(scene.root(), "body"), 0);
  const MadeOfForeign made = test::madeOfForeign(scene);
  const Json& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
  const Json& accessor = made.json["accessors"][attributes["POSITION"].get<std::size_t>()];
  CHECK(accessor["min"] == Json{-3, -1, -5});
  CHECK(accessor["max"] == Json{2, 4, 1});
}

TEST_CASE("A face that is no triangle, or names a vertex that is not there, is left out") {
  Body body;
  auto faces = std::make_unique<aiFace[]>(3);
  const auto setFace = [&](std::size_t face, const std::vector<unsigned>& indices) {
    faces[face].mNumIndices = static_cast<unsigned>(indices.size());
    auto all = std::make_unique<unsigned[]>(indices.size());
    std::ranges::copy(indices, all.get());
    faces[face].mIndices = all.release();
  };
  setFace(0, {0, 1});
  setFace(1, {0, 1, 3});
  setFace(2, {2, 1, 0});
  const std::unique_ptr<aiFace[]> before(body.mesh.mFaces);
  body.mesh.mFaces = faces.release();
  body.mesh.mNumFaces = 3;
  CHECK(firstOf(test::madeOfForeign(body.scene)).indices == std::vector<std::uint32_t>{2, 1, 0});
}

TEST_CASE("Morph targets are differences from the mesh, named, with their weights at rest") {
  Body body;
  body.mesh.mNormals = vectors({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  aiAnimMesh& smile = body.scene.addTarget(body.mesh, "smile",
                                           {Vec3(0.0, 0.0, 1.0), Vec3(2.0, 5.0, 0.0), Vec3(-1.0, 3.0, 0.0)});
  smile.mNormals = vectors({{0, 1, 0}, {0, 0, 1}, {0, 0, 1}});
  smile.mWeight = 0.25F;
  aiAnimMesh& other = body.scene.addTarget(body.mesh, "of another mesh", {Vec3(9.0)});
  other.mWeight = notANumber;
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  const Primitive& skin = firstOf(made);
  REQUIRE(skin.morphTargets.size() == 2);
  CHECK(skin.morphTargets[0].positions == std::vector<glm::vec3>{{0, 0, 1}, {0, 5, 0}, {-1, 0, 0}});
  CHECK(skin.morphTargets[0].normals == std::vector<glm::vec3>{{0, 1, -1}, {0, 0, 0}, {0, 0, 0}});
  CHECK(skin.morphTargets[1].positions == std::vector<glm::vec3>(3, glm::vec3(0.0F)));
  CHECK(made.file.scene->meshes[0].morphWeights == std::vector<float>{0.25F, 0.0F});
  CHECK(made.json["meshes"][0]["extras"]["targetNames"] == Json{"smile", "of another mesh"});
}

TEST_CASE("A mesh without bones that two nodes show is written once") {
  Body body;
  body.scene.show(body.scene.addNode(body.scene.root(), "second"), 0);
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  CHECK(made.file.scene->meshes.size() == 1);
  CHECK(made.file.scene->nodes[0].mesh == 0);
  CHECK(made.file.scene->nodes[1].mesh == 0);
  CHECK(made.meshes.nodeOfMesh == std::vector<int>{0}); // the first that shows it
}

TEST_CASE("A mesh without a vertex or a face is no mesh") {
  Body body;
  body.mesh.mNumFaces = 0;
  aiMesh& empty = body.scene.addTriangle("empty", corners);
  empty.mNumVertices = 0;
  body.scene.show(body.node, 1);
  body.scene.addTriangle("shown", corners);
  body.scene.show(body.node, 2);
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  REQUIRE(made.file.scene->meshes.size() == 1);
  CHECK(made.file.scene->meshes[0].name == "shown");
  CHECK(made.file.scene->meshes[0].primitives.size() == 1);
  CHECK(made.meshes.nodeOfMesh == std::vector<int>{-1, -1, 0});
  body.mesh.mNumFaces = 1;
  empty.mNumVertices = 3;
}

TEST_CASE("Meshes of one node are parts of one mesh, each with its material") {
  Body body;
  body.scene.addTriangle("hair", {Vec3(0.0), Vec3(0.0, 0.0, 4.0), Vec3(0.0, 5.0, 0.0)}).mMaterialIndex = 1;
  body.scene.show(body.node, 1);
  body.scene.addMaterial("cloth");
  body.scene.addMaterial("brown");
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  REQUIRE(made.file.scene->meshes.size() == 1);
  REQUIRE(made.file.scene->meshes[0].primitives.size() == 2);
  CHECK(made.file.scene->meshes[0].primitives[0].material == 0);
  CHECK(made.file.scene->meshes[0].primitives[1].material == 1);
  CHECK(made.file.scene->meshes[0].primitives[1].positions[1] == glm::vec3(0, 0, 4));
  CHECK(made.meshes.nodeOfMesh == std::vector<int>{0, 0});
  // A material that is not there is none.
  body.mesh.mMaterialIndex = 7;
  CHECK(test::madeOfForeign(body.scene).file.scene->meshes[0].primitives[0].material == -1);
}

TEST_CASE("Vertices follow the bones that move them, in shares of one, and the mesh where none does") {
  Body body;
  body.scene.addNode(body.scene.root(), "upper");
  body.scene.addNode(body.scene.root(), "lower");
  const Mat4 back = toMatrix({Vec3(0.0, -2.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  body.scene.addBone(body.mesh, "upper", {{0, 3.0F}, {1, 0.0F}, {9, 1.0F}, {2, notANumber}}, back);
  body.scene.addBone(body.mesh, "lower", {{0, 1.0F}, {1, 0.5F}, {2, -1.0F}});
  body.scene.addBone(body.mesh, "nobody", {{2, 1.0F}});
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  CHECK(weightsOf(made, 0) == std::map<std::string, float>{{"upper", 0.75F}, {"lower", 0.25F}});
  CHECK(weightsOf(made, 1) == std::map<std::string, float>{{"lower", 1.0F}});
  CHECK(weightsOf(made, 2) == std::map<std::string, float>{{"body without weights", 1.0F}});
  CHECK(made.meshes.lostBones == 1);
  CHECK(made.meshes.unweightedVertices == 1);
  const Skin& skin = made.file.scene->skins.at(0);
  REQUIRE(skin.joints.size() == 3);
  CHECK(skin.inverseBind[0] == back);
  CHECK(skin.inverseBind[1] == Mat4(1.0));
  CHECK(skin.inverseBind[2] == Mat4(1.0));
  // The joint of those without a bone hangs at their mesh.
  CHECK(made.file.scene->nodes[at(skin.joints[2])].parent == NodeIndex(0));
  const Json& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
  CHECK(attributes.contains("WEIGHTS_0"));
  CHECK_FALSE(attributes.contains("WEIGHTS_1")); // nobody needs a second four
}

TEST_CASE(
    "Vertices that no bone moves hang under the root of their mesh, which may be another than the bones'") {
  const bool isBelowOneRoot = GENERATE(true, false);
  const bool isWholeBound = GENERATE(true, false);
  CAPTURE(isBelowOneRoot, isWholeBound);
  ForeignScene scene;
  aiNode& hips = scene.addNode(scene.root(), "hips");
  scene.addNode(scene.addNode(hips, "spine"), "upper");
  aiNode& clothes = scene.addNode(isBelowOneRoot ? hips : scene.root(), "clothes");
  aiNode& body = scene.addNode(clothes, "body");
  aiMesh& mesh = scene.addTriangle("skin", corners);
  scene.show(body, 0);
  scene.addBone(mesh, "upper", {{0, 1.0F}, {1, 1.0F}, {isWholeBound ? 2U : 1U, 1.0F}});
  const MadeOfForeign made = test::madeOfForeign(scene);
  CHECK(made.meshes.unweightedVertices == (isWholeBound ? 0 : 1));
  CHECK(made.meshes.spansRoots == (!isBelowOneRoot && !isWholeBound));
}

TEST_CASE("Of many bones at a vertex the eight strongest stay, the strongest first") {
  const int bones = GENERATE(4, 5, 8, 9);
  CAPTURE(bones);
  Body body;
  float sum = 0.0F;
  for (int bone = 1; bone <= bones; ++bone) {
    body.scene.addNode(body.scene.root(), "bone" + std::to_string(bone));
    const auto weight = static_cast<float>(bone);
    body.scene.addBone(body.mesh, "bone" + std::to_string(bone), {{0, weight}, {1, 1.0F}, {2, 1.0F}});
    sum += bones - bone < 8 ? weight : 0.0F;
  }
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  const std::map<std::string, float> weights = weightsOf(made, 0);
  CHECK(weights.size() == static_cast<std::size_t>(std::min(bones, 8)));
  for (int bone = std::max(1, bones - 7); bone <= bones; ++bone) {
    INFO(bone);
    REQUIRE(weights.contains("bone" + std::to_string(bone)));
    CHECK(weights.at("bone" + std::to_string(bone)) == Approx(static_cast<float>(bone) / sum));
  }
  const Json& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
  CHECK(attributes.contains("JOINTS_1") == (bones > 4));
  CHECK_FALSE(attributes.contains("JOINTS_2"));
  CHECK(firstOf(made).influences[0].weights[0] == Approx(static_cast<float>(bones) / sum));
}

TEST_CASE(
    "Skinned meshes of one node share a skin where their bones agree, and are apart where they do not") {
  const double off = GENERATE(0.0, 1.0);
  CAPTURE(off);
  Body body;
  body.scene.addNode(body.scene.root(), "upper");
  body.scene.addNode(body.scene.root(), "lower");
  body.scene.addBone(body.mesh, "upper", {{0, 1.0F}, {1, 1.0F}, {2, 1.0F}});
  aiMesh& coat = body.scene.addTriangle("coat", corners);
  body.scene.show(body.node, 1);
  const auto moved = [](double x) {
    return toMatrix({Vec3(x, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  };
  body.scene.addBone(coat, "upper", {{0, 1.0F}}, moved(off));
  body.scene.addBone(coat, "lower", {{1, 1.0F}, {2, 1.0F}}, moved(5.0));
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  const Scene& scene = *made.file.scene;
  if (off == 0.0) {
    REQUIRE(scene.meshes.size() == 1);
    CHECK(scene.meshes[0].primitives.size() == 2);
    REQUIRE(scene.skins.size() == 1);
    CHECK(scene.skins[0].joints.size() == 2);
    CHECK(scene.skins[0].inverseBind[1] == moved(5.0));
  } else {
    REQUIRE(scene.meshes.size() == 2);
    REQUIRE(scene.skins.size() == 2);
    CHECK(scene.skins[static_cast<std::size_t>(scene.nodes[0].skin)].inverseBind[0] == Mat4(1.0));
    // The second mesh hangs below the node under its name.
    const auto second = std::ranges::find(scene.nodes, 1, &Node::mesh);
    REQUIRE(second != scene.nodes.end());
    CHECK(second->name == "body");
    CHECK(second->parent == NodeIndex(0));
    CHECK(scene.skins[static_cast<std::size_t>(second->skin)].inverseBind[0] == moved(1.0));
    CHECK(weightsOf(made, 1, 1) == std::map<std::string, float>{{"lower", 1.0F}});
  }
  CHECK(made.meshes.nodeOfMesh == std::vector<int>{0, 0});
}

TEST_CASE("A mesh with bones and one without at the same node are two") {
  Body body;
  body.scene.addNode(body.scene.root(), "upper");
  body.scene.addTriangle("hat", corners);
  body.scene.show(body.node, 1);
  body.scene.addBone(body.mesh, "upper", {{0, 1.0F}, {1, 1.0F}, {2, 1.0F}});
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  REQUIRE(made.file.scene->meshes.size() == 2);
  CHECK(made.file.scene->skins.size() == 1);
  CHECK(made.file.scene->meshes[1].name == "hat");
  CHECK(made.file.scene->meshes[1].primitives[0].influences.empty());
}

TEST_CASE("Two nodes whose meshes follow the same bones share the skin") {
  Body body;
  body.scene.addNode(body.scene.root(), "upper");
  const std::vector<aiVertexWeight> all{{0, 1.0F}, {1, 1.0F}, {2, 1.0F}};
  body.scene.addBone(body.mesh, "upper", all);
  body.scene.addBone(body.scene.addTriangle("coat", corners), "upper", all);
  body.scene.show(body.scene.addNode(body.scene.root(), "second"), 1);
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  CHECK(made.file.scene->skins.size() == 1);
  CHECK(made.file.scene->nodes[0].skin == 0);
  CHECK(made.file.scene->nodes[2].skin == 0);
  CHECK(made.file.scene->nodes[2].mesh == 1);
}

TEST_CASE("What places a mesh alone, as FBX has it, is in its bind and moves nothing below") {
  ForeignScene scene;
  const Mat4 geometric = toMatrix({Vec3(7.0, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  aiNode& pivot = scene.addNode(scene.root(), "body_$AssimpFbx$_GeometricTranslation", geometric);
  aiNode& node = scene.addNode(pivot, "body");
  scene.show(node, 0);
  aiMesh& mesh = scene.addTriangle("skin", corners);
  scene.addNode(scene.root(), "upper");
  const Mat4 offset = toMatrix({Vec3(0.0, 1.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  scene.addBone(mesh, "upper", {{0, 1.0F}, {1, 1.0F}, {2, 1.0F}}, offset);
  const MadeOfForeign made = test::madeOfForeign(scene);
  CHECK(made.file.scene->skins.at(0).inverseBind.at(0) == offset * geometric);
}

TEST_CASE("A bone whose matrix holds no number binds where it is") {
  Body body;
  body.scene.addNode(body.scene.root(), "upper");
  aiBone& bone = body.scene.addBone(body.mesh, "upper", {{0, 1.0F}, {1, 1.0F}, {2, 1.0F}});
  bone.mOffsetMatrix.a4 = notANumber;
  CHECK(test::madeOfForeign(body.scene).file.scene->skins.at(0).inverseBind.at(0) == Mat4(1.0));
}

TEST_CASE("Lengths of a mesh, its targets and its bones are in metres where the file's are not") {
  ForeignScene scene("RootNode", Mat4(Mat3(0.5)));
  aiMesh& mesh = scene.addTriangle("skin", corners);
  scene.show(scene.addNode(scene.root(), "body", Vec3(4.0, 0.0, 0.0)), 0);
  scene.addNode(scene.root(), "upper", Vec3(0.0, 2.0, 0.0));
  scene.addTarget(mesh, "smile", {Vec3(0.0, 0.0, 8.0), corners[1], corners[2]});
  const Mat4 offset = toMatrix({Vec3(0.0, -2.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  scene.addBone(mesh, "upper", {{0, 1.0F}, {1, 1.0F}, {2, 1.0F}}, offset);
  const MadeOfForeign made = test::madeOfForeign(scene);
  CHECK(firstOf(made).positions[2] == glm::vec3(0, 1.5F, 0));
  CHECK(firstOf(made).morphTargets[0].positions[0] == glm::vec3(0, 0, 4));
  CHECK(made.file.scene->nodes[0].rest.translation == Vec3(2.0, 0.0, 0.0));
  CHECK(made.file.scene->nodes[0].rest.scale == Vec3(1.0));
  const Mat4& bind = made.file.scene->skins.at(0).inverseBind.at(0);
  CHECK(Vec3(bind[3]) == Vec3(0.0, -1.0, 0.0));
  CHECK(Vec3(bind[0]) == Vec3(1.0, 0.0, 0.0));
}

TEST_CASE("A mesh without bones that two nodes show at other scales is written for each in its own lengths") {
  ForeignScene scene; // an FBX without a unit: centimetres
  scene.addTriangle("flag", corners);
  scene.show(scene.addNode(scene.root(), "in metres", Mat4(Mat3(100.0))), 0); // undoes the unit
  scene.show(scene.addNode(scene.root(), "in centimetres"), 0);
  const MadeOfForeign made = test::madeOfForeign(scene, interchange::Format::fbx);
  const Scene& figure = *made.file.scene;
  REQUIRE(figure.meshes.size() == 2);
  const auto heightAt = [&](std::size_t node) {
    return figure.meshes.at(at(figure.nodes.at(node).mesh)).primitives.at(0).positions.at(2).y;
  };
  CHECK(heightAt(0) == 3.0F);
  CHECK(heightAt(1) == Approx(0.03));
}

TEST_CASE("Two nodes whose meshes follow one bone from other places have a skin each") {
  Body body;
  body.scene.addNode(body.scene.root(), "upper");
  const std::vector<aiVertexWeight> all{{0, 1.0F}, {1, 1.0F}, {2, 1.0F}};
  const Mat4 offset = toMatrix({Vec3(0.0, 1.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  body.scene.addBone(body.mesh, "upper", all);
  body.scene.addBone(body.scene.addTriangle("coat", corners), "upper", all, offset);
  body.scene.show(body.scene.addNode(body.scene.root(), "second"), 1);
  const MadeOfForeign made = test::madeOfForeign(body.scene);
  const Scene& scene = *made.file.scene;
  REQUIRE(scene.skins.size() == 2);
  CHECK(scene.skins[at(scene.nodes[0].skin)].inverseBind[0] == Mat4(1.0));
  CHECK(scene.skins[at(scene.nodes[2].skin)].inverseBind[0] == offset);
}

TEST_CASE("Bones agree as near as single precision has them, which is more where the joint is far away") {
  const auto [miss, meshes] = GENERATE(table<double, std::size_t>({{0.005, 1}, {0.02, 2}}));
  CAPTURE(miss);
  const auto movedBy = [](double x) {
    return toMatrix({Vec3(x, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)});
  };
  Body body;
  body.scene.addNode(body.scene.root(), "upper");
  const std::vector<aiVertexWeight> all{{0, 1.0F}, {1, 1.0F}, {2, 1.0F}};
  body.scene.addBone(body.mesh, "upper", all, movedBy(1000.0));
  body.scene.addBone(body.scene.addTriangle("coat", corners), "upper", all, movedBy(1000.0 + miss));
  body.scene.show(body.node, 1);
  CHECK(test::madeOfForeign(body.scene).file.scene->meshes.size() == meshes);
}
