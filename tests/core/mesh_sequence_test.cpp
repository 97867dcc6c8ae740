#include "core/scene/mesh_sequence.h"

#include <catch2/catch.hpp>

using namespace stretch;

namespace {

/// Two vertices that move along x, a unit for each frame, with as many names as given.
MeshSequence moving(std::size_t frames, std::vector<std::string> names) {
  MeshSequence sequence;
  sequence.name = "walk";
  sequence.vertexCount = 2;
  sequence.frameNames = std::move(names);
  sequence.framesPerSecond = 12.0;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    sequence.positions.emplace_back(static_cast<float>(frame), 0.0F, 0.0F);
    sequence.positions.emplace_back(static_cast<float>(frame), 1.0F, 0.0F);
  }
  return sequence;
}

} // namespace

TEST_CASE("The diagonal of a box reaches over all its points, on every side of the origin") {
  CHECK(boxDiagonal({}) == 0.0);
  CHECK(boxDiagonal(std::vector<glm::vec3>{{5, 6, 7}}) == 0.0);
  CHECK(boxDiagonal(std::vector<glm::vec3>{{2, 0, 0}, {0, 3, 0}, {0, 0, 6}}) == Approx(7.0));
  CHECK(boxDiagonal(std::vector<glm::vec3>{{-3, -10, -2}, {-1, -4, -5}}) == Approx(7.0));
  CHECK(boxDiagonal(std::vector<glm::vec3>{{1, 1, 1}, {2, 3, 7}, {4, 4, 1}}) == Approx(std::sqrt(54.0)));
}

TEST_CASE("A sequence counts its frames by its vertices, and has none without them") {
  CHECK(MeshSequence{}.frameCount() == 0);
  CHECK(moving(3, {}).frameCount() == 3);
  MeshSequence sequence = moving(3, {});
  CHECK(sequence.frame(2)[1] == glm::vec3(2, 1, 0));
  sequence.frame(1)[0].x = 7.0F;
  CHECK(std::as_const(sequence).frame(1)[0] == glm::vec3(7, 0, 0));
}

TEST_CASE("Settling frames are left out from the front with their names, and one frame is always kept") {
  const MeshSequence all = moving(4, {"a", "b", "c", "d"});
  CHECK(withoutFirstFrames(all, 0).positions == all.positions);
  const MeshSequence later = withoutFirstFrames(all, 1);
  CHECK(later.frameCount() == 3);
  CHECK(later.frame(0)[0] == glm::vec3(1, 0, 0));
  CHECK(later.frame(2)[1] == glm::vec3(3, 1, 0));
  CHECK(later.frameNames == std::vector<std::string>{"b", "c", "d"});
  CHECK(later.name == "walk");
  CHECK(later.framesPerSecond == 12.0);
  for (const std::size_t many : {3, 4, 100}) {
    const MeshSequence last = withoutFirstFrames(all, many);
    CHECK(last.frameCount() == 1);
    CHECK(last.frame(0)[0] == glm::vec3(3, 0, 0));
    CHECK(last.frameNames == std::vector<std::string>{"d"});
  }
  // Fewer names than frames: none is left over that would name another frame.
  CHECK(withoutFirstFrames(moving(4, {"a"}), 2).frameNames.empty());
  CHECK(withoutFirstFrames(MeshSequence{}, 3).frameCount() == 0);
}

TEST_CASE("The extent of a sequence is that of its first frame, or of the first that is no speck") {
  MeshSequence growing;
  growing.vertexCount = 2;
  const auto extentWith = [&](const std::vector<float>& sizes) {
    growing.positions.clear();
    for (const float size : sizes) {
      growing.positions.insert(growing.positions.end(), {{0, 0, 0}, {size, 0, 0}});
    }
    const SequenceExtent extent = extentOf(growing);
    return std::pair(extent.frame, static_cast<float>(extent.diagonal));
  };
  CHECK(extentWith({2.0F, 100.0F, 1.0F}) == std::pair(std::size_t{0}, 2.0F));
  CHECK(extentWith({0.0F, 0.5F, 3.0F, 100.0F}) == std::pair(std::size_t{2}, 3.0F));
  CHECK(extentWith({1.0F, 100.0F}) == std::pair(std::size_t{0}, 1.0F)); // a hundredth is no speck
  CHECK(extentWith({0.0F, 0.0F}) == std::pair(std::size_t{0}, 0.0F));
  CHECK(extentWith({}) == std::pair(std::size_t{0}, 0.0F));
}
