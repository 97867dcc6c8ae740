#include "tests/support/assets/dummy_fixture.h"

#include <fstream>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "assets/dummy/dummy.h"

namespace stretch::assets {

namespace {

bool isBelow(const std::vector<Joint>& skeleton, int joint, int above) {
  while (joint >= 0 && joint != above) {
    joint = skeleton[static_cast<std::size_t>(joint)].parent;
  }
  return joint == above;
}

} // namespace

const Character& madeDummy() {
  static const Character dummy = makeDummy();
  return dummy;
}

std::filesystem::path committedDummyPath() {
  return std::filesystem::path(STRETCH_SOURCE_DIR) / "assets/dummy.glb";
}

std::vector<std::uint8_t> committedDummy() {
  std::ifstream file(committedDummyPath(), std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return {bytes.begin(), bytes.end()};
}

void bendJoint(SkinnedMesh& mesh, const std::vector<Joint>& skeleton, int joint, double degrees) {
  const Joint& bent = skeleton[static_cast<std::size_t>(joint)];
  const Vec3 above = bent.position - skeleton[static_cast<std::size_t>(bent.parent)].position;
  const Vec3 below = skeleton[static_cast<std::size_t>(joint) + 1].position - bent.position;
  const Quat turn = glm::angleAxis(degrees * pi / 180.0, glm::normalize(glm::cross(above, below)));
  for (SkinnedVertex& vertex : mesh.vertices) {
    Vec3 moved(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      const bool turns = isBelow(skeleton, vertex.influences.joints[i], joint);
      moved += vertex.influences.weights[i] *
               (turns ? bent.position + turn * (vertex.position - bent.position) : vertex.position);
    }
    vertex.position = moved;
  }
}

} // namespace stretch::assets
