// The names of a humanoid's thumbs, which VRM 1.0 moved by one.
#include <map>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;

TEST_CASE("Thumbs of VRM 0 are read by the names that their bones have today, on either side") {
  test::GlbBuilder glb = test::armBuilder();
  gltf::Json& bones = glb.json["extensions"]["VRM"]["humanoid"]["humanBones"];
  std::map<std::string, NodeIndex> expected;
  int node = 0;
  for (const std::string side : {"left", "right"}) {
    for (const auto& [before, now] : {std::pair("ThumbProximal", "ThumbMetacarpal"),
                                      {"ThumbIntermediate", "ThumbProximal"},
                                      {"ThumbDistal", "ThumbDistal"}}) {
      bones.push_back({{"bone", side + before}, {"node", node}});
      expected[side + now] = NodeIndex(node++);
    }
  }
  CHECK(test::loaded(glb).scene->humanoid == expected);
}
