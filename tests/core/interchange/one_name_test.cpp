// Joints of one name in files of other programs: each moves by its own channels, and keeps its name.
#include <algorithm>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/gltf/source/source.h"
#include "core/interchange/one_name.h"
#include "tests/support/core/foreign_text.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using interchange::Format;

namespace {

gltf::Loaded loadedAs(const std::string& name, const std::string& text) {
  const test::TemporaryFolder folder;
  Result<gltf::Loaded> loaded = gltf::load(folder.write(name, text));
  INFO(test::refusal(loaded));
  REQUIRE(loaded);
  return std::move(loaded).value();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::vector<std::string> namesOf(const gltf::Loaded& loaded) {
  std::vector<std::string> names;
  std::ranges::transform(loaded.scene->nodes, std::back_inserter(names), &Node::name);
  return names;
}

/// Of all nodes in the order of the file, at a time of the only clip.
std::vector<Vec3> placesAt(const gltf::Loaded& loaded, double seconds) {
  REQUIRE(loaded.clips.size() == 1);
  std::vector<Vec3> places;
  for (const Mat4& world :
       worldMatrices(*loaded.scene, samplePose(*loaded.scene, loaded.clips.front(), seconds))) {
    places.push_back(positionOf(world));
  }
  return places;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, glm::length(a[i] - b[i]));
  }
  return most;
}

std::size_t toldOfNames(const gltf::Loaded& loaded) {
  return static_cast<std::size_t>(std::ranges::count_if(
      loaded.warnings, [](const std::string& line) { return line.find("are called") != std::string::npos; }));
}

/// A binary FBX holds a name so: its length, the name, two bytes and its class.
std::string binaryModel(const std::string& name) {
  std::string text = "S";
  const auto length = static_cast<char>(name.size() + 7);
  text += length;
  text += std::string(3, '\0') + name + std::string("\0\1Model", 7);
  return text;
}

std::string textOf(const interchange::NamesApart& names) {
  return {reinterpret_cast<const char*>(names.bytes.data()), names.bytes.size()};
}

interchange::NamesApart apart(const std::string& text, Format format) {
  return interchange::withNamesApart({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                                     format);
}

} // namespace

TEST_CASE("Two joints of one name in a BVH move each by its own columns, and keep their name") {
  const std::string told = test::personBvh();
  const gltf::Loaded plain = loadedAs("plain.bvh", told);
  // The upper leg turns, the head does not: both are called Head.
  for (const std::string name : {"Head", "Hips"}) {
    const gltf::Loaded same = loadedAs("same.bvh", replaced(told, "JOINT Leg", "JOINT " + name));
    CHECK(farthest(placesAt(same, 0.04), placesAt(plain, 0.04)) < 1e-6);
    CHECK(farthest(placesAt(same, 0.0), placesAt(same, 0.04)) > 0.1);
    CHECK(std::ranges::count(namesOf(same), name) == 2);
    CHECK(std::ranges::count(namesOf(same), "EndSite_" + name) >= 1);
    CHECK(toldOfNames(same) == 0);
  }
}

TEST_CASE("Two joints of one name in an FBX move each by its own curves, and keep their name") {
  const std::string told = test::twoBonesFbx();
  const gltf::Loaded plain = loadedAs("plain.fbx", told);
  const gltf::Loaded same = loadedAs("same.fbx", replaced(told, "Model::lower\"", "Model::upper\""));
  CHECK(std::ranges::count(namesOf(same), "upper") == 2);
  for (const double seconds : {0.0, 0.5, 1.0}) {
    CHECK(farthest(placesAt(same, seconds), placesAt(plain, seconds)) < 1e-6);
  }
  REQUIRE(same.scene->skins.size() == plain.scene->skins.size());
  CHECK(same.scene->skins.front().joints == plain.scene->skins.front().joints);
  CHECK(toldOfNames(same) == 0);
}

TEST_CASE("Names of a binary FBX are parted in place, the first keeps its own") {
  const std::string file = "Kaydara FBX Binary  " + binaryModel("Arm") + binaryModel("Leg") +
                           binaryModel("Arm") + binaryModel("Arm") + binaryModel("A") + binaryModel("A") +
                           "Arm" + '\0' + '\1' + "Geometry";
  const interchange::NamesApart names = apart(file, Format::fbx);
  REQUIRE(names.bytes.size() == file.size());
  CHECK(textOf(names).starts_with("Kaydara FBX Binary  " + binaryModel("Arm") + binaryModel("Leg")));
  CHECK(names.original.size() == 3);
  for (const auto& [given, name] : names.original) {
    CHECK(given.size() == name.size());
    CHECK(textOf(names).find(binaryModel(given)) != std::string::npos);
    CHECK(names.nameOf(given) == name);
    CHECK(names.nameOf("EndSite_" + given) == "EndSite_" + name);
  }
  CHECK(names.nameOf("Arm") == "Arm");
}

TEST_CASE("Where no name is free two joints keep theirs, and one line tells of it") {
  // 62 names of one character, and one more than once.
  std::string text = "HIERARCHY\nROOT -\n{\n OFFSET 0 0 0\n CHANNELS 3 Xposition Yposition Zposition\n";
  std::string row = "0 1 0";
  for (const char c : std::string("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyzz")) {
    text += " JOINT ";
    text += c;
    text += "\n {\n OFFSET 0 1 0\n CHANNELS 1 Xrotation\n End Site\n {\n OFFSET 0 1 0\n }\n }\n";
    row += " 5";
  }
  text += "}\nMOTION\nFrames: 2\nFrame Time: 0.1\n" + row + "\n" + row + "\n";
  const gltf::Loaded loaded = loadedAs("letters.bvh", text);
  CHECK(toldOfNames(loaded) == 1);
  CHECK(std::ranges::any_of(loaded.warnings, [](const std::string& line) {
    return line.find("2 joints are called 'z'") != std::string::npos;
  }));
}

TEST_CASE("A node of a Collada moves by its own channel, whatever other nodes are called") {
  const std::string told = test::postCollada();
  // Before the post stands a node that has the post's id for its name.
  const std::string twin = "<node id=\"twin\" name=\"post\"><translate sid=\"move\">5 0 0</translate></node>";
  const gltf::Loaded both =
      loadedAs("twin.dae", replaced(told, "<node id=\"post\"", twin + "<node id=\"post\""));
  const std::vector<Vec3> first = placesAt(both, 0.0);
  const std::vector<Vec3> last = placesAt(both, 1.0);
  const std::vector<std::string> names = namesOf(both);
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK((glm::length(first[i] - last[i]) > 0.1) == (names[i] == "post"));
  }
  CHECK(std::ranges::count(names, "post") == 1);
}

TEST_CASE("Joints of a BVH may be called by the words that name them") {
  const std::string text = "HIERARCHY\nROOT ROOT\n{\nJOINT JOINT\n{\nJOINT JOINT\n{\n}\n}\n}\nMOTION\n";
  const interchange::NamesApart names = apart(text, Format::bvh);
  REQUIRE(names.original.size() == 1);
  const auto& [given, name] = *names.original.begin();
  CHECK(name == "JOINT");
  std::string wanted = text;
  wanted.replace(text.rfind("JOINT"), 5, given);
  CHECK(textOf(names) == wanted);
}
