#include "tests/support/core/two_sheets.h"

#include <cmath>

namespace stretch::test {

using gltf::Json;

GlbBuilder twoSheets(const std::string& pictureUri) {
  GlbBuilder glb;
  glb.json = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"mesh": 1, "translation": [5, 0, 0]}],
    "materials": [{"name": "plain"}, {"name": "cloth", "alphaMode": "MASK", "alphaCutoff": 0.25,
      "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "roughnessFactor": 0.375},
      "occlusionTexture": {"index": 0, "texCoord": 1}, "extensions": {"KHR_materials_unlit": {}}}],
    "extensionsUsed": ["KHR_materials_unlit"],
    "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071}]})");
  glb.json["images"] = {{{"uri", pictureUri}, {"name", "weave"}}};
  const auto sheet = [&](const char* name, int material) {
    const int places = glb.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 3);
    for (const char* const bound : {"min", "max"}) {
      const float value = bound[1] == 'i' ? 0.0F : 1.0F;
      glb.json["accessors"][static_cast<std::size_t>(places)][bound] = {value, value, 0.0F};
    }
    const int lifted = glb.floats({0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2}, "VEC3", 3);
    glb.json["accessors"][static_cast<std::size_t>(lifted)]["min"] = {0, 0, 0};
    glb.json["accessors"][static_cast<std::size_t>(lifted)]["max"] = {0, 0, 2};
    const int indices = glb.accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 1);
    const Json primitive{{"attributes", {{"POSITION", places}}},
                         {"indices", indices},
                         {"material", material},
                         {"targets", {{{"POSITION", lifted}}}}};
    glb.json["meshes"].push_back({{"name", name}, {"primitives", {primitive}}, {"weights", {0}}});
  };
  sheet("sail", 1);
  sheet("flag", 0);
  Json& sail = glb.json["meshes"][0]["primitives"][0]["attributes"];
  sail["TEXCOORD_0"] = glb.floats({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2", 2);
  sail["TEXCOORD_1"] = glb.floats({.5F, 0, .75F, 0, .75F, .5F, .5F, .5F}, "VEC2", 2);
  glb.json["meshes"][1]["primitives"][0]["attributes"]["COLOR_0"] =
      glb.floats({1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, .5F, .5F, .5F, 1}, "VEC4", 4);
  const float slope = 1.0F / std::sqrt(5.0F); // of the lifted sheet: (0, -2, 1) of unit length
  const float down = -2.0F * slope;
  const float level = slope - 1.0F;
  Json& flag = glb.json["meshes"][1]["primitives"][0];
  flag["attributes"]["NORMAL"] = glb.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  flag["targets"][0]["NORMAL"] =
      glb.floats({0, down, level, 0, down, level, 0, down, level, 0, down, level}, "VEC3", 3);
  const int times = glb.floats({0, 0.5F, 1}, "SCALAR", 1);
  glb.json["accessors"][static_cast<std::size_t>(times)]["min"] = {0};
  glb.json["accessors"][static_cast<std::size_t>(times)]["max"] = {1};
  const int weights = glb.floats({0, 1, 0}, "SCALAR", 1);
  const Json channels{{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}},
                      {{"sampler", 0}, {"target", {{"node", 1}, {"path", "weights"}}}}};
  glb.json["animations"] = {
      {{"name", "flutter"}, {"samplers", {{{"input", times}, {"output", weights}}}}, {"channels", channels}}};
  return glb;
}

} // namespace stretch::test
