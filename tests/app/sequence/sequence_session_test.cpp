#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

#include "app/sequence/open_any.h"
#include "app/sequence/sequence_session.h"
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
    session.document = std::move(opened).value();
    session.document.settings.bones = 8;
  }

  app::SequenceSession session;

private:
  test::TemporaryFolder folder_;
};

Status waitForCompression(app::SequenceSession& session) {
  for (int i = 0; i < 60000 && session.job != nullptr; ++i) {
    if (std::optional<Status> done = app::takeCompression(session)) {
      return *done;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return Success{};
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
  const app::SequenceDocument& document = tube.session.document;
  CHECK(document.analysis->problem.empty());
  CHECK(document.analysis->joints.size() == 12);
  CHECK(document.analysis->vertexDiameters.size() == document.mesh->vertexCount);
  CHECK(app::jointsAt(document, 0).size() == 31);
  const skinning::LengthFunction all = app::fittedLength(document);
  CHECK(all.frameCount == 12);
  CHECK(all.line.slope < 0.0);
  tube.session.document.settings.body.firstFittedFrame = 5;
  CHECK(app::fittedLength(document).frameCount == 7);
  tube.session.document.settings.body.firstFittedFrame = 500;
  CHECK(app::fittedLength(document).frameCount == 1);
}

TEST_CASE("a sequence without a centre line opens all the same, and can be measured") {
  const test::TemporaryFolder folder;
  MeshSequence ring = test::still(test::torus(3.0, 0.5, 40, 12));
  ring.positions.insert(ring.positions.end(), ring.positions.begin(), ring.positions.end());
  test::writeObjFrames(ring, folder.path() / "ring", "ring");
  const auto opened = app::openSequence({folder.path() / "ring"});
  REQUIRE(opened);
  CHECK_FALSE(opened->analysis->problem.empty());
  CHECK(app::jointsAt(*opened, 0).empty());
  CHECK(opened->settings.stretch == skinning::StretchOption::measured);
}

TEST_CASE("a compression beside the caller ends with a result that can be exported") {
  OpenedTube tube;
  app::SequenceSession& session = tube.session;
  const test::TemporaryFolder folder;
  CHECK_FALSE(app::exportResult(session.document, folder / "early.glb"));
  REQUIRE(app::startCompression(session));
  CHECK_FALSE(app::startCompression(session));
  REQUIRE(waitForCompression(session));
  REQUIRE(session.document.result != nullptr);
  CHECK_FALSE(app::isOutdated(session.document));
  CHECK(app::jointsAt(session.document, 3).size() == 9);
  session.document.quantise = false;
  const double plain = app::exported(session.document).bytesPerFrame;
  session.document.quantise = true;
  CHECK(app::exported(session.document).bytesPerFrame < plain);
  REQUIRE(app::exportResult(session.document, folder / "tube.glb"));
  CHECK(app::openDocument(folder / "tube.glb"));
  session.document.settings.bones = 9;
  CHECK(app::isOutdated(session.document));
}

TEST_CASE("a cancelled compression leaves the result before it") {
  OpenedTube tube;
  app::SequenceSession& session = tube.session;
  REQUIRE(app::startCompression(session));
  session.job->cancel();
  REQUIRE(waitForCompression(session));
  CHECK(session.job == nullptr);
  CHECK(session.document.result == nullptr);
}

TEST_CASE("a compression that cannot be done says why") {
  OpenedTube tube;
  tube.session.document.settings.bones = 100000;
  REQUIRE(app::startCompression(tube.session));
  const Status done = waitForCompression(tube.session);
  REQUIRE_FALSE(done);
  CHECK(done.error().what.find("bones") != std::string::npos);
}

TEST_CASE("the shown frame is the nearest one within the sequence") {
  OpenedTube tube;
  tube.session.view.frame = 3.6;
  CHECK(app::shownFrame(tube.session) == 4);
  tube.session.view.frame = 400.0;
  CHECK(app::shownFrame(tube.session) == 11);
}
