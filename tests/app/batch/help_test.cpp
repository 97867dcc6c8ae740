// What the help of a verb tells of its options: under which heading each stands, and how a setting reads.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/app/run_verb.h"

using namespace stretch;

namespace {

std::vector<std::string> helpLines(const std::string& verb) {
  const test::VerbAnswer help = test::runVerb({verb, "--help"});
  REQUIRE(help.exitCode == 0);
  std::vector<std::string> lines;
  std::istringstream text(help.output);
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// The options of each heading, without their dashes.
std::map<std::string, std::set<std::string>> optionsByHeading(const std::string& verb) {
  std::map<std::string, std::set<std::string>> found;
  std::string heading;
  for (const std::string& line : helpLines(verb)) {
    if (!line.empty() && line.front() != ' ' && line.ends_with(':')) {
      heading = line.substr(0, line.size() - 1);
    } else if (line.starts_with("  -")) {
      const std::size_t first = line.find("--") + 2;
      found[heading].insert(line.substr(first, line.find_first_of(" :", first) - first));
    }
  }
  return found;
}

/// The text behind an option, blanks made one.
std::string helpOf(const std::string& verb, const std::string& option) {
  for (const std::string& line : helpLines(verb)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == option) {
      std::string text;
      while (words >> word) {
        text += (text.empty() ? "" : " ") + word;
      }
      return text;
    }
  }
  return "not listed";
}

using Options = std::set<std::string>;

} // namespace

TEST_CASE("Options of a verb stand under the headings of what they are about") {
  const Options written{"form", "influences", "key-frames", "keep-skeleton", "key-every-frame"};
  for (const char* const verb : {"exaggerate", "pose", "elastic", "import-clip"}) {
    CAPTURE(verb);
    CHECK(optionsByHeading(verb)["What is written"] == written);
  }
  CHECK(optionsByHeading("elastic")["Weight"] ==
        Options{"amount", "stiffness", "damping", "inertia", "gravity", "young", "density", "moduli"});
  auto exaggerate = optionsByHeading("exaggerate");
  CHECK(exaggerate["Every moment at once"] == Options{"auto", "all-clips", "style", "strength"});
  CHECK(exaggerate["Trail (each --limb starts the next)"] ==
        Options{"limb",       "range",     "scale",         "axes",          "pivot",
                "turn-limit", "ease-in",   "ease-out",      "remap",         "bend",
                "blend",      "switch",    "volume",        "turn-end",      "release",
                "linger",     "overshoot", "space",         "no-pull",       "reference",
                "as-seen",    "camera",    "stay-in-world", "no-keep-depth", "turn-to-view"});
  for (const std::string& option : exaggerate["Settings of the style, with --auto"]) {
    CHECK(option.starts_with("style-"));
  }
  CHECK(exaggerate["Settings of the style, with --auto"].size() > 20);
  auto compress = optionsByHeading("compress");
  CHECK(compress["Compression"] == Options{"bones", "tolerance", "stretch", "weights", "joints", "influences",
                                           "scale-limit", "length", "skip", "young", "mass",
                                           "metres-per-unit", "gravity"});
  CHECK(compress["Clip"] == Options{"quantise", "quantise-mesh", "meshopt", "key-tolerance"});
  auto compare = optionsByHeading("compare");
  CHECK(compare["Flattening"] == Options{"gravity", "mass", "metres-per-unit"});
  CHECK(compare["STED"] == Options{"sted-rings", "sted-window", "sted-dt", "sted-c"});
  CHECK(compare["Options"] == Options{"help", "clip", "flattening", "json", "json-line"});
}

TEST_CASE("The help of a setting tells its choices, its unit and its default") {
  CHECK(helpOf("exaggerate", "--scale") ==
        "How long the limb becomes at the tip, in lengths of itself. Default: 1.0");
  CHECK(
      helpOf("exaggerate", "--linger") ==
      "Frames of the release for which the limb keeps all of its exaggeration before it comes back. [frames] "
      "Default: 0.0");
  CHECK(helpOf("exaggerate", "--pivot") ==
        "The end of the range that stays where it is. (start, end) Default: start");
  CHECK(helpOf("exaggerate", "--axes") == "Active axes of the trail's space, any of x, y, z. Default: xyz");
  CHECK(helpOf("exaggerate", "--ease-in") ==
        "Ease-in: fraction of the path and value there, P,V. [fraction,value] Default: 0.0,0.1");
  // What is found where nothing is given, and what is a name or a switch, has no default to tell.
  const std::string release = helpOf("exaggerate", "--release");
  CHECK(release.ends_with("than it came. [frames]"));
  CHECK(helpOf("exaggerate", "--turn-end") == "The hand or foot turns with the limb.");
  CHECK(helpOf("exaggerate", "--no-pull") ==
        "Switches this off: Pull the tip to the wanted length where its line does not reach it.");
  CHECK(helpOf("exaggerate", "--camera") ==
        "Camera that judges the trail: one of the file, or front, side, top, three-quarter.");
  CHECK(helpOf("elastic", "--gravity") ==
        "TEXT Gravity along x, y, z of the scene; 0,0,0 leaves inertia alone. "
        "[m/s^2] Default: 0.0,-9.81,0.0");
  CHECK(helpOf("compress", "--bones") ==
        "TEXT Bones, in a row along the body or one for each part that moves alike. Default: 30");
  CHECK(helpOf("compress", "--influences") ==
        "TEXT The most bones that a vertex hangs on, where weights are fitted. (4, 8) Default: 4");
  CHECK(helpOf("compare", "--sted-window") == "INT=3 Frame steps of the temporal part, odd");
}

TEST_CASE("The help of every verb shows how it is called") {
  for (const app::Verb& verb : app::batchVerbs()) {
    CAPTURE(verb.name);
    const std::vector<std::string> lines = helpLines(verb.name);
    const auto examples = std::ranges::count_if(lines, [&](const std::string& line) {
      return line.starts_with("  stretch-engine " + verb.name + ' ');
    });
    CHECK(examples > 0);
    const char* const heading = examples == 1 ? "Example:" : "Examples:";
    CHECK(std::ranges::count(lines, std::string(heading)) == 1);
  }
}
