// What the verb check tells in words, line by line what it tells in numbers.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/files/save.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

constexpr const char* checkedDummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";

std::string stretchedPunchIn(const test::TemporaryFolder& folder) {
  const Result<Document> source = openDocument(checkedDummy);
  REQUIRE(source);
  const Document document =
      test::withNewTrail(*source, {.limb = "left-arm", .startFrame = 21.0, .endFrame = 27.0, .scale = 3.0});
  std::string file = (folder / "stretched.glb").string();
  REQUIRE(saveDocument(document, file, {.clean = true, .form = {}}));
  return file;
}

std::string checkWords(std::vector<std::string> words) {
  words.insert(words.begin(), "check");
  const test::VerbAnswer answer = test::runVerb(words);
  REQUIRE(answer.exitCode == 0);
  return answer.output;
}

Json numbersOf(std::vector<std::string> words) {
  words.emplace_back("--json");
  return Json::parse(checkWords(words));
}

/// One line for each finding, then one that counts them and names what is left open.
std::string linesOf(const Json& engines) {
  std::string lines;
  for (const Json& engine : engines) {
    const std::string name = engine["engine"].get<std::string>();
    for (const Json& finding : engine["findings"]) {
      const std::string clip = finding["clip"].get<std::string>();
      lines += name + " " + finding["severity"].get<std::string>() +
               (clip.empty() ? "" : " in '" + clip + "'") + ": " + finding["what"].get<std::string>() + "; " +
               finding["remedy"].get<std::string>() + " [" + finding["id"].get<std::string>() + "]\n";
    }
    std::string open;
    for (const Json& subject : engine["not_judged"]) {
      open += open.empty() ? subject.get<std::string>() : ", " + subject.get<std::string>();
    }
    const std::size_t count = engine["findings"].size();
    lines += name + ": " + std::to_string(count) + (count == 1 ? " finding" : " findings") +
             "; not judged: " + (open.empty() ? "nothing" : open) + "\n";
  }
  return lines;
}

} // namespace

TEST_CASE("Each finding of an engine is a line, and then how many there are and what was not judged",
          "[check]") {
  const test::TemporaryFolder folder;
  const std::string file = stretchedPunchIn(folder);
  const Json report = numbersOf({file, "--engine", "all"});
  REQUIRE(report["engines"].size() == 7);
  std::size_t findings = 0;
  for (const Json& engine : report["engines"]) {
    findings += engine["findings"].size();
    CHECK_FALSE(engine["not_judged"].empty());
  }
  CHECK(findings > 2);
  const std::string words = checkWords({file, "--engine", "all"});
  CHECK_THAT(words, Catch::EndsWith(linesOf(report["engines"])));
  // Of some that are asked for there are these alone, in the order of all.
  const Json two = numbersOf({file, "--engine", "godot,three"});
  REQUIRE(two["engines"].size() == 2);
  CHECK(two["engines"][0]["engine"] == "three");
  CHECK_THAT(checkWords({file, "--engine", "godot,three"}), Catch::EndsWith(linesOf(two["engines"])));
}

TEST_CASE("Without engines and a file from before neither is told of, with them each once", "[check]") {
  const test::TemporaryFolder folder;
  const std::string file = stretchedPunchIn(folder);
  CHECK_THAT(checkWords({file}), !Catch::Contains("not judged"));
  CHECK_FALSE(numbersOf({file}).contains("engines"));
  CHECK_FALSE(numbersOf({file}).contains("worse"));
  const Json report = numbersOf({file, "--engine", "godot", "--before", checkedDummy});
  CHECK(report.contains("worse"));
  CHECK(report["engines"].size() == 1);
  CHECK(report["problems"].size() == numbersOf({file})["problems"].size());
  CHECK_THAT(checkWords({file}),
             Catch::Contains(std::to_string(report["problems"].size()) + " problems found"));
}
