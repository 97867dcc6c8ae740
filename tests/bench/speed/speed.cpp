// speed [--json] [--repeat N] [--only TEXT] [FILE]: this program beside floors and peers, as ratios within
// one run. FILE: a GLB with a skeleton and a clip; default: the bundled character. Peers are measured where
// they are installed: Blender, f3d, CGAL (when the bench is built). Starting needs a display.
#include <algorithm>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/files/save.h"
#include "tests/bench/speed/rows.h"

namespace stretch::bench {

namespace {

int run(const std::string& file, int repetitions, const std::string& only, bool asJson) {
  const Result<app::Document> document = app::openDocument(file);
  if (!document) {
    fmt::print(stderr, "speed: {}\n", document.error().line());
    return 1;
  }
  if (document->clips->empty() || document->body.limbs.empty()) {
    fmt::print(stderr, "speed: {}: needs a clip and a limb\n", file);
    return 1;
  }
  const SpeedInput input{file, *document, repetitions};
  std::vector<Comparison> all;
  // Files come first: a program that is started takes over the peak of the one that starts it.
  for (const auto& [name, measured] : {std::pair{"files", &fileComparisons},
                                       {"motion", &motionComparisons},
                                       {"surfaces", &surfaceComparisons},
                                       {"start", &startComparisons}}) {
    if (only.empty() || only == name) {
      for (Comparison& row : measured(input)) {
        all.push_back(std::move(row));
      }
    }
  }
  print(all, asJson);
  return 0;
}

} // namespace

} // namespace stretch::bench

int main(int argumentCount, char** arguments) {
  CLI::App program{"This program beside floors and peers, as ratios within one run."};
  std::string file = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  std::string only;
  int repetitions = 20;
  bool asJson = false;
  program.add_option("FILE", file, "A GLB with a skeleton and a clip; default: the bundled character");
  program.add_option("--repeat", repetitions, "Repetitions of each measurement")->check(CLI::Range(1, 1000));
  program.add_option("--only", only, "One group of rows")
      ->check(CLI::IsMember({"motion", "files", "surfaces", "start"}));
  program.add_flag("--json", asJson, "Print one JSON document");
  CLI11_PARSE(program, argumentCount, arguments);
  return stretch::bench::run(file, repetitions, only, asJson);
}
