// Names and states of a user's own files.
#include "app/files/user_files.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A file of a name has what every system lets it have, and a short name tells files of two folders "
          "apart") {
  CHECK(fileOfName("/poses", "a/b\\c:d*e?f\"g<h>i|j\tk l").string() == "/poses/a_b_c_d_e_f_g_h_i_j_k l.json");
  const std::string name = nameFor("/takes/one/punch.glb");
  CHECK_THAT(name, Catch::StartsWith("punch-"));
  CHECK(name.size() == std::string("punch-").size() + 16);
  CHECK(nameFor("/takes/two/../one/punch.glb") == name);
  CHECK(nameFor("/takes/two/punch.glb") != name);
}

TEST_CASE("A file is another one where its size or its time has changed, and none where it is gone") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("punch.glb", "four");
  const std::optional<FileStamp> before = stampOf(file);
  REQUIRE(before);
  CHECK(before->bytes == 4);
  CHECK(before->time == std::filesystem::last_write_time(file));
  CHECK(stampOf(file) == before);
  std::ofstream(file, std::ios::app) << "more";
  std::filesystem::last_write_time(file, before->time);
  REQUIRE(stampOf(file));
  CHECK(stampOf(file)->bytes == 8);
  CHECK_FALSE(stampOf(file) == before);
  std::filesystem::resize_file(file, 4);
  std::filesystem::last_write_time(file, before->time);
  CHECK(stampOf(file) == before);
  std::filesystem::last_write_time(file, before->time + std::chrono::seconds(2));
  CHECK_FALSE(stampOf(file) == before);
  CHECK_FALSE(stampOf(folder / "gone.glb"));
}
