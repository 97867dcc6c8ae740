#include "app/file_work.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <future>
#include <memory>
#include <thread>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "app/edits/pose/offset_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/files/save.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/file_desk.h"
#include "tests/support/app/run_verb.h"

using namespace stretch;
using namespace stretch::app;
using test::Desk;
namespace fs = std::filesystem;

namespace {

using Kind = FileQuestion::Kind;

/// An autosave as if another process had kept it whose number a living one has now.
gltf::Json ofGoneProcess(const fs::path& autosave) {
  gltf::Json kept = gltf::Json::parse(*readText(autosave));
  kept["process"] = static_cast<long>(getppid());
  kept["began"] = 1U;
  return kept;
}

/// The end of the program, asked for with a change that is not saved.
void quitUnsaved(Desk& desk, FileWork& work) {
  desk.openNow(work, "a.glb");
  desk.edit();
  desk.news();
  work.quit(desk);
  REQUIRE(work.question().kind == Kind::unsaved);
}

} // namespace

TEST_CASE("A file is opened beside the caller, one that cannot be read leaves what is open", "[jobs]") {
  Desk desk;
  FileWork work;
  work.openFile(desk, {desk.file("a.glb")});
  CHECK(work.isOpening());
  CHECK(work.openingName() == "a.glb");
  work.openFile(desk, {desk.file("b.glb")});
  CHECK(desk.told.size() == 1); // One at a time.
  desk.waitWhileOpening(work);
  CHECK(desk.news() == "opened ");
  CHECK(work.path() == desk.file("a.glb"));
  std::ofstream(desk.file("broken.glb")) << "no model";
  desk.openNow(work, "broken.glb");
  CHECK(desk.lastTone() == Tone::error);
  CHECK(desk.news().empty());
  CHECK(work.path() == desk.file("a.glb"));
  CHECK(work.question().kind == Kind::none);
}

TEST_CASE("Unsaved work is asked for before another file is opened") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  desk.edit();
  desk.news();
  work.openFile(desk, {desk.file("b.glb")});
  REQUIRE(work.question().kind == Kind::unsaved);
  CHECK_FALSE(work.isOpening());
  work.answer(desk, FileAnswer::overwrite); // Not offered.
  REQUIRE(work.question().kind == Kind::unsaved);

  SECTION("cancel leaves everything as it is") {
    work.answer(desk, FileAnswer::cancel);
    CHECK(work.question().kind == Kind::none);
    CHECK_FALSE(work.isOpening());
    CHECK(desk.isEdited());
  }
  SECTION("discard opens it, without asking again") {
    work.answer(desk, FileAnswer::discard);
    desk.waitWhileOpening(work);
    CHECK(desk.news() == "closing opened ");
    CHECK(work.path() == desk.file("b.glb"));
  }
  SECTION("save asks for a name, and goes on once it is saved") {
    work.answer(desk, FileAnswer::save);
    REQUIRE(work.question().kind == Kind::name);
    work.saveAs(desk, desk.file("mine.glb"));
    desk.waitWhileOpening(work);
    CHECK(desk.news() == "saved:mine.glb closing opened ");
    CHECK(work.path() == desk.file("b.glb"));
  }
  SECTION("a save that fails goes no further") {
    work.answer(desk, FileAnswer::save);
    work.saveAs(desk, desk.file("no-folder") / "mine.glb");
    CHECK(desk.lastTone() == Tone::error);
    CHECK(work.question().kind == Kind::none);
    CHECK_FALSE(work.isOpening());
  }
}

TEST_CASE("While a question is open no other file is opened, and the answer goes on with what was asked") {
  Desk desk;
  FileWork work;
  quitUnsaved(desk, work);
  work.openFile(desk, {desk.file("b.glb")});
  CHECK(desk.told.back() == std::pair(Tone::info, std::string("Answer the question first")));
  CHECK(work.question().kind == Kind::unsaved);
  work.answer(desk, FileAnswer::discard);
  CHECK(desk.news() == "quit ");
  CHECK_FALSE(work.isOpening());
}

TEST_CASE("A name that is not given forgets what waited for it") {
  Desk desk;
  FileWork work;
  quitUnsaved(desk, work);
  work.answer(desk, FileAnswer::save);
  REQUIRE(work.question().kind == Kind::name);
  work.answer(desk, FileAnswer::cancel);
  work.saveAs(desk, desk.file("mine.glb"));
  CHECK(desk.news() == "saved:mine.glb "); // and no quit
  work.quit(desk);
  CHECK(desk.news() == "quit ");
}

TEST_CASE("What another program changed is overwritten only when the user says so") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  desk.edit();
  work.save(desk);
  work.saveAs(desk, desk.file("mine.glb"));
  desk.edit();
  work.returned(desk);
  const std::size_t toldBefore = desk.told.size();
  std::ofstream(desk.file("mine.glb"), std::ios::app) << "more";
  work.returned(desk);
  work.returned(desk);
  CHECK(desk.told.size() == toldBefore + 1);
  desk.news();
  work.save(desk);
  REQUIRE(work.question().kind == Kind::overwrite);
  CHECK(work.question().about == desk.file("mine.glb"));
  CHECK(desk.news().empty());

  SECTION("overwrite") {
    work.answer(desk, FileAnswer::overwrite);
    CHECK(desk.news() == "saved:mine.glb ");
    desk.edit();
    work.save(desk);
    CHECK(desk.news() == "saved:mine.glb "); // Its stamp is known again.
  }
  SECTION("cancel") {
    work.answer(desk, FileAnswer::cancel);
    CHECK(work.question().kind == Kind::none);
    CHECK(hasUnsavedWork(desk.document));
  }
  SECTION("another name") {
    work.answer(desk, FileAnswer::otherName);
    REQUIRE(work.question().kind == Kind::name);
    work.saveAs(desk, desk.file("other.glb"));
    CHECK(desk.news() == "saved:other.glb ");
  }
}

TEST_CASE("Of two windows on one file the second to save is told that the first one did") {
  Desk first;
  Desk second(first.folder);
  FileWork firstWork;
  FileWork secondWork;
  first.openNow(firstWork, "a.glb");
  first.edit();
  firstWork.saveAs(first, first.file("shared.glb"));
  second.openNow(secondWork, "shared.glb");
  second.edit();
  first.document.character()->view().frame = 3.0;
  first.edit();
  first.edit();
  firstWork.save(first);
  CHECK(first.news() == "opened saved:shared.glb saved:shared.glb ");
  secondWork.returned(second);
  CHECK(second.lastTone() == Tone::warning);
  secondWork.save(second);
  CHECK(secondWork.question().kind == Kind::overwrite);
  CHECK(second.news() == "opened ");
}

TEST_CASE("A file that another program changes while it is read is not overwritten unasked", "[jobs]") {
  Desk desk;
  FileWork work([&](const FileWork::Paths& paths, const skinning::Progress& progress) {
    Result<Opened> read = openAny(paths, progress);
    std::ofstream(paths.front(), std::ios::app) << "more";
    return read;
  });
  desk.openNow(work, "a.glb");
  desk.edit();
  work.saveAs(desk, desk.file("mine.glb"));
  desk.openNow(work, "mine.glb");
  desk.news();
  desk.edit();
  REQUIRE_FALSE(desk.document.character()->savePath().empty());
  work.save(desk);
  CHECK(work.question().kind == Kind::overwrite);
  CHECK(desk.news().empty());
}

TEST_CASE("Work of a process that is gone is offered, even where another one has its number now") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  desk.edit();
  work.update(desk, 10.0);
  const fs::path file = autosavePath(desk.file("a.glb"));
  gltf::Json kept = ofGoneProcess(file);
  REQUIRE(writeText(file, kept.dump()));
  CHECK(findAutosave(desk.file("a.glb")));
  kept.erase("began"); // Of a version that did not say: it may be alive.
  REQUIRE(writeText(file, kept.dump()));
  CHECK_FALSE(findAutosave(desk.file("a.glb")));
}

TEST_CASE("Work that comes while another file is read is asked for as well", "[jobs]") {
  Desk desk;
  std::promise<void> mayRead;
  std::shared_future<void> gate = mayRead.get_future().share();
  bool blocks = false;
  FileWork work([&](const FileWork::Paths& paths, const skinning::Progress& progress) {
    if (blocks) {
      gate.wait();
    }
    return openAny(paths, progress);
  });
  desk.openNow(work, "a.glb");
  blocks = true;
  work.openFile(desk, {desk.file("b.glb")});
  CHECK(work.question().kind == Kind::none);
  desk.edit();
  mayRead.set_value();
  desk.waitWhileOpening(work);
  REQUIRE(work.question().kind == Kind::unsaved);
  desk.news();
  SECTION("cancel keeps what is open") {
    work.answer(desk, FileAnswer::cancel);
    CHECK_FALSE(work.isOpening());
    CHECK(desk.isEdited());
    CHECK(desk.news().empty());
  }
  SECTION("discard shows what was read") {
    work.answer(desk, FileAnswer::discard);
    CHECK(desk.news() == "closing opened ");
    CHECK_FALSE(desk.isEdited());
  }
}

TEST_CASE("Unsaved work is kept aside, offered after a crash, and forgotten once it is saved", "[jobs]") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  desk.edit();
  desk.clock = 10.0;
  work.update(desk, desk.clock);
  CHECK(work.isKeptAside(*desk.document.character()));
  desk.document.character()->view().frame = 7.0;
  CHECK_FALSE(work.isKeptAside(*desk.document.character()));
  desk.clock += 60.0;
  work.update(desk, desk.clock);
  CHECK(placeOfAutosave(autosavePath(desk.file("a.glb"))).value_or(WorkPlace{}).frame == 7.0);
  desk.edit();
  work.update(desk, desk.clock + 1.0); // Not yet again.
  CHECK_FALSE(work.isKeptAside(*desk.document.character()));
  desk.edit();

  SECTION("saved") {
    work.saveAs(desk, desk.file("mine.glb"));
    CHECK_FALSE(findAutosave(desk.file("a.glb")));
  }
  SECTION("undone") {
    while (desk.document.character()->undo()) {
    }
    work.update(desk, desk.clock + 1.0);
    CHECK_FALSE(findAutosave(desk.file("a.glb")));
  }
  SECTION("a crash: the next start offers it with the file") {
    FileWork next;
    desk.document = OpenDocument();
    desk.openNow(next, "a.glb");
    REQUIRE(next.question().kind == Kind::restore);
    CHECK(next.question().about == desk.file("a.glb"));
    CHECK_FALSE(desk.isEdited());
    next.answer(desk, FileAnswer::restore);
    CHECK(desk.isEdited());
    CHECK(hasUnsavedWork(desk.document));
    CHECK_FALSE(findAutosave(desk.file("a.glb")));
  }
  SECTION("a crash: a start without a file offers the newest, and opens its file") {
    FileWork next;
    desk.document = OpenDocument();
    next.offerAutosave({});
    REQUIRE(next.question().kind == Kind::restore);
    next.answer(desk, FileAnswer::restore);
    desk.waitWhileOpening(next);
    CHECK(desk.isEdited());
    CHECK(next.question().kind == Kind::none);
  }
  SECTION("a crash: what is not wanted is gone") {
    FileWork next;
    next.offerAutosave({});
    next.answer(desk, FileAnswer::discard);
    CHECK(next.question().kind == Kind::none);
    CHECK_FALSE(findAutosave(desk.file("a.glb")));
  }
}

TEST_CASE(
    "Work that cannot be kept aside any more is told once, does not count as kept, and is tried again") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  const bool keptBefore = GENERATE(true, false);
  const fs::path folder = autosavePath(desk.file("a.glb")).parent_path();
  if (keptBefore) {
    desk.edit();
    work.update(desk, desk.clock += 10.0);
    REQUIRE(work.isKeptAside(*desk.document.character()));
    fs::rename(folder, folder.parent_path() / "away");
  }
  fs::create_directories(folder.parent_path());
  REQUIRE(writeText(folder, "in the way"));
  desk.told.clear();
  desk.edit();
  desk.document.character()->view().frame = 5.0;
  work.update(desk, desk.clock += 10.0);
  REQUIRE(desk.told.size() == 1);
  CHECK(desk.lastTone() == Tone::warning);
  CHECK_THAT(desk.told.back().second, Catch::StartsWith("Unsaved work is not kept aside: "));
  CHECK_FALSE(work.isKeptAside(*desk.document.character()));
  work.update(desk, desk.clock += 10.0);
  CHECK(desk.told.size() == 1);

  fs::remove(folder); // There is room again: nothing was edited since.
  work.update(desk, desk.clock += 10.0);
  CHECK(desk.told.size() == 1);
  CHECK(work.isKeptAside(*desk.document.character()));
  CHECK(placeOfAutosave(autosavePath(desk.file("a.glb"))).value_or(WorkPlace{}).frame == 5.0);
}

TEST_CASE("After a save under another name unsaved work is kept for the file that was saved") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  desk.edit();
  work.saveAs(desk, desk.file("saved.glb"));
  CHECK(work.path() == desk.file("saved.glb"));
  desk.edit();
  desk.document.character()->view().frame = 7.0;
  desk.document.character()->view().selection.editTrails().limbs = {"left-arm"};
  work.update(desk, desk.clock + 100.0);
  CHECK_FALSE(findAutosave(desk.file("a.glb")));
  FileWork next;
  desk.document = OpenDocument();
  desk.openNow(next, "saved.glb");
  REQUIRE(next.question().kind == Kind::restore);
  next.answer(desk, FileAnswer::restore);
  CHECK(desk.document.character()->view().frame == 7.0);
  CHECK(desk.document.character()->view().selection.limbs() == std::vector<std::string>{"left-arm"});
}

TEST_CASE("Images that a file needs are told where it is saved elsewhere, not at every save") {
  Desk desk;
  FileWork work;
  fs::create_directories(desk.file("in"));
  fs::create_directories(desk.file("out"));
  const std::string boxer = desk.file("in/boxer.gltf").string();
  REQUIRE(test::runVerb({"resave", desk.file("a.glb").string(), "-o", boxer}).exitCode == 0);
  gltf::Json json = gltf::Json::parse(readText(boxer).value());
  json["images"].push_back(gltf::Json{{"uri", "red.png"}});
  std::ofstream(boxer) << json.dump();
  std::ofstream(desk.file("in/red.png")) << "a picture";
  desk.openNow(work, "in/boxer.gltf");
  const auto isTold = [&](const std::string& name) {
    const std::pair line(Tone::warning, name + " needs red.png, written beside it; move them together");
    const bool isAmong = std::ranges::find(desk.told, line) != desk.told.end();
    desk.told.clear();
    return isAmong;
  };
  work.saveAs(desk, desk.file("in/copy.glb"));
  CHECK_FALSE(isTold("copy.glb"));
  work.saveAs(desk, desk.file("out/moved.glb"));
  CHECK(isTold("moved.glb"));
  CHECK(fs::exists(desk.file("out/red.png")));
  work.save(desk);
  CHECK_FALSE(isTold("moved.glb"));
  work.exportClean(desk, desk.file("out/clean.glb"));
  CHECK(isTold("clean.glb"));
}

TEST_CASE("Save incremental takes the next free number") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "punch.glb";
  CHECK(nextIncrement(file).filename() == "punch-001.glb");
  std::ofstream(folder.path() / "punch-001.glb") << "x";
  CHECK(nextIncrement(file).filename() == "punch-002.glb");
  CHECK(nextIncrement(folder.path() / "punch-001.glb").filename() == "punch-002.glb");
  CHECK(nextIncrement(folder.path() / "one-two.glb").filename() == "one-two-001.glb");
  CHECK(nextIncrement(folder.path() / "punch-008.glb").filename() == "punch-009.glb"); // not one of before
  CHECK(nextIncrement(folder.path() / "jump-360.glb").filename() == "jump-361.glb");
  CHECK(nextIncrement(folder.path() / "take-20261130.glb").filename() == "take-20261130-001.glb");
}

TEST_CASE("Unsaved work that cannot be taken up stays where it is, and what is left out of it is told") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  desk.edit();
  work.update(desk, 10.0);
  const fs::path file = autosavePath(desk.file("a.glb"));
  gltf::Json kept = ofGoneProcess(file);
  const bool isRefused = GENERATE(true, false);
  const int lost = GENERATE(1, 3);
  if (isRefused) {
    kept["work"]["version"] = 1000;
  }
  kept["work"]["adjustments"] = gltf::Json::array();
  for (int i = 0; i < lost; ++i) {
    kept["work"]["adjustments"].push_back({{"controller", "no such controller " + std::to_string(i)},
                                           {"clip", 0},
                                           {"keys", {{{"frame", 3}, {"move", {0, 1, 0}}}}}});
  }
  REQUIRE(writeText(file, kept.dump()));
  FileWork next;
  desk.document = OpenDocument();
  desk.openNow(next, "a.glb");
  REQUIRE(next.question().kind == Kind::restore);
  desk.told.clear();
  next.answer(desk, FileAnswer::restore);
  CHECK(fs::exists(file) == isRefused);
  CHECK(desk.isEdited() != isRefused);
  if (isRefused) {
    REQUIRE(desk.told.size() == 1);
    CHECK(desk.lastTone() == Tone::error);
    CHECK_THAT(desk.told.back().second, Catch::Contains(file.string()));
  } else {
    REQUIRE(desk.told.size() == 2);
    CHECK(desk.told[0].second == "What fits of the unsaved work is back");
    CHECK(desk.lastTone() == Tone::warning);
    CHECK_THAT(desk.told[1].second, Catch::Contains("no such controller 0"));
    CHECK(desk.told[1].second.ends_with(" (and 2 more)") == (lost == 3));
    CHECK(desk.told[1].second.ends_with("more)") == (lost == 3));
  }
}

TEST_CASE("A source that a rig or a binding has changed is kept aside once, comes back, and goes with the "
          "autosave") {
  Desk desk;
  FileWork work;
  desk.openNow(work, "a.glb");
  desk.edit();
  work.update(desk, desk.clock += 10.0);
  const fs::path file = autosavePath(desk.file("a.glb"));
  const fs::path source = fs::path(file).replace_extension("source") / "source.glb";
  CHECK_FALSE(fs::exists(source)); // The file has it.

  const auto bind = [&] {
    Session& session = *desk.document.character();
    Document changed = session.document();
    changed.source = std::make_shared<const gltf::Source>(*changed.source);
    REQUIRE(session.edit(changed, "Bind"));
  };
  bind();
  work.update(desk, desk.clock += 10.0);
  REQUIRE(fs::exists(source));
  fs::remove(source);
  desk.edit();
  work.update(desk, desk.clock += 10.0);
  CHECK_FALSE(fs::exists(source)); // It was written already.
  bind();
  work.update(desk, desk.clock += 10.0);
  REQUIRE(fs::exists(source));

  SECTION("saved") {
    work.saveAs(desk, desk.file("mine.glb"));
    CHECK_FALSE(fs::exists(source.parent_path()));
    desk.edit();
    work.update(desk, desk.clock += 10.0);
    const fs::path beside = autosavePath(desk.file("mine.glb")).replace_extension("source");
    CHECK_FALSE(fs::exists(beside)); // The file that was saved has it.
  }
  SECTION("a crash") {
    FileWork next;
    desk.document = OpenDocument();
    desk.openNow(next, "a.glb");
    const std::shared_ptr<const gltf::Source> opened = desk.document.character()->document().source;
    REQUIRE(next.question().kind == Kind::restore);
    next.answer(desk, FileAnswer::restore);
    CHECK(desk.document.character()->document().source != opened);
    CHECK(desk.document.character()->document().source->path == desk.file("a.glb"));
    CHECK_FALSE(fs::exists(source));
    next.update(desk, desk.clock += 10.0);
    CHECK(fs::exists(source)); // It is no part of the file yet.
  }
}
