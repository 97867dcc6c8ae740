// Sequences in files of other programs, from the command line.
#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <fstream>

#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/compressed_files.h"
#include "tests/support/core/two_sheets.h"

using namespace stretch;
using namespace stretch::test;
using gltf::Json;

namespace {

/// The eight vertices of the two sheets at rest, the second one raised over three samples, half a second
/// apart.
std::string raisedSheets() {
  std::string bytes;
  const auto put = [&](auto number) {
    const auto raw = std::bit_cast<std::array<char, 4>>(number);
    bytes.append(raw.rbegin(), raw.rend());
  };
  put(std::int32_t{3});
  put(std::int32_t{8});
  for (const float time : {0.0F, 0.5F, 1.0F}) {
    put(time);
  }
  for (int sample = 0; sample < 3; ++sample) {
    for (const float left : {0.0F, 5.0F}) {
      for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
        put(left + static_cast<float>(x));
        put(static_cast<float>(y));
        put(left > 0.0F ? static_cast<float>(sample) : 0.0F);
      }
    }
  }
  return bytes;
}

VerbAnswer compressedTo(const std::filesystem::path& output, const std::vector<std::string>& sequence) {
  std::vector<std::string> words{"compress"};
  words.insert(words.end(), sequence.begin(), sequence.end());
  for (const std::string& word : {std::string("-o"), output.string(), std::string("--stretch"),
                                  std::string("measured"), std::string("--bones"), std::string("2")}) {
    words.push_back(word);
  }
  VerbAnswer answer = runVerb(words);
  INFO(answer.told);
  CHECK(answer.exitCode == 0);
  return answer;
}

} // namespace

TEST_CASE("an MDD cache moves the vertices of a glTF, which keeps its materials and its rate") {
  const TemporaryFolder folder;
  twoSheets().write(folder / "sheets.glb");
  const auto cache = folder.write("raised.mdd", raisedSheets());
  compressedTo(folder / "out.glb", {(folder / "sheets.glb").string(), cache.string()});
  const auto file = gltf::loadAsItStands(folder / "out.glb");
  REQUIRE(file);
  REQUIRE(file->scene->meshes.size() == 2);
  CHECK(file->scene->materials.at(1).baseColorTexture.image == 0);
  CHECK(file->clips.at(0).endSeconds == Approx(1.0));
}

TEST_CASE("compare takes a glTF with its cache where the words leave no other choice") {
  const TemporaryFolder folder;
  twoSheets().write(folder / "sheets.glb");
  const std::string base = (folder / "sheets.glb").string();
  const std::string cache = folder.write("raised.mdd", raisedSheets()).string();
  const VerbAnswer answer = runVerb({"compare", base, cache, base, cache, "--json"});
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  CHECK(Json::parse(answer.output)["rmse_percent"] == 0.0);
}

TEST_CASE("a glTF sequence packed by meshopt becomes the same clip as the plain one") {
  const TemporaryFolder folder;
  twoSheets().write(folder / "plain.glb");
  packedByMeshopt(twoSheets(), Filters::none).write(folder / "packed.glb");
  std::filesystem::create_directories(folder / "a");
  std::filesystem::create_directories(folder / "b");
  std::filesystem::copy_file(folder / "plain.glb", folder / "a" / "sheets.glb");
  std::filesystem::copy_file(folder / "packed.glb", folder / "b" / "sheets.glb");
  compressedTo(folder / "a.glb", {(folder / "a" / "sheets.glb").string()});
  compressedTo(folder / "b.glb", {(folder / "b" / "sheets.glb").string()});
  CHECK(readBytes(folder / "a.glb") == readBytes(folder / "b.glb"));
}

TEST_CASE("a glTF sequence packed by Draco is compressed, and compares with the plain one") {
  const TemporaryFolder folder;
  tubeBuilder().write(folder / "plain.glb");
  packedByDraco(tubeBuilder(), DracoMethod::sequential).write(folder / "packed.glb");
  compressedTo(folder / "out.glb", {(folder / "packed.glb").string()});
  const VerbAnswer answer =
      runVerb({"compare", (folder / "plain.glb").string(), (folder / "packed.glb").string(), "--json"});
  REQUIRE(answer.exitCode == 0);
  CHECK(Json::parse(answer.output)["rmse_percent"].get<double>() < 0.1);
}

TEST_CASE("a cache named alone finds the glTF beside it that has as many vertices") {
  const TemporaryFolder folder;
  twoSheets().write(folder / "sheets.glb");
  const auto cache = folder.write("raised.mdd", raisedSheets());
  CHECK(compressedTo(folder / "out.glb", {cache.string()}).exitCode == 0);
}
