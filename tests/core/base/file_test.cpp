#include "core/base/file.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>

#include "core/base/descriptor.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using test::TemporaryFolder;

namespace fs = std::filesystem;

namespace {

std::size_t entriesOf(const TemporaryFolder& folder) {
  const fs::recursive_directory_iterator entries(folder.path());
  return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

std::string textOf(const fs::path& path) {
  return readText(path).value();
}

// While it lives a file that grows beyond `bytes` meets a full disk.
class SmallDisk {
public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

private:
  rlimit before_{};
  void (*handler_)(int);
};

} // namespace

TEST_CASE("What was written is read again, whether the file was there or not") {
  const TemporaryFolder folder;
  const Bytes bytes{0, 255, 10, 13};
  REQUIRE(writeFile(folder / "a.bin", bytes));
  CHECK(readFile(folder / "a.bin").value() == bytes);
  REQUIRE(writeFile(folder / "a.bin", {}));
  CHECK(readFile(folder / "a.bin").value().empty());
  CHECK(entriesOf(folder) == 1);
}

TEST_CASE("A file that cannot be read is told by its name") {
  const TemporaryFolder folder;
  CHECK(readText(folder / "none").error().line().find("none: there is no such file") != std::string::npos);
  CHECK(readFile(folder.path()).error().what == "is a folder");
}

TEST_CASE(
    "A file of 4 GiB and more is refused without being read, a folder and what is not there are named so") {
  const TemporaryFolder folder;
  std::ofstream(folder / "huge.glb") << "glTF";
  fs::resize_file(folder / "huge.glb", std::uintmax_t(5) << 30); // Sparse: it takes no room.
  CHECK(test::refusal(readFile(folder / "huge.glb")) ==
        (folder / "huge.glb").string() + ": is larger than 4 GiB; check the file");
  CHECK(test::refusal(readText(folder / "huge.glb")).find("is larger than 4 GiB") != std::string::npos);
  CHECK(test::refusal(readFile(folder.path())) == folder.path().string() + ": is a folder; give a file");
  CHECK(test::refusal(readFile(folder / "none.glb")) ==
        (folder / "none.glb").string() + ": there is no such file; check the path");
}

TEST_CASE("A pair of which one cannot be replaced is left as it was") {
  const TemporaryFolder folder;
  folder.write("model.bin", "old data");
  fs::create_directories(folder / "model.gltf" / "inside");
  const std::array<OutputFile, 3> pair{OutputFile{folder / "model.bin", {1}},
                                       {folder / "textures/new.png", {2}},
                                       {folder / "model.gltf", {3}}};
  const Status failed = writeFiles(pair, MissingFolder::isMade);
  REQUIRE_FALSE(failed);
  CHECK(failed.error().where == (folder / "model.gltf").string());
  CHECK(textOf(folder / "model.bin") == "old data");
  CHECK(entriesOf(folder) == 3); // the folder textures has gone again
}

TEST_CASE("Of files that are saved together those before the one that cannot be replaced are as they were") {
  const std::size_t count = GENERATE(2U, 3U, 4U);
  const TemporaryFolder folder;
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const fs::path path = folder.write(std::to_string(i) + ".bin", "old " + std::to_string(i));
    files.push_back({path, {1}});
  }
  fs::create_directories(folder / "model.gltf" / "inside");
  files.push_back({folder / "model.gltf", {2}});
  REQUIRE_FALSE(writeFiles(files));
  for (std::size_t i = 0; i + 1 < count; ++i) {
    CHECK(textOf(files[i].path) == "old " + std::to_string(i));
  }
  CHECK(entriesOf(folder) == count + 1); // with the folder in the way
}

TEST_CASE("A pair is replaced whole and leaves no other name of the old files") {
  const TemporaryFolder folder;
  folder.write("model.bin", "old data");
  folder.write("model.gltf", "old text");
  const std::array<OutputFile, 2> pair{OutputFile{folder / "model.bin", {'a'}},
                                       {folder / "model.gltf", {'b'}}};
  REQUIRE(writeFiles(pair));
  CHECK(textOf(folder / "model.bin") + textOf(folder / "model.gltf") == "ab");
  CHECK(entriesOf(folder) == 2);
}

TEST_CASE("A full disk leaves the old file and nothing else") {
  const TemporaryFolder folder;
  folder.write("model.glb", "old");
  const Bytes large(100000, 7);
  {
    const SmallDisk disk(5000);
    const Status failed = writeFile(folder / "model.glb", large);
    REQUIRE_FALSE(failed);
    CHECK(failed.error().what.starts_with("cannot be written"));
  }
  CHECK(textOf(folder / "model.glb") == "old");
  CHECK(entriesOf(folder) == 1);
}

TEST_CASE("Folders are made only where that is asked for") {
  const TemporaryFolder folder;
  CHECK_FALSE(writeFile(folder / "mistyped/picture.png", Bytes{1}));
  CHECK(entriesOf(folder) == 0);
  CHECK(writeFile(folder / "textures/deep/picture.png", Bytes{1}, MissingFolder::isMade));
  CHECK(readFile(folder / "textures/deep/picture.png").value() == Bytes{1});
}

TEST_CASE("Writers of one file do not meet") {
  const TemporaryFolder folder;
  constexpr std::size_t size = 20000;
  std::array<std::thread, 4> writers;
  for (std::size_t i = 0; i < writers.size(); ++i) {
    writers[i] = std::thread([&folder, i] {
      for (int round = 0; round < 20; ++round) {
        const Bytes content(size, static_cast<std::uint8_t>('0' + i));
        check(writeFile(folder / "a.glb", content).ok(), "a writer is not in the way of another");
      }
    });
  }
  for (std::thread& writer : writers) {
    writer.join();
  }
  const std::string text = textOf(folder / "a.glb");
  CHECK(text == std::string(size, text.front()));
  CHECK(entriesOf(folder) == 1);
}

TEST_CASE("What killed programs left half written is removed, and nothing else") {
  const TemporaryFolder folder;
  const std::string part = partName;
  folder.write(part + "1-0.tmp", "left");
  folder.write(part + "video-1.tmp", "left");
  folder.write(part + "1-0.png", "the user's");
  folder.write(".stretch-engine-1-0.tmp", "content of before a save that was killed");
  folder.write("picture.tmp", "the user's");
  const Descriptor other(open(folder.write(part + "2-0.tmp", "under way").c_str(), O_RDONLY));
  REQUIRE(flock(other.number(), LOCK_EX) == 0);
  removeLeftParts(folder.path());
  CHECK_FALSE(fs::exists(folder / (part + "1-0.tmp")));
  CHECK_FALSE(fs::exists(folder / (part + "video-1.tmp")));
  CHECK(entriesOf(folder) == 4);
  removeLeftParts(folder / "missing");
}

TEST_CASE("Files that are under way are not taken for left ones") {
  const TemporaryFolder folder;
  std::atomic<bool> isDone = false;
  std::thread sweeper([&] {
    while (!isDone) {
      removeLeftParts(folder.path());
    }
  });
  const Bytes content(100, 'a');
  std::size_t written = 0;
  for (int round = 0; round < 1000; ++round) {
    written += writeFile(folder / "picture.png", content).ok() ? 1 : 0;
  }
  isDone = true;
  sweeper.join();
  CHECK(written == 1000);
  CHECK(entriesOf(folder) == 1);
}

TEST_CASE("A file of the user that is named like a part file stays") {
  const TemporaryFolder folder;
  for (const char* name : {"a.glb.partial", "a.glb.part", "a.glb.tmp"}) {
    folder.write(name, "mine");
  }
  REQUIRE(writeFile(folder / "a.glb", Bytes{1}));
  for (const char* name : {"a.glb.partial", "a.glb.part", "a.glb.tmp"}) {
    CHECK(textOf(folder / name) == "mine");
  }
}

TEST_CASE("A replaced file keeps its permissions") {
  const TemporaryFolder folder;
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(folder.write("a.glb", "old"), own);
  REQUIRE(writeFile(folder / "a.glb", Bytes{1}));
  CHECK(fs::status(folder / "a.glb").permissions() == own);
}

TEST_CASE("A file that is write-protected is not replaced") {
  const TemporaryFolder folder;
  fs::permissions(folder.write("a.glb", "old"), fs::perms::owner_read);
  const Status refused = writeFile(folder / "a.glb", Bytes{1});
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().line(), Catch::Contains("write-protected"));
  CHECK(textOf(folder / "a.glb") == "old");
  CHECK(entriesOf(folder) == 1);
}

TEST_CASE("A symbolic link stays and leads to the new content") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "real");
  folder.write("real/a.glb", "old");
  fs::create_symlink("real/a.glb", folder / "link.glb");
  fs::create_symlink("link.glb", folder / "chain.glb");
  REQUIRE(writeFile(folder / "chain.glb", Bytes{'n'}));
  CHECK(fs::is_symlink(folder / "chain.glb"));
  CHECK(fs::is_symlink(folder / "link.glb"));
  CHECK(textOf(folder / "real/a.glb") == "n");
  CHECK(entriesOf(folder) == 4);
}

TEST_CASE("A name as long as the system allows can be written") {
  const TemporaryFolder folder;
  std::string name(251, 'n');
  name += ".glb";
  CHECK(writeFile(folder / name, Bytes{1}));
  CHECK(entriesOf(folder) == 1);
}

TEST_CASE("What is no file is not replaced by one") {
  CHECK_FALSE(writeFile("/dev/null", Bytes{1}));
  CHECK(fs::is_character_file("/dev/null"));
}
