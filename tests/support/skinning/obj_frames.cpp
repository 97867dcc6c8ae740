#include "tests/support/skinning/obj_frames.h"

#include <fstream>

#include <fmt/format.h>

namespace stretch::test {

void writeObjFrames(const MeshSequence& sequence, const std::filesystem::path& folder,
                    const std::string& name) {
  std::filesystem::create_directories(folder);
  for (std::size_t frame = 0; frame < sequence.frameCount(); ++frame) {
    std::ofstream out(folder / fmt::format("{}-{}.obj", name, frame + 1));
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      const glm::vec3& p = sequence.frame(frame)[v];
      out << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    }
    for (const Triangle& t : sequence.triangles) {
      out << fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
  }
}

} // namespace stretch::test
