#include "app/file_work.h"

#include <catch2/catch.hpp>

#include "app/edits/pose/offset_edits.h"
#include "app/files/save.h"
#include "core/base/file.h"
#include "tests/support/app/file_desk.h"

using namespace stretch;
using namespace stretch::app;
using test::Desk;

namespace {

using Kind = FileQuestion::Kind;

/// Poses the left hand at the playhead without a key.
void poseWithoutKey(Session& session) {
  ViewState& view = session.view();
  view.unkeyed.clip = view.clip;
  view.unkeyed.frame = view.frame;
  view.unkeyed.offsets["left-hand"] = {"left-hand", Vec3(0.1, 0.0, 0.0), Vec3(0.0)};
}

/// A file that is open and posed without a key at frame 16.
Session& openPosed(Desk& desk, FileWork& work) {
  desk.openNow(work, "a.glb");
  Session& session = *desk.document.character();
  session.view().frame = 16.0;
  poseWithoutKey(session);
  return session;
}

} // namespace

TEST_CASE("A pose without a key is asked for before it is lost, and told when a file is saved without it") {
  Desk desk;
  FileWork work;
  Session& session = openPosed(desk, work);
  CHECK_FALSE(hasUnsavedWork(desk.document)); // no file would hold it
  CHECK(wouldLoseWork(desk.document));
  work.quit(desk);
  CHECK(work.question().kind == Kind::unsaved);
  work.answer(desk, FileAnswer::cancel);
  work.openFile(desk, {desk.file("b.glb")});
  CHECK(work.question().kind == Kind::unsaved);
  work.answer(desk, FileAnswer::cancel);
  desk.told.clear();
  work.saveAs(desk, desk.file("mine.glb"));
  REQUIRE(desk.told.size() == 2);
  CHECK(desk.told[1].first == Tone::warning);
  CHECK_THAT(desk.told[1].second, Catch::Contains("The pose at frame 16 has no key: it is not in the file"));
  desk.told.clear();
  work.exportClean(desk, desk.file("clean.glb"));
  CHECK(desk.lastTone() == Tone::warning);
  desk.news();
  SECTION("discarded, it is not asked for again") {
    work.openFile(desk, {desk.file("b.glb")});
    work.answer(desk, FileAnswer::discard);
    desk.waitWhileOpening(work);
    CHECK(work.path() == desk.file("b.glb"));
    CHECK_FALSE(wouldLoseWork(desk.document));
  }
  SECTION("posed while another file is read, it is asked for before that is shown") {
    session.view().unkeyed = {};
    work.openFile(desk, {desk.file("b.glb")});
    poseWithoutKey(session);
    desk.waitWhileOpening(work);
    REQUIRE(work.question().kind == Kind::unsaved);
    work.answer(desk, FileAnswer::discard);
    CHECK(work.path() == desk.file("b.glb"));
  }
  SECTION("at another frame it is gone, and nothing is asked") {
    session.view().frame = 17.0;
    CHECK_FALSE(wouldLoseWork(desk.document));
    work.quit(desk);
    CHECK(desk.news() == "quit ");
  }
  SECTION("in another clip, too") {
    session.view().clip = 1;
    CHECK_FALSE(wouldLoseWork(desk.document));
  }
}

TEST_CASE("A pose without a key is keyed where the question for unsaved work is answered by Save") {
  Desk desk;
  FileWork work;
  Session& session = openPosed(desk, work);
  work.saveAs(desk, desk.file("mine.glb"));
  desk.news();
  work.quit(desk);
  work.answer(desk, FileAnswer::save);
  CHECK(desk.news() == "saved:mine.glb quit ");
  CHECK(offsetAt(session.document(), 0, 16.0, "left-hand").move == Vec3(0.1, 0.0, 0.0));
  CHECK(session.history().undoLabel() == "Key the left hand");
  CHECK_FALSE(isPosedWithoutKey(session.view()));
  const Document saved = openDocument(desk.file("mine.glb").string()).value();
  CHECK(saved.adjustments == session.document().adjustments);
}

TEST_CASE(
    "What is only tried when a file is saved by the question takes no key of its own, nor that of a pose") {
  Desk desk;
  FileWork work;
  Session& session = openPosed(desk, work);
  work.saveAs(desk, desk.file("mine.glb"));
  session.begin("Try");
  session.preview(setLooping(session.document(), 0, true));
  work.quit(desk);
  work.answer(desk, FileAnswer::save);
  CHECK(offsetAt(session.document(), 0, 16.0, "left-hand").move == Vec3(0.1, 0.0, 0.0));
  CHECK(session.document().loopingClips.empty());
  const Document saved = openDocument(desk.file("mine.glb").string()).value();
  CHECK(saved.adjustments.size() == 1);
}
