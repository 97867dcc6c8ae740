#include "tests/support/app/camera_file.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "core/gltf/source/glb.h"
#include "tests/support/core/glb_builder.h"

namespace stretch::test {

std::string boxerWithCameras(const TemporaryFolder& folder) {
  const Result<gltf::Glb> glb = gltf::readGlb(readBytes(STRETCH_SOURCE_DIR "/assets/dummy.glb"));
  REQUIRE(glb);
  GlbBuilder file{gltf::Json::parse(glb->json), glb->binary};
  const float turn = std::sqrt(0.5F);
  file.json["cameras"] = {
      {{"type", "perspective"},
       {"perspective", {{"yfov", 0.6}, {"aspectRatio", 16.0 / 9.0}, {"znear", 0.1}}}},
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.1}, {"zfar", 100.0}}}}};
  const std::size_t first = file.json["nodes"].size();
  file.json["nodes"].push_back({{"name", "Side"},
                                {"camera", 0},
                                {"translation", {4.0, 1.2, 0.5}},
                                {"rotation", {0.0, turn, 0.0, turn}}});
  file.json["nodes"].push_back({{"name", "Front"}, {"camera", 0}, {"translation", {0.0, 1.2, 5.0}}});
  file.json["nodes"].push_back({{"name", "Flat"}, {"camera", 1}, {"translation", {0.0, 1.2, 5.0}}});
  for (std::size_t i = 0; i < 3; ++i) {
    file.json["scenes"][0]["nodes"].push_back(first + i);
  }
  const int times = file.floats({0.0F, 27.0F / 24.0F}, "SCALAR", 1);
  file.json["accessors"][static_cast<std::size_t>(times)]["min"] = {0.0F};
  file.json["accessors"][static_cast<std::size_t>(times)]["max"] = {27.0F / 24.0F};
  const int places = file.floats({4.0F, 1.2F, 0.5F, 0.0F, 1.2F, 5.0F}, "VEC3", 3);
  const int turns = file.floats({0.0F, turn, 0.0F, turn, 0.0F, 0.0F, 0.0F, 1.0F}, "VEC4", 4);
  gltf::Json& clip = file.json["animations"][0];
  for (const auto& [path, output] : {std::pair("translation", places), std::pair("rotation", turns)}) {
    clip["samplers"].push_back({{"input", times}, {"output", output}});
    clip["channels"].push_back(
        {{"sampler", clip["samplers"].size() - 1}, {"target", {{"node", first + 1}, {"path", path}}}});
  }
  const std::filesystem::path path = folder / "cameras.glb";
  file.write(path);
  return path.string();
}

} // namespace stretch::test
