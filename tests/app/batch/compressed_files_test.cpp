#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/compressed_files.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::test;
using gltf::Json;

namespace {

Json jsonOf(const std::string& verb, const std::filesystem::path& file) {
  const VerbAnswer answer = runVerb({verb, file.string(), "--json"});
  REQUIRE(answer.exitCode == 0);
  return Json::parse(answer.output);
}

// The punching biped stretched from the command line.
gltf::Loaded stretched(const GlbBuilder& file, const TemporaryFolder& folder, const std::string& name) {
  const std::filesystem::path source = folder / (name + ".glb");
  const std::filesystem::path output = folder / (name + "-stretched.glb");
  file.write(source);
  REQUIRE(runVerb({"exaggerate", source.string(), "-o", output.string(), "--limb", "left-arm", "--range",
                   "0:12", "--scale", "3"})
              .exitCode == 0);
  Result<gltf::Loaded> loaded = gltf::loadAsItStands(output);
  REQUIRE(loaded);
  return std::move(loaded.value());
}

} // namespace

TEST_CASE(
    "A packed character has the limbs of the plain one and is stretched alike, its packed data untouched") {
  const MovingBiped moving = punchingBiped();
  const GlbBuilder plain = characterFile(moving.scene, {moving.clip});
  const GlbBuilder packed = packedByMeshopt(plain, Filters::none);
  const TemporaryFolder folder;
  const gltf::Loaded expected = stretched(plain, folder, "plain");
  const gltf::Loaded found = stretched(packed, folder, "packed");
  CHECK(jsonOf("info", folder / "packed.glb")["limbs"] == jsonOf("info", folder / "plain.glb")["limbs"]);
  REQUIRE(found.scene->nodes.size() == expected.scene->nodes.size());
  CHECK(found.scene->nodes.size() > moving.scene.nodes.size()); // bind leaves
  CHECK(found.scene->meshes[0].primitives[0].positions == expected.scene->meshes[0].primitives[0].positions);
  CHECK(found.scene->skins[0].inverseBind == expected.scene->skins[0].inverseBind);
  for (const double seconds : {0.0, 0.2, 0.35, 0.5, 1.0}) {
    const auto frameAt = [&](const gltf::Loaded& file) {
      return frameOf(*file.scene, samplePose(*file.scene, file.clips[0], seconds), seconds);
    };
    CHECK(largestMatrixMiss(frameAt(found), frameAt(expected)) == 0.0);
  }
  const Result<gltf::Loaded> source = gltf::load(folder / "packed.glb");
  REQUIRE(source);
  const gltf::Bytes& before = source->source->buffers[0];
  const gltf::Bytes& after = found.source->buffers[0];
  REQUIRE(before.size() < after.size());
  CHECK(std::equal(before.begin(), before.end(), after.begin()));
}

TEST_CASE("info and check list the extensions of a file and say which are not shown") {
  const MovingBiped moving = punchingBiped();
  GlbBuilder file = packedByMeshopt(characterFile(moving.scene, {moving.clip}), Filters::none);
  file.json["extensionsUsed"].push_back("KHR_materials_clearcoat");
  const TemporaryFolder folder;
  file.write(folder / "model.glb");
  const Json expected = {
      {{"name", "EXT_meshopt_compression"}, {"required", true}, {"shown", true}},
      {{"name", "KHR_materials_clearcoat"}, {"required", false}, {"shown", false}},
  };
  CHECK(jsonOf("info", folder / "model.glb")["extensions"] == expected);
  CHECK(jsonOf("check", folder / "model.glb")["extensions"] == expected);
}
