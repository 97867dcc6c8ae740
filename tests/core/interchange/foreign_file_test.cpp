#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/source.h"
#include "core/interchange/file_kind.h"
#include "core/interchange/foreign_file.h"
#include "tests/support/core/foreign_text.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using test::FbxText;
using test::TemporaryFolder;

namespace {

constexpr double inch = 0.0254;

gltf::Loaded loadedText(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  Result<gltf::Loaded> loaded = gltf::load(folder.write(name, text));
  INFO(test::refusal(loaded));
  REQUIRE(loaded);
  return std::move(loaded).value();
}

std::size_t nodeNamed(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.nodes, name, &Node::name);
  REQUIRE(found != scene.nodes.end());
  return static_cast<std::size_t>(found - scene.nodes.begin());
}

Mat4 worldOf(const gltf::Loaded& loaded, const std::string& name, double seconds) {
  return worldMatrices(*loaded.scene, samplePose(*loaded.scene, loaded.clips.front(),
                                                 seconds))[nodeNamed(*loaded.scene, name)];
}

bool tells(const gltf::Loaded& loaded, const std::string& text) {
  return std::ranges::any_of(loaded.warnings,
                             [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

void checkNear(const Vec3& is, const Vec3& wanted, double most) {
  INFO(is.x << " " << is.y << " " << is.z << " instead of " << wanted.x << " " << wanted.y << " "
            << wanted.z);
  CHECK(glm::length(is - wanted) <= most);
}

// The lower bone of twoBonesFbx, by hand: T(0,10,0) Rz(90) T(0,5,0) T(0,2,0) Rx(angle) T(0,-2,0).
Vec3 lowerAt(double seconds, double scale = 1.0) {
  const double angle = 120.0 * seconds * pi / 180.0;
  return inch * Vec3(-scale * (7.0 - 2.0 * std::cos(angle)), 10.0, -scale * 2.0 * std::sin(angle));
}

} // namespace

TEST_CASE("A BVH is a clip on a skeleton: metres, its own rate, its own frames") {
  const gltf::Loaded loaded = loadedText("person.bvh", test::personBvh());
  REQUIRE(loaded.clips.size() == 1);
  CHECK(loaded.clips.front().framesPerSecond == Approx(50.0));
  CHECK(loaded.clips.front().endSeconds == Approx(0.04));
  checkNear(positionOf(worldOf(loaded, "Leg", 0.0)), {0.0, 0.4, 0.0}, 1e-6);
  checkNear(positionOf(worldOf(loaded, "EndSite_Leg", 0.0)), {0.0, 0.0, 0.0}, 1e-6);
  // Turned by 90 degrees about x, and carried along.
  checkNear(positionOf(worldOf(loaded, "EndSite_Leg", 0.04)), {0.06, 0.4, -0.4}, 1e-6);
  CHECK(tells(loaded, "names no unit"));
  CHECK_FALSE(tells(loaded, "frames and holds"));
}

TEST_CASE("A BVH rests on the floor that its motion is over, and as it is where nothing carries it") {
  const gltf::Loaded carried = loadedText("person.bvh", test::personBvh());
  const auto restOf = [](const gltf::Loaded& loaded, const std::string& name) {
    return positionOf(worldMatrices(*loaded.scene, restPose(*loaded.scene))[nodeNamed(*loaded.scene, name)]);
  };
  checkNear(restOf(carried, "Hips"), {0.0, 0.8, 0.0}, 1e-6);
  checkNear(restOf(carried, "EndSite_Leg"), {0.0, 0.0, 0.0}, 1e-6);
  std::string text = test::personBvh();
  for (std::size_t at = text.find(" 80 0 0 0"); at != std::string::npos; at = text.find(" 80 0 0 0")) {
    text.replace(at, 9, " 0 0 0 0");
  }
  checkNear(restOf(loadedText("person.bvh", text), "Hips"), {0.0, 0.0, 0.0}, 1e-6);
}

TEST_CASE("The unit of a BVH is guessed from the size of the figure, and told") {
  const double unit = GENERATE(0.01, 1.0, 0.2, 10.0);
  const gltf::Loaded loaded = loadedText("person.bvh", test::personBvh(3, 3, unit));
  const double wanted = unit == 0.2 || unit == 10.0 ? 1.7 : 1.6;
  INFO("160 times " << unit << " high");
  const double height =
      positionOf(worldOf(loaded, "Head", 0.0)).y - positionOf(worldOf(loaded, "EndSite_Leg", 0.0)).y;
  CHECK(height == Approx(wanted).epsilon(1e-4));
}

TEST_CASE("A BVH that holds another number of frames than it says") {
  SECTION("more: those that it says are read, with a warning") {
    const gltf::Loaded loaded = loadedText("person.bvh", test::personBvh(3, 4));
    CHECK(tells(loaded, "says 3 frames and holds 4"));
    CHECK(loaded.clips.front().endSeconds == Approx(0.04));
  }
  SECTION("fewer: one line") {
    const TemporaryFolder folder;
    const std::string told = test::refusal(gltf::load(folder.write("person.bvh", test::personBvh(30, 3))));
    CHECK(told.find("is a BVH file that cannot be read") != std::string::npos);
    CHECK(told.find('\n') == std::string::npos);
    const std::string text = test::personBvh(30, 3);
    CHECK(told.find("(line " + std::to_string(std::ranges::count(text, '\n') + 1) + " - ") !=
          std::string::npos);
  }
}

TEST_CASE("A BVH whose frames take no time, or none that is a number, is refused in one line") {
  for (const char* const time : {"0", "-1", "nan"}) {
    INFO(time);
    std::string text = test::personBvh(3, 3);
    text.replace(text.find("0.02", text.find("Frame Time")), 4, time);
    const TemporaryFolder folder;
    const std::string told = test::refusal(gltf::load(folder.write("person.bvh", text)));
    CHECK(told.find("Frame Time") != std::string::npos);
  }
}

TEST_CASE(
    "A Collada whose unit has no length is refused in one line, and a place that is no number is told") {
  const TemporaryFolder folder;
  std::string text = test::postCollada();
  text.replace(text.find("0.0254"), 6, "000000");
  for (const char* const unit : {"000000", "-00001"}) {
    INFO(unit);
    text.replace(text.find("meter=\"") + 7, 6, unit);
    const std::string line = test::refusal(gltf::load(folder.write("flat.dae", text)));
    CHECK(line.find("its unit has no length") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
  std::string person = test::personBvh();
  person.replace(person.find("OFFSET 0 -40"), 12, "OFFSET 0 nan");
  CHECK(tells(loadedText("odd.bvh", person), "it is no number, are where their parents are: 1"));
  CHECK_FALSE(tells(loadedText("person.bvh", test::personBvh()), "it is no number"));
}

TEST_CASE("Nodes of an FBX that hang on each other, and on nothing that begins at the top, are told") {
  std::string text = test::twoBonesFbx();
  CHECK_FALSE(tells(loadedText("bones.fbx", text), "not hang on the top of the file"));
  const std::string whole = "C: \"OO\",11,10\n";
  REQUIRE(text.find(whole) != std::string::npos);
  text.replace(text.find(whole), whole.size(), "C: \"OO\",11,11\n");
  CHECK(
      tells(loadedText("circle.fbx", text), "1 node does not hang on the top of the file, and is left out"));
}

TEST_CASE("A file without a byte is called empty") {
  const TemporaryFolder folder;
  for (const char* const name : {"a.fbx", "a.glb", "a.gltf"}) {
    CHECK(test::refusal(gltf::load(folder.write(name, ""))).find("is empty") != std::string::npos);
  }
}

TEST_CASE("A file's only clip bears the file's name where a program named it, and its own else") {
  const auto nameOf = [](const std::string& called) {
    std::string text = test::twoBonesFbx();
    const std::string stack = "AnimStack::";
    text.replace(text.find(stack + "bend"), stack.size() + 4, stack + called);
    return loadedText("left jab.fbx", text).clips.front().name;
  };
  CHECK(nameOf("mixamo.com") == "left jab");
  CHECK(nameOf("Take 001") == "left jab");
  CHECK(nameOf("") == "left jab");
  CHECK(nameOf("Take 1 of the jab") == "Take 1 of the jab");
  CHECK(loadedText("walk.bvh", test::personBvh()).clips.front().name == "walk");
}

TEST_CASE("Pivots of an FBX are collapsed: the motion is the file's within 1e-4 of the height, at and "
          "between keys") {
  const gltf::Loaded loaded = loadedText("bones.fbx", test::twoBonesFbx());
  CHECK(std::ranges::none_of(loaded.scene->nodes,
                             [](const Node& node) { return node.name.find('$') != std::string::npos; }));
  REQUIRE(loaded.clips.size() == 1);
  CHECK(loaded.clips.front().name == "bend");
  CHECK(loaded.clips.front().framesPerSecond == Approx(24.0));
  constexpr double height = 5.0 * inch;
  for (int step = 0; step <= 96; ++step) {
    const double seconds = step / 96.0;
    INFO(seconds << " s");
    checkNear(positionOf(worldOf(loaded, "lower", seconds)), lowerAt(seconds), 1.1e-4 * height);
  }
  checkNear(positionOf(worldOf(loaded, "upper", 0.5)), {0.0, 10.0 * inch, 0.0}, 1e-7);
  CHECK_FALSE(tells(loaded, "bend or step between keys"));
  CHECK_FALSE(tells(loaded, "layers"));
}

TEST_CASE("Units and axes of an FBX become metres and Y up") {
  SECTION("centimetres") {
    const gltf::Loaded loaded = loadedText("bones.fbx", test::twoBonesFbx({.centimetresOfUnit = 1.0}));
    checkNear(positionOf(worldOf(loaded, "upper", 0.0)), {0.0, 0.1, 0.0}, 1e-7);
  }
  SECTION("Z up") {
    const gltf::Loaded loaded = loadedText("bones.fbx", test::twoBonesFbx({.isZUp = true}));
    checkNear(positionOf(worldOf(loaded, "upper", 0.0)), {0.0, 0.0, -10.0 * inch}, 1e-7);
    const Vec3 upright = lowerAt(1.0);
    checkNear(positionOf(worldOf(loaded, "lower", 1.0)), {upright.x, upright.z, -upright.y}, 1e-6);
  }
  SECTION("a root that undoes the unit, as Blender writes it, leaves no scale behind") {
    const gltf::Loaded loaded =
        loadedText("bones.fbx", test::twoBonesFbx({.centimetresOfUnit = 1.0, .upperScale = 100.0}));
    CHECK(glm::length(loaded.scene->nodes[nodeNamed(*loaded.scene, "upper")].rest.scale - Vec3(1.0)) < 1e-5);
    CHECK(glm::length(Vec3(worldOf(loaded, "lower", 0.0)[0])) == Approx(1.0).epsilon(1e-5));
  }
}

TEST_CASE("A parent's scale reaches a bone, or does not where the FBX says so") {
  const gltf::Loaded inherits = loadedText("bones.fbx", test::twoBonesFbx({.upperScale = 2.0}));
  CHECK(glm::length(Vec3(worldOf(inherits, "lower", 0.5)[0])) == Approx(2.0).epsilon(1e-5));
  const gltf::Loaded sheds =
      loadedText("bones.fbx", test::twoBonesFbx({.childInherits = 2, .upperScale = 2.0}));
  CHECK(glm::length(Vec3(worldOf(sheds, "lower", 0.5)[0])) == Approx(1.0).epsilon(1e-5));
  // Its place is the scaled one either way.
  checkNear(positionOf(worldOf(sheds, "lower", 0.5)), lowerAt(0.5, 2.0), 1e-5);
  checkNear(positionOf(worldOf(inherits, "lower", 0.5)), lowerAt(0.5, 2.0), 1e-5);
}

TEST_CASE("A scale that is not inherited is not, with pivots and without, at rest and while the clip plays") {
  for (const bool upperPivots : {false, true}) {
    for (const bool lowerPivots : {false, true}) {
      CAPTURE(upperPivots, lowerPivots);
      const gltf::Loaded loaded = loadedText("bones.fbx", test::twoBonesFbx({.childInherits = 2,
                                                                             .upperScale = 2.0,
                                                                             .upperPivots = upperPivots,
                                                                             .lowerPivots = lowerPivots}));
      for (const double seconds : {0.0, 0.5, 1.0}) {
        const Mat4 lower = worldOf(loaded, "lower", seconds);
        for (int axis = 0; axis < 3; ++axis) {
          CHECK(glm::length(Vec3(lower[axis])) == Approx(1.0).epsilon(1e-4));
        }
      }
    }
  }
}

TEST_CASE("An uneven scale that is not inherited is taken back along the parent's axes") {
  const gltf::Loaded loaded =
      loadedText("bones.fbx", test::twoBonesFbx({.childInherits = 2, .upperStretch = 2.0}));
  const Mat4 across = worldOf(loaded, "lower", 0.75); // turned by 90 degrees
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(glm::length(Vec3(across[axis])) == Approx(1.0).epsilon(0.01));
  }
}

TEST_CASE("What the library cannot do with an FBX is told where it shows") {
  CHECK(tells(loadedText("bones.fbx", test::twoBonesFbx({.keyFlags = 8})), "bend or step between keys"));
  CHECK(tells(loadedText("bones.fbx", test::twoBonesFbx({.keyFlags = 2})), "bend or step between keys"));
  CHECK_FALSE(tells(loadedText("bones.fbx", test::twoBonesFbx({.keyFlags = 4})), "between keys"));
  CHECK(tells(loadedText("bones.fbx", test::twoBonesFbx({.layers = 2})), "not blended"));
  const TemporaryFolder folder;
  const std::string old =
      test::refusal(gltf::load(folder.write("old.fbx", test::twoBonesFbx({.version = 6100}))));
  CHECK(old.find("version 6.1") != std::string::npos);
  std::string bigEndian = "Kaydara FBX Binary  ";
  bigEndian += std::string("\0\x1a\x01\0\0\x1d\x4c", 7) + std::string(100, '\0');
  CHECK(test::refusal(gltf::load(folder.write("big.fbx", bigEndian))).find("big endian") !=
        std::string::npos);
}

TEST_CASE("What the reader calls faulty is counted, and the first of it told") {
  const auto told = [](const std::vector<std::pair<std::string, std::string>>& faults) {
    std::string text = test::twoBonesFbx();
    for (const auto& [whole, broken] : faults) {
      REQUIRE(text.find(whole) != std::string::npos);
      text.replace(text.find(whole), whole.size(), broken);
    }
    const gltf::Loaded loaded = loadedText("bones.fbx", text);
    const auto line = std::ranges::find_if(loaded.warnings, [](const std::string& one) {
      return one.find("what the reader calls faulty") != std::string::npos;
    });
    return line == loaded.warnings.end() ? std::string() : *line;
  };
  CHECK(told({}).empty());
  const std::pair<std::string, std::string> faces{"PolygonVertexIndex", "PolygonVertexOndex"};
  const std::pair<std::string, std::string> keys{"KeyValueFloat", "KeyValueFlaat"};
  const std::pair<std::string, std::string> weights{"Indexes: *2 {\n      a: 0,1",
                                                    "Indexes: *1 {\n      a: 0"};
  CHECK_THAT(told({faces}), Catch::Contains("(1 times, first: ") && Catch::Contains("PolygonVertexIndex"));
  CHECK_THAT(told({keys}), Catch::Contains("(1 times, first: ") && Catch::Contains("KeyValueFloat"));
  CHECK_THAT(told({weights}), Catch::Contains("(1 times, first: ") && Catch::Contains("index and weight"));
  // Keys are read before meshes.
  CHECK_THAT(told({faces, keys}), Catch::Contains("(2 times, first: ") && Catch::Contains("KeyValueFloat") &&
                                      !Catch::Contains("PolygonVertexIndex"));
}

TEST_CASE("Meshes of an FBX come with skin, material and morph target") {
  const gltf::Loaded loaded = loadedText("bones.fbx", test::twoBonesFbx());
  const Scene& scene = *loaded.scene;
  REQUIRE(scene.meshes.size() == 1);
  REQUIRE(scene.skins.size() == 1);
  const Primitive& skin = scene.meshes.front().primitives.front();
  REQUIRE(skin.positions.size() == 3);
  REQUIRE(skin.influences.size() == 3);
  REQUIRE(skin.morphTargets.size() == 1);
  CHECK(scene.materials.at(static_cast<std::size_t>(skin.material)).name == "red");
  CHECK(scene.materials.at(static_cast<std::size_t>(skin.material)).baseColor.g == Approx(0.0));
  CHECK((*loaded.source->json)["meshes"][0]["extras"]["targetNames"][0] == "smile");
  for (std::size_t v = 0; v < 3; ++v) {
    const Vec3 rest = Vec3(skin.positions[v]) / inch;
    const std::string bone = scene.nodes[at(scene.skins[0].joints.at(skin.influences[v].joints[0]))].name;
    INFO(rest.x << " " << rest.y << " " << bone);
    CHECK(bone == (rest.y > 10.5 ? "lower" : "upper"));
    CHECK(skin.morphTargets[0].positions[v].z == Approx(rest.x > 0.5 ? 2.0 * inch : 0.0).margin(1e-7));
    if (bone == "upper") {
      // The bone is bound without the quarter turn that it rests with.
      const Mat4 joint =
          worldOf(loaded, bone, 0.0) * scene.skins[0].inverseBind.at(skin.influences[v].joints[0]);
      checkNear(transformPoint(joint, Vec3(skin.positions[v])), inch * Vec3(0.0, 10.0 + rest.x, 0.0), 1e-6);
    }
  }
}

TEST_CASE("Vertices of a skin that no bone moves stay with their mesh") {
  std::string text = test::twoBonesFbx();
  const std::size_t weights = text.find("a: 1,1");
  text.replace(weights, 6, "a: 1,0");
  const gltf::Loaded loaded = loadedText("bones.fbx", text);
  CHECK(tells(loaded, "1 vertices of skinned meshes follow no bone"));
  CHECK(loaded.scene->skins.at(0).joints.size() == 3);
  // glTF asks for one node above all joints of a skin; where there is one, none is added.
  const auto rootsOf = [](const gltf::Loaded& file) {
    return static_cast<std::size_t>(
        std::ranges::count_if(file.scene->skins.at(0).joints, [&](NodeIndex joint) {
          return !file.scene->nodes[at(joint)].parent.exists();
        }));
  };
  CHECK(rootsOf(loaded) == 0);
  CHECK(loaded.scene->nodes.back().name == "Common root");
  CHECK(loadedText("bones.fbx", test::twoBonesFbx()).scene->nodes.back().name != "Common root");
}

TEST_CASE("Bones of a skin that the file has no node for are counted, and what they move stays") {
  const auto skinOf = [](const std::string& first, const std::string& second) {
    std::string text = test::postCollada();
    const auto put = [&](const std::string& before, const std::string& at, const std::string& instead) {
      const std::size_t place = text.find(at);
      REQUIRE(place != std::string::npos);
      text.replace(place, at.size(), before + instead);
    };
    put("<library_controllers><controller id=\"c\"><skin source=\"#g\"><bind_shape_matrix>1 0 0 0 0 1 0 0 0 "
        "0 1 0 0 0 0 1</bind_shape_matrix><source id=\"j\"><Name_array "
        "id=\"j-a\" "
        "count=\"2\">" +
            first + " " + second +
            "</Name_array><technique_common><accessor source=\"#j-a\" count=\"2\" stride=\"1\"><param "
            "name=\"JOINT\" type=\"name\"/></accessor></technique_common></source><source "
            "id=\"b\"><float_array "
            "id=\"b-a\" count=\"32\">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 "
            "1</float_array>"
            "<technique_common><accessor source=\"#b-a\" count=\"2\" stride=\"16\"><param name=\"TRANSFORM\" "
            "type=\"float4x4\"/></accessor></technique_common></source><source id=\"w\"><float_array "
            "id=\"w-a\" "
            "count=\"1\">1</float_array><technique_common><accessor source=\"#w-a\" count=\"1\" stride=\"1\">"
            "<param name=\"WEIGHT\" type=\"float\"/></accessor></technique_common></source><joints><input "
            "semantic=\"JOINT\" source=\"#j\"/><input semantic=\"INV_BIND_MATRIX\" source=\"#b\"/></joints>"
            "<vertex_weights count=\"3\"><input semantic=\"JOINT\" source=\"#j\" offset=\"0\"/><input "
            "semantic=\"WEIGHT\" source=\"#w\" offset=\"1\"/><vcount>1 1 1</vcount><v>0 0 1 0 1 0</v>"
            "</vertex_weights></skin></controller></library_controllers>",
        "<library_animations>", "<library_animations>");
    put("<instance_controller url=\"#c\"/>", "<instance_geometry url=\"#g\"/>", "");
    return loadedText("post.dae", text);
  };
  constexpr const char* lost = "bones of skins are not in the file: what they move stays";
  CHECK(tells(skinOf("nobody", "no-one"), std::string("2 ") + lost));
  CHECK(tells(skinOf("post", "nobody"), std::string("1 ") + lost));
  CHECK_FALSE(tells(skinOf("post", "post"), lost));
}

TEST_CASE("Collada opens in metres and Y up, and plays") {
  const gltf::Loaded loaded = loadedText("post.dae", test::postCollada());
  REQUIRE(loaded.clips.size() == 1);
  checkNear(positionOf(worldOf(loaded, "post", 0.0)), {0.0, 10.0 * inch, 0.0}, 1e-6);
  checkNear(positionOf(worldOf(loaded, "post", 1.0)), {0.0, 20.0 * inch, 0.0}, 1e-6);
  REQUIRE(loaded.scene->meshes.size() == 1);
  const std::vector<glm::vec3>& corners = loaded.scene->meshes[0].primitives.at(0).positions;
  const float longest = std::ranges::max(corners, {}, [](const glm::vec3& p) { return glm::length(p); }).x;
  CHECK(std::max(longest, 0.0F) <= 1.01F * static_cast<float>(inch));
}

TEST_CASE("The same foreign file gives the same bytes, whatever it is called") {
  const TemporaryFolder folder;
  const std::string text = test::twoBonesFbx();
  const auto first =
      interchange::convertedInProcess(folder.write("a.fbx", text), interchange::Format::fbx, text.size());
  const auto second =
      interchange::convertedInProcess(folder.write("b.data", text), interchange::Format::fbx, text.size());
  REQUIRE(first);
  REQUIRE(second);
  CHECK(first->glb == second->glb);
  CHECK(gltf::load(folder / "b.data"));
}

TEST_CASE("A file of another kind is called by its name, with the way out") {
  const auto [bytes, name, way] = GENERATE(table<std::string, std::string, std::string>({
      {"PK\x03\x04", "a ZIP archive", "unpack"},
      {"\x89PNG\r\n", "a picture (PNG)", "the character that it belongs to"},
      {"\xFF\xD8\xFF\xE0", "a picture (JPEG)", "the character"},
      {"BLENDER-v300", "a scene of Blender", "export it"},
      {"RIFF....WEBPVP8", "a picture (WebP)", "the character"},
      {"RIFF....WAVEfmt", "a sound or a video", "give a character"},
      {"o cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "an OBJ mesh", "'bind'"},
      {"Dear reader,\n", "a text", "give a character"},
      {"<?xml version=\"1.0\"?><svg/>", "a text in XML", "give a character"},
      {std::string("\x01\x02\x00\x07", 4), "a file of a kind that is not known", "give a character"},
  }));
  const TemporaryFolder folder;
  const std::string told = test::refusal(gltf::load(folder.write("thing.fbx", bytes)));
  INFO(told);
  CHECK(told.find("is " + name + ", no character") != std::string::npos);
  CHECK(told.find(way) != std::string::npos);
}

TEST_CASE("Text that may be glTF is left to its own reader") {
  const TemporaryFolder folder;
  CHECK(test::refusal(gltf::load(folder.write("a.gltf", "{ \"asset\": "))).find("is no valid JSON") !=
        std::string::npos);
  CHECK(test::refusal(gltf::load(folder.write("b.gltf", "[1]"))).find("no character") == std::string::npos);
}

TEST_CASE("Foreign files are known by their names before they are read") {
  CHECK(interchange::isForeignName(".fbx"));
  CHECK(interchange::isForeignName(".BVH"));
  CHECK(interchange::isForeignName(".dae"));
  CHECK_FALSE(interchange::isForeignName(".glb"));
  CHECK_FALSE(interchange::isForeignName(".fb"));
}

TEST_CASE("A small foreign file that asks for much is refused in one line") {
  const TemporaryFolder folder;
  std::string text = test::personBvh();
  text.replace(text.find("Frames: 3"), 9, "Frames: 2000000000");
  const std::string told = test::refusal(gltf::load(folder.write("greedy.bvh", text)));
  INFO(told);
  CHECK(told != "accepted");
  CHECK(told.find('\n') == std::string::npos);
  std::string deep = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\n";
  for (int i = 0; i < 200000; ++i) {
    deep += "JOINT a\n{\nOFFSET 0 1 0\nCHANNELS 0\n";
  }
  const std::string stack = test::refusal(gltf::load(folder.write("deep.bvh", deep)));
  INFO(stack);
  CHECK(stack != "accepted");
  CHECK(stack.find('\n') == std::string::npos);
}

TEST_CASE("No damaged foreign file brings the program down") {
  const std::string text = GENERATE(test::personBvh(), test::twoBonesFbx(), test::postCollada());
  const TemporaryFolder folder;
  std::mt19937 random(7);
  const auto below = [&](std::size_t most) { return random() % most; };
  for (int run = 0; run < 40; ++run) {
    std::string damaged = text;
    for (std::size_t change = 0; change <= below(6); ++change) {
      const std::size_t place = below(damaged.size() - 8);
      switch (below(4)) {
      case 0:
        damaged[place] = static_cast<char>(below(256));
        break;
      case 1:
        damaged.erase(place, 1 + below(30));
        break;
      case 2:
        damaged.insert(place, damaged.substr(below(damaged.size() - 8), 1 + below(30)));
        break;
      default:
        damaged.replace(place, 1, "999999999");
        break;
      }
      if (damaged.size() < 200) {
        break;
      }
    }
    const std::string told =
        test::refusal(gltf::load(folder.write("damaged.fbx", damaged), gltf::Tolerance::warn));
    INFO("run " << run << ": " << told);
    CHECK_FALSE(told.empty());
    CHECK(told.find('\n') == std::string::npos);
  }
}
