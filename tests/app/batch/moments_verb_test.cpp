// The verb `moments`, from the command line's end.
#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;
using test::runVerb;

namespace {

constexpr const char* dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
constexpr const char* swing = STRETCH_SOURCE_DIR "/assets/dummy_swing.glb";
constexpr const char* leap = STRETCH_SOURCE_DIR "/assets/dummy_leap.glb";

Json answerOf(const std::vector<std::string>& words) {
  const test::VerbAnswer answer = runVerb(words);
  CAPTURE(answer.told);
  REQUIRE(answer.exitCode == 0);
  return Json::parse(answer.output, nullptr, false);
}

/// The strongest moment of a limb of this kind.
Json momentOf(const Json& clip, const std::string& limb, const std::string& kind) {
  for (const Json& moment : clip["moments"]) {
    if (moment["limb"] == limb && moment["kind"] == kind) {
      return moment;
    }
  }
  FAIL("no " << kind << " of the " << limb);
  return {};
}

void checkRange(const Json& moment, double start, double tip) {
  CHECK(moment["start"].get<double>() == Approx(start).margin(1.0));
  CHECK(moment["tip"].get<double>() == Approx(tip).margin(1.0));
  CHECK(moment["end"] == moment["tip"]);
}

} // namespace

TEST_CASE(
    "Moments of the bundled clips are the punches, the swing, the leap and the landing that were keyed") {
  const Json punch = answerOf({"moments", dummy, "--json"});
  CHECK(punch["clip"] == "One-two punch");
  CHECK(punch["fps"].get<double>() == 24.0);
  checkRange(momentOf(punch, "left-arm", "stroke"), 21.0, 27.0);
  checkRange(momentOf(punch, "right-arm", "stroke"), 40.0, 43.0);
  checkRange(momentOf(answerOf({"moments", swing, "--json"}), "right-arm", "stroke"), 34.0, 44.0);
  const Json jump = answerOf({"moments", leap, "--json"});
  checkRange(momentOf(jump, "left-arm", "stroke"), 31.0, 37.0);
  checkRange(momentOf(jump, "body", "landing"), 63.0, 68.0);
}

TEST_CASE("Moments come strongest first, of the first clip, of a named one or of all") {
  const Json first = answerOf({"moments", dummy, "--json"});
  for (std::size_t i = 1; i < first["moments"].size(); ++i) {
    CHECK(first["moments"][i]["strength"].get<double>() <= first["moments"][i - 1]["strength"].get<double>());
  }
  const Json all = answerOf({"moments", dummy, "--all-clips", "--json"});
  REQUIRE(all.size() == 2);
  CHECK(all[0] == first);
  CHECK(all[1] == answerOf({"moments", dummy, "--clip", "Guard", "--json"}));
  for (const Json& moment : all[1]["moments"]) {
    CHECK(moment["strength"].get<double>() < 1.0); // It only bounces.
  }
}

TEST_CASE("Several files make one list of all their moments, strongest first") {
  const Json list = answerOf({"moments", dummy, leap, "--json"});
  const Json apart[] = {answerOf({"moments", dummy, "--json"}), answerOf({"moments", leap, "--json"})};
  REQUIRE(list.size() == apart[0]["moments"].size() + apart[1]["moments"].size());
  CHECK(list[0]["file"] == leap);
  CHECK(list[0]["clip"] == "Leap and landing");
  CHECK(list[0]["fps"].get<double>() == 24.0);
  CHECK(list[0]["strength"] == apart[1]["moments"][0]["strength"]);
  for (std::size_t i = 1; i < list.size(); ++i) {
    CHECK(list[i]["strength"].get<double>() <= list[i - 1]["strength"].get<double>());
  }
}

TEST_CASE("Moments are told as lines of text without --json") {
  const test::VerbAnswer one = runVerb({"moments", dummy});
  CHECK(one.exitCode == 0);
  CHECK(one.output.starts_with("clip One-two punch, 24 fps: "));
  CHECK(one.output.find("stroke   left-arm         frames 21 to 27\n") != std::string::npos);
  const test::VerbAnswer several = runVerb({"moments", swing, dummy});
  CHECK(several.output.find(std::string("frames 21 to 27 of One-two punch in ") + dummy) !=
        std::string::npos);
}

TEST_CASE("A file of a library that cannot be read is told, and the others stand in the list") {
  const test::VerbAnswer answer = runVerb({"moments", "gone.glb", dummy, "missing.glb", "--json"});
  CHECK(answer.exitCode == 1);
  CHECK(answer.told.find("gone.glb") != std::string::npos);
  CHECK(answer.told.find("missing.glb") != std::string::npos);
  CHECK(Json::parse(answer.output, nullptr, false).size() > 4);
  const test::VerbAnswer alone = runVerb({"moments", "gone.glb", "--json"});
  CHECK(alone.exitCode == 1);
  CHECK(alone.output.empty());
}

TEST_CASE("All clips and one of them cannot be asked at once; a clip that is missing is named") {
  CHECK(runVerb({"moments", dummy, "--all-clips", "--clip", "Guard"}).exitCode == 2);
  const test::VerbAnswer missing = runVerb({"moments", dummy, "--clip", "Kick"});
  CHECK(missing.exitCode == 1);
  CHECK(missing.told.find("Kick") != std::string::npos);
}
