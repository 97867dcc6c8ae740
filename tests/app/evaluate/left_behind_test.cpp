#include "app/evaluate/left_behind.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/app/boxer.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

// The boxer's left hand is at (0.8, 1.5, 0); its arm is 0.6 long: near is within 0.12, small is below 0.36.
const Vec3 leftHand(0.8, 1.5, 0.0);

struct Boxed {
  Document document = test::boxer();
  Scene scene = *document.scene;

  NodeIndex named(const std::string& name) const {
    for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
      if (scene.nodes[node].name == name) {
        return NodeIndex(node);
      }
    }
    return NodeIndex::none;
  }
  Vec3 placeOf(NodeIndex node) const {
    Vec3 place(0.0);
    for (; node.exists(); node = scene.nodes[at(node)].parent) {
      place += scene.nodes[at(node)].rest.translation;
    }
    return place;
  }
  int addMesh(const std::vector<Vec3>& points, const std::string& name = "") {
    Primitive primitive;
    for (const Vec3& point : points) {
      primitive.positions.emplace_back(point);
    }
    primitive.indices = {0, 1, 0};
    scene.meshes.push_back({name, {primitive}, {}});
    return static_cast<int>(scene.meshes.size()) - 1;
  }
  /// A box below a node, about a place of the world.
  NodeIndex addBox(const std::string& name, NodeIndex parent, const Vec3& middle, double extent = 0.1) {
    const NodeIndex node = test::addNode(scene, name, parent, middle - placeOf(parent));
    scene.nodes[at(node)].mesh = addMesh({Vec3(-0.5 * extent), Vec3(0.5 * extent)});
    return node;
  }
  std::vector<std::string> told(const std::string& limb = "left-arm",
                                const std::vector<NodeIndex>& movedNodes = {}) {
    document.scene = std::make_shared<const Scene>(scene);
    std::vector<bool> moved(scene.nodes.size(), false);
    for (const NodeIndex node : movedNodes) {
      moved[at(node)] = true;
    }
    return partsLeftBehind(document, *findLimb(document, limb), moved, rig::bindPlaces(*document.scene));
  }
};

std::string leftBehindLine(const std::string& part, const std::string& hangsOn, const std::string& end) {
  return "the mesh \"" + part + "\" stands at the limb's end but hangs on \"" + hangsOn +
         "\", so it stays where it is; hang it on \"" + end + "\" where the file was made";
}

using Lines = std::vector<std::string>;

/// Weights of two vertices, each of one joint by its slot in a skin.
std::vector<VertexInfluences> following(std::uint16_t first, std::uint16_t second) {
  std::vector<VertexInfluences> both(2);
  both[0].joints[1] = first; // The strongest is not the first.
  both[0].weights = {0.25F, 0.75F};
  both[1].joints[0] = second;
  both[1].weights = {1.0F};
  return both;
}

} // namespace

TEST_CASE("What stands at a hand and hangs on the trunk is told with what it hangs on and where it should") {
  Boxed boxed;
  const std::string trunk = GENERATE("Hips", "Spine");
  boxed.addBox("Glove", boxed.named(trunk), leftHand);
  CHECK(boxed.told() == Lines{leftBehindLine("Glove", trunk, "LeftHand")});
  CHECK(boxed.told("right-arm").empty());
  CHECK(boxed.told("spine").empty()); // Not a limb that reaches out.
}

TEST_CASE("What the limb moves, what hangs on a limb and what hangs on no part of the body is not left") {
  Boxed boxed;
  const NodeIndex glove = boxed.addBox("Glove", boxed.named("Hips"), leftHand);
  CHECK(boxed.told("left-arm", {glove}).empty());
  CHECK(boxed.told("left-arm", {boxed.named("Hips")}).size() == 1);
  for (const char* joint : {"LeftArm", "LeftForeArm", "RightArm", "RightForeArm"}) {
    Boxed other;
    other.addBox("Glove", other.named(joint), leftHand);
    CHECK(other.told().empty());
  }
  Boxed alone;
  alone.addBox("Glove", NodeIndex::none, leftHand);
  CHECK(alone.told().empty());
}

TEST_CASE("A part hangs on the trunk through nodes without a mesh, not through a chain of cloth") {
  const bool isCloth = GENERATE(false, true);
  Boxed boxed;
  const Vec3 between(0.3, 1.2, 0.0);
  const NodeIndex cape = isCloth ? boxed.addBox("Cape", boxed.named("Spine"), between)
                                 : test::addNode(boxed.scene, "Cape", boxed.named("Spine"),
                                                 between - boxed.placeOf(boxed.named("Spine")));
  boxed.addBox("Glove", cape, leftHand);
  CHECK(boxed.told() == (isCloth ? Lines{} : Lines{leftBehindLine("Glove", "Spine", "LeftHand")}));
}

TEST_CASE("Only what is near the end, small, and nearer to it than to any other end is left behind") {
  const auto told = [](const Vec3& middle, double extent) {
    Boxed boxed;
    boxed.addBox("Glove", boxed.named("Hips"), middle, extent);
    return boxed.told().size();
  };
  CHECK(told(leftHand + Vec3(0.0, 0.0, 0.119), 0.1) == 1);
  CHECK(told(leftHand + Vec3(0.0, 0.0, 0.121), 0.1) == 0);
  CHECK(told(leftHand, 0.359) == 1);
  CHECK(told(leftHand, 0.361) == 0);
  // Both hands at one place but for a tenth.
  const auto between = [](double share) {
    Boxed boxed;
    boxed.scene.nodes[at(boxed.named("RightHand"))].rest.translation = Vec3(1.2, 0.0, 0.0);
    const Vec3 rightHand = boxed.placeOf(boxed.named("RightHand"));
    boxed.addBox("Glove", boxed.named("Hips"), leftHand + share * (rightHand - leftHand), 0.01);
    return std::pair(boxed.told("left-arm").size(), boxed.told("right-arm").size());
  };
  CHECK(between(0.4) == std::pair<std::size_t, std::size_t>(1, 0));
  CHECK(between(0.6) == std::pair<std::size_t, std::size_t>(0, 1));
}

TEST_CASE("A leg's end takes in what is three tenths of it away, an arm's two") {
  Boxed boxed;
  rig::Limb& limb = boxed.document.body.limbs[0];
  boxed.addBox("Boot", boxed.named("Hips"), leftHand + Vec3(0.0, 0.0, 0.15));
  CHECK(boxed.told().empty());
  static_cast<rig::LimbPlace&>(limb) = rig::biped::leftLeg;
  CHECK(boxed.told().size() == 1);
}

TEST_CASE("A part that is not much nearer to the end than to what it hangs on belongs there") {
  const auto told = [](double fromTrunk) {
    Boxed boxed; // The part is 0.1 from the hand, beyond it as seen from the trunk.
    boxed.scene.nodes[at(boxed.named("Spine"))].rest.translation =
        leftHand + Vec3(0.1 - fromTrunk, 0.0, 0.0) - Vec3(0.0, 1.0, 0.0);
    boxed.scene.nodes[at(boxed.named("LeftArm"))].rest.translation +=
        Vec3(0.2, 1.5, 0.0) - boxed.placeOf(boxed.named("LeftArm"));
    REQUIRE(glm::length(boxed.placeOf(boxed.named("LeftHand")) - leftHand) < 1e-12);
    boxed.addBox("Glove", boxed.named("Spine"), leftHand + Vec3(0.1, 0.0, 0.0), 0.01);
    return boxed.told().size();
  };
  CHECK(told(0.1 / 0.35 + 0.005) == 1);
  CHECK(told(0.1 / 0.35 - 0.005) == 0);
}

TEST_CASE("Nodes without a name are told by their number, and an end that is none by the last joint") {
  Boxed boxed;
  const NodeIndex hips = boxed.named("Hips");
  boxed.addBox("Glove", hips, leftHand);
  boxed.scene.nodes[at(hips)].name.clear();
  rig::Limb& limb = boxed.document.body.limbs[0];
  limb.endNode = NodeIndex::none;
  limb.endOffset = Vec3(0.3, 0.0, 0.0);
  CHECK(boxed.told() == Lines{leftBehindLine("Glove", "#" + std::to_string(hips.value), "LeftForeArm")});
}

TEST_CASE(
    "A mesh whose vertices all follow one joint of the trunk is a part, by its own name or its mesh's") {
  const auto told = [](std::uint16_t first, std::uint16_t second, const std::string& node,
                       const std::vector<std::string>& moved = {}, const Vec3& aside = Vec3(0.0)) {
    Boxed boxed;
    Skin skin;
    skin.joints = {boxed.named("Hips"), boxed.named("Spine"), boxed.named("LeftHand")};
    for (const NodeIndex joint : skin.joints) {
      Mat4 inverse(1.0);
      inverse[3] = Vec4(-boxed.placeOf(joint), 1.0);
      skin.inverseBind.push_back(inverse);
    }
    boxed.scene.skins = {skin};
    const NodeIndex holder = test::addNode(boxed.scene, node, NodeIndex::none, Vec3(5.0));
    const int mesh =
        boxed.addMesh({leftHand + aside - Vec3(0.05), leftHand + aside + Vec3(0.05)}, "GloveMesh");
    boxed.scene.nodes[at(holder)].mesh = mesh;
    boxed.scene.nodes[at(holder)].skin = 0;
    boxed.scene.meshes[at(mesh)].primitives[0].influences = following(first, second);
    std::vector<NodeIndex> movedNodes(moved.size());
    std::ranges::transform(moved, movedNodes.begin(),
                           [&](const std::string& one) { return boxed.named(one); });
    return boxed.told("left-arm", movedNodes);
  };
  const std::string holder = GENERATE("Glove", "");
  const std::string name = holder.empty() ? "GloveMesh" : holder;
  CHECK(told(1, 1, holder) == Lines{leftBehindLine(name, "Spine", "LeftHand")});
  CHECK(told(0, 0, holder) == Lines{leftBehindLine(name, "Hips", "LeftHand")});
  CHECK(told(2, 2, holder).empty()); // Of the hand itself.
  CHECK(told(1, 1, holder, {"Spine"}).empty());
  CHECK(told(0, 1, holder).empty());
  CHECK(told(1, 7, holder).empty());                           // A slot that the skin does not have.
  CHECK(told(1, 1, holder, {}, Vec3(-0.5, 0.0, 0.0)).empty()); // Nowhere near the hand.
}
