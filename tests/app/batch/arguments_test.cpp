#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "app/schema/parse_text.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr const char* dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";

int run(const std::vector<std::string>& words) {
  std::vector<const char*> arguments{"stretch-engine"};
  for (const std::string& word : words) {
    arguments.push_back(word.c_str());
  }
  return runVerbs(batchVerbs(), static_cast<int>(arguments.size()), arguments.data());
}

} // namespace

TEST_CASE("A range is two frames in order") {
  CHECK(parseRange("3:12.5", "--range").value() == Vec2(3.0, 12.5));
  CHECK(parseRange("-5:500", "--range").value() == Vec2(-5.0, 500.0));
  for (const char* text : {"12:3", "12", "a:b", ""}) {
    INFO(text);
    const Result<Vec2> range = parseRange(text, "--range");
    REQUIRE_FALSE(range);
    CHECK(range.error().where == "--range");
  }
}

TEST_CASE("A file that cannot be opened is named") {
  const test::TemporaryFolder folder;
  const std::string text = folder.write("notes.txt", "no model").string();
  CHECK(openDocument(FileArguments{text}).error().where.rfind(text, 0) == 0);
  CHECK(openDocument(FileArguments{folder.path().string()}).error().what == "is a folder");
}

TEST_CASE("Exaggerating writes nothing when a limb, its scale or its range is wrong") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  CHECK(run({"exaggerate", dummy, "-o", output}) == 1);
  CHECK(run({"exaggerate", dummy, "-o", output, "--limb", "left-arm"}) == 1);
  CHECK(run({"exaggerate", dummy, "-o", output, "--limb", "third-arm", "--scale", "2"}) == 1);
  CHECK(run({"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "2", "--range",
             "900:990"}) == 1);
  CHECK(run({"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "much"}) == 2);
  CHECK(run({"exaggerate", dummy, "--limb", "left-arm", "--scale", "2"}) == 2);
  CHECK(run({"bend", dummy}) == 2);
  CHECK(folder.fileCount() == 0);
  CHECK(run({"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "2"}) == 0);
  CHECK(folder.fileCount() == 1);
}
