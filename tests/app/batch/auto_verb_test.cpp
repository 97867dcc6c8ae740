#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include "app/files/save.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;

namespace {

const std::string punchPath = STRETCH_SOURCE_DIR "/assets/dummy.glb";

Json report(const std::vector<std::string>& words) {
  const test::VerbAnswer answer = test::runVerb(words);
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  return Json::parse(answer.output);
}

/// One line for a moment: what became of it, and why no more.
std::string momentLine(const Json& moment) {
  const bool done = moment["exaggerated"].get<bool>();
  std::string line = fmt::format("  {}, {} from frame {:g} to {:g}: ", moment["limb"].get<std::string>(),
                                 moment["kind"].get<std::string>(), moment["start"].get<double>(),
                                 moment["tip"].get<double>());
  line += done ? fmt::format("scale {:.3g}", moment["length_scale"].get<double>()) : "left out";
  line += done && moment["along_ground"].get<bool>() ? ", along the ground" : "";
  line += moment.contains("why") ? (done ? ", with more " : ", ") + moment["why"].get<std::string>() : "";
  return line + "\n";
}

} // namespace

TEST_CASE("Every moment of a clip is exaggerated in the named style, and told of") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const Json subtle = report({"exaggerate", punchPath, "-o", out, "--auto", "--style", "subtle", "--json"});
  CHECK(subtle["style"] == "Subtle");
  CHECK(subtle["origin"] == "ours");
  REQUIRE(subtle["clips"].size() == 1);
  const Json& clip = subtle["clips"][0];
  CHECK(clip["trails"].size() >= 2);
  double most = 0.0;
  for (const Json& moment : clip["moments"]) {
    const bool done = moment["exaggerated"].get<bool>();
    CHECK((done || moment.contains("why")));
    most = done ? std::max(most, moment["length_scale"].get<double>()) : most;
  }
  CHECK(most == Approx(1.2));
  const Json stronger = report(
      {"exaggerate", punchPath, "-o", out, "--auto", "--style", "Subtle", "--strength", "2", "--json"});
  CHECK(stronger["clips"][0]["moments"][0]["length_scale"] == 1.4);
}

TEST_CASE("One setting of a style is changed for one run, and all clips are done at once") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const Json done = report({"exaggerate", punchPath, "-o", out, "--auto", "--all-clips", "--style", "Subtle",
                            "--style-arm", "1.3", "--json"});
  CHECK(done["style"] == "Subtle, changed");
  CHECK(done["origin"] == "own");
  CHECK(done["clips"][0]["moments"][0]["length_scale"] == 1.3);
  CHECK(test::runVerb({"exaggerate", punchPath, "-o", out, "--auto", "--strength", "2.5"}).exitCode == 2);
}

TEST_CASE("Limbs are exaggerated in every clip in which they can be, and the others say why not") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const Json all =
      report({"exaggerate", punchPath, "-o", out, "--all-clips", "--limb", "left-arm", "--range", "4:8",
              "--scale", "2", "--limb", "right-arm", "--range", "40:43", "--scale", "1.5", "--json"});
  REQUIRE(all["clips"].size() == 2);
  CHECK(all["clips"][0]["clip"] == "One-two punch");
  CHECK(all["clips"][1]["clip"] == "Guard");
  REQUIRE(all["clips"][0]["trails"].size() == 2);
  CHECK(all["clips"][0]["left_out"].empty());
  REQUIRE(all["clips"][1]["trails"].size() == 1); // It has no frame 40.
  CHECK(all["clips"][1]["trails"][0]["limb"] == "left-arm");
  REQUIRE(all["clips"][1]["left_out"].size() == 1);
  CHECK(all["clips"][1]["left_out"][0].get<std::string>().starts_with("right-arm: "));
  const Json& arm = all["clips"][1]["trails"][0];
  CHECK(arm["limb_length_after"].get<double>() == Approx(2.0 * arm["limb_length_before"].get<double>()));
  CHECK(report({"info", out, "--json"})["trails"].size() == 3);
  const Result<app::Document> saved = app::openDocument(out);
  REQUIRE(saved);
  for (const rig::Trail& trail : saved->trails) { // in turn, in each clip anew
    CHECK(trail.colour == (trail.limb == "left-arm" ? 0 : 1));
  }
  const test::VerbAnswer told = test::runVerb({"exaggerate", punchPath, "-o", out, "--all-clips", "--limb",
                                               "right-arm", "--range", "40:43", "--scale", "2", "--loops"});
  CHECK(told.exitCode == 0);
  CHECK(told.output.find("Guard:\nleft out: right-arm: ") != std::string::npos);
}

TEST_CASE(
    "A style that is taken from a saved clip gives another one the same ratios within two in a hundred") {
  const test::TemporaryFolder folder;
  const std::string first = (folder / "first.glb").string();
  const std::string second = (folder / "second.glb").string();
  const std::string style = (folder / "style.json").string();
  const std::string other = STRETCH_SOURCE_DIR "/assets/dummy_leap.glb";
  REQUIRE(test::runVerb({"exaggerate", punchPath, "-o", first, "--limb", "left-arm", "--range", "21:27",
                         "--scale", "1.6"})
              .exitCode == 0);
  REQUIRE(test::runVerb({"styles", "--take", first, "--name", "Mine", "-o", style}).exitCode == 0);
  const Json done = report({"exaggerate", other, "-o", second, "--auto", "--style", style, "--json"});
  CHECK(done["style"] == "Mine");
  const Json& trails = done["clips"][0]["trails"];
  REQUIRE_FALSE(trails.empty());
  const double ratio =
      trails[0]["limb_length_after"].get<double>() / trails[0]["limb_length_before"].get<double>();
  CHECK(ratio == Approx(1.6).epsilon(0.02));
}

TEST_CASE("The styles are listed with where they come from") {
  const Json list = report({"styles", "--json"});
  REQUIRE(list.size() >= 11);
  CHECK(list[0]["name"] == "Duck Amuck (1953)");
  CHECK(list[0]["origin"] == "measured");
  CHECK(report({"styles", "--style", "Heavy", "--json"})["weight"] == 0.5);
}

TEST_CASE("In a strong style a loop's seam, standing feet and the floor are as the source has them") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const std::string assets = STRETCH_SOURCE_DIR "/assets/";
  for (const auto& [file, clip] :
       {std::pair("dummy_swing.glb", "#0"), {"dummy.glb", "#0"}, {"dummy_leap.glb", "#0"}}) {
    CAPTURE(file, clip);
    const Json done = report({"exaggerate", assets + file, "-o", out, "--auto", "--clip", clip, "--style",
                              "Rubber hose", "--strength", "2", "--json"});
    CHECK_FALSE(done["clips"][0]["trails"].empty());
    CHECK(done.value("worse", Json::array()).dump() == "[]");
  }
}

TEST_CASE("What becomes of every moment is told in words as in numbers, clip by clip") {
  const test::TemporaryFolder folder;
  std::vector<std::string> words{"exaggerate", punchPath, "-o",    (folder / "out.glb").string(),
                                 "--auto",     "--style", "Opera", "--all-clips"};
  const test::VerbAnswer told = test::runVerb(words);
  words.emplace_back("--json");
  const Json done = report(words);
  REQUIRE(done["clips"].size() == 2);
  std::string lines;
  for (const Json& clip : done["clips"]) {
    lines += clip["clip"].get<std::string>() + ":\n";
    lines += clip["moments"].empty() ? "  nothing to exaggerate: no limb makes a stroke\n" : "";
    for (const Json& moment : clip["moments"]) {
      lines += momentLine(moment);
    }
    for (const Json& note : clip["notes"]) {
      lines += "  " + note.get<std::string>() + "\n";
    }
    lines += clip["made_loop"].get<bool>()
                 ? "  the clip is marked as a loop, so that the way back goes on at its start\n"
                 : "";
  }
  CHECK_THAT(told.output, Catch::StartsWith(lines));
}

TEST_CASE("Trails that are made at once have the colours in turn, named ones in their order") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const auto coloursOf = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"exaggerate", punchPath, "-o", out});
    REQUIRE(test::runVerb(words).exitCode == 0);
    const Result<app::Document> saved = app::openDocument(out);
    REQUIRE(saved);
    std::vector<int> colours;
    std::ranges::transform(saved->trails, std::back_inserter(colours), &rig::Trail::colour);
    return colours;
  };
  CHECK(coloursOf({"--limb", "right-arm", "--range", "40:43", "--scale", "2", "--limb", "left-arm", "--range",
                   "21:27", "--scale", "2", "--limb", "left-leg", "--range", "21:27", "--scale", "1.5"}) ==
        std::vector<int>{0, 1, 2});
  std::vector<int> made = coloursOf({"--auto", "--style", "Subtle"});
  std::vector<int> inTurn;
  for (std::size_t i = 0; i < made.size(); ++i) {
    inTurn.push_back(static_cast<int>(i % 5));
  }
  std::ranges::sort(made);
  std::ranges::sort(inTurn);
  CHECK(made.size() > 1);
  CHECK(made == inTurn);
}

TEST_CASE("Every clip that is exaggerated with --loops becomes a loop, and none does without it") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  for (const bool loops : {true, false}) {
    std::vector<std::string> words{"exaggerate",  punchPath, "-o",       out,
                                   "--all-clips", "--limb",  "left-arm", "--range",
                                   "4:8",         "--scale", "2"};
    if (loops) {
      words.emplace_back("--loops");
    }
    REQUIRE(test::runVerb(words).exitCode == 0);
    const Result<app::Document> saved = app::openDocument(out);
    REQUIRE(saved);
    for (const int clip : {0, 1}) {
      CHECK(app::isLooping(*saved, clip) == loops);
    }
  }
}
