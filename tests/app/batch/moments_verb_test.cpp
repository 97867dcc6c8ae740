// The verb `moments`, from the command line's end.
#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;
using test::runVerb;

namespace {

constexpr const char* oneTwoPath = STRETCH_SOURCE_DIR "/assets/dummy.glb";
constexpr const char* battersPath = STRETCH_SOURCE_DIR "/assets/dummy_swing.glb";
constexpr const char* leapersPath = STRETCH_SOURCE_DIR "/assets/dummy_leap.glb";

Json momentsTold(const std::vector<std::string>& words) {
  const test::VerbAnswer answer = runVerb(words);
  CAPTURE(answer.told);
  REQUIRE(answer.exitCode == 0);
  return Json::parse(answer.output, nullptr, false);
}

/// The strongest moment of a limb of this kind.
Json toldMoment(const Json& clip, const std::string& limb, const std::string& kind) {
  for (const Json& moment : clip["moments"]) {
    if (moment["limb"] == limb && moment["kind"] == kind) {
      return moment;
    }
  }
  FAIL("no " << kind << " of the " << limb);
  return {};
}

void checkKeyed(const Json& moment, double start, double tip) {
  CHECK(moment["start"].get<double>() == Approx(start).margin(1.0));
  CHECK(moment["tip"].get<double>() == Approx(tip).margin(1.0));
  CHECK(moment["end"] == moment["tip"]);
}

} // namespace

TEST_CASE(
    "Moments of the bundled clips are the punches, the swing, the leap and the landing that were keyed") {
  const Json punch = momentsTold({"moments", oneTwoPath, "--json"});
  CHECK(punch["clip"] == "One-two punch");
  CHECK(punch["fps"].get<double>() == 24.0);
  checkKeyed(toldMoment(punch, "left-arm", "stroke"), 21.0, 27.0);
  checkKeyed(toldMoment(punch, "right-arm", "stroke"), 40.0, 43.0);
  checkKeyed(toldMoment(momentsTold({"moments", battersPath, "--json"}), "right-arm", "stroke"), 34.0, 44.0);
  const Json jump = momentsTold({"moments", leapersPath, "--json"});
  checkKeyed(toldMoment(jump, "left-arm", "stroke"), 31.0, 37.0);
  checkKeyed(toldMoment(jump, "body", "landing"), 63.0, 68.0);
}

TEST_CASE("Moments come strongest first, of the first clip, of a named one or of all") {
  const Json first = momentsTold({"moments", oneTwoPath, "--json"});
  for (std::size_t i = 1; i < first["moments"].size(); ++i) {
    CHECK(first["moments"][i]["strength"].get<double>() <= first["moments"][i - 1]["strength"].get<double>());
  }
  const Json all = momentsTold({"moments", oneTwoPath, "--all-clips", "--json"});
  REQUIRE(all.size() == 2);
  CHECK(all[0] == first);
  CHECK(all[1] == momentsTold({"moments", oneTwoPath, "--clip", "Guard", "--json"}));
  for (const Json& moment : all[1]["moments"]) {
    CHECK(moment["strength"].get<double>() < 1.0); // It only bounces.
  }
}

TEST_CASE("Several files make one list of all their moments, strongest first") {
  const Json list = momentsTold({"moments", oneTwoPath, leapersPath, "--json"});
  const Json apart[] = {momentsTold({"moments", oneTwoPath, "--json"}),
                        momentsTold({"moments", leapersPath, "--json"})};
  REQUIRE(list.size() == apart[0]["moments"].size() + apart[1]["moments"].size());
  CHECK(list[0]["file"] == leapersPath);
  CHECK(list[0]["clip"] == "Leap and landing");
  CHECK(list[0]["fps"].get<double>() == 24.0);
  CHECK(list[0]["strength"] == apart[1]["moments"][0]["strength"]);
  for (std::size_t i = 1; i < list.size(); ++i) {
    CHECK(list[i]["strength"].get<double>() <= list[i - 1]["strength"].get<double>());
  }
}

TEST_CASE("Moments are told as lines of text without --json") {
  const test::VerbAnswer one = runVerb({"moments", oneTwoPath});
  CHECK(one.exitCode == 0);
  CHECK(one.output.starts_with("clip One-two punch, 24 fps: "));
  CHECK(one.output.find("stroke   left-arm         frames 21 to 27\n") != std::string::npos);
  const test::VerbAnswer several = runVerb({"moments", battersPath, oneTwoPath});
  CHECK(several.output.find(std::string("frames 21 to 27 of One-two punch in ") + oneTwoPath) !=
        std::string::npos);
}

TEST_CASE("A file of a library that cannot be read is told, and the others stand in the list") {
  const test::VerbAnswer answer = runVerb({"moments", "gone.glb", oneTwoPath, "missing.glb", "--json"});
  CHECK(answer.exitCode == 1);
  CHECK(answer.told.find("gone.glb") != std::string::npos);
  CHECK(answer.told.find("missing.glb") != std::string::npos);
  CHECK(Json::parse(answer.output, nullptr, false).size() > 4);
  const test::VerbAnswer alone = runVerb({"moments", "gone.glb", "--json"});
  CHECK(alone.exitCode == 1);
  CHECK(alone.output.empty());
}

TEST_CASE("All clips and one of them cannot be asked at once, a clip that is missing is named") {
  CHECK(runVerb({"moments", oneTwoPath, "--all-clips", "--clip", "Guard"}).exitCode == 2);
  const test::VerbAnswer missing = runVerb({"moments", oneTwoPath, "--clip", "Kick"});
  CHECK(missing.exitCode == 1);
  CHECK(missing.told.find("Kick") != std::string::npos);
}
