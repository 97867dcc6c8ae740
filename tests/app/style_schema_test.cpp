#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "app/files/user_files.h"
#include "app/files/user_styles.h"
#include "app/schema/style_schema.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/other_value.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

Json minimal() {
  return {{"version", 1}, {"name", "Mine"}};
}

} // namespace

TEST_CASE("A style comes back from its file as it was, whichever setting is changed") {
  for (const rig::Style& style : rig::builtInStyles()) {
    rig::Style own = style;
    own.origin = rig::StyleOrigin::own;
    const Result<rig::Style> read = styleFromJson(styleToJson(style));
    REQUIRE(read.ok());
    CHECK(*read == own);
  }
  for (const Setting<rig::Style>& setting : styleSchema()) {
    INFO(setting.name);
    CHECK(setting.option.starts_with("--style-"));
    rig::Style style;
    style.name = "Mine";
    REQUIRE(setSetting(setting, test::otherValue(setting), style));
    style.arm.least = std::min(style.arm.least, style.arm.usual);
    for (rig::ScaleRange* const range : {&style.arm, &style.leg, &style.torso, &style.other}) {
      range->usual = std::clamp(range->usual, 0.0, 5.0);
      range->least = std::min(range->least, range->usual);
      range->most = std::max(range->most, range->usual);
    }
    const Result<rig::Style> read = styleFromJson(styleToJson(style));
    REQUIRE(read.ok());
    CHECK(*read == style);
  }
}

TEST_CASE("What a style leaves out is as in a new one") {
  const Result<rig::Style> read = styleFromJson(minimal());
  REQUIRE(read.ok());
  rig::Style plain;
  plain.name = "Mine";
  CHECK(*read == plain);
}

TEST_CASE("A style that makes no sense is refused with its key") {
  const auto refusalWith = [](const char* key, const Json& value) {
    Json json = minimal();
    json[key] = value;
    return test::refusal(styleFromJson(json));
  };
  CHECK_THAT(refusalWith("version", 2), Catch::StartsWith("version:"));
  CHECK_THAT(refusalWith("name", ""), Catch::StartsWith("name:"));
  CHECK_THAT(refusalWith("name", std::string(101, 'a')), Catch::StartsWith("name:"));
  CHECK_THAT(refusalWith("name", std::string(100, 'a')), Catch::Equals("accepted"));
  CHECK_THAT(refusalWith("leg", rig::Style().leg.most), Catch::Equals("accepted"));
  CHECK_THAT(refusalWith("arms", 2.0), Catch::StartsWith("arms: is not a setting of a style"));
  CHECK_THAT(refusalWith("leg", 6.0), Catch::StartsWith("leg:"));
  CHECK_THAT(refusalWith("leg", 0.5), Catch::StartsWith("leg: its least, usual and largest"));
  CHECK_THAT(refusalWith("torso_most", 0.5), Catch::StartsWith("torso: its least, usual and largest"));
  CHECK_THAT(refusalWith("axes", "xz"), Catch::StartsWith("axes:"));
  CHECK_THAT(refusalWith("ease_in", Json::array({0.6, 0.1})), Catch::Equals("accepted"));
  Json both = minimal();
  both["ease_in"] = {0.6, 0.1};
  both["ease_out"] = {0.4, 0.9};
  CHECK_THAT(test::refusal(styleFromJson(both)), Catch::Contains("the whole path"));
  CHECK_THAT(test::refusal(styleFromJson(Json{{"name", "Mine"}})), Catch::StartsWith("version:"));
  CHECK_THAT(test::refusal(styleFromJson(Json{{"version", 1}})), Catch::StartsWith("name:"));
  CHECK_THAT(test::refusal(styleFromJson(Json::array())), Catch::Contains("is not a JSON object"));
}

TEST_CASE("A style of an older file whose eases cross the half stops there, each on its side") {
  Json json = minimal();
  json["ease_in"] = {0.2, 0.6};
  json["ease_out"] = {0.2, 0.3};
  const Result<rig::Style> crossed = styleFromJson(json);
  REQUIRE(crossed.ok());
  CHECK(crossed->easeIn.value == 0.5);
  CHECK(crossed->easeOut.value == 0.5);
  json["ease_in"] = {0.2, 0.4};
  json["ease_out"] = {0.2, 0.7};
  const Result<rig::Style> apart = styleFromJson(json);
  REQUIRE(apart.ok());
  CHECK(apart->easeIn.value == 0.4);
  CHECK(apart->easeOut.value == 0.7);
}

TEST_CASE(
    "The user's styles are found by name beside the built-in ones, and files that are none are passed over") {
  const test::TemporaryFolder folder;
  rig::Style style = rig::builtInStyles().front();
  style.name = "Mine: a/b";
  REQUIRE(saveStyle(style, fileOfName(folder.path(), style.name)));
  std::ofstream(folder.path() / "broken.json") << "{";
  std::ofstream(folder.path() / "notes.txt") << "none";
  const std::vector<rig::Style> all = allStyles(folder.path());
  REQUIRE(all.size() == rig::builtInStyles().size() + 1);
  CHECK(all.back().name == "Mine: a/b");
  CHECK(all.back().origin == rig::StyleOrigin::own);
  CHECK(findStyle("mine", folder.path())->arm.usual == 2.0);
  CHECK(findStyle((folder.path() / "Mine_ a_b.json").string(), "")->name == "Mine: a/b");
  CHECK_THAT(test::refusal(findStyle("anime", folder.path())), Catch::Contains("Rubber hose"));
  CHECK_THAT(test::refusal(findStyle((folder.path() / "broken.json").string(), "")),
             Catch::StartsWith((folder.path() / "broken.json").string()));
  CHECK(userStyles(folder.path() / "nowhere").empty());
  style.arm.usual = 7.0;
  CHECK_THAT(test::refusal(saveStyle(style, folder.path() / "large.json")), Catch::Contains("arm"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "large.json"));
}

TEST_CASE(
    "The verb of styles lists each with where it is from, and writes out one with all of its settings") {
  const test::VerbAnswer list = test::runVerb({"styles"});
  REQUIRE(list.exitCode == 0);
  const std::string lines = "\n" + list.output;
  CHECK_THAT(lines, Catch::Contains("\nAverage of the six (measured)\n"));
  CHECK_THAT(lines, Catch::Contains("\nRubber hose (ours)\n"));
  const test::VerbAnswer one = test::runVerb({"styles", "--style", "Rubber hose"});
  REQUIRE(one.exitCode == 0);
  CHECK_THAT(one.output, Catch::StartsWith("Rubber hose (ours)\n"));
  for (const auto& setting : styleSchema()) {
    CHECK_THAT(one.output, Catch::Contains("\n  " + setting.name + ": "));
  }
}

TEST_CASE("The verb of styles refuses what it cannot do together, and names that are no style's") {
  const auto refused = [](const std::vector<std::string>& words) {
    std::vector<std::string> all{"styles"};
    all.insert(all.end(), words.begin(), words.end());
    const test::VerbAnswer answer = test::runVerb(all);
    CHECK(answer.exitCode != 0);
    CHECK(answer.output.empty());
    return answer.told;
  };
  CHECK_THAT(refused({"-o", "a.json"}), Catch::Contains("-o: says no style; give --style or --take as well"));
  CHECK_THAT(refused({"--style", "Subtle", "--take", "a.glb"}),
             Catch::Contains("--style: stands beside --take; give one of them"));
  CHECK_THAT(refused({"--style", "Subtle", "--name", "Mine"}),
             Catch::Contains("--name: says how a style is taken; give --take as well"));
  CHECK_THAT(refused({"--style", "Subtle", "--clip", "Punch"}),
             Catch::Contains("--clip: says how a style is taken; give --take as well"));
  CHECK_THAT(refused({"--style", "Subtle", "-o", "a.txt"}),
             Catch::Contains("a.txt: an output has to end in .json; give it such a name"));
}
