// Where nodes that hang on none are put: into which scenes.
#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::armBuilder;
using test::GlbBuilder;

namespace {

constexpr int prop = 3; // below node 0
constexpr int firstAdded = 6;

Json patched(const gltf::Loaded& file, const gltf::Edits& edits) {
  const Result<gltf::Source> changed = gltf::patched(*file.source, edits);
  INFO(test::refusal(changed));
  REQUIRE(changed);
  return *changed->json;
}

} // namespace

TEST_CASE("A new root that takes over a mesh joins every scene that shows the mesh") {
  GlbBuilder glb = armBuilder();
  glb.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {5}}}, {{"nodes", {5, 0}}}};
  glb.json["scene"] = 2;
  const gltf::Loaded file = test::loaded(glb);
  gltf::Edits edits;
  edits.addedNodes = {{"prop_mesh", NodeIndex::none, {}, NodeIndex(prop), false}};
  const Json changed = patched(file, edits);
  CHECK(changed["scenes"][0]["nodes"] == Json::array({0, firstAdded}));
  CHECK(changed["scenes"][1]["nodes"] == Json::array({5}));
  CHECK(changed["scenes"][2]["nodes"] == Json::array({5, 0, firstAdded}));
}

TEST_CASE("A new root joins the scene that is shown") {
  GlbBuilder glb = armBuilder();
  glb.json["scenes"] = {{{"nodes", {5}}}, {{"nodes", {0}}}};
  glb.json["scene"] = 1;
  const gltf::Loaded file = test::loaded(glb);
  gltf::Edits edits;
  edits.addedNodes = {{"root_too", NodeIndex::none, {}, NodeIndex::none, false}};
  const Json changed = patched(file, edits);
  CHECK(changed["scenes"][0]["nodes"] == Json::array({5}));
  CHECK(changed["scenes"][1]["nodes"] == Json::array({0, firstAdded}));
}
