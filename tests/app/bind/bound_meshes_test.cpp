// Meshes that are bound to the joints of their file: skins, matrices and weights of small boxes on a boxer.
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "app/bind/bind_mesh.h"
#include "app/bind/body_to_bind.h"
#include "app/locators/fit_locators.h"
#include "core/anim/sampling.h"
#include "core/gltf/source/added_file.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/matrices.h"
#include "tests/support/nodes.h"
#include "tests/support/refusal.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/skinning/tube_person.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Primitive boxFrom(const glm::vec3& low, const glm::vec3& high) {
  const auto corner = [&](unsigned i) {
    return glm::vec3((i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                     (i & 4U) != 0 ? high.z : low.z);
  };
  Primitive box;
  for (const unsigned i : {0U, 2U, 1U, 1U, 2U, 3U, 4U, 5U, 6U, 5U, 7U, 6U, 0U, 1U, 4U, 1U, 5U, 4U,
                           2U, 6U, 3U, 3U, 6U, 7U, 0U, 4U, 2U, 2U, 4U, 6U, 1U, 3U, 5U, 3U, 7U, 5U}) {
    box.positions.push_back(corner(i));
    box.indices.push_back(static_cast<std::uint32_t>(box.indices.size()));
  }
  return box;
}

NodeIndex addMesh(Scene& scene, const std::string& name, NodeIndex parent, const Vec3& place,
                  const std::vector<Primitive>& primitives) {
  scene.meshes.push_back({name, primitives, {}});
  const NodeIndex node = test::addNode(scene, name, parent, place);
  scene.nodes[at(node)].mesh = static_cast<int>(scene.meshes.size()) - 1;
  return node;
}

/// The boxer's joints with arms and trunk of boxes: "Arms" where they are seen, "Trunk" the same in two
/// primitives, "Shell" that stands elsewhere and is as far off in its mesh.
Scene dressed() {
  Scene scene = *test::boxer().scene;
  addMesh(scene, "Arms", NodeIndex::none, Vec3(0.0),
          {boxFrom({0.15F, 1.42F, -0.08F}, {0.85F, 1.58F, 0.08F}),
           boxFrom({-0.85F, 1.42F, -0.08F}, {-0.15F, 1.58F, 0.08F})});
  addMesh(scene, "Trunk", NodeIndex::none, Vec3(0.0),
          {boxFrom({-0.15F, 0.9F, -0.1F}, {0.15F, 1.2F, 0.1F}),
           boxFrom({-0.15F, 1.2F, -0.1F}, {0.15F, 1.7F, 0.1F})});
  addMesh(scene, "Shell", NodeIndex::none, Vec3(0.0, 0.0, 1.0),
          {boxFrom({-0.2F, 1.0F, -1.12F}, {0.2F, 1.4F, -0.88F})});
  return scene;
}

Document opened(const Scene& scene, const std::vector<Clip>& clips) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "dressed.glb";
  test::characterFile(scene, clips).write(file);
  Document document = test::openedFile(file);
  document.body = test::boxer().body; // it has no legs to be known by
  document.limbsCorrected = true;
  return document;
}

Track movesOf(NodeIndex node) {
  Track track;
  track.node = node;
  track.channel = Channel::translation;
  track.width = 3;
  track.times = {0.0F, 0.5F};
  track.values = {0.0F, 0.0F, 0.0F, 0.0F, 0.5F, 0.0F};
  return track;
}

NodeIndex nodeNamed(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.nodes, name, &Node::name);
  REQUIRE(found != scene.nodes.end());
  return NodeIndex(static_cast<std::size_t>(found - scene.nodes.begin()));
}

const Skin& skinOf(const Scene& scene, const std::string& mesh) {
  const int skin = scene.nodes[at(nodeNamed(scene, mesh))].skin;
  REQUIRE(skin >= 0);
  return scene.skins[at(skin)];
}

BoundMeshes boundAt(const Document& document) {
  Result<BoundMeshes> bound = bindMeshes(document, {});
  INFO((bound ? std::string() : bound.error().line()));
  REQUIRE(bound);
  return std::move(bound).value();
}

Scene sceneOf(const BoundMeshes& bound) {
  const Result<std::shared_ptr<const Scene>> scene = gltf::sceneWith(*bound.source, {});
  REQUIRE(scene);
  return **scene;
}

/// Bound once for all: that takes a while.
struct Dressed {
  Document document = opened(dressed(), *test::boxer().clips);
  BoundMeshes bound = boundAt(document);
};

const Dressed& dressedOnce() {
  static const Dressed made;
  return made;
}

Document dressedAndBound() {
  Result<Document> bound = withBoundMeshes(dressedOnce().document, dressedOnce().bound);
  REQUIRE(bound);
  return std::move(bound).value();
}

} // namespace

TEST_CASE(
    "Meshes that stand alike get a skin together, one that stands elsewhere its own, and all stay in place") {
  const Document& document = dressedOnce().document;
  const BoundMeshes& bound = dressedOnce().bound;
  CHECK(bound.report.meshes == 3);
  CHECK(bound.report.vertices == 5 * 36);
  CHECK(bound.report.joints == 9);
  CHECK(bound.moves.empty());
  const Scene scene = sceneOf(bound);
  CHECK(scene.skins.size() == 2);
  CHECK(&skinOf(scene, "Arms") == &skinOf(scene, "Trunk"));
  CHECK(&skinOf(scene, "Arms") != &skinOf(scene, "Shell"));
  const std::vector<Mat4> rest = worldMatrices(*document.scene, restPose(*document.scene));
  for (const char* const mesh : {"Arms", "Trunk", "Shell"}) {
    const Skin& skin = skinOf(scene, mesh);
    REQUIRE(skin.joints.size() == 9);
    const Mat4& toWorld = rest[at(nodeNamed(*document.scene, mesh))];
    for (std::size_t slot = 0; slot < skin.joints.size(); ++slot) {
      CHECK(test::largestDifference(rest[at(skin.joints[slot])] * skin.inverseBind[slot], toWorld) < 1e-6);
    }
    for (const Primitive& primitive :
         scene.meshes[at(scene.nodes[at(nodeNamed(scene, mesh))].mesh)].primitives) {
      REQUIRE(primitive.influences.size() == primitive.positions.size());
      for (const VertexInfluences& vertex : primitive.influences) {
        double sum = 0.0;
        std::set<std::uint16_t> slots;
        CHECK(vertex.weights[0] > 0.0F);
        for (std::size_t i = 0; i < VertexInfluences::capacity && vertex.weights[i] > 0.0F; ++i) {
          sum += static_cast<double>(vertex.weights[i]);
          CHECK(slots.insert(vertex.joints[i]).second); // none twice
        }
        CHECK(sum == Approx(1.0).margin(1e-5));
      }
    }
  }
}

TEST_CASE("A mesh that a clip moves by its node is told of, and one whose joints are moved is not") {
  Scene scene = dressed();
  Clip clip = test::boxer().clips->front();
  const auto told = [&](const std::vector<Clip>& clips) {
    Document document = opened(scene, clips);
    Track morphs = movesOf(nodeNamed(scene, "Arms")); // moves no place of it
    morphs.channel = Channel::weights;
    std::vector<Clip> all = *document.clips;
    all.front().tracks.emplace_back(morphs);
    document.clips = std::make_shared<const std::vector<Clip>>(all);
    std::vector<std::string> lines = boundAt(document).report.warnings;
    std::erase_if(
        lines, [](const std::string& line) { return line.find("is moved by a clip") == std::string::npos; });
    return lines;
  };
  clip.tracks.emplace_back(movesOf(nodeNamed(scene, "Trunk")));
  Clip second = clip;
  second.name = "second";
  CHECK(told({test::boxer().clips->front(), second}) ==
        std::vector<std::string>{"Trunk is moved by a clip, which no longer moves its mesh Trunk"});
}

TEST_CASE("What moves the mesh is told of, and not what moves the new joints with it") {
  const test::TubePerson person = test::tubePerson();
  Primitive tube;
  for (const Triangle& triangle : person.triangles) {
    for (const std::uint32_t corner : triangle) {
      tube.indices.push_back(static_cast<std::uint32_t>(tube.positions.size()));
      tube.positions.emplace_back(person.positions[corner]);
    }
  }
  Scene scene;
  const NodeIndex stage = test::addNode(scene, "Stage", NodeIndex::none, Vec3(0.0));
  const NodeIndex holder = test::addNode(scene, "Holder", stage, Vec3(0.0));
  scene.nodes[at(holder)].rest.scale = Vec3(1.0, 1.0, 1.25); // no joints hang below what scales unevenly
  const NodeIndex body = addMesh(scene, "Body", holder, Vec3(0.0), {tube});
  Clip clip;
  clip.endSeconds = 0.5;
  for (const NodeIndex node : {stage, holder, body}) {
    clip.tracks.emplace_back(movesOf(node));
  }
  const test::TemporaryFolder folder;
  test::characterFile(scene, {clip}).write(folder / "person.glb");
  const Document document = test::openedFile(folder / "person.glb");
  const Result<FittedLocators> fitted = fitLocators(document, "biped");
  REQUIRE(fitted);
  const Result<BoundMeshes> bound = bindMeshes(document, {.locators = fitted->locators});
  REQUIRE(bound);
  std::vector<std::string> lines = bound->report.warnings;
  std::erase_if(lines,
                [](const std::string& line) { return line.find("is moved by a clip") == std::string::npos; });
  CHECK(lines == std::vector<std::string>{"Body is moved by a clip, which no longer moves its mesh Body",
                                          "Holder is moved by a clip, which no longer moves its mesh Body"});
}

TEST_CASE("Matrices that were never set say where their joints stand as soon as something follows them, in "
          "each skin") {
  const Document whole = dressedAndBound();
  Scene scene = *whole.scene;
  std::vector<std::vector<Mat4>> wanted;
  for (Skin& skin : scene.skins) {
    wanted.push_back(skin.inverseBind);
    for (std::size_t slot = 0; slot < skin.joints.size(); ++slot) {
      if (scene.nodes[at(skin.joints[slot])].name == "Spine") {
        skin.inverseBind[slot] = glm::translate(Mat4(1.0), Vec3(0.0, 40.0, 0.0));
      }
    }
  }
  const Scene bound = sceneOf(boundAt(opened(scene, *whole.clips)));
  REQUIRE(bound.skins.size() == wanted.size());
  std::size_t mended = 0;
  for (std::size_t skin = 0; skin < wanted.size(); ++skin) {
    for (std::size_t slot = 0; slot < wanted[skin].size(); ++slot) {
      const bool isSame =
          test::largestDifference(bound.skins[skin].inverseBind[slot], wanted[skin][slot]) < 1e-4;
      const bool isBroken = bound.nodes[at(bound.skins[skin].joints[slot])].name == "Spine";
      CAPTURE(skin, slot);
      CHECK((isSame || isBroken));
      mended += isSame && isBroken ? 1 : 0;
    }
  }
  CHECK(mended == 2);
  // Weights are as they were, in the same skins.
  for (const char* const name : {"Arms", "Trunk", "Shell"}) {
    CAPTURE(name);
    const Node& before = whole.scene->nodes[at(nodeNamed(*whole.scene, name))];
    const Node& after = bound.nodes[at(nodeNamed(bound, name))];
    CHECK(after.skin == before.skin);
    for (std::size_t p = 0; p < bound.meshes[at(after.mesh)].primitives.size(); ++p) {
      const Primitive& one = whole.scene->meshes[at(before.mesh)].primitives[p];
      const Primitive& other = bound.meshes[at(after.mesh)].primitives[p];
      REQUIRE(one.influences.size() == other.influences.size());
      for (std::size_t v = 0; v < one.influences.size(); ++v) {
        CHECK(one.influences[v].joints == other.influences[v].joints);
        for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
          CHECK(one.influences[v].weights[i] == Approx(other.influences[v].weights[i]).margin(1e-4));
        }
      }
    }
  }
}

TEST_CASE("What follows a joint that its skin lacks follows the one above it, which is named once") {
  const Document whole = dressedAndBound();
  Scene scene = *whole.scene;
  const std::string lacking = "LeftForeArm";
  Skin& skin = scene.skins[at(scene.nodes[at(nodeNamed(scene, "Arms"))].skin)];
  const auto slot = std::ranges::find(skin.joints, nodeNamed(scene, lacking)) - skin.joints.begin();
  skin.joints.erase(skin.joints.begin() + slot);
  skin.inverseBind.erase(skin.inverseBind.begin() + slot);
  VertexInfluences first;
  first.weights[0] = 1.0F;
  for (Mesh& mesh : scene.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      std::ranges::fill(primitive.influences, first);
    }
  }
  const Scene bound = sceneOf(boundAt(opened(scene, *test::boxer().clips)));
  const auto weightsOf = [](const Scene& of, const std::string& mesh, std::size_t primitive,
                            std::size_t vertex) {
    std::map<std::string, double> weights;
    const Node& node = of.nodes[at(nodeNamed(of, mesh))];
    const VertexInfluences& one = of.meshes[at(node.mesh)].primitives[primitive].influences[vertex];
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      const std::string& joint = of.nodes[at(of.skins[at(node.skin)].joints[one.joints[i]])].name;
      const bool isNew = one.weights[i] > 0.0F && weights.try_emplace(joint, one.weights[i]).second;
      CHECK((isNew || (one.weights[i] == 0.0F && one.joints[i] == 0)));
      CHECK((!isNew || i + 1 == weights.size())); // without a gap
    }
    return weights;
  };
  std::size_t joined = 0;
  for (const std::size_t primitive : {0U, 1U}) {
    for (std::size_t vertex = 0; vertex < 36; ++vertex) {
      std::map<std::string, double> wanted = weightsOf(*whole.scene, "Arms", primitive, vertex);
      joined += wanted.contains(lacking) && wanted.contains("LeftArm") ? 1 : 0;
      if (wanted.contains(lacking)) {
        wanted["LeftArm"] += wanted[lacking];
        wanted.erase(lacking);
      }
      const std::map<std::string, double> is = weightsOf(bound, "Arms", primitive, vertex);
      REQUIRE(is.size() == wanted.size());
      for (const auto& [joint, weight] : wanted) {
        CHECK(is.at(joint) == Approx(weight).margin(1e-3));
      }
    }
  }
  CHECK(joined > 0);
}

TEST_CASE("A piece that follows a joint at the end of a row alone goes on following it, no other does") {
  const std::string follows = GENERATE("Badge", "Chest", "Badge and Chest", "Badge beside the body");
  Scene scene = *dressedAndBound().scene;
  const NodeIndex badge = test::addNode(
      scene, "Badge", follows == "Badge beside the body" ? NodeIndex::none : nodeNamed(scene, "Chest"),
      {0.5, 0.5, 0.0});
  const Node& shell = scene.nodes[at(nodeNamed(scene, "Shell"))];
  Skin& skin = scene.skins[at(shell.skin)];
  const auto chest = static_cast<std::size_t>(std::ranges::find(skin.joints, nodeNamed(scene, "Chest")) -
                                              skin.joints.begin());
  skin.joints.push_back(badge);
  skin.inverseBind.push_back(glm::translate(Mat4(1.0), Vec3(-0.5, -0.5, 0.0)) * skin.inverseBind[chest]);
  VertexInfluences first;
  first.joints[0] = static_cast<std::uint16_t>(follows == "Chest" ? chest : skin.joints.size() - 1);
  first.weights[0] = 1.0F;
  std::vector<VertexInfluences>& influences = scene.meshes[at(shell.mesh)].primitives.front().influences;
  std::ranges::fill(influences, first);
  if (follows == "Badge and Chest") {
    influences[5].joints[1] = static_cast<std::uint16_t>(chest);
    influences[5].weights = {0.6F, 0.4F};
  }
  const BoundMeshes done = boundAt(opened(scene, *test::boxer().clips));
  const bool isKept = follows == "Badge";
  const auto told = std::ranges::count(
      done.report.warnings, "36 vertices of things that followed \"Badge\" alone go on following it");
  CHECK(told == (isKept ? 1 : 0));
  const Scene bound = sceneOf(done);
  const Node& after = bound.nodes[at(nodeNamed(bound, "Shell"))];
  for (const VertexInfluences& one : bound.meshes[at(after.mesh)].primitives.front().influences) {
    const bool isBadges = bound.nodes[at(bound.skins[at(after.skin)].joints[one.joints[0]])].name == "Badge";
    CHECK((isBadges && one.weights[0] == 1.0F) == isKept);
  }
}

TEST_CASE("What a bind needs is asked for in one line") {
  Document document = opened(dressed(), *test::boxer().clips);
  document.addedFiles.resize(1);
  CHECK_THAT(test::refusal(bindMeshes(document, {})),
             Catch::Contains("props from other files are added to it"));
  const Document bare = opened(*test::boxer().scene, *test::boxer().clips);
  CHECK_THAT(test::refusal(bindMeshes(bare, {})), Catch::Contains("the file shows no mesh with triangles"));
  test::SyntheticBiped pieces = test::makeNamedBody("Mixamo");
  pieces.rigid = true;
  pieces.withSkin = false;
  Document rigid = opened(test::build(pieces).scene, {});
  rigid.body = rig::detectBody(*rigid.scene);
  CHECK_THAT(test::refusal(bindMeshes(rigid, {})), Catch::Contains("rigid pieces that follow their nodes"));
}

TEST_CASE("Joints to bind are those of skins in use, without sockets that only hold rigid things") {
  Document document = dressedAndBound();
  Scene scene = *document.scene;
  const NodeIndex socket = test::addNode(scene, "Socket", nodeNamed(scene, "Chest"), Vec3(0.0, 0.1, 0.2));
  addMesh(scene, "Badge", socket, Vec3(0.0), {boxFrom({-0.1F, -0.1F, 0.0F}, {0.1F, 0.1F, 0.1F})});
  const NodeIndex free = test::addNode(scene, "Free", nodeNamed(scene, "Chest"), Vec3(0.0, 0.1, -0.2));
  const NodeIndex idle = test::addNode(scene, "Idle", nodeNamed(scene, "Chest"), Vec3(0.2, 0.1, -0.2));
  addMesh(scene, "Glove", nodeNamed(scene, "LeftHand"), Vec3(0.0),
          {boxFrom({0.0F, -0.1F, 0.0F}, {0.1F, 0.1F, 0.1F})});
  for (const NodeIndex joint : {socket, free}) {
    scene.skins[0].joints.push_back(joint);
    scene.skins[0].inverseBind.emplace_back(1.0);
  }
  Skin unused = scene.skins[0];
  unused.joints.push_back(idle);
  unused.inverseBind.emplace_back(1.0);
  scene.skins.push_back(unused);
  document.scene = std::make_shared<const Scene>(scene);
  const SkeletonToBind skeleton = ownSkeleton(document);
  const auto isBound = [&](NodeIndex node) {
    return std::ranges::find(skeleton.nodes, node) != skeleton.nodes.end();
  };
  CHECK_FALSE(isBound(socket));
  CHECK(isBound(free));
  CHECK_FALSE(isBound(idle));
  CHECK(isBound(nodeNamed(scene, "LeftHand"))); // it holds a glove, and ends a limb
  CHECK(skeleton.nodes.size() == 10);
  for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
    CHECK(skeleton.joints[i].parent < static_cast<int>(i));
    CHECK(glm::distance(skeleton.joints[i].place, positionOf(skeleton.worlds[i])) < 1e-12);
  }
}

TEST_CASE("A body is bound in the morphs that it rests in, its primitives one after the other") {
  Scene scene = dressed();
  Primitive& trunk = scene.meshes[1].primitives[1];
  trunk.morphTargets.resize(1);
  trunk.morphTargets[0].positions.assign(trunk.positions.size(), glm::vec3(0.0F, 0.0F, 0.5F));
  scene.meshes[1].primitives[0].morphTargets.resize(1);
  scene.meshes[1].primitives[0].morphTargets[0].positions.assign(36, glm::vec3(0.0F));
  scene.meshes[1].morphWeights = {0.5};
  const auto nodes =
      std::vector<NodeIndex>{nodeNamed(scene, "Arms"), nodeNamed(scene, "Trunk"), nodeNamed(scene, "Shell")};
  const BodyToBind body = bodyToBind(scene, nodes);
  REQUIRE(body.positions.size() == 5 * 36);
  CHECK(body.triangles.size() == 5 * 12);
  CHECK(body.meshes[0].firstVertex == 0);
  CHECK(body.meshes[1].firstVertex == 2 * 36);
  CHECK(body.meshes[2].firstVertex == 4 * 36);
  CHECK(body.positions[3 * 36] == trunk.positions[0] + glm::vec3(0.0F, 0.0F, 0.25F));
  CHECK(body.positions[4 * 36] == scene.meshes[2].primitives[0].positions[0] + glm::vec3(0.0F, 0.0F, 1.0F));
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    CHECK(body.triangles[i][0] == 3 * i);
    CHECK(body.triangles[i][2] == 3 * i + 2);
  }
  scene.nodes[at(nodes[1])].morphWeights = {1.0}; // the node's win
  CHECK(bodyToBind(scene, nodes).positions[3 * 36] == trunk.positions[0] + glm::vec3(0.0F, 0.0F, 0.5F));
}
