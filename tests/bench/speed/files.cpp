#include <filesystem>

#include <fmt/core.h>
#include <tiny_gltf.h>

#include "app/files/save.h"
#include "core/base/check.h"
#include "tests/bench/speed/long_clip.h"
#include "tests/bench/speed/rows.h"

namespace stretch::bench {

namespace {

void openWithTinygltf(const std::filesystem::path& path) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  check(loader.LoadBinaryFromFile(&model, &error, &warning, path.string()),
        "tinygltf opens the bench's file");
}

Comparison opening(const SpeedInput& input) {
  const Pair cost = measureInTurn(
      input.repetitions, [&] { check(app::openDocument(input.file).ok(), "the bench's file opens"); },
      [&] { openWithTinygltf(input.file); });
  return {"open, with limbs found and clips read", "tinygltf, with images", cost.ours, cost.other, 1.2,
          "checks of the file, its JSON"};
}

Comparison saving(const SpeedInput& input) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "stretch-engine-speed.glb";
  app::Document moving = input.document;
  addTrail(moving, 0, 0.0, 20.0);
  const auto save = [&](const app::Document& document) {
    check(app::saveDocument(document, path, {}).ok(), "the file of a bench can be written");
  };
  const Pair cost = measureInTurn(
      input.repetitions, [&] { save(moving); }, [&] { save(input.document); });
  std::filesystem::remove(path);
  return {"save with one trail",
          "save without",
          cost.ours,
          cost.other,
          1.5,
          "keys of the trail, the file's JSON once more"};
}

/// Peak memory above what the program takes for anything, beside the file's own size.
std::vector<Comparison> memory(const SpeedInput& input) {
  constexpr double constantMegabytes = 60.0;
  const double file = 1e-6 * static_cast<double>(std::filesystem::file_size(input.file));
  const std::string output = (std::filesystem::temp_directory_path() / "stretch-engine-speed.glb").string();
  const std::string limb = input.document.body.limbs.front().id;
  const std::string program = STRETCH_PROGRAM;
  std::vector<Comparison> rows;
  for (const auto& [name, command] :
       {std::pair<std::string, std::vector<std::string>>{"info", {program, "info", input.file.string()}},
        {"resave", {program, "resave", input.file.string(), "-o", output}},
        {"exaggerate",
         {program, "exaggerate", input.file.string(), "-o", output, "--limb", limb, "--scale", "2"}}}) {
    const RunCost cost = runProgram(command);
    check(cost.ran, "the program answers");
    rows.push_back({fmt::format("peak memory of {}, above {:.0f} MB", name, constantMegabytes),
                    "the file's size", std::max(0.0, cost.megabytes - constantMegabytes), file, 4.0,
                    "images, decoded"});
  }
  std::filesystem::remove(output);
  return rows;
}

} // namespace

std::vector<Comparison> fileComparisons(const SpeedInput& input) {
  std::vector<Comparison> rows{opening(input), saving(input)};
  for (Comparison& row : memory(input)) {
    rows.push_back(std::move(row));
  }
  return rows;
}

} // namespace stretch::bench
