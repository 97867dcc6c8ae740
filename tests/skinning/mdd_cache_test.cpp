// MDD point caches, and frames whose numbers have gaps.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/patch/edits.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;
using Catch::Contains;

namespace {

constexpr const char* oneTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

template <typename Number>
void putBigEndian(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  bytes.append(raw.rbegin(), raw.rend());
}

/// Two samples of three points, a second apart; numbers count up from 0.
struct MddFile {
  std::int32_t samples = 2;
  std::int32_t points = 3;
  std::vector<float> times{0.0F, 0.04F};
  std::vector<float> numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};

  [[nodiscard]] std::string bytes() const {
    std::string made;
    putBigEndian(made, samples);
    putBigEndian(made, points);
    for (const float time : times) {
      putBigEndian(made, time);
    }
    for (const float number : numbers) {
      putBigEndian(made, number);
    }
    return made;
  }
};

Result<MeshSequence> readMddOf(const MddFile& file) {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", oneTriangle);
  return readSequence({base, folder.write("run.mdd", file.bytes())});
}

std::string refusalOf(const MddFile& file) {
  const auto sequence = readMddOf(file);
  REQUIRE_FALSE(sequence);
  return sequence.error().line();
}

std::string numberedFrames(const std::vector<int>& numbers) {
  const test::TemporaryFolder folder;
  for (const int number : numbers) {
    folder.write("cloth2_" + std::to_string(number) + "_low.obj", oneTriangle);
  }
  const auto sequence = readSequence({folder.path()});
  REQUIRE(sequence);
  for (const std::string& warning : sequence->warnings) {
    if (warning.find("number") != std::string::npos) {
      return warning;
    }
  }
  return {};
}

} // namespace

TEST_CASE("an MDD cache moves the vertices of its base mesh, at the rate of its times") {
  const auto sequence = readMddOf({});
  REQUIRE(sequence);
  CHECK(sequence->frameCount() == 2);
  CHECK(sequence->framesPerSecond == 25.0);
  CHECK(sequence->frame(0)[2] == glm::vec3(6, 7, 8));
  CHECK(sequence->frame(1)[0] == glm::vec3(9, 10, 11));
}

TEST_CASE("an MDD cache stands for itself and the mesh beside it, as a PC2 does") {
  const test::TemporaryFolder folder;
  const auto cache = folder.write("run.mdd", MddFile{}.bytes());
  CHECK_THAT(readSequence({cache}).error().line(), Contains("3 points") && Contains("run.mdd"));
  folder.write("mesh.obj", oneTriangle);
  CHECK(readSequence({cache}));
}

TEST_CASE("bad MDD caches are refused with one clear line, before memory is taken") {
  MddFile file;
  file.numbers.pop_back();
  CHECK_THAT(refusalOf(file), Contains("cut short") && Contains("run.mdd"));
  file = {};
  file.samples = std::numeric_limits<std::int32_t>::max();
  CHECK_THAT(refusalOf(file), Contains("cut short"));
  file.points = std::numeric_limits<std::int32_t>::max();
  CHECK_THAT(refusalOf(file), Contains("cut short"));
  file = {};
  file.points = std::numeric_limits<std::int32_t>::max();
  CHECK_THAT(refusalOf(file), Contains("cut short"));
  file.points = -3;
  CHECK_THAT(refusalOf(file), Contains("-3 points"));
  file.points = 0;
  CHECK_THAT(refusalOf(file), Contains("0 points, 2 samples"));
  file = {};
  file.samples = 0;
  CHECK_THAT(refusalOf(file), Contains("3 points, 0 samples"));
  file = {};
  file.points = 2;
  CHECK_THAT(refusalOf(file), Contains("2 points") && Contains("3 vertices"));
  file = {};
  file.times[1] = -1.0F;
  CHECK_THAT(refusalOf(file), Contains("sample 1"));
  file.times[1] = std::nanf("");
  CHECK_THAT(refusalOf(file), Contains("sample 1"));
  file = {};
  file.numbers[12] = std::nanf("");
  CHECK_THAT(refusalOf(file), Contains("vertex 1") && Contains("sample 1"));
}

TEST_CASE("times that do not move on, or unevenly, are told") {
  MddFile file;
  file.times[1] = 0.0F;
  auto sequence = readMddOf(file);
  REQUIRE(sequence);
  CHECK(sequence->framesPerSecond == 30.0);
  REQUIRE_FALSE(sequence->warnings.empty());
  CHECK_THAT(sequence->warnings[0], Contains("do not move on"));
  file.samples = 3;
  file.times = {0.0F, 0.04F, 0.16F};
  file.numbers.resize(27);
  sequence = readMddOf(file);
  REQUIRE(sequence);
  CHECK_THAT(sequence->warnings.at(0), Contains("uneven") && Contains("12.5"));
}

TEST_CASE("a cache may begin at any time, and its times be off by a tenth of a frame") {
  MddFile file;
  file.samples = 3;
  file.numbers.resize(27);
  const auto isUneven = [&](const std::vector<float>& times) {
    file.times = times;
    const auto sequence = readMddOf(file);
    REQUIRE(sequence);
    CHECK(sequence->framesPerSecond == 25.0);
    return std::ranges::any_of(sequence->warnings, [](const std::string& warning) {
      return warning.find("times of the cache are uneven") != std::string::npos;
    });
  };
  CHECK_FALSE(isUneven({10.0F, 10.04F, 10.08F}));
  CHECK_FALSE(isUneven({10.0F, 10.043F, 10.08F}));
  CHECK(isUneven({10.0F, 10.045F, 10.08F}));
  CHECK(isUneven({10.0F, 10.035F, 10.08F}));
}

TEST_CASE("how much faster or slower than its times a cache plays at a rate is told") {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", oneTriangle);
  const auto cache = folder.write("run.mdd", MddFile{}.bytes());
  const auto told = [&](double framesPerSecond) {
    const auto sequence = readSequence({base, cache}, {}, {}, framesPerSecond);
    REQUIRE(sequence);
    for (const std::string& warning : sequence->warnings) {
      if (warning.find("by the times") != std::string::npos) {
        return warning;
      }
    }
    return std::string();
  };
  const std::string own = "by the times of the cache it has 25 frames per second: at ";
  CHECK(told(50.0) == own + "50 it plays 2 times as fast as it was made");
  CHECK(told(12.5) == own + "12.5 it plays 0.5 times as fast as it was made");
  CHECK(told(25.02).empty());
  CHECK(told(24.98).empty());
}

TEST_CASE(
    "a rate that is asked for in place of the one of the times is told, of times that make none it is not") {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", oneTriangle);
  const auto at = [&](const MddFile& file, double framesPerSecond) {
    const auto sequence =
        readSequence({base, folder.write("run.mdd", file.bytes())}, {}, {}, framesPerSecond);
    REQUIRE(sequence);
    CHECK(sequence->framesPerSecond == framesPerSecond);
    return std::ranges::any_of(sequence->warnings, [](const std::string& warning) {
      return warning.find("times as fast as it was made") != std::string::npos;
    });
  };
  CHECK(at({}, 50.0));
  CHECK_FALSE(at({}, 25.0));
  MddFile standing;
  standing.times = {0.0F, 0.0F};
  CHECK_FALSE(at(standing, 50.0));
}

TEST_CASE("a cache of counts that no file can hold is refused") {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", oneTriangle);
  std::string bytes("POINTCACHE2\0", 12);
  const auto put = [&](auto number) {
    const auto raw = std::bit_cast<std::array<char, 4>>(number);
    bytes.append(raw.begin(), raw.end());
  };
  put(std::int32_t{1});
  put(std::numeric_limits<std::int32_t>::max());
  put(0.0F);
  put(1.0F);
  put(std::numeric_limits<std::int32_t>::max());
  CHECK_THAT(readSequence({base, folder.write("run.pc2", bytes)}).error().line(), Contains("cut short"));
}

TEST_CASE("two files that are no mesh and cache are told apart") {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", oneTriangle);
  const auto text = folder.write("notes.txt", "no mesh");
  const auto cache = folder.write("run.mdd", MddFile{}.bytes());
  CHECK_THAT(readSequence({text, cache}).error().line(), Contains("notes.txt") && Contains("not a mesh"));
  CHECK_THAT(readSequence({base, text}).error().line(),
             Contains("notes.txt") && Contains("not a point cache"));
}

TEST_CASE("numbers that are missing between frames are told, a step that all keep is none") {
  CHECK(numberedFrames({1, 2, 3, 4}).empty());
  CHECK(numberedFrames({1, 5, 9, 13}).empty());
  CHECK_THAT(numberedFrames({1, 2, 4, 5, 9}), Contains("number 3, 6 to 8"));
  CHECK_THAT(numberedFrames({0, 10, 30, 40}), Contains("number 20:"));
}

TEST_CASE("frames whose names differ in more than a number have no numbers of which some are missing") {
  const auto toldOf = [](const std::vector<std::string>& names, std::size_t played) {
    const test::TemporaryFolder folder;
    for (const std::string& name : names) {
      folder.write(name, oneTriangle);
    }
    const auto sequence = readSequence({folder.path()});
    REQUIRE(sequence);
    CHECK(sequence->frameCount() == played);
    return std::ranges::any_of(sequence->warnings, [](const std::string& warning) {
      return warning.find("has the number") != std::string::npos;
    });
  };
  CHECK(toldOf({"cloth_1.obj", "cloth_2.obj", "cloth_9.obj"}, 3));
  CHECK_FALSE(toldOf({"cloth_1.obj", "cloth_2.obj", "sleeve_9.obj"}, 2));
  CHECK_FALSE(toldOf({"cloth_1.obj", "cloth_2.obj", "cloth_last.obj"}, 2));
  CHECK_FALSE(toldOf({"first.obj", "second.obj", "third.obj"}, 3));
}

TEST_CASE("a cache of a glTF mesh comes with what that says of its surface, one of an OBJ without") {
  const test::TemporaryFolder folder;
  const SkinnedSequence tube = test::wavingTube(4, 3);
  REQUIRE(gltf::save(encodeGltf(tube).source, folder / "base.glb"));
  MddFile file;
  const Result<MeshSequence> bare = readAnimatedGltf(folder / "base.glb");
  REQUIRE(bare);
  file.points = static_cast<std::int32_t>(bare->vertexCount);
  file.samples = 1;
  file.times = {0.0F};
  file.numbers.assign(3 * bare->vertexCount, 0.5F);
  const auto sequence = readSequence({folder / "base.glb", folder.write("run.mdd", file.bytes())});
  REQUIRE(sequence);
  CHECK(sequence->frame(0)[bare->vertexCount - 1] == glm::vec3(0.5F));
  CHECK(sequence->triangles.size() == bare->triangles.size());
  REQUIRE(sequence->surface != nullptr);
  CHECK(sequence->surface->triangles.size() == bare->triangles.size());
  CHECK(sequence->surface->parts.size() == 1);
  CHECK(readMddOf({})->surface == nullptr);
}
