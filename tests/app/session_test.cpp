#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/keys/clips.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/ranges.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/files/user_files.h"
#include "app/session.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/run_command.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

namespace fs = std::filesystem;

Document withTrail(const Document& document, double scale) {
  NewTrail trail;
  trail.limb = "left-arm";
  trail.settings.endFrame = 10.0;
  trail.settings.scale = scale;
  trail.exaggerated = true;
  trail.connected = true;
  const Result<CreatedTrail> created = createTrail(document, trail);
  REQUIRE(created);
  return created->document;
}

Document scaled(const Document& document, double scale) {
  rig::TrailSettings settings = document.trails.front().settings;
  settings.scale = scale;
  const Result<Document> changed = setTrailSettings(document, document.trails.front().id, settings);
  REQUIRE(changed);
  return *changed;
}

/// Another home folder while it lives, without settings of a desktop elsewhere.
class HomeFolder {
public:
  explicit HomeFolder(const fs::path& folder) {
    for (const char* const name : {"HOME", "XDG_CONFIG_HOME"}) {
      const char* const before = std::getenv(name);
      before_.emplace_back(name, before == nullptr ? std::nullopt : std::optional<std::string>(before));
    }
    setenv("HOME", folder.c_str(), 1);
    unsetenv("XDG_CONFIG_HOME");
  }
  ~HomeFolder() {
    for (const auto& [name, before] : before_) {
      static_cast<void>(before ? setenv(name, before->c_str(), 1) : unsetenv(name));
    }
  }
  HomeFolder(const HomeFolder&) = delete;
  HomeFolder& operator=(const HomeFolder&) = delete;

private:
  std::vector<std::pair<const char*, std::optional<std::string>>> before_;
};

/// First name that is proposed for a clip opened from this file.
fs::path proposedFor(const fs::path& file) {
  const Result<Document> opened = openDocument(file);
  REQUIRE(opened);
  return Session(*opened).proposedSavePath();
}

} // namespace

TEST_CASE("A drag previews from the state at its beginning and is one undo step") {
  Session session(withTrail(test::boxer(), 1.0));
  session.begin("Scale");
  for (const double scale : {1.5, 2.0, 2.5}) {
    session.preview(scaled(session.atBegin(), scale));
    CHECK(session.document().trails.front().settings.scale == scale);
    CHECK(session.atBegin().trails.front().settings.scale == 1.0);
  }
  session.commit();
  CHECK(session.document().trails.front().settings.scale == 2.5);
  CHECK(session.history().undoLabel() == "Scale");
  REQUIRE(session.undo());
  CHECK(session.document().trails.front().settings.scale == 1.0);
  CHECK_FALSE(session.history().canUndo());
}

TEST_CASE("A drag that comes back, or is cancelled, leaves no step") {
  Session session(withTrail(test::boxer(), 1.0));
  session.begin("Scale");
  session.preview(scaled(session.atBegin(), 3.0));
  SECTION("back") {
    session.preview(scaled(session.atBegin(), 1.0));
    session.commit();
  }
  SECTION("cancelled") {
    session.cancel();
  }
  SECTION("undone in the middle") {
    CHECK_FALSE(session.undo());
  }
  CHECK_FALSE(session.isDragging());
  CHECK_FALSE(session.history().canUndo());
  CHECK(session.document().trails.front().settings.scale == 1.0);
}

TEST_CASE("No edit slips in while a drag is on") {
  Session session(withTrail(test::boxer(), 1.0));
  session.begin("Scale");
  CHECK_FALSE(session.edit(scaled(session.atBegin(), 2.0), "Other"));
  session.cancel();
  CHECK(session.edit(scaled(session.document(), 2.0), "Other"));
}

TEST_CASE("What undo takes away is no longer selected") {
  Session session(test::boxer());
  session.edit(withTrail(session.document(), 2.0), "Trail");
  session.view().selection.editTrails().trail = session.document().trails.front().id;
  session.view().selection.editTrails().spheres = {5.0};
  session.undo();
  CHECK(session.view().selection.trail() == 0);
  CHECK(session.view().selection.spheres().empty());
}

TEST_CASE("What the session remembers of a frame is what evaluating gives, whatever was edited in between") {
  Session session(test::boxer());
  const auto check = [&] {
    const Document& document = session.document();
    const double seconds = 10.0 / clipOf(document, 0).framesPerSecond;
    const FrameState fresh = evaluate(document, prepareMotion(document, 0), seconds);
    CHECK(session.frameAt(10.0).worlds == fresh.worlds);
    CHECK(session.originalAt(10.0).worlds == evaluateOriginal(document, 0, seconds).worlds);
  };
  check();
  session.edit(withTrail(session.document(), 2.0), "Trail");
  check();
  session.begin("Scale");
  session.preview(scaled(session.atBegin(), 0.5));
  check();
  session.cancel();
  check();
  session.undo();
  check();
}

TEST_CASE("The first save proposes another name, a clean export does not count as saving") {
  const Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  const test::TemporaryFolder folder;
  Session session(*opened);
  CHECK(session.proposedSavePath().filename() == "dummy-stretched.glb");
  session.edit(withTrail(session.document(), 2.0), "Trail");
  REQUIRE(session.save(folder / "clean.glb", true));
  CHECK_FALSE(session.history().isSaved());
  CHECK(session.savePath().empty());
  REQUIRE(session.save(folder / "work.glb", false));
  CHECK(session.history().isSaved());
  CHECK(session.proposedSavePath() == folder / "work.glb");
}

TEST_CASE("A first save is proposed beside the source, that of a bundled clip in the user's documents") {
  const test::TemporaryFolder home;
  const HomeFolder living(home.path());
  fs::create_directories(home / "Documents");
  const fs::path bundled = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  CHECK(proposedFor(bundled) == home / "Documents/dummy-stretched.glb");
  fs::copy_file(bundled, home / "own.glb");
  CHECK(proposedFor(home / "own.glb") == home / "own-stretched.glb");
}

TEST_CASE("The documents are the folder that the desktop names") {
  const test::TemporaryFolder home;
  const HomeFolder living(home.path());
  CHECK(documentsFolder() == home.path());
  fs::create_directories(home / "Dokumente");
  fs::create_directories(home / ".config");
  home.write(".config/user-dirs.dirs", "# Folders\nXDG_DOCUMENTS_DIR=\"$HOME/Dokumente\"\n");
  CHECK(documentsFolder() == home / "Dokumente");
  CHECK_FALSE(isWritableFolder(home / "gone"));
  // By its whole path as well, but not by one that is none, or is not there.
  const auto named = [&](const std::string& folder) {
    home.write(".config/user-dirs.dirs", "XDG_DOCUMENTS_DIR=" + folder + "\n");
    return documentsFolder();
  };
  CHECK(named("\"" + (home / "Dokumente").string() + "\"") == home / "Dokumente");
  for (const char* const none : {"\"Dokumente\"", "\"$HOME/gone\"", "\"$HOME/Dokumente"}) {
    CHECK(named(none) == home.path());
  }
}

TEST_CASE("A file that carries our work is saved back to itself") {
  const Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  const test::TemporaryFolder folder;
  Session first(withTrail(*opened, 2.0));
  REQUIRE(first.save(folder / "work.glb", false));
  const Result<Document> ours = openDocument(folder / "work.glb");
  REQUIRE(ours);
  CHECK(Session(*ours).savePath() == folder / "work.glb");
  CHECK(Session(*opened).savePath().empty());
}

TEST_CASE("A trail that the character does not follow is counted as left out of the motion") {
  const Document connected = withTrail(test::boxer(), 2.0);
  CHECK(disconnectedTrails(test::boxer()) == 0);
  CHECK(disconnectedTrails(connected) == 0);
  CHECK(disconnectedTrails(*setConnected(connected, connected.trails.front().id, false)) == 1);
}

TEST_CASE("An applied trail is opened again by a change, and by disconnecting it") {
  const Document connected = withTrail(test::boxer(), 2.0);
  const int id = connected.trails.front().id;
  const Document applied = *applyTrail(connected, id);
  CHECK(findTrail(applied, id)->applied);
  CHECK(findTrail(*setTrailSettings(applied, id, findTrail(applied, id)->settings), id)->applied);
  CHECK_FALSE(findTrail(scaled(applied, 3.0), id)->applied);
  CHECK_FALSE(findTrail(*setConnected(applied, id, false), id)->applied);
}

TEST_CASE("Undoing an import brings back the clip that was viewed before, one import after the other") {
  Document start = test::boxer();
  const auto withClips = [&](std::size_t count) {
    Document document = start;
    document.clips = std::make_shared<const std::vector<Clip>>(count, start.clips->front());
    return document;
  };
  start = withClips(2);
  Session session(start);
  session.view().frame = 6.0;
  const auto import = [&](std::size_t count) {
    REQUIRE(session.edit(withClips(count), "Import a clip"));
    showClip(session, static_cast<int>(count) - 1);
  };
  import(3);
  session.view().frame = 9.0;
  import(5);
  REQUIRE(session.view().clip == 4);
  CHECK(test::run(session, command::undo).empty());
  CHECK(session.view().clip == 2);
  CHECK(session.view().frame == 9.0);
  CHECK(test::run(session, command::undo).empty());
  CHECK(session.view().clip == 0);
  CHECK(session.view().frame == 6.0);
}

TEST_CASE("A range that was set in an imported clip goes with the clip when that is undone") {
  Document start = test::boxer();
  Session session(start);
  Document more = start;
  more.clips = std::make_shared<const std::vector<Clip>>(2, start.clips->front());
  REQUIRE(session.edit(more, "Import a clip"));
  showClip(session, 1);
  session.view().rangeStart = 12.0;
  session.view().rangeEnd = 18.0;
  CHECK(test::run(session, command::undo).empty());
  CHECK(session.view().clip == 0);
  CHECK_FALSE(isRangeSet(session.view()));
}
