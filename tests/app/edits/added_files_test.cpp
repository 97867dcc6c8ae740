// Files that are added beside a character: none to one that is of no file.
#include <catch2/catch.hpp>

#include "app/edits/pose/prop_file_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("Files are added to a character of a file alone, and none leave it as it is") {
  Document made = test::boxer();
  made.source = nullptr;
  CHECK(withAddedFiles(made, {}));
  CHECK_THAT(test::refusal(withAddedFiles(made, {gltf::AddedFile{}})),
             Catch::Contains("the character is of no file") && Catch::Contains("open one"));
  const Document opened = test::boxer();
  const Result<Document> same = withAddedFiles(opened, {});
  REQUIRE(same);
  CHECK(same->scene == opened.scene);
}
