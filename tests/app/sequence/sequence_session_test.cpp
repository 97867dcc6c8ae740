#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

#include "app/commands/table/document_commands.h"
#include "app/file_work.h"
#include "app/files/save.h"
#include "app/open_document.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/file_desk.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;

namespace {

/// A tetrahedron whose third vertex rises by a morph target, as a glTF of its own.
constexpr const char* morphingTetrahedron = R"({"asset": {"version": "2.0"}, "scene": 0,
"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 4, "targets": [{"POSITION": 1}]}]}],
"animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
  "samplers": [{"input": 2, "output": 3}]}],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
  {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3",
   "min": [0, 0, 0], "max": [0, 1, 0]},
  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
  {"bufferView": 1, "byteOffset": 8, "componentType": 5126, "count": 2, "type": "SCALAR"},
  {"bufferView": 2, "componentType": 5123, "count": 12, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 16},
  {"buffer": 0, "byteOffset": 112, "byteLength": 24}],
"buffers": [{"byteLength": 136, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAAgABAAAAAQADAAAAAwACAAEAAgADAA=="}]})";

/// A bending tube of 12 frames, opened from its folder.
class OpenedTube {
public:
  OpenedTube() {
    test::writeObjFrames(test::shorteningTube(12, 2.0, 0.06, 0.1), folder_.path() / "frames", "tube");
    auto opened = app::openSequence({folder_.path() / "frames"});
    REQUIRE(opened);
    document.emplace(std::move(opened).value());
    document->settings.bones = 8;
    session.emplace(*document);
  }

  /// One edit of the open document.
  template <typename Change>
  void edit(const Change& change, const char* label = "Change") {
    app::SequenceDocument changed = session->document();
    change(changed);
    session->edit(std::move(changed), label);
  }

  std::optional<app::SequenceDocument> document; ///< As it was opened.
  std::optional<app::SequenceSession> session;

private:
  test::TemporaryFolder folder_;
};

/// Asks again and again, as a window does once per frame, until `take` answers something or `goesOn` does
/// not. An hour is enough for a build that looks for races, on a machine that has other work.
template <typename Take, typename GoesOn>
auto waitFor(const Take& take, const GoesOn& goesOn) -> decltype(take()) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::hours(1);
  while (goesOn() && std::chrono::steady_clock::now() < end) {
    if (auto taken = take()) {
      return taken;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::nullopt;
}

bool isShare(double share) {
  return share >= 0.0 && share <= 1.0;
}

Status waitForCompression(app::SequenceSession& session) {
  const auto done = waitFor([&] { return session.takeCompression(); },
                            [&] {
                              REQUIRE(isShare(session.compressedShare()));
                              return session.isCompressing();
                            });
  return done.value_or(Success{});
}

std::optional<Result<app::WrittenClip>> waitForExport(app::SequenceSession& session) {
  return waitFor([&] { return session.takeExport(); },
                 [&] {
                   REQUIRE(isShare(session.exportedShare()));
                   return session.isExporting();
                 });
}

/// The result as it would be written, encoded beside the caller.
std::shared_ptr<const app::ExportedClip> waitForClip(app::SequenceSession& session) {
  session.keepClip();
  const auto known = [&]() -> std::optional<bool> {
    session.keepClip();
    return session.clip() != nullptr ? std::optional(true) : std::nullopt;
  };
  (void)waitFor(known, [&] {
    REQUIRE(isShare(session.encodedShare()));
    return true;
  });
  return session.clip();
}

} // namespace

TEST_CASE("a folder, a morphing glTF and a character are told apart") {
  const test::TemporaryFolder folder;
  test::writeObjFrames(test::shorteningTube(3, 1.0, 0.0, 0.0), folder.path() / "frames", "tube");
  CHECK(app::holdsSequence(folder.path() / "frames"));
  CHECK_FALSE(app::holdsSequence(folder.path()));
  const auto frames = app::openAny({folder.path() / "frames"});
  REQUIRE(frames);
  CHECK(std::holds_alternative<app::SequenceDocument>(*frames));
  const auto oneFrame = app::openAny({folder.path() / "frames" / "tube-2.obj"});
  REQUIRE(oneFrame);
  CHECK(std::get<app::SequenceDocument>(*oneFrame).mesh->frameCount() == 3);
  const auto morph = app::openAny({folder.write("morph.gltf", morphingTetrahedron)});
  REQUIRE(morph);
  REQUIRE(std::holds_alternative<app::SequenceDocument>(*morph));
  CHECK(std::get<app::SequenceDocument>(*morph).mesh->vertexCount == 4);
  const auto character = app::openAny({STRETCH_SOURCE_DIR "/assets/dummy.glb"});
  REQUIRE(character);
  CHECK(std::holds_alternative<app::Document>(*character));
  CHECK_FALSE(app::openAny({folder.path()}));
}

TEST_CASE("an opened sequence knows its centre line, its thickness and how length falls with curvature") {
  OpenedTube tube;
  const app::SequenceDocument& document = tube.session->document();
  CHECK(document.analysis->problem.empty());
  CHECK(document.analysis->joints.size() == 12);
  CHECK(document.analysis->vertexDiameters.size() == document.mesh->vertexCount);
  CHECK(app::bonesAt(document, 0).size() == 30);
  const skinning::LengthFunction all = app::fittedLength(document);
  CHECK(all.frameCount == 12);
  CHECK(all.line.slope < 0.0);
  tube.edit([](app::SequenceDocument& changed) { changed.settings.body.firstFittedFrame = 5; });
  CHECK(app::fittedLength(tube.session->document()).frameCount == 7);
  tube.edit([](app::SequenceDocument& changed) { changed.settings.body.firstFittedFrame = 500; });
  CHECK(app::fittedLength(tube.session->document()).frameCount == 1);
}

TEST_CASE("a sequence without a centre line opens all the same, and can be measured") {
  const test::TemporaryFolder folder;
  MeshSequence ring = test::still(test::torus(3.0, 0.5, 40, 12));
  ring.positions.insert(ring.positions.end(), ring.positions.begin(), ring.positions.end());
  test::writeObjFrames(ring, folder.path() / "ring", "ring");
  const auto opened = app::openSequence({folder.path() / "ring"});
  REQUIRE(opened);
  CHECK_FALSE(opened->analysis->problem.empty());
  CHECK(app::bonesAt(*opened, 0).empty());
  CHECK(opened->settings.stretch == skinning::StretchOption::measured);
}

TEST_CASE("a compression beside the caller ends with a result that can be exported", "[jobs]") {
  OpenedTube tube;
  app::SequenceSession& session = *tube.session;
  const test::TemporaryFolder folder;
  CHECK_FALSE(session.startExport(folder / "early.glb"));
  session.view().showSkinned = false;
  REQUIRE(session.startCompression());
  CHECK_FALSE(session.startCompression());
  REQUIRE(waitForCompression(session));
  CHECK(session.view().showSkinned); // what was waited for is seen
  REQUIRE(session.document().result != nullptr);
  CHECK_FALSE(app::isOutdated(session.document()));
  CHECK(app::bonesAt(session.document(), 3).size() == 8);
  tube.edit([](app::SequenceDocument& changed) { changed.encoding.quantise = false; });
  const double plain = waitForClip(session)->clip.bytesPerFrame;
  tube.edit([](app::SequenceDocument& changed) { changed.encoding.quantise = true; });
  CHECK(waitForClip(session)->clip.bytesPerFrame < plain);
  REQUIRE(session.startExport(folder / "tube.glb"));
  CHECK_FALSE(session.startExport(folder / "another.glb"));
  const auto written = waitForExport(session);
  REQUIRE(written);
  REQUIRE(*written);
  CHECK((*written)->metrics.rmsePercent ==
        Approx(session.document().result->compressed.metrics.rmsePercent).margin(1e-3));
  CHECK(app::openDocument(folder / "tube.glb"));
  tube.edit([](app::SequenceDocument& changed) { changed.settings.bones = 9; });
  CHECK(app::isOutdated(session.document()));
}

TEST_CASE("settings and results of a sequence are undone and done again by value") {
  OpenedTube tube;
  app::SequenceSession& session = *tube.session;
  REQUIRE(session.startCompression());
  REQUIRE(waitForCompression(session));
  CHECK(session.history().undoLabel() == "Compress");
  const app::SequenceDocument compressed = session.document();
  tube.edit([](app::SequenceDocument& changed) { changed.settings.bones = 5; }, "Change the bones");
  const app::SequenceDocument edited = session.document();
  CHECK(session.history().undoLabel() == "Change the bones");
  REQUIRE(session.undo());
  CHECK(app::sameDocument(session.document(), compressed));
  CHECK_FALSE(app::isOutdated(session.document()));
  REQUIRE(session.redo());
  CHECK(app::sameDocument(session.document(), edited));
  CHECK(app::isOutdated(session.document()));
  REQUIRE(session.undo());
  REQUIRE(session.undo());
  CHECK(app::sameDocument(session.document(), *tube.document));
  CHECK_FALSE(session.undo());
}

TEST_CASE("what is open is nothing, a character or a sequence, never both") {
  app::OpenDocument open;
  CHECK(open.isEmpty());
  CHECK_FALSE(open.with(false, [](auto&) { return true; }));
  open.open(test::boxer());
  CHECK(open.character() != nullptr);
  CHECK(open.sequence() == nullptr);
  OpenedTube tube;
  open.open(*tube.document);
  CHECK(open.character() == nullptr);
  REQUIRE(open.sequence() != nullptr);
  CHECK(open.with(std::size_t{0}, [](auto& session) { return session.history().canUndo() ? 2 : 1; }) == 1);
}

TEST_CASE("a command means for a sequence what its table says, and nothing else") {
  OpenedTube tube;
  app::OpenDocument open;
  open.open(*tube.document);
  const auto command = [](const std::string& id) {
    for (const app::DocumentCommand& known : app::documentCommands()) {
      if (known.id == id) {
        return known;
      }
    }
    return app::DocumentCommand{};
  };
  CHECK_FALSE(app::isEnabled(command("trail.apply"), open));
  CHECK_FALSE(app::isEnabled(command("edit.undo"), open));
  REQUIRE(app::isEnabled(command("time.end"), open));
  REQUIRE(app::run(command("time.end"), open));
  CHECK(open.sequence()->view().frame == 11.0);
  REQUIRE(app::run(command("time.back"), open));
  CHECK(open.sequence()->view().frame == 10.0);
  REQUIRE(app::run(command("sequence.original"), open));
  CHECK_FALSE(open.sequence()->view().showOriginal);
  app::SequenceDocument changed = open.sequence()->document();
  changed.encoding.quantise = !changed.encoding.quantise;
  open.sequence()->edit(changed, "Quantise");
  REQUIRE(app::isEnabled(command("edit.undo"), open));
  REQUIRE(app::run(command("edit.undo"), open));
  CHECK(app::sameDocument(open.sequence()->document(), *tube.document));
}

TEST_CASE("a cancelled compression leaves the result before it", "[jobs]") {
  OpenedTube tube;
  app::SequenceSession& session = *tube.session;
  REQUIRE(session.startCompression());
  session.cancelWork();
  REQUIRE(waitForCompression(session));
  CHECK_FALSE(session.isCompressing());
  CHECK(session.document().result == nullptr);
}

TEST_CASE("a result is encoded beside the caller whenever its encoding changes, unless that was cancelled",
          "[jobs]") {
  OpenedTube tube;
  app::SequenceSession& session = *tube.session;
  session.keepClip();
  CHECK_FALSE(session.isEncoding());
  REQUIRE(session.startCompression());
  REQUIRE(waitForCompression(session));
  REQUIRE(session.clip() != nullptr);
  session.keepClip();
  CHECK_FALSE(session.isEncoding());
  tube.edit([](app::SequenceDocument& changed) { changed.encoding.keyTolerancePercent = 0.5; });
  CHECK(session.clip() == nullptr);
  session.keepClip();
  REQUIRE(session.isEncoding());
  session.cancelWork();
  (void)waitFor(
      [&]() -> std::optional<bool> {
        session.keepClip();
        return session.isEncoding() ? std::nullopt : std::optional(true);
      },
      [] { return true; });
  CHECK(session.clip() == nullptr);
  tube.edit([](app::SequenceDocument& changed) { changed.encoding.keyTolerancePercent = 0.4; });
  REQUIRE(waitForClip(session) != nullptr);
  CHECK(session.clip()->settings.keyTolerancePercent == 0.4);
}

TEST_CASE("an export that cannot be written or was cancelled leaves no file, and the first says why",
          "[jobs]") {
  OpenedTube tube;
  app::SequenceSession& session = *tube.session;
  const test::TemporaryFolder folder;
  REQUIRE(session.startCompression());
  REQUIRE(waitForCompression(session));
  REQUIRE(session.startExport(folder / "nowhere" / "tube.glb"));
  const auto failed = waitForExport(session);
  REQUIRE(failed);
  REQUIRE_FALSE(*failed);
  CHECK_THAT(failed->error().line(), Catch::Contains("nowhere"));
  tube.edit([](app::SequenceDocument& changed) { changed.encoding.keyTolerancePercent = 0.5; });
  REQUIRE(session.startExport(folder / "tube.glb"));
  session.cancelWork();
  CHECK_FALSE(waitForExport(session));
  CHECK_FALSE(session.isExporting());
  CHECK_FALSE(std::filesystem::exists(folder / "tube.glb"));
}

TEST_CASE("the bones of a file take the place of own ones and leave again, another body's are refused") {
  OpenedTube tube;
  app::SequenceSession& session = *tube.session;
  const test::TemporaryFolder folder;
  REQUIRE(session.startCompression());
  REQUIRE(waitForCompression(session));
  REQUIRE(session.startExport(folder / "tube.glb"));
  REQUIRE(waitForExport(session));
  tube.edit([](app::SequenceDocument& changed) { changed.settings.tolerancePercent = 0.2; });
  const auto changed = app::withSkeleton(session.document(), folder / "tube.glb");
  REQUIRE(changed);
  CHECK(changed->settings.skeleton.size() == 8);
  CHECK(changed->skeletonFile == folder / "tube.glb");
  CHECK_FALSE(changed->settings.tolerancePercent);
  session.edit(*changed, "Take the bones");
  CHECK(app::isOutdated(session.document()));
  REQUIRE(session.startCompression());
  REQUIRE(waitForCompression(session));
  const auto& bones = session.document().result->compressed.skinned.bones;
  CHECK(bones.front().name == changed->settings.skeleton.front().name);
  CHECK(app::withoutSkeleton(*changed).settings.skeleton.empty());
  CHECK(app::withoutSkeleton(*changed).skeletonFile.empty());
  const auto refused =
      app::withSkeleton(session.document(), std::filesystem::path(STRETCH_SOURCE_DIR "/assets/dummy.glb"));
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().line(), Catch::StartsWith("dummy.glb: "));
  const auto missing = app::withSkeleton(session.document(), folder / "missing.glb");
  REQUIRE_FALSE(missing);
  CHECK_THAT(missing.error().line(), Catch::StartsWith("missing.glb: "));
}

TEST_CASE("a compression that cannot be done says why", "[jobs]") {
  OpenedTube tube;
  tube.edit([](app::SequenceDocument& changed) { changed.settings.bones = 100000; });
  REQUIRE(tube.session->startCompression());
  const Status done = waitForCompression(*tube.session);
  REQUIRE_FALSE(done);
  CHECK(done.error().what.find("bones") != std::string::npos);
}

TEST_CASE("the shown frame is the nearest one within the sequence") {
  OpenedTube tube;
  tube.session->view().frame = 3.6;
  CHECK(app::shownFrame(*tube.session) == 4);
  tube.session->view().frame = 400.0;
  CHECK(app::shownFrame(*tube.session) == 11);
}

TEST_CASE("A sequence goes without a question as it was opened or exported, and else after one") {
  OpenedTube tube;
  test::Desk desk;
  desk.document.open(*tube.document);
  app::SequenceSession& session = *desk.document.sequence();
  const test::TemporaryFolder folder;
  app::FileWork work;
  const auto asks = [&] {
    work.quit(desk);
    const bool asked = work.question().kind == app::FileQuestion::Kind::unsaved;
    work.answer(desk, app::FileAnswer::cancel);
    return asked;
  };
  CHECK_FALSE(asks());
  REQUIRE(session.startCompression());
  REQUIRE(waitForCompression(session));
  CHECK(asks());
  REQUIRE(session.startExport(folder / "tube.glb"));
  REQUIRE(waitForExport(session));
  CHECK_FALSE(asks());
  REQUIRE(session.undo());
  CHECK(asks());
  REQUIRE(session.redo());
  CHECK_FALSE(asks());
  REQUIRE(session.startExport(folder / "again.glb"));
  app::SequenceDocument meanwhile = session.document();
  meanwhile.settings.bones = 7;
  session.edit(meanwhile, "Change");
  REQUIRE(waitForExport(session));
  CHECK(asks()); // what was written is what was open before
  REQUIRE(session.undo());
  CHECK_FALSE(asks());

  app::SequenceDocument changed = session.document();
  changed.settings.bones = 9;
  session.edit(changed, "Change");
  desk.news();
  work.openFile(desk, {desk.file("a.glb")});
  work.answer(desk, app::FileAnswer::save); // is not offered
  CHECK(work.question().kind == app::FileQuestion::Kind::unsaved);
  work.answer(desk, app::FileAnswer::discard);
  desk.waitWhileOpening(work);
  CHECK(desk.news() == "closing opened ");
  CHECK(desk.document.character() != nullptr);
}
