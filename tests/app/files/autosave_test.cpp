// Of work that was kept aside: which is offered, and where the artist was.
#include "app/files/autosave.h"

#include <chrono>
#include <cstdlib>
#include <optional>

#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "tests/support/app/boxer.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
namespace fs = std::filesystem;

namespace {

/// A folder with two files, and the state folder beside them.
struct KeptAside {
  KeptAside() { setenv("XDG_STATE_HOME", (folder.path() / "state").c_str(), 1); }
  /// Keeps work on a file aside under a name of its own, as other processes do.
  [[nodiscard]] fs::path keep(const char* name, const fs::path& source, int minutesAgo,
                              const WorkPlace& place = {}) const {
    fs::path file = autosavePath(source).parent_path() / name;
    REQUIRE(writeText(file, autosaveText(test::boxer(), place, source)));
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::minutes(minutesAgo));
    return file;
  }

  test::TemporaryFolder folder;
  fs::path punch = folder.write("punch.glb", "a punch");
  fs::path walk = folder.write("walk.glb", "a walk");
};

} // namespace

TEST_CASE(
    "Of work that was kept aside several times the newest is offered, that of the file which is asked for") {
  const KeptAside kept;
  const fs::path older = kept.keep("a.json", kept.punch, 30);
  const fs::path newest = kept.keep("b.json", kept.punch, 20);
  const fs::path oldest = kept.keep("c.json", kept.punch, 40);
  const fs::path ofWalk = kept.keep("d.json", kept.walk, 10);
  const fs::path ofGone = kept.keep("e.json", kept.folder / "gone.glb", 5);
  const fs::path noAutosave = kept.keep("f.txt", kept.punch, 1);
  const std::optional<Autosave> ofPunch = findAutosave(kept.punch);
  REQUIRE(ofPunch);
  CHECK(ofPunch->file == newest);
  CHECK(ofPunch->source == kept.punch);
  // Of any file that is still there.
  const std::optional<Autosave> ofAny = findAutosave({});
  REQUIRE(ofAny);
  CHECK(ofAny->file == ofWalk);
  CHECK(ofAny->source == kept.walk);
  for (const fs::path& left : {older, oldest, ofGone, noAutosave}) {
    CHECK(fs::exists(left));
  }
  removeAutosave(newest);
  REQUIRE(findAutosave(kept.punch));
  CHECK(findAutosave(kept.punch)->file == older);
}

TEST_CASE("Work that was kept aside says which clip, frame, limbs and trail the artist was at") {
  const KeptAside kept;
  const WorkPlace place{1, 12.5, {"neck", "left-arm"}, 3};
  CHECK(placeOfAutosave(kept.keep("a.json", kept.punch, 0, place)) == place);
  const fs::path broken = kept.keep("b.json", kept.punch, 0);
  REQUIRE(writeText(broken, "{"));
  CHECK_FALSE(placeOfAutosave(broken));
}
