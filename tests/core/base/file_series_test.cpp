// Files that are made one after the other and stand whole or not at all, and places that are looked at before
// any work.
#include "core/base/file_series.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using test::TemporaryFolder;
namespace fs = std::filesystem;

TEST_CASE("A series takes away what one that was killed left in its folder") {
  const TemporaryFolder folder;
  folder.write(std::string(partName) + "1-0.tmp", "left");
  folder.write("a", "the user's");
  const FileSeries series(folder.path());
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("None of a series is at its place before its end, and then all are") {
  const TemporaryFolder folder;
  FileSeries series(folder.path());
  for (const char* const name : {"a", "b", "c"}) {
    REQUIRE(series.add(folder / name, Bytes{1, 2}));
    CHECK_FALSE(fs::exists(folder / name));
  }
  REQUIRE(series.finish());
  for (const char* const name : {"a", "b", "c"}) {
    CHECK(readText(folder / name).value() == "\x01\x02");
  }
  CHECK(folder.fileCount() == 3);
}

TEST_CASE("A series that is begun in a folder where another one is written leaves that one whole") {
  const TemporaryFolder folder;
  FileSeries first(folder.path());
  REQUIRE(first.add(folder / "a", Bytes{1}));
  REQUIRE(first.add(folder / "b", Bytes{2}));
  {
    FileSeries second(folder.path());
    REQUIRE(second.add(folder / "c", Bytes{3}));
    CHECK(folder.fileCount() == 3);
  }
  CHECK(folder.fileCount() == 2);
  REQUIRE(first.finish());
  CHECK(readText(folder / "a").value() == "\x01");
  CHECK(readText(folder / "b").value() == "\x02");
  CHECK(folder.fileCount() == 2);
}

TEST_CASE("A series that was moved on is written as one, and one that is given up leaves what was there") {
  const TemporaryFolder folder;
  folder.write("a", "of before");
  {
    std::optional<FileSeries> series(folder.path());
    REQUIRE(series->add(folder / "a", Bytes{1}));
    const FileSeries given = std::move(*series);
    series.reset();
    CHECK(folder.fileCount() == 2);
  }
  CHECK(folder.fileCount() == 1);
  CHECK(readText(folder / "a").value() == "of before");
}

TEST_CASE("A place is refused before any work where nothing can be written") {
  const TemporaryFolder folder;
  folder.write("there", "x");
  fs::create_directories(folder / "folder");
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  fs::create_symlink("there", folder / "link");
  fs::create_symlink("folder", folder / "link to a folder");
  fs::create_symlink("missing/file", folder / "link to nowhere");
  for (const char* const name : {"new", "there", "link"}) {
    CAPTURE(name);
    CHECK(checkPlace(folder / name));
  }
  const auto told = [&](const char* name) {
    const Status place = checkPlace(folder / name);
    return place ? std::string("may be written") : place.error().what;
  };
  CHECK(told("folder") == "is a folder");
  CHECK(told("link to a folder") == "is a folder");
  CHECK(told("missing/file") == "there is no such folder");
  CHECK(told("there/file") == "there is no such folder");
  CHECK(told("link to nowhere") == "there is no such folder");
  CHECK(told("pipe") == "is not a regular file");
  CHECK(readText(folder / "there").value() == "x");
}
