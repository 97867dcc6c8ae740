#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <utility>

#include "core/gltf/json/json.h"
#include "core/gltf/load/report.h"
#include "tests/support/core/compressed_files.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/damaged_json.h"

using namespace stretch;

namespace {

// Spots of the file are overwritten, in its text as likely as in its data; sometimes its end is missing.
gltf::Bytes mutated(gltf::Bytes bytes, std::mt19937& random) {
  for (unsigned change = random() % 4 + 1; change > 0; --change) {
    bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
  }
  if (random() % 8 == 0) {
    bytes.resize(random() % bytes.size());
  }
  return bytes;
}

gltf::Bytes withOtherNumber(test::GlbBuilder glb, std::mt19937& random) {
  glb.json = test::withOtherValue(std::move(glb.json), random);
  return glb.bytes();
}

// Bytes from `start` on are overwritten, one by one or as runs, or missing at the end.
test::GlbBuilder withDamage(const test::GlbBuilder& glb, std::size_t start, std::mt19937& random) {
  test::GlbBuilder damaged = glb;
  gltf::Bytes& bytes = damaged.binary;
  for (unsigned change = random() % 4 + 1; change > 0; --change) {
    const std::size_t place = start + random() % (bytes.size() - start);
    const std::size_t end = std::min(bytes.size(), place + (random() % 4 == 0 ? random() % 16 : 1));
    const auto value = static_cast<std::uint8_t>(random() % 4 == 0 ? random() % 2 * 255 : random() % 256);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(place),
              bytes.begin() + static_cast<std::ptrdiff_t>(end), value);
  }
  if (random() % 16 == 0) {
    const std::size_t left = start + random() % (bytes.size() - start);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(left), bytes.end(), std::uint8_t{0});
  }
  return damaged;
}

// A file that opens has to be whole: what the rest of the program relies on.
void checkSound(const gltf::Loaded& file) {
  const int nodes = static_cast<int>(file.scene->nodes.size());
  CHECK(parentsFirst(*file.scene).size() == file.scene->nodes.size());
  for (const Clip& clip : file.clips) {
    for (const CopyOnWrite<Track>& track : clip.tracks) {
      const std::size_t perKey = track->interpolation == Interpolation::cubicSpline ? 3 : 1;
      CHECK((track->node.exists() && track->node.value < nodes));
      CHECK(track->values.size() == track->times.size() * perKey * static_cast<std::size_t>(track->width));
    }
  }
  for (const Mesh& mesh : file.scene->meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      CHECK(primitive.normals.size() == primitive.positions.size());
      for (const std::uint32_t index : primitive.indices) {
        CHECK(index < primitive.positions.size());
      }
    }
  }
}

void openAnyhow(const gltf::Bytes& bytes) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder / "model.glb", bytes);
  const Result<gltf::Loaded> result = gltf::load(folder / "model.glb", gltf::Tolerance::warn);
  if (result) {
    checkSound(*result);
  } else {
    CHECK_FALSE(result.error().line().empty());
  }
  const std::vector<gltf::Problem> problems = gltf::diagnose(folder / "model.glb").problems;
  const bool hasError = std::any_of(problems.begin(), problems.end(), [](const gltf::Problem& problem) {
    return problem.severity == gltf::Severity::error;
  });
  CHECK(hasError == !result.ok());
}

} // namespace

TEST_CASE("Damaged bytes never bring the reader down") {
  std::mt19937 random(20240611);
  const gltf::Bytes bytes = test::armBuilder().bytes();
  for (int round = 0; round < 400; ++round) {
    openAnyhow(mutated(bytes, random));
  }
}

TEST_CASE("Wrong numbers never bring the reader down") {
  std::mt19937 random(4711);
  const test::GlbBuilder glb = test::armBuilder();
  for (int round = 0; round < 600; ++round) {
    openAnyhow(withOtherNumber(glb, random));
  }
}

TEST_CASE("Damaged views packed by meshopt never bring the reader down") {
  std::mt19937 random(1848);
  const auto filters = GENERATE(test::Filters::none, test::Filters::all);
  const test::GlbBuilder glb = test::packedByMeshopt(test::tubeBuilder(), filters);
  for (int round = 0; round < 500; ++round) {
    openAnyhow(withDamage(glb, 0, random).bytes());
  }
}

TEST_CASE("Damaged meshes packed by Draco never bring the reader down") {
  std::mt19937 random(1871);
  const auto method = GENERATE(test::DracoMethod::sequential, test::DracoMethod::edgebreaker);
  const test::GlbBuilder glb = test::packedByDraco(test::tubeBuilder(), method);
  const auto start = glb.json["bufferViews"].back()["byteOffset"].get<std::size_t>();
  for (int round = 0; round < 500; ++round) {
    openAnyhow(withDamage(glb, start, random).bytes());
  }
}

TEST_CASE("Wrong numbers in packed files never bring the reader down") {
  std::mt19937 random(1789);
  const test::GlbBuilder plain = test::tubeBuilder();
  const std::vector<test::GlbBuilder> files{test::packedByMeshopt(plain, test::Filters::all),
                                            test::packedByDraco(plain, test::DracoMethod::edgebreaker)};
  for (int round = 0; round < 1000; ++round) {
    openAnyhow(withOtherNumber(files[random() % files.size()], random));
  }
}

TEST_CASE("A small file that names the same bytes over and over is refused before it fills the memory") {
  test::GlbBuilder glb = test::armBuilder();
  const std::size_t vertices = 1U << 17U;
  const int positions = glb.floats(std::vector<float>(vertices * 3, 1.0F), "VEC3", 3);
  gltf::Json& primitives = glb.json["meshes"][1]["primitives"];
  for (int i = 0; i < 1000; ++i) {
    primitives.push_back({{"attributes", {{"POSITION", positions}, {"NORMAL", positions}}}});
  }
  glb.json["accessors"][static_cast<std::size_t>(positions)]["bufferView"] =
      glb.json["bufferViews"].size() - 1;
  const Result<gltf::Loaded> result = test::loadBytes(glb.bytes());
  REQUIRE_FALSE(result.ok());
  CHECK(result.error().what.find("memory") != std::string::npos);
}
