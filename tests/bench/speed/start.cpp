#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/bench/speed/rows.h"

namespace stretch::bench {

namespace {

double medianMilliseconds(const std::vector<std::string>& command, int repetitions) {
  std::vector<double> costs;
  for (int i = 0; i < repetitions; ++i) {
    const RunCost cost = runProgram(command);
    if (!cost.ran) {
      return 0.0;
    }
    costs.push_back(cost.milliseconds);
  }
  std::sort(costs.begin(), costs.end());
  return costs[costs.size() / 2];
}

} // namespace

std::vector<Comparison> startComparisons(const SpeedInput& input) {
  if (std::getenv("DISPLAY") == nullptr) {
    return {};
  }
  const std::filesystem::path script = std::filesystem::temp_directory_path() / "stretch-engine-quit.script";
  std::ofstream(script) << "quit\n";
  const int repetitions = std::max(5, input.repetitions / 4);
  const std::string file = input.file.string();
  const double ours = medianMilliseconds({STRETCH_DRIVEN, script.string(), file}, repetitions);
  const double least = medianMilliseconds({STRETCH_MINIMAL_GL}, repetitions);
  const std::string picture = (std::filesystem::temp_directory_path() / "stretch-engine-f3d.png").string();
  const double viewer = medianMilliseconds({"f3d", "--output", picture, file}, repetitions);
  std::filesystem::remove(script);
  std::filesystem::remove(picture);
  return {{"start, open, first frame, end", "a window of GLFW, one clear, end", ours, least, 1.5,
           "fonts, shaders, the scene's first drawing"},
          {"start, open, first frame, end", "f3d, one picture", ours, viewer, 0.35, "as above"}};
}

} // namespace stretch::bench
