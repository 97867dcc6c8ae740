// Which cameras of a file somebody can look through, and how wide their pictures are.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;

namespace {

/// The cameras of the arm's file, whose only one is this.
std::vector<SceneCamera> camerasWith(const char* json) {
  test::GlbBuilder glb = test::armBuilder();
  glb.json["cameras"] = Json::array({Json::parse(json)});
  const gltf::Loaded file = test::loaded(glb);
  const bool isTold = test::warnsOf(file, "has neither a usable angle nor a usable height");
  CHECK(isTold == file.scene->cameras.empty());
  return file.scene->cameras;
}

} // namespace

TEST_CASE("A lens has an angle between nothing and a half turn, or a height") {
  for (const char* const angle : {"0.001", "3.14"}) {
    CHECK(camerasWith(
              (R"({"type": "perspective", "perspective": {"yfov": )" + std::string(angle) + "}}").c_str())
              .size() == 1);
  }
  for (const char* const angle : {"-0.5", "0", "3.15"}) {
    CHECK(camerasWith(
              (R"({"type": "perspective", "perspective": {"yfov": )" + std::string(angle) + "}}").c_str())
              .empty());
  }
  CHECK(camerasWith(R"({"type": "orthographic", "orthographic": {"ymag": 2}})").size() == 1);
  CHECK(camerasWith(R"({"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 0}})").empty());
  CHECK(camerasWith(R"({"type": "orthographic", "orthographic": {"xmag": 3}})").empty());
  CHECK(camerasWith(R"({"type": "orthographic", "perspective": {"yfov": 1}})").empty());
  CHECK(camerasWith(R"({"perspective": {"yfov": 1}})").empty());
}

TEST_CASE("A picture is as wide as its camera says, where that is a width at all") {
  const auto aspectOf = [](const char* json) { return camerasWith(json).at(0).aspect; };
  CHECK(aspectOf(R"({"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": 2.5}})") == 2.5);
  CHECK_FALSE(aspectOf(R"({"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": -2}})"));
  CHECK_FALSE(aspectOf(R"({"type": "perspective", "perspective": {"yfov": 1}})"));
  CHECK(aspectOf(R"({"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2}})") == 1.5);
  CHECK_FALSE(aspectOf(R"({"type": "orthographic", "orthographic": {"ymag": 2}})"));
}
