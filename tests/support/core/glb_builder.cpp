#include "tests/support/core/glb_builder.h"

#include <algorithm>
#include <fstream>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/glb.h"

namespace stretch::test {

namespace fs = std::filesystem;
using gltf::Json;

namespace {

Json nodesOfArm() {
  return Json::parse(R"([
    {"name": "root", "children": [1, 4]},
    {"name": "upper", "children": [2], "translation": [0, 1, 0], "extras": {"odd": [1, 2.5, 12345678901]}},
    {"children": [3], "name": "lower", "translation": [0, 1, 0], "rotation": [0, 0, 0.6, 0.8]},
    {"name": "prop", "mesh": 1, "translation": [0, 0.5, 0], "scale": [1, 1, 1]},
    {"name": "body", "mesh": 0, "skin": 0},
    {"name": "camera", "matrix": [0,1,0,0, -1,0,0,0, 0,0,1,0, 0,1,0,1], "camera": 0, "x_unknown": {"kept": true}}])");
}

void addMeshes(GlbBuilder& glb) {
  const int positions = glb.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0}, "VEC3", 3);
  glb.json["accessors"][static_cast<std::size_t>(positions)]["min"] = {0, 0, 0};
  glb.json["accessors"][static_cast<std::size_t>(positions)]["max"] = {1, 2, 0};
  const std::vector<std::uint8_t> jointNumbers{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0,
                                               0, 1, 0, 0, 1, 2, 0, 0, 2, 0, 0, 0};
  const int joints = glb.accessor(jointNumbers, 5121, "VEC4", 4);
  const int weights = glb.floats(
      {1, 0, 0, 0, 1, 0, 0, 0, .5F, .5F, 0, 0, .25F, .75F, 0, 0, .5F, .5F, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
  const int indices = glb.accessor(std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5}, 5123, "SCALAR", 1);
  glb.json["meshes"] = {
      {{"name", "skin"},
       {"primitives",
        {{{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
          {"indices", indices},
          {"mode", 5},
          {"material", 0}}}}},
      {{"name", "prop"}, {"primitives", {{{"attributes", {{"POSITION", positions}}}}}}}};
}

void addSkin(GlbBuilder& glb) {
  std::vector<float> matrices;
  for (int joint = 0; joint < 3; ++joint) {
    const auto height = static_cast<float>(joint);
    const std::vector<float> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1};
    matrices.insert(matrices.end(), matrix.begin(), matrix.end());
  }
  const int inverseBind = glb.floats(matrices, "MAT4", 16);
  glb.json["skins"] = {{{"joints", {0, 1, 2}}, {"inverseBindMatrices", inverseBind}}};
}

Json sampler(int input, const char* interpolation, int output) {
  return {{"input", input}, {"interpolation", interpolation}, {"output", output}};
}

Json channel(int sampler, int node, const char* path) {
  return {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
}

int timesOf(GlbBuilder& glb, const std::vector<float>& times) {
  const int accessor = glb.floats(times, "SCALAR", 1);
  glb.json["accessors"][static_cast<std::size_t>(accessor)]["min"] = {times.front()};
  glb.json["accessors"][static_cast<std::size_t>(accessor)]["max"] = {times.back()};
  return accessor;
}

void addClips(GlbBuilder& glb) {
  const int times = timesOf(glb, {0, .5F, 1});
  const int oneTime = timesOf(glb, {0});
  const float half = 0.70710678F;
  const int turns = glb.floats({0, 0, 0, 1, 0, 0, half, half, 0, 0, 0, 1}, "VEC4", 4);
  const int moves = glb.floats(
      {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0}, "VEC3", 3);
  const int scales = glb.floats({1, 1, 1, 2, 2, 2, 1, 1, 1}, "VEC3", 3);
  const int still = glb.floats({0, 0, 0, 1}, "VEC4", 4);
  glb.json["animations"] = {
      {{"name", "wave"},
       {"samplers",
        {sampler(times, "LINEAR", turns), sampler(times, "CUBICSPLINE", moves),
         sampler(times, "STEP", scales)}},
       {"channels", {channel(0, 2, "rotation"), channel(1, 2, "translation"), channel(2, 1, "scale")}}},
      {{"name", "still"},
       {"samplers", {sampler(oneTime, "LINEAR", still)}},
       {"channels", {channel(0, 1, "rotation")}}}};
}

} // namespace

gltf::Bytes GlbBuilder::bytes() const {
  gltf::Glb glb;
  Json document = json;
  Json& buffers = document["buffers"];
  if (!buffers.is_array() || buffers.empty() || !buffers[0].is_object()) {
    buffers = {Json::object()};
  }
  buffers[0]["byteLength"] = binary.size();
  glb.json = document.dump();
  glb.hasBinary = true;
  glb.binary = binary;
  return gltf::writeGlb(glb).value();
}

void GlbBuilder::write(const fs::path& path) const {
  writeBytes(path, bytes());
}

GlbBuilder armBuilder() {
  GlbBuilder glb;
  glb.json = {{"asset", {{"version", "2.0"}, {"generator", "stretch-engine tests"}, {"x_unknown", 1.5}}},
              {"extensionsUsed", {"X_unknown"}},
              {"extensions", {{"X_unknown", {{"kept", {1, 2, 3}}}}}},
              {"scene", 0},
              {"scenes", {{{"nodes", {0, 5}}}}},
              {"nodes", nodesOfArm()},
              {"cameras", {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}}},
              {"materials", {{{"name", "skin"}, {"doubleSided", true}}}},
              {"bufferViews", Json::array()},
              {"accessors", Json::array()}};
  addMeshes(glb);
  addSkin(glb);
  addClips(glb);
  return glb;
}

void writeBytes(const fs::path& path, const gltf::Bytes& bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

gltf::Bytes readBytes(const fs::path& path) {
  return readFile(path).value();
}

Result<gltf::Loaded> loadBytes(const gltf::Bytes& bytes, gltf::Tolerance tolerance) {
  const TemporaryFolder folder;
  writeBytes(folder / "model.glb", bytes);
  return gltf::load(folder / "model.glb", tolerance);
}

gltf::Loaded loaded(const GlbBuilder& glb) {
  Result<gltf::Loaded> result = loadBytes(glb.bytes());
  if (!result) {
    FAIL(result.error().line());
  }
  return std::move(result.value());
}

bool warnsOf(const gltf::Loaded& file, const std::string& words) {
  return std::ranges::any_of(file.warnings,
                             [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

} // namespace stretch::test
