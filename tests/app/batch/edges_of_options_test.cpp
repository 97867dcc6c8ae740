// Numbers of options at the edge of what they may be.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/batch/options.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using Words = std::vector<std::string>;

TEST_CASE("A number of an option is taken up to its edge, and refused beyond it") {
  const test::TemporaryFolder folder;
  const std::string gone = (folder / "gone.glb").string();
  // What is taken gets as far as the file that is not there.
  const auto isTaken = [](Words words, const std::string& option) {
    words.push_back(option);
    CAPTURE(option);
    const test::VerbAnswer answer = test::runVerb(words);
    CHECK((answer.exitCode == 1 || answer.exitCode == 2));
    return answer.exitCode == 1;
  };
  const Words automatic{"exaggerate", gone, "-o", (folder / "out.glb").string(), "--auto"};
  CHECK(isTaken(automatic, "--strength=0"));
  CHECK(isTaken(automatic, "--strength=2"));
  CHECK_FALSE(isTaken(automatic, "--strength=-0.01"));
  CHECK_FALSE(isTaken(automatic, "--strength=2.01"));
  const Words trail{"trail", gone, "--limb", "left-arm"};
  CHECK(isTaken(trail, "--fps=0.01"));
  CHECK(isTaken(trail, "--fps=10000"));
  CHECK_FALSE(isTaken(trail, "--fps=0.0099"));
  CHECK_FALSE(isTaken(trail, "--fps=10001"));
  CHECK(isTaken(trail, "--range=5:6"));
  CHECK_FALSE(isTaken(trail, "--range=5:5"));
  const Words compare{"compare", gone, gone};
  CHECK(isTaken(compare, "--sted-rings=1"));
  CHECK(isTaken(compare, "--sted-rings=8"));
  CHECK_FALSE(isTaken(compare, "--sted-rings=0"));
  CHECK_FALSE(isTaken(compare, "--sted-rings=9"));
  CHECK(isTaken(compare, "--sted-window=1"));
  CHECK_FALSE(isTaken(compare, "--sted-window=-1"));
  CHECK_FALSE(isTaken(compare, "--sted-window=2"));
  for (const char* const option : {"--sted-dt", "--sted-c"}) {
    CHECK(isTaken(compare, std::string(option) + "=0"));
    CHECK_FALSE(isTaken(compare, std::string(option) + "=-0.1"));
  }
}

TEST_CASE("A cylinder may lie on the ground or stand on it, and not be turned beyond that") {
  const auto exitCode = [](const char* angle) {
    return test::runVerb({"flatten", "--mass", "1", "--young", "1e6", "--length", "1", "--width", "1", angle})
        .exitCode;
  };
  CHECK(exitCode("--angle=90") == 0);
  CHECK(exitCode("--angle=-90") == 0);
  CHECK(exitCode("--angle=90.1") == 2);
  CHECK(exitCode("--angle=-90.1") == 2);
}

TEST_CASE("A pose is taken from the first frame of a clip to its last, in a range that holds the frame") {
  const test::TemporaryFolder folder;
  const auto told = [&](const Words& options) {
    Words words{"pose",   test::posedCharacter,    "-o", (folder / "out.glb").string(),
                "--pose", "a pose that nobody has"};
    words.insert(words.end(), options.begin(), options.end());
    return test::runVerb(words).told;
  };
  const auto isLookedFor = Catch::Contains("is no pose of the library");
  CHECK_THAT(told({"--pose-frame=60"}), isLookedFor);
  CHECK_THAT(told({"--pose-frame=-1"}), Catch::Contains("frame -1 lies outside the clip"));
  CHECK_THAT(told({"--pose-amount=0"}), isLookedFor);
  CHECK_THAT(told({"--pose-amount=-0.1"}), Catch::Contains("-0.1 is no amount"));
  CHECK_THAT(told({"--pose-frame=4", "--pose-range=4:9"}), isLookedFor);
  CHECK_THAT(told({"--pose-frame=9", "--pose-range=4:9"}), isLookedFor);
  CHECK_THAT(told({"--pose-frame=10", "--pose-range=4:9"}), Catch::Contains("does not hold frame 10"));
}

TEST_CASE("Weight is given in the frames that a clip has, from its first to its last") {
  const test::TemporaryFolder folder;
  const auto told = [&](const std::string& range) {
    return test::runVerb({"elastic", test::posedCharacter, "-o", (folder / "out.glb").string(), "--limb",
                          "left-arm", "--range=" + range})
        .told;
  };
  const auto isOutside = Catch::Contains("the range lies outside the clip, which has the frames 0 to 60");
  CHECK_THAT(told("-5:0"), isOutside);
  CHECK_THAT(told("60:61"), isOutside);
  CHECK_THAT(told("50:61"), Catch::Contains("the range is cut to the frames 50 to 60"));
  CHECK_THAT(told("0:60"), !Catch::Contains("the range"));
}

TEST_CASE("Moduli name the bones of a limb from 0 to its last one") {
  CHECK(app::checkModuli({{0, 1, 5000.0}, {2, 2, 9000.0}}, 3, "moduli"));
  const Status beyond = app::checkModuli({{0, 1, 5000.0}, {2, 3, 9000.0}}, 3, "moduli");
  REQUIRE_FALSE(beyond);
  CHECK(beyond.error().line() == "moduli: names bone 3, and the last one is 2; count bones from 0");
}
