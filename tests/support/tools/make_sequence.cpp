// Writes a mesh sequence for checks of the program as a whole: OBJ frames of a tube that bends, shortens with
// its curvature and is flattened by gravity.
//   make-sequence FOLDER [FRAMES]
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <fmt/core.h>

#include "tests/support/skinning/bodies.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount < 2) {
    std::cerr << "usage: make-sequence FOLDER [FRAMES]\n";
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  const int frames = argumentCount > 2 ? std::atoi(arguments[2]) : 24;
  std::filesystem::create_directories(folder);
  const stretch::MeshSequence tube = stretch::test::shorteningTube(frames, 2.4, 0.05, 0.12);
  for (std::size_t frame = 0; frame < tube.frameCount(); ++frame) {
    std::ofstream out(folder / fmt::format("tube-{}.obj", frame + 1));
    for (std::size_t v = 0; v < tube.vertexCount; ++v) {
      const glm::vec3& p = tube.frame(frame)[v];
      out << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    }
    for (const stretch::Triangle& t : tube.triangles) {
      out << fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
  }
  return 0;
}
