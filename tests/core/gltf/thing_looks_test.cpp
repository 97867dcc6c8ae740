// What a thing of another file looks like in the file that takes it: its pictures, and its shape at rest.
#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/source/added_file.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;

namespace {

Json takenFrom(const test::TemporaryFolder& folder, const test::GlbBuilder& glb) {
  glb.write(folder / "sheets.glb");
  const Result<gltf::Thing> thing = gltf::readThing(folder / "sheets.glb");
  INFO(test::refusal(thing));
  REQUIRE(thing);
  CHECK(thing->warnings.empty());
  return *thing->source->json;
}

} // namespace

TEST_CASE("A picture that does not say what it is is told by how it begins, of each kind") {
  using namespace std::string_literals;
  const auto& [bytes, type] =
      GENERATE(values<std::pair<std::string, std::string>>({{"\xFF\xD8\xFF\xE0 cloth"s, "image/jpeg"},
                                                            {"RIFF\x10\0\0\0WEBPVP8L"s, "image/webp"},
                                                            {"\x89PNG\r\n\x1A\n cloth"s, "image/png"}}));
  CAPTURE(type);
  const test::TemporaryFolder folder;
  folder.write("cloth.picture", bytes);
  const Json taken = takenFrom(folder, test::twoSheets("cloth.picture"));
  REQUIRE(taken["images"].size() == 1);
  CHECK(taken["images"][0]["mimeType"] == type);
  CHECK(taken["images"][0].contains("bufferView"));
}

TEST_CASE("A thing keeps the morph weights that its node has at rest, beside those of its mesh") {
  const test::TemporaryFolder folder;
  test::GlbBuilder glb = test::twoSheets();
  glb.json["nodes"][1]["weights"] = {0.75};
  const Json nodes = takenFrom(folder, glb)["nodes"];
  REQUIRE(nodes.size() == 2);
  CHECK_FALSE(nodes[0].contains("weights"));
  CHECK(nodes[1]["weights"] == Json::array({0.75}));
}
