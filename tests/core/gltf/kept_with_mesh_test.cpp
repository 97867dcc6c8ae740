// What a file says of a mesh and of its node beside its places: kept where the mesh moves, is bound or is
// animated anew.
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/core/compressed_files.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;

namespace {

constexpr int heldProp = 3; // holds a mesh of its own
constexpr int newLeaf = 6;  // the first node that is added

Json withMeshMoved(const GlbBuilder& glb) {
  const gltf::Loaded file = test::loaded(glb);
  gltf::Edits edits;
  edits.addedNodes = {{"prop_bind", NodeIndex(heldProp), {}, NodeIndex(heldProp), true}};
  const Result<gltf::Source> changed = gltf::patched(*file.source, edits);
  INFO(test::refusal(changed));
  REQUIRE(changed);
  return *changed->json;
}

} // namespace

TEST_CASE("Expressions of the user's own follow a mesh that moves, as those that VRM names") {
  GlbBuilder glb = test::armBuilder();
  glb.json["extensions"]["VRMC_vrm"]["expressions"] = Json::parse(R"({
    "preset": {"happy": {"morphTargetBinds": [{"node": 3, "index": 0, "weight": 1}]}},
    "custom": {"smirk": {"morphTargetBinds": [{"node": 4, "index": 0, "weight": 1},
                                              {"node": 3, "index": 0, "weight": 0.5}]}}})");
  const Json expressions = withMeshMoved(glb)["extensions"]["VRMC_vrm"]["expressions"];
  CHECK(expressions["preset"]["happy"]["morphTargetBinds"][0]["node"] == newLeaf);
  CHECK(expressions["custom"]["smirk"]["morphTargetBinds"][0]["node"] == 4);
  CHECK(expressions["custom"]["smirk"]["morphTargetBinds"][1]["node"] == newLeaf);
}

TEST_CASE("Instances of a mesh go along with it, other extensions of its node stay there") {
  const bool isAlone = GENERATE(true, false);
  GlbBuilder glb = test::armBuilder();
  const Json instances{{"attributes", {{"TRANSLATION", 0}}}};
  Json& extensions = glb.json["nodes"][heldProp]["extensions"];
  extensions["EXT_mesh_gpu_instancing"] = instances;
  if (!isAlone) {
    extensions["EXT_label"] = {{"text", "sword"}};
  }
  const Json nodes = withMeshMoved(glb)["nodes"];
  CHECK(nodes[newLeaf]["extensions"] == Json{{"EXT_mesh_gpu_instancing", instances}});
  CHECK(nodes[heldProp].contains("extensions") == !isAlone);
  if (!isAlone) {
    CHECK(nodes[heldProp]["extensions"] == Json{{"EXT_label", {{"text", "sword"}}}});
  }
}

TEST_CASE("A mesh packed by Draco follows the weights that it is bound by, not the packed ones") {
  const gltf::Loaded file =
      test::loaded(test::packedByDraco(test::tubeBuilder(), test::DracoMethod::sequential));
  const std::size_t vertices = file.scene->meshes[0].primitives[0].positions.size();
  const auto holder = std::ranges::find(file.scene->nodes, 0, &Node::mesh);
  REQUIRE(holder != file.scene->nodes.end());
  VertexInfluences last;
  last.joints[0] = 2;
  last.weights[0] = 1.0F;
  gltf::Edits edits;
  edits.boundMeshes = {{NodeIndex(static_cast<std::size_t>(holder - file.scene->nodes.begin())),
                        holder->skin,
                        {std::vector<VertexInfluences>(vertices, last)}}};
  const Result<gltf::Source> bound = gltf::patched(*file.source, edits);
  INFO(test::refusal(bound));
  REQUIRE(bound);
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(*bound, folder / "bound.glb"));
  const Result<gltf::Loaded> again = gltf::load(folder / "bound.glb");
  INFO(test::refusal(again));
  REQUIRE(again);
  const Primitive& tube = again->scene->meshes[0].primitives[0];
  CHECK(tube.positions.size() == vertices);
  REQUIRE(tube.influences.size() == vertices);
  CHECK(std::ranges::all_of(tube.influences, [](const VertexInfluences& vertex) {
    return vertex.joints[0] == 2 && vertex.weights[0] == 1.0F;
  }));
}

TEST_CASE("A clip whose extras are no object keeps them, whatever rate is noted for it") {
  GlbBuilder glb = test::armBuilder();
  const Json own = GENERATE(Json("by hand"), Json{{"take", 7}});
  glb.json["animations"][0]["extras"] = own;
  const gltf::Loaded file = test::loaded(glb);
  gltf::Edits edits;
  edits.clips = {{0, {}}};
  edits.clips[0].framesPerSecond = 12.0;
  const Result<gltf::Source> changed = gltf::patched(*file.source, edits);
  INFO(test::refusal(changed));
  REQUIRE(changed);
  const Json extras = (*changed->json)["animations"][0]["extras"];
  if (own.is_object()) {
    CHECK(extras["take"] == 7);
    CHECK(extras["stretch_engine"]["frames_per_second"] == 12.0);
  } else {
    CHECK(extras == own);
  }
}
