// Which files of a folder are the frames of a sequence, and in which order they are played.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "skinning/sequence/read_sequence.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;
using Catch::Contains;

namespace {

using Names = std::vector<std::string>;

/// A folder of frames that differ in nothing but their names.
struct Frames {
  explicit Frames(const Names& names) {
    for (const std::string& name : names) {
      folder.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    }
  }
  [[nodiscard]] Result<MeshSequence> read(const std::string& named = {}) const {
    return readSequence({named.empty() ? folder.path() : folder / named});
  }

  test::TemporaryFolder folder;
};

Names playedOf(const Names& names) {
  const auto sequence = Frames(names).read();
  REQUIRE(sequence);
  CHECK(sequence->warnings.empty());
  return sequence->frameNames;
}

} // namespace

TEST_CASE("what is not named like the frames of a folder is left out and told") {
  const Frames frames({"f_0002.obj", "f_0001.obj", "rest.obj", "base.obj"});
  const auto sequence = frames.read();
  REQUIRE(sequence);
  CHECK(sequence->frameNames == Names{"f_0001.obj", "f_0002.obj"});
  CHECK(sequence->warnings == Names{"left out what is not named like f_0001.obj: base.obj, rest.obj"});
  CHECK(frames.read("f_0002.obj")->warnings.empty());
}

TEST_CASE("of several series in a folder the one that is named is played, and without a name none") {
  const Frames frames({"f_1.obj", "f_2.obj", "g_01.obj", "g_02.obj", "g_03.obj"});
  CHECK_THAT(test::refusal(frames.read()), Contains("several series") && Contains("f_1.obj and g_01.obj"));
  const auto named = frames.read("f_2.obj");
  REQUIRE(named);
  CHECK(named->frameNames == Names{"f_1.obj", "f_2.obj"});
  CHECK(named->name == frames.folder.path().filename());
  CHECK(sequencePaths({frames.folder / "g_01.obj"}) == std::vector{frames.folder / "g_01.obj"});
  CHECK(frames.read("g_01.obj")->frameCount() == 3);
}

TEST_CASE("names that differ in two numbers are played in the order of both, which is told") {
  const Frames frames({"shot2_f1.obj", "shot1_f2.obj", "shot1_f1.obj", "shot2_f2.obj"});
  const auto sequence = frames.read();
  REQUIRE(sequence);
  CHECK(sequence->frameNames == Names{"shot1_f1.obj", "shot1_f2.obj", "shot2_f1.obj", "shot2_f2.obj"});
  REQUIRE(sequence->warnings.size() == 1);
  CHECK_THAT(sequence->warnings[0], Contains("2 numbers") && Contains("shot1_f1.obj to shot2_f2.obj"));
  CHECK(frames.read("shot2_f1.obj")->frameNames == Names{"shot2_f1.obj", "shot2_f2.obj"});
}

TEST_CASE("frames that are not named alike are played in the order of their names, which is told") {
  const auto sequence = Frames({"c2.obj", "b.obj", "a10x.obj"}).read();
  REQUIRE(sequence);
  CHECK(sequence->frameNames == Names{"a10x.obj", "b.obj", "c2.obj"});
  REQUIRE(sequence->warnings.size() == 1);
  CHECK_THAT(sequence->warnings[0], Contains("in the order of their names"));
}

TEST_CASE("two frames of one number are refused") {
  CHECK_THAT(test::refusal(Frames({"f_1.obj", "f_01.obj", "f_2.obj"}).read()),
             Contains("f_01.obj and f_1.obj have the same number"));
  CHECK_THAT(test::refusal(Frames({"f_1.obj", "f_1.50.obj", "f_1.5.obj", "f_2.obj"}).read("f_2.obj")),
             Contains("same number"));
  CHECK(playedOf({"f_12345678901234567890123.obj", "f_12345678901234567890124.obj"}).size() == 2);
}

TEST_CASE("a minus is the sign of a number where the row has a zero, and else part of the name") {
  const Names rolled{"f_-10.obj", "f_-5.obj", "f_0.obj", "f_5.obj"};
  CHECK(playedOf(rolled) == rolled);
  CHECK(playedOf({"wolf-1.obj", "wolf-2.obj", "wolf-3.obj"}).front() == "wolf-1.obj");
  CHECK_THAT(test::refusal(Frames({"wolf-1.obj", "wolf-2.obj", "wolf1.obj", "wolf2.obj"}).read()),
             Contains("several series"));
}

TEST_CASE("frames between frames are played by their fractions") {
  const Names between{"cloth.1.obj", "cloth.1.05.obj", "cloth.1.25.obj", "cloth.1.5.obj",
                      "cloth.2.obj", "cloth.2.75.obj", "cloth.10.obj"};
  CHECK(playedOf({between[6], between[2], between[0], between[4], between[3], between[5], between[1]}) ==
        between);
  // A version in front of the number of a frame, with a mesh of it beside the row.
  const auto versioned = Frames({"sim_v2.obj", "sim_v2.9.obj", "sim_v2.10.obj"}).read();
  REQUIRE(versioned);
  CHECK(versioned->frameNames == Names{"sim_v2.9.obj", "sim_v2.10.obj"});
}

TEST_CASE("four meshes that are left out beside frames are told by name, of more how many") {
  Names names{"f_1.obj", "f_2.obj", "a.obj", "b.obj", "c.obj", "d.obj"};
  const auto told = [&] { return Frames(names).read()->warnings; };
  CHECK(told() == Names{"left out what is not named like f_1.obj: a.obj, b.obj, c.obj, d.obj"});
  names.emplace_back("e.obj");
  CHECK(told() == Names{"left out what is not named like f_1.obj: a.obj, b.obj, c.obj, d.obj and 1 more"});
}

TEST_CASE("of names with two numbers it is told which of the last number are missing") {
  const auto told = [](const Names& names) {
    const auto sequence = Frames(names).read();
    REQUIRE(sequence);
    REQUIRE_FALSE(sequence->warnings.empty());
    CHECK_THAT(sequence->warnings.back(), Contains("the names differ in 2 numbers"));
    return sequence->warnings.size() == 1 ? std::string() : sequence->warnings.front();
  };
  CHECK(told({"shot1_f1.obj", "shot2_f2.obj", "shot4_f3.obj"}).empty());
  CHECK(told({"shot1_f1.obj", "shot1_f2.obj", "shot1_f4.obj", "shot2_f1.obj", "shot2_f2.obj"}) ==
        "no frame has the number 3: the next one follows at once");
}

TEST_CASE("frames whose numbers keep no step lack none, and neither does one frame alone") {
  CHECK(playedOf({"f_0.obj", "f_4.obj", "f_10.obj"}).size() == 3);
  CHECK(playedOf({"body.obj"}) == Names{"body.obj"});
  CHECK(playedOf({"f_7.obj"}) == Names{"f_7.obj"});
}

TEST_CASE("a frame that is named stands for those of its kind of file whose names end in other numbers") {
  CHECK(Frames({"f_1.obj", "f_2.obj", "f_3.ply"}).read("f_2.obj")->frameNames == Names{"f_1.obj", "f_2.obj"});
  CHECK(Frames({"f_1.obj", "f_2.OBJ"}).read("f_1.obj")->frameNames == Names{"f_1.obj", "f_2.OBJ"});
  const Frames behind({"f1_low.obj", "f2_low.obj"});
  CHECK(behind.read()->frameCount() == 2);
  CHECK_THAT(test::refusal(behind.read("f1_low.obj")), Contains("a single file is no mesh sequence"));
}
