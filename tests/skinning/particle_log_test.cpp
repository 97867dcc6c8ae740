// Logs of the worm simulation: particles frame by frame, and the membranes that join them.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "skinning/sequence/read_sequence.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;
using Catch::Contains;

namespace {

// Six lines of the box and more, then how many elastic and how many liquid particles there are.
std::string head(const std::string& elastic, const std::string& liquid) {
  return "0\n100\n0\n100\n0\n100\n" + elastic + "\n" + liquid + "\n";
}

const std::string twoFrames = "9\t9\t9\t2.1\n0\t0\t0\t2.1\n1\t0\t0\t2.1\n0\t0\t1\t2.1\n5\t5\t5\t1.1\n"
                              "9\t9\t9\t2.1\n0\t2\t0\t2.1\n1\t2\t0\t2.1\n0\t2\t1\t2.1\n5\t5\t5\t1.1\n";

Result<MeshSequence> logged(const std::string& positions, const std::string& membranes) {
  const test::TemporaryFolder folder;
  folder.write("position_buffer.txt", positions);
  folder.write("membranes_buffer.txt", membranes);
  return readSequence({folder.path()});
}

std::string refused(const std::string& positions, const std::string& membranes) {
  const auto sequence = logged(positions, membranes);
  REQUIRE_FALSE(sequence);
  return sequence.error().line();
}

} // namespace

TEST_CASE("particles of a log that no membrane joins are left out, in every frame") {
  for (const char* const membranes : {"1\n1\t2\t3\n", "1\t2\t3\n", "1\n\n1 2 3\n\n"}) {
    for (const std::string& positions :
         {head("4", "1") + twoFrames, head("4", "1") + "\n" + twoFrames + "\n"}) {
      const auto sequence = logged(positions, membranes);
      REQUIRE(sequence);
      CHECK(sequence->vertexCount == 3);
      REQUIRE(sequence->frameCount() == 2);
      CHECK(sequence->frame(0)[0] == glm::vec3(0.0F, 0.0F, 0.0F));
      CHECK(sequence->frame(0)[1] == glm::vec3(1.0F, 0.0F, 0.0F));
      CHECK(sequence->frame(1)[0] == glm::vec3(0.0F, 2.0F, 0.0F));
      CHECK(sequence->frame(1)[2] == glm::vec3(0.0F, 2.0F, 1.0F));
      CHECK(sequence->triangles.size() == 1);
      CHECK(sequence->frameNames == std::vector<std::string>{"frame 0", "frame 1"});
    }
  }
}

TEST_CASE("the last particle of a frame may be joined, and one behind it may not") {
  CHECK(logged(head("4", "1") + twoFrames, "1\n1 2 4\n"));
  CHECK_THAT(refused(head("4", "1") + twoFrames, "1\n1 2 5\n"), Contains("position_buffer.txt:9"));
  CHECK_THAT(refused(head("4", "0") + twoFrames, "1\n1 2 4\n"), Contains("position_buffer.txt:9"));
  CHECK_THAT(refused(head("4", "2000000000") + twoFrames, "1\n1 2 4\n"), Contains("position_buffer.txt:9"));
}

TEST_CASE("a line of a log that is no particle is refused by its number") {
  const std::string start = head("4", "1") + twoFrames;
  for (const char* const line : {"1 2 3\n", "1 2 3 4 5\n", "1 2 x 4\n", "7\n", "1 2\n"}) {
    CAPTURE(line);
    CHECK_THAT(refused(start + line, "1\n1 2 3\n"),
               Contains("position_buffer.txt:19") && Contains("the line is no particle (x, y, z, type)"));
  }
  // Of particles that are left out no place is looked at, of the others each.
  const auto second = [](const std::string& first, const std::string& joined) {
    return head("4", "1") + first + "\n" + joined + "\n1 0 0 2.1\n0 0 1 2.1\n5 5 5 1.1\n";
  };
  CHECK(logged(second("1e30 0 0 2.1", "0 0 0 2.1"), "1\n1 2 3\n"));
  CHECK_THAT(refused(second("0 0 0 2.1", "0 1e30 0 2.1"), "1\n1 2 3\n"), Contains("position_buffer.txt:10"));
}

TEST_CASE("a log that holds no frame or a part of one is refused") {
  const std::string told = "the log ends within a frame or holds none";
  CHECK_THAT(refused(head("4", "1"), "1\n1 2 3\n"), Contains(told));
  CHECK_THAT(refused(head("4", "1") + twoFrames + "9 9 9 2.1\n", "1\n1 2 3\n"), Contains(told));
  CHECK_THAT(refused("", "1\n1 2 3\n"), Contains(told));
}

TEST_CASE("a membrane that is not three particles is refused by its line, and a log of none") {
  const std::string told = "a membrane needs three particle numbers";
  const std::string positions = head("4", "1") + twoFrames;
  for (const char* const line : {"1 2", "1 2 x", "1 2 -3", "1 2 2.5", "1 2 1e9", "3"}) {
    CAPTURE(line);
    CHECK_THAT(refused(positions, std::string("2\n1 2 3\n") + line + "\n"),
               Contains("membranes_buffer.txt:3") && Contains(told));
  }
  CHECK_THAT(refused(positions, "0\n"), Contains("no membranes are listed"));
  CHECK_THAT(refused(positions, ""), Contains("no membranes are listed"));
}
