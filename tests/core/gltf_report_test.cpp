#include <catch2/catch.hpp>

#include <cmath>

#include "core/gltf/load/report.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using test::armBuilder;

namespace {

std::vector<gltf::Problem> problemsOf(const test::GlbBuilder& glb) {
  const test::TemporaryFolder folder;
  glb.write(folder / "model.glb");
  return gltf::diagnose(folder / "model.glb").problems;
}

// Two nodes, the lower turned by 45 degrees under a parent with this scale; the lower holds a mesh.
Scene turnedUnder(const Vec3& scale) {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].children = {NodeIndex(1)};
  scene.nodes[0].rest.scale = scale;
  scene.nodes[1].parent = NodeIndex(0);
  scene.nodes[1].mesh = 0;
  scene.nodes[1].rest.rotation = glm::angleAxis(pi / 4, Vec3(0, 0, 1));
  return scene;
}

} // namespace

TEST_CASE("A sound file has no problems") {
  CHECK(problemsOf(armBuilder()).empty());
}

TEST_CASE("Problems after the first error are reported too") {
  test::GlbBuilder glb = armBuilder();
  glb.json["nodes"][1].erase("name");
  glb.json["nodes"][0]["children"] = {99};
  glb.json["nodes"][4]["mesh"] = 12;
  glb.json["skins"][0]["skeleton"] = 33;
  const std::vector<gltf::Problem> problems = problemsOf(glb);
  REQUIRE(problems.size() == 3);
  CHECK(problems[0].where == "nodes[0].children[0]");
  CHECK(problems[1].where == "nodes[4].mesh");
  CHECK(problems[2].where == "skins[0].skeleton");
}

TEST_CASE("A file that is not there is one error") {
  const std::vector<gltf::Problem> problems = gltf::diagnose("/nowhere/at/all.glb").problems;
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].severity == gltf::Severity::error);
}

TEST_CASE("A skin of more joints than some engines hold is told, from 129 on") {
  const std::size_t joints = GENERATE(128U, 129U);
  test::GlbBuilder glb = armBuilder();
  const std::size_t own = glb.json["nodes"].size();
  for (std::size_t i = glb.json["skins"][0]["joints"].size(); i < joints; ++i) {
    glb.json["nodes"][0]["children"].push_back(glb.json["nodes"].size());
    glb.json["skins"][0]["joints"].push_back(glb.json["nodes"].size());
    glb.json["nodes"].push_back({{"name", "twist " + std::to_string(i)}});
  }
  REQUIRE(glb.json["nodes"].size() > own);
  glb.json["skins"][0].erase("inverseBindMatrices");
  const std::vector<gltf::Problem> problems = problemsOf(glb);
  REQUIRE(problems.size() == (joints > 128 ? 1 : 0));
  if (!problems.empty()) {
    CHECK(problems[0].severity == gltf::Severity::warning);
    CHECK(problems[0].where == "skins[0]");
    CHECK(problems[0].what == "has 129 joints; some engines hold 128 at most");
  }
}

TEST_CASE("A rotation under an uneven scale shears, under an even one it does not") {
  CHECK(gltf::residualShear(turnedUnder(Vec3(2.0)), {}).empty());
  CHECK(gltf::residualShear(turnedUnder(Vec3(-2.0, 2.0, 2.0)), {}).empty());
  const std::vector<gltf::Shear> shear = gltf::residualShear(turnedUnder(Vec3(2.0, 1.0, 1.0)), {});
  REQUIRE(shear.size() == 1);
  CHECK(shear[0].node == NodeIndex(1));
  CHECK(shear[0].clip == -1);
  CHECK(shear[0].cosine == Approx(0.6)); // columns (2, 1) and (-2, 1): 3 / 5
}

TEST_CASE("Shear is found at the key where it is largest") {
  const Track scale{
      NodeIndex(0), Channel::scale, Interpolation::linear, 3, {0, 1, 2}, {1, 1, 1, 2, 1, 1, 1, 1, 1}, -1};
  Clip clip;
  clip.tracks = {CopyOnWrite<Track>(scale)};
  const std::vector<gltf::Shear> shear = gltf::residualShear(turnedUnder(Vec3(1.0)), {clip});
  REQUIRE(shear.size() == 1);
  CHECK(shear[0].clip == 0);
  CHECK(shear[0].timeSeconds == 1.0);
}

TEST_CASE("Shear of a node that no mesh follows does not matter") {
  Scene scene = turnedUnder(Vec3(2.0, 1.0, 1.0));
  scene.nodes[1].mesh = -1;
  CHECK(gltf::residualShear(scene, {}).empty());
}

TEST_CASE("Of shear is told whether it stands at rest or in which clip and when") {
  test::GlbBuilder glb = armBuilder();
  glb.json["nodes"][2]["rotation"] = {0.0, 0.0, std::sin(pi / 8), std::cos(pi / 8)};
  std::string where = "at rest";
  SECTION("at rest") {
    glb.json["nodes"][1]["scale"] = {2, 1, 1};
  }
  SECTION("in a clip") {
    gltf::Json& still = glb.json["animations"][1];
    const int times = glb.floats({0, 0.5}, "SCALAR", 1);
    glb.json["accessors"].back()["min"] = {0};
    glb.json["accessors"].back()["max"] = {0.5};
    const int scales = glb.floats({1, 1, 1, 3, 1, 1}, "VEC3", 3);
    still["samplers"].push_back({{"input", times}, {"output", scales}});
    still["channels"].push_back(
        {{"sampler", still["samplers"].size() - 1}, {"target", {{"node", 1}, {"path", "scale"}}}});
    std::swap(glb.json["animations"][0], glb.json["animations"][1]);
    where = "in clip 'still' at 0.500 s";
  }
  const std::vector<gltf::Problem> problems = problemsOf(glb);
  REQUIRE_FALSE(problems.empty());
  CHECK(problems[0].severity == gltf::Severity::warning);
  CHECK_THAT(problems[0].what, Catch::Contains("'lower' is sheared") && Catch::Contains(where));
}
