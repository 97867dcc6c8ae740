// What is told of a sequence and its result, by values: nothing is compressed here.
#include "app/sequence/sequence_document.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/sequence/open_any.h"
#include "app/sequence/sequence_session.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;

namespace {

/// Nothing but what is measured of a body: a centre line of three joints in each of two frames.
app::SequenceDocument measuredBody() {
  app::SequenceAnalysis analysis;
  analysis.vertexDiameters = {0.5, 0.5, 0.5};
  analysis.joints = {{Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0)},
                     {Vec3(0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 3.0, 0.0)}};
  analysis.measured = {{0.0, 3.0}, {0.25, 2.75}};
  app::SequenceDocument document;
  document.paths = {"frames"};
  document.mesh = std::make_shared<const MeshSequence>();
  document.analysis = std::make_shared<const app::SequenceAnalysis>(std::move(analysis));
  return document;
}

/// Three bones in a row along x, each 1 long, in one frame.
skinning::SkinnedSequence threeBones() {
  skinning::SkinnedSequence skinned;
  for (int bone = 0; bone < 3; ++bone) {
    const Vec3 pivot(bone, 0.0, 0.0);
    skinned.bones.push_back({.pivot = pivot, .end = pivot + Vec3(1.0, 0.0, 0.0), .parent = bone - 1});
    skinned.poses.push_back({.position = pivot + Vec3(0.0, 2.0, 0.0), .scale = Vec3(2.0, 1.0, 1.0)});
  }
  return skinned;
}

std::shared_ptr<const app::Compression> resultOf(skinning::SkinnedSequence skinned) {
  app::Compression result;
  result.compressed.skinned = std::move(skinned);
  return std::make_shared<const app::Compression>(std::move(result));
}

std::vector<bool> lastsOf(const std::vector<app::ShownBone>& bones) {
  std::vector<bool> lasts(bones.size());
  std::transform(bones.begin(), bones.end(), lasts.begin(),
                 [](const app::ShownBone& bone) { return bone.isLast; });
  return lasts;
}

} // namespace

TEST_CASE("Each part of a sequence makes another one") {
  const app::SequenceDocument document = measuredBody();
  const auto differs = [&](const std::function<void(app::SequenceDocument&)>& change) {
    app::SequenceDocument other = document;
    change(other);
    return !app::sameDocument(document, other) && !app::sameDocument(other, document);
  };
  CHECK(app::sameDocument(document, app::SequenceDocument(document)));
  CHECK(differs([](app::SequenceDocument& d) { d.paths = {"base.obj", "cache.pc2"}; }));
  CHECK(differs([](app::SequenceDocument& d) { d.mesh = std::make_shared<const MeshSequence>(); }));
  CHECK(differs([](app::SequenceDocument& d) {
    d.analysis = std::make_shared<const app::SequenceAnalysis>(*d.analysis);
  }));
  CHECK(differs([](app::SequenceDocument& d) { d.settings.bones += 1; }));
  CHECK(differs([](app::SequenceDocument& d) { d.skeletonFile = "rig.glb"; }));
  CHECK(differs([](app::SequenceDocument& d) { d.encoding.meshopt = true; }));
  CHECK(differs([](app::SequenceDocument& d) { d.result = resultOf({}); }));
}

TEST_CASE("A clip that was encoded is that of its own result and its own settings alone") {
  app::SequenceDocument document = measuredBody();
  document.result = resultOf({});
  const app::ExportedClip clip{document.encoding, document.result, {}};
  CHECK(app::isClipOf(clip, document));
  app::SequenceDocument packed = document;
  packed.encoding.meshopt = true;
  CHECK_FALSE(app::isClipOf(clip, packed));
  app::SequenceDocument again = document; // compressed once more, to the same
  again.result = resultOf({});
  CHECK_FALSE(app::isClipOf(clip, again));
}

TEST_CASE("A step of a sequence takes memory for a result that it does not share") {
  const app::SequenceDocument document = measuredBody();
  skinning::SkinnedSequence skinned = threeBones();
  skinned.bindPositions.resize(100);
  skinned.influences.resize(100);
  skinned.triangles.resize(50);
  app::SequenceDocument compressed = document;
  compressed.result = resultOf(skinned);
  const std::size_t alone = sizeof(app::SequenceDocument);
  CHECK(app::bytesBeyond(document, document) == alone);
  CHECK(app::bytesBeyond(compressed, compressed) == alone);
  CHECK(app::bytesBeyond(document, compressed) == alone);
  CHECK(app::bytesBeyond(compressed, document) ==
        alone + 100 * (sizeof(glm::vec3) + sizeof(skinning::Influences)) + 50 * sizeof(Triangle) +
            3 * sizeof(skinning::BonePose));
}

TEST_CASE("The bones that are drawn are the centre line's pieces, then the result's, with their ends") {
  app::SequenceDocument document = measuredBody();
  const std::vector<app::ShownBone> pieces = app::bonesAt(document, 1);
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].start == Vec3(0.0));
  CHECK(pieces[0].end == Vec3(0.0, 1.0, 0.0));
  CHECK(pieces[1].start == Vec3(0.0, 1.0, 0.0));
  CHECK(pieces[1].end == Vec3(0.0, 3.0, 0.0));
  CHECK(lastsOf(pieces) == std::vector<bool>{false, true});
  CHECK(app::bonesAt(document, 2).empty());

  skinning::SkinnedSequence skinned = threeBones();
  skinned.bones[2].parent = 0; // two hang on the first
  document.result = resultOf(skinned);
  const std::vector<app::ShownBone> tree = app::bonesAt(document, 0);
  REQUIRE(tree.size() == 3);
  CHECK(tree[1].start == Vec3(1.0, 2.0, 0.0));
  CHECK(tree[1].end == Vec3(3.0, 2.0, 0.0)); // twice as long
  CHECK(lastsOf(tree) == std::vector<bool>{false, true, true});
  skinned.chained = true; // in a row nobody asks for parents
  document.result = resultOf(skinned);
  CHECK(lastsOf(app::bonesAt(document, 0)) == std::vector<bool>{false, false, true});
}

TEST_CASE("Lengths are the result's where that measured them, else those that opening measured") {
  app::SequenceDocument document = measuredBody();
  CHECK(app::measuredFrames(document).size() == 2);
  app::Compression result;
  document.result = std::make_shared<const app::Compression>(result);
  CHECK(app::measuredFrames(document).size() == 2); // free bones have no model
  result.compressed.model.emplace();
  result.compressed.model->measured = {{0.5, 1.0}};
  document.result = std::make_shared<const app::Compression>(result);
  REQUIRE(app::measuredFrames(document).size() == 1);
  CHECK(app::measuredFrames(document).front().length == 1.0);
}

TEST_CASE("A look is offered where there is what it shows") {
  using app::SequenceLook;
  const auto offered = [](const app::SequenceDocument& document) {
    std::vector<SequenceLook> looks;
    for (const SequenceLook look :
         {SequenceLook::material, SequenceLook::compare, SequenceLook::error, SequenceLook::thickness,
          SequenceLook::segments, SequenceLook::cylinders}) {
      if (app::canShow(document, look)) {
        looks.push_back(look);
      }
    }
    return looks;
  };
  using Looks = std::vector<SequenceLook>;
  app::SequenceDocument body = measuredBody();
  CHECK(offered(body) == Looks{SequenceLook::material, SequenceLook::compare, SequenceLook::thickness,
                               SequenceLook::segments, SequenceLook::cylinders});
  app::SequenceDocument branching = body;
  app::SequenceAnalysis withoutLine = *body.analysis;
  withoutLine.joints.clear();
  branching.analysis = std::make_shared<const app::SequenceAnalysis>(withoutLine);
  CHECK(offered(branching) == Looks{SequenceLook::material, SequenceLook::compare, SequenceLook::thickness});
  branching.result = resultOf({});
  CHECK(offered(branching).size() == 6);
  app::SequenceDocument sheet = branching;
  sheet.analysis = std::make_shared<const app::SequenceAnalysis>();
  CHECK(offered(sheet) ==
        Looks{SequenceLook::material, SequenceLook::compare, SequenceLook::error, SequenceLook::segments});
}

TEST_CASE("A folder of one mesh is no sequence, one of several or with the log of a simulation is") {
  const test::TemporaryFolder folder;
  CHECK_FALSE(app::holdsSequence(folder.path()));
  folder.write("frame-1.obj", "");
  folder.write("notes.txt", "");
  CHECK_FALSE(app::holdsSequence(folder.path()));
  folder.write("frame-2.obj", "");
  CHECK(app::holdsSequence(folder.path()));
  CHECK_FALSE(app::holdsSequence(folder / "nowhere"));
  const test::TemporaryFolder logged;
  logged.write("membranes_buffer.txt", "");
  CHECK(app::holdsSequence(logged.path()));
}

TEST_CASE("A sequence is opened with thirty bones, one of few vertices with one for every four of them") {
  const test::TemporaryFolder folder;
  const auto bonesOf = [&](const MeshSequence& mesh, const std::string& name) {
    test::writeObjFrames(mesh, folder / name, name);
    const Result<app::SequenceDocument> opened = app::openSequence({folder / name});
    REQUIRE(opened);
    return opened->settings.bones;
  };
  const MeshSequence ring = test::still(test::torus(3.0, 0.5, 40, 12));
  MeshSequence twice = ring;
  twice.positions.insert(twice.positions.end(), ring.positions.begin(), ring.positions.end());
  CHECK(bonesOf(twice, "ring") == 30);
  const MeshSequence small = test::still(test::torus(3.0, 0.5, 4, 3)); // 12 vertices
  twice = small;
  twice.positions.insert(twice.positions.end(), small.positions.begin(), small.positions.end());
  CHECK(bonesOf(twice, "small") == 3);
}
