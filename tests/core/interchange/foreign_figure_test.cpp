#include <limits>

#include <catch2/catch.hpp>
#include <fmt/core.h>
#include <glm/gtc/quaternion.hpp>

#include "tests/support/core/foreign_scene.h"

using namespace stretch;
using interchange::Figure;
using interchange::Format;
using test::ForeignScene;

namespace {

Mat4 turned(const Vec3& axis, double degrees, double scale = 1.0) {
  return toMatrix({Vec3(0.0), glm::angleAxis(glm::radians(degrees), axis), Vec3(scale)});
}

std::vector<std::string> namesOf(const Figure& figure) {
  std::vector<std::string> names;
  for (const interchange::FigureNode& node : figure.nodes) {
    names.push_back(node.name);
  }
  return names;
}

/// Where a foreign file's nodes rest.
Vec3 placeOf(const Figure& figure, const std::string& name) {
  return positionOf(interchange::restWorlds(figure).at(static_cast<std::size_t>(figure.byName.at(name))));
}

void checkNear(const Vec3& is, const Vec3& wanted) {
  INFO(is.x << " " << is.y << " " << is.z << " instead of " << wanted.x << " " << wanted.y << " "
            << wanted.z);
  CHECK(glm::length(is - wanted) < 1e-6);
}

/// A figure whose only node stands at (1, 2, 3) units.
ForeignScene oneNode() {
  ForeignScene scene;
  scene.addNode(scene.root(), "one", Vec3(1.0, 2.0, 3.0));
  return scene;
}

} // namespace

TEST_CASE("A root that only carries the rest is left out, and stays where something needs it") {
  const auto namesWhere = [](const auto& change) {
    ForeignScene scene("Root");
    scene.addNode(scene.root(), "a");
    scene.addNode(scene.root(), "b");
    change(scene);
    return namesOf(interchange::figureOf(scene.scene(), Format::collada));
  };
  const std::vector<Vec3> corners{Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)};
  const std::vector<std::string> without{"a", "b"};
  const std::vector<std::string> with{"Root", "a", "b"};
  CHECK(namesWhere([](ForeignScene&) {}) == without);
  CHECK(namesWhere([&](ForeignScene& scene) {
          scene.addTriangle("skin", corners);
          scene.show(scene.root(), 0);
        }) == with);
  CHECK(namesWhere([&](ForeignScene& scene) {
          scene.addBone(scene.addTriangle("skin", corners), "Root", {});
        }) == with);
  CHECK(namesWhere([&](ForeignScene& scene) {
          scene.addBone(scene.addTriangle("skin", corners), "a", {});
        }) == without);
  CHECK(namesWhere([&](ForeignScene& scene) { scene.addChannel(scene.addClip("walk", 1.0), "Root"); }) ==
        with);
  CHECK(namesWhere([&](ForeignScene& scene) { scene.addChannel(scene.addClip("walk", 1.0), "b"); }) ==
        without);
  const ForeignScene alone("Alone");
  CHECK(namesOf(interchange::figureOf(alone.scene(), Format::fbx)) == std::vector<std::string>{"Alone"});
  ForeignScene bvh("Hips");
  bvh.addNode(bvh.root(), "leg", Vec3(0.0, -1.0, 0.0));
  CHECK(namesOf(interchange::figureOf(bvh.scene(), Format::bvh)) == std::vector<std::string>{"Hips", "leg"});
}

TEST_CASE("Nodes come parents first, and a name leads to the first that has it") {
  ForeignScene scene;
  aiNode& a = scene.addNode(scene.root(), "a");
  scene.addNode(a, "leaf", Vec3(1.0, 0.0, 0.0));
  scene.addNode(scene.addNode(scene.root(), "b"), "leaf", Vec3(2.0, 0.0, 0.0));
  const Figure figure = interchange::figureOf(scene.scene(), Format::collada);
  CHECK(namesOf(figure) == std::vector<std::string>{"a", "leaf", "b", "leaf"});
  CHECK(figure.nodes[0].parent == -1);
  CHECK(figure.nodes[1].parent == 0);
  CHECK(figure.nodes[2].parent == -1);
  CHECK(figure.nodes[3].parent == 2);
  CHECK(figure.byName.at("leaf") == 1);
}

TEST_CASE("Pivots go into what hangs below them, unless they show a mesh or move one") {
  const auto namesWhere = [](bool showsMesh, bool isBone) {
    ForeignScene scene;
    aiNode& pivot = scene.addNode(scene.root(), "arm_$AssimpFbx$_Rotation", Vec3(0.0, 1.0, 0.0));
    scene.addNode(pivot, "arm", Vec3(0.0, 2.0, 0.0));
    scene.addNode(pivot, "sleeve", Vec3(0.0, 4.0, 0.0));
    aiMesh& mesh = scene.addTriangle("skin", {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)});
    if (showsMesh) {
      scene.show(pivot, 0);
    }
    if (isBone) {
      scene.addBone(mesh, "arm_$AssimpFbx$_Rotation", {});
    }
    const Figure figure = interchange::figureOf(scene.scene(), Format::collada);
    checkNear(placeOf(figure, "arm"), Vec3(0.0, 3.0, 0.0));
    checkNear(placeOf(figure, "sleeve"), Vec3(0.0, 5.0, 0.0));
    return namesOf(figure);
  };
  CHECK(namesWhere(false, false) == std::vector<std::string>{"arm", "sleeve"});
  CHECK(namesWhere(true, false) == std::vector<std::string>{"arm_$AssimpFbx$_Rotation", "arm", "sleeve"});
  CHECK(namesWhere(false, true) == std::vector<std::string>{"arm_$AssimpFbx$_Rotation", "arm", "sleeve"});
}

TEST_CASE("An FBX is in the unit that it says, in centimetres where it says none that can be") {
  const auto metres = [](const auto& say) {
    ForeignScene scene = oneNode();
    say(scene);
    const Figure figure = interchange::figureOf(scene.scene(), Format::fbx);
    checkNear(placeOf(figure, "one"), figure.worldOfUnit * Vec3(1.0, 2.0, 3.0));
    return figure.worldOfUnit;
  };
  CHECK(metres([](ForeignScene&) {}) == 0.01);
  CHECK(metres([](ForeignScene& scene) { scene.say({{"UpAxis", 1}}); }) == 0.01);
  CHECK(metres([](ForeignScene& scene) { scene.sayUnit(100.0); }) == Approx(1.0));
  CHECK(metres([](ForeignScene& scene) { scene.sayUnit(2.54); }) == Approx(0.0254));
  CHECK(metres([](ForeignScene& scene) { scene.sayUnit(0.0); }) == 0.01);
  CHECK(metres([](ForeignScene& scene) { scene.sayUnit(-5.0); }) == 0.01);
  CHECK(metres([](ForeignScene& scene) { scene.sayUnit(std::numeric_limits<double>::infinity()); }) == 0.01);
  CHECK(metres([](ForeignScene& scene) {
          scene.scene().mMetaData = aiMetadata::Alloc(1);
          scene.scene().mMetaData->Set(0, "UnitScaleFactor", 50.0F);
        }) == Approx(0.5));
}

TEST_CASE("The axes that an FBX calls right, up and front become X, Y and Z, each way around") {
  using Said = std::vector<std::pair<std::string, int>>;
  const auto [said, place] = GENERATE(table<Said, Vec3>({
      {{{"CoordAxis", 0}, {"UpAxis", 1}, {"FrontAxis", 2}}, Vec3(1, 2, 3)},
      {{{"CoordAxis", 0}, {"UpAxis", 2}, {"FrontAxis", 1}, {"FrontAxisSign", -1}}, Vec3(1, 3, -2)},
      {{{"CoordAxis", 1}, {"UpAxis", 2}, {"FrontAxis", 0}}, Vec3(2, 3, 1)},
      {{{"CoordAxis", 1}, {"UpAxis", 0}, {"UpAxisSign", -1}, {"FrontAxis", 2}}, Vec3(2, -1, 3)},
      {{{"CoordAxis", 0}, {"CoordAxisSign", -1}, {"UpAxis", 1}, {"FrontAxis", 2}, {"FrontAxisSign", -1}},
       Vec3(-1, 2, -3)},
      // Mirrored, twice the same, or none: as they are.
      {{{"CoordAxis", 0}, {"UpAxis", 2}, {"FrontAxis", 1}}, Vec3(1, 2, 3)},
      {{{"CoordAxis", 0}, {"UpAxis", 1}, {"FrontAxis", 1}}, Vec3(1, 2, 3)},
      {{{"CoordAxis", 0}, {"UpAxis", 3}, {"FrontAxis", 2}}, Vec3(1, 2, 3)},
      {{{"CoordAxis", -1}, {"UpAxis", 1}, {"FrontAxis", 2}}, Vec3(1, 2, 3)},
  }));
  ForeignScene scene = oneNode();
  scene.say(said);
  checkNear(placeOf(interchange::figureOf(scene.scene(), Format::fbx), "one"), 0.01 * place);
}

TEST_CASE("A topmost node that undoes the file's scale takes it, else every length does") {
  const auto [own, scale, length] = GENERATE(table<double, double, double>({
      {100.0, 1.0, 3.0},   // Blender's armature: metres inside
      {100.5, 1.005, 3.0}, // within one hundredth
      {1.0, 1.0, 0.03},
      {50.0, 50.0, 0.03},
  }));
  CAPTURE(own);
  ForeignScene scene;
  aiNode& top = scene.addNode(scene.root(), "top", Mat4(Mat3(own)));
  scene.addNode(top, "tip", Vec3(0.0, 3.0, 0.0));
  const Figure figure = interchange::figureOf(scene.scene(), Format::fbx);
  const std::vector<Mat4> worlds = interchange::restWorlds(figure);
  CHECK(glm::length(Vec3(worlds[0][1])) == Approx(scale));
  CHECK(positionOf(worlds[1]).y == Approx(0.01 * own * 3.0));
  CHECK(Vec3(interchange::localOf(figure, figure.nodes[1], interchange::restOf)[3]).y == Approx(length));
  CHECK(figure.nodes[1].lengths == figure.nodes[0].lengths);
}

TEST_CASE("A BVH is in metres or centimetres by the height of a person, and else as high as one") {
  const auto [height, metres] = GENERATE(table<double, double>({
      {1.6, 1.6},
      {0.51, 0.51},
      {2.99, 2.99},
      {160.0, 1.6},
      {50.0, 0.5},
      {299.0, 2.99},
      {0.5, 1.7},
      {3.0, 1.7},
      {49.0, 1.7},
      {300.0, 1.7},
      {1e4, 1.7},
  }));
  CAPTURE(height);
  ForeignScene scene("Hips");
  scene.addNode(scene.root(), "foot", Vec3(5.0, -height / 2.0, 0.0));
  scene.addNode(scene.root(), "head", Vec3(0.0, height / 2.0, 1.0));
  const Figure figure = interchange::figureOf(scene.scene(), Format::bvh);
  CHECK(placeOf(figure, "head").y - placeOf(figure, "foot").y == Approx(metres).epsilon(1e-5));
  CHECK(figure.unitNote.find(fmt::format("the figure, {:.4g} high, is taken to be {:.2f} m", height,
                                         metres)) != std::string::npos);
  CHECK(figure.worldOfUnit == Approx(metres / height).epsilon(1e-5));
}

TEST_CASE("A BVH that lies flat is measured by its longest side, and one without any extent stays") {
  ForeignScene flat("Hips");
  flat.addNode(flat.root(), "tip", Vec3(0.0, 0.0, 160.0));
  checkNear(placeOf(interchange::figureOf(flat.scene(), Format::bvh), "tip"), Vec3(0.0, 0.0, 1.6));
  const ForeignScene point("Hips");
  const Figure figure = interchange::figureOf(point.scene(), Format::bvh);
  CHECK(figure.worldOfUnit == 1.0);
  CHECK(figure.height == 1.0);
}

TEST_CASE(
    "A BVH rests on the floor where its motion carries it by more than half of what is below the root") {
  const auto [carried, lift] =
      GENERATE(table<double, double>({{100.0, 1.0}, {51.0, 1.0}, {49.0, 0.0}, {0.0, 0.0}}));
  CAPTURE(carried);
  ForeignScene scene("Hips");
  scene.addNode(scene.root(), "foot", Vec3(0.0, -100.0, 0.0));
  scene.addNode(scene.root(), "head", Vec3(0.0, 70.0, 0.0));
  aiAnimation& clip = scene.addClip("walk", 30.0);
  test::setPlaces(scene.addChannel(clip, "foot"), {{0.0, Vec3(0.0, 1000.0, 0.0)}});
  test::setPlaces(scene.addChannel(clip, "Hips"), {{0.0, Vec3(0.0, carried, 0.0)}, {1.0, Vec3(0.0)}});
  CHECK(interchange::figureOf(scene.scene(), Format::bvh).nodes[0].restLift == Approx(lift).margin(1e-6));
}

TEST_CASE("A scale of the parent reaches a node unless the FBX keeps it off, row by row of its axes") {
  const int inherit = GENERATE(0, 1, 2);
  CAPTURE(inherit);
  ForeignScene scene;
  aiNode& parent = scene.addNode(scene.root(), "parent",
                                 toMatrix({Vec3(0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(2.0, 4.0, 8.0)}));
  aiNode& child = scene.addNode(parent, "child", turned({0, 0, 1}, 90.0));
  child.mMetaData = aiMetadata::Alloc(1);
  child.mMetaData->Set(0, "InheritType", inherit);
  const Figure figure = interchange::figureOf(scene.scene(), Format::collada);
  CHECK(figure.nodes[1].shedsScale == (inherit == 2));
  const Mat4 world = interchange::restWorlds(figure)[1];
  checkNear(Vec3(world[0]), Vec3(0.0, inherit == 2 ? 1.0 : 4.0, 0.0));
  checkNear(Vec3(world[1]), Vec3(inherit == 2 ? -1.0 : -2.0, 0.0, 0.0));
  checkNear(Vec3(world[2]), Vec3(0.0, 0.0, inherit == 2 ? 1.0 : 8.0));
}

TEST_CASE("A node that rests at no number rests as its parent does") {
  ForeignScene scene;
  aiNode& odd = scene.addNode(scene.root(), "odd", Vec3(1.0, 2.0, 3.0));
  odd.mTransformation.a4 = std::numeric_limits<float>::quiet_NaN();
  CHECK(interchange::restOf(odd) == Mat4(1.0));
}

TEST_CASE("A figure is as high as its nodes reach, else as its meshes do, in metres") {
  ForeignScene scene("RootNode", Mat4(Mat3(2.0)));
  scene.addNode(scene.root(), "a", Vec3(-1.0, 0.0, 0.0));
  scene.addTriangle("skin", {Vec3(1.0, 1.0, 1.0), Vec3(1.0, 1.0, -6.0), Vec3(1.0, 3.0, 1.0)});
  CHECK(interchange::figureOf(scene.scene(), Format::collada).height == Approx(14.0));
  scene.addNode(scene.root(), "b", Vec3(4.0, -3.0, 0.0));
  CHECK(interchange::figureOf(scene.scene(), Format::collada).height == Approx(10.0));
}

TEST_CASE("What a BVH carries its root by is counted from where the root rests") {
  const auto [carried, lift] = GENERATE(table<double, double>({{60.0, 0.0}, {80.0, 0.5}}));
  CAPTURE(carried);
  ForeignScene scene("Hips", toMatrix({Vec3(0.0, 50.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)}));
  scene.addNode(scene.root(), "foot", Vec3(0.0, -100.0, 0.0)); // half a metre below the floor
  scene.addNode(scene.root(), "head", Vec3(0.0, 70.0, 0.0));
  test::setPlaces(scene.addChannel(scene.addClip("walk", 30.0), "Hips"), {{0.0, Vec3(0.0, carried, 0.0)}});
  CHECK(interchange::figureOf(scene.scene(), Format::bvh).nodes[0].restLift == Approx(lift).margin(1e-6));
}
