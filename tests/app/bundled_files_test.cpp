#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include "app/bundled_files.h"
#include "app/files/bundled_folder.h"
#include "app/files/save.h"
#include "app/open_document.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

namespace fs = std::filesystem;

void touch(const fs::path& path) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "x";
}

} // namespace

TEST_CASE(
    "the bundled clips are found beside an installed program and beside one that was built from sources") {
  const test::TemporaryFolder folder;
  CHECK_FALSE(bundledFolder(folder.path() / "bin").has_value());
  touch(folder.path() / "share/stretch-engine/dummy.glb");
  CHECK(bundledFolder(folder.path() / "bin") == folder.path() / "share/stretch-engine");
  touch(folder.path() / "sources/assets/dummy.glb");
  CHECK(bundledFolder(folder.path() / "sources/build/release") == folder.path() / "sources/assets");
  CHECK(bundledFolder(folder.path() / "sources/build/release/tests") == folder.path() / "sources/assets");
}

TEST_CASE("every bundled clip opens, has its picture beside it and is called what the welcome says") {
  for (const BundledClip& clip : bundledClips()) {
    CAPTURE(clip.file);
    const fs::path assets = fs::path(STRETCH_SOURCE_DIR) / "assets";
    CHECK(fs::exists(assets / clip.picture));
    const Result<Document> document = openDocument(assets / clip.file);
    REQUIRE(document.ok());
    CHECK(document->clips->front().name == clip.name);
    CHECK(allLimbs(*document).size() == 6);
  }
}
