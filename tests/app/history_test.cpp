#include <catch2/catch.hpp>

#include "app/edits/trail_edits.h"
#include "app/history.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document looping(const Document& document, bool loops) {
  return setLooping(document, 0, loops);
}

} // namespace

TEST_CASE("A new history has nothing to undo and is saved") {
  History<Document> history(test::boxer());
  CHECK_FALSE(history.canUndo());
  CHECK_FALSE(history.canRedo());
  CHECK_FALSE(history.undo());
  CHECK_FALSE(history.redo());
  CHECK(history.undoLabel().empty());
  CHECK(history.redoLabel().empty());
  CHECK(history.isSaved());
}

TEST_CASE("Undo and redo walk between documents and name what they take back or bring") {
  const Document start = test::boxer();
  History<Document> history(start);
  REQUIRE(history.push(looping(start, true), "Loop the clip"));
  CHECK(history.undoLabel() == "Loop the clip");
  REQUIRE(history.undo());
  CHECK(sameDocument(history.current(), start));
  CHECK(history.redoLabel() == "Loop the clip");
  REQUIRE(history.redo());
  CHECK(history.current().loopingClips == std::vector<int>{0});
}

TEST_CASE("A state equal to the current one is no step") {
  const Document start = test::boxer();
  History<Document> history(start);
  CHECK_FALSE(history.push(looping(start, false), "Nothing"));
  CHECK_FALSE(history.canUndo());
}

TEST_CASE("A new edit drops what was undone") {
  const Document start = test::boxer();
  History<Document> history(start);
  history.push(looping(start, true), "First");
  history.undo();
  Document other = start;
  other.limbsCorrected = true;
  history.push(other, "Second");
  CHECK_FALSE(history.canRedo());
  CHECK(history.undoLabel() == "Second");
}

TEST_CASE("A document is saved where it was marked, and nowhere once that state is dropped") {
  const Document start = test::boxer();
  History<Document> history(start);
  history.push(looping(start, true), "First");
  CHECK_FALSE(history.isSaved());
  history.markSaved();
  CHECK(history.isSaved());
  history.undo();
  CHECK_FALSE(history.isSaved());
  Document other = start;
  other.limbsCorrected = true;
  history.push(other, "Second");
  CHECK_FALSE(history.isSaved());
  history.undo();
  CHECK_FALSE(history.isSaved());
}
