#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/document.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/files/saved_work.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/scene/bind_chains.h"
#include "rig/limb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

namespace fs = std::filesystem;

constexpr const char* dummyPath = STRETCH_SOURCE_DIR "/assets/dummy.glb";
constexpr double lastFrame = 60.0;
constexpr double framesPerSecond = 24.0;

template <typename Value>
Value orFail(const Result<Value>& result) {
  INFO((result ? std::string() : result.error().line()));
  REQUIRE(result);
  return *result;
}

Document opened(const fs::path& path) {
  Document document = orFail(openDocument(path));
  setFramesPerSecond(document, framesPerSecond);
  return document;
}

// Joints by value, lengths but for the rounding of what the file stores in single precision.
bool sameLimbs(const Document& a, const Document& b) {
  return std::equal(a.body.limbs.begin(), a.body.limbs.end(), b.body.limbs.begin(), b.body.limbs.end(),
                    [](const rig::Limb& first, const rig::Limb& second) {
                      return first.id == second.id && first.joints == second.joints &&
                             first.endNode == second.endNode &&
                             std::abs(first.restLength - second.restLength) < 1e-5 * first.restLength;
                    });
}

struct Stretch {
  std::string limb;
  double startFrame = 0.0;
  double endFrame = 0.0;
  double scale = 1.0;
};

Document stretched(const Document& document, const Stretch& wanted) {
  NewTrail trail;
  trail.limb = wanted.limb;
  trail.settings.startFrame = wanted.startFrame;
  trail.settings.endFrame = wanted.endFrame;
  trail.settings.scale = wanted.scale;
  trail.exaggerated = true;
  trail.connected = true;
  const CreatedTrail created = orFail(createTrail(document, trail));
  return orFail(applyTrail(created.document, created.trailId));
}

fs::path saved(const Document& document, const fs::path& path, bool clean = false) {
  SaveOptions options;
  options.clean = clean;
  const Status done = saveDocument(document, path, options);
  INFO((done ? std::string() : done.error().line()));
  REQUIRE(done);
  return path;
}

gltf::Bytes bytesOf(const fs::path& path) {
  return orFail(readFile(path));
}

std::vector<Mat4> matricesAt(const Document& document, double frame) {
  const rig::MotionState motion = prepareMotion(document, 0);
  const FrameState state = evaluate(document, motion, frame / motion.framesPerSecond);
  return skinMatrices(document.scene->skins.front(), state);
}

// Largest distance between what two documents make of the rest positions of the mesh.
double difference(const Document& a, const Document& b, double frame) {
  const std::vector<Mat4> first = matricesAt(a, frame);
  const std::vector<Mat4> second = matricesAt(b, frame);
  double worst = 0.0;
  for (const Primitive& primitive : a.scene->meshes.front().primitives) {
    for (std::size_t v = 0; v < primitive.positions.size(); v += 7) {
      Vec3 moved(0.0);
      for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
        const std::size_t slot = primitive.influences[v].joints[i];
        const auto weight = static_cast<double>(primitive.influences[v].weights[i]);
        const Vec3 point(primitive.positions[v]);
        moved += weight * (transformPoint(first[slot], point) - transformPoint(second[slot], point));
      }
      worst = std::max(worst, glm::length(moved));
    }
  }
  return worst;
}

double worstDifference(const Document& a, const Document& b) {
  double worst = 0.0;
  for (double frame = 0.0; frame <= lastFrame; frame += 0.5) {
    worst = std::max(worst, difference(a, b, frame));
  }
  return worst;
}

std::ptrdiff_t countLeaves(const Document& document) {
  return std::count_if(document.scene->nodes.begin(), document.scene->nodes.end(),
                       [](const Node& node) { return node.isBindLeaf; });
}

// The left arm as if the character had no hand: its end is a point of the forearm.
Document withoutHand(Document document) {
  rig::Limb& arm = *std::find_if(document.body.limbs.begin(), document.body.limbs.end(),
                                 [](const rig::Limb& limb) { return limb.id == "left-arm"; });
  arm.endOffset = document.scene->nodes[at(arm.endNode)].rest.translation;
  arm.endNode = NodeIndex::none;
  return document;
}

double armLength(const Document& document, double frame) {
  const rig::MotionState motion = prepareMotion(document, 0);
  return rig::limbLength(*findLimb(document, "left-arm"),
                         evaluate(document, motion, frame / motion.framesPerSecond));
}

} // namespace

TEST_CASE("A saved file opens as it was left, and gives the source back when its trail is deleted") {
  const test::TemporaryFolder folder;
  const Document source = opened(dummyPath);
  const Document before = stretched(source, {"left-arm", 12.0, 27.0, 2.0});
  const Document again = opened(saved(before, folder.path() / "punch.glb"));
  CHECK(again.trails == before.trails);
  CHECK(sameLimbs(again, before));
  CHECK(again.scene->bindChains.empty());
  CHECK(worstDifference(again, before) <= 1e-6 * source.body.height);

  const Document emptied = orFail(deleteTrail(again, again.trails.front().id));
  saved(emptied, folder.path() / "back.glb", true);
  saved(source, folder.path() / "source.glb", true);
  CHECK(bytesOf(folder.path() / "back.glb") == bytesOf(folder.path() / "source.glb"));
}

TEST_CASE("Saving writes what is seen: a connected trail is keyed as it stands, applied or not") {
  const test::TemporaryFolder folder;
  const Document source = opened(dummyPath);
  const Document applied = stretched(source, {"left-arm", 12.0, 27.0, 2.0});
  const int id = applied.trails.front().id;
  saved(stretched(source, {"left-arm", 12.0, 27.0, 3.0}), folder / "three.glb", true);
  rig::TrailSettings settings = applied.trails.front().settings;
  settings.scale = 3.0;
  saved(orFail(setTrailSettings(applied, id, settings)), folder / "changed.glb", true);
  CHECK(bytesOf(folder / "changed.glb") == bytesOf(folder / "three.glb"));
}

TEST_CASE("A trail that the character does not follow is kept in the file and not keyed") {
  const test::TemporaryFolder folder;
  const Document source = opened(dummyPath);
  const Document applied = stretched(source, {"left-arm", 12.0, 27.0, 2.0});
  const Document loose = orFail(setConnected(applied, applied.trails.front().id, false));
  saved(loose, folder / "loose-clean.glb", true);
  saved(source, folder / "source.glb", true);
  CHECK(bytesOf(folder / "loose-clean.glb") == bytesOf(folder / "source.glb"));
  CHECK(opened(saved(loose, folder / "loose.glb")).trails == loose.trails);
}

TEST_CASE("A trail changed in a saved file gives what it would have given from the start") {
  const test::TemporaryFolder folder;
  const Document source = opened(dummyPath);
  const Document two =
      opened(saved(stretched(source, {"left-arm", 12.0, 27.0, 2.0}), folder.path() / "two.glb"));
  rig::TrailSettings settings = two.trails.front().settings;
  settings.scale = 3.0;
  const Document three = orFail(setTrailSettings(two, two.trails.front().id, settings));
  saved(orFail(applyTrail(three, three.trails.front().id)), folder.path() / "changed.glb", true);
  saved(stretched(source, {"left-arm", 12.0, 27.0, 3.0}), folder.path() / "direct.glb", true);
  CHECK(bytesOf(folder.path() / "changed.glb") == bytesOf(folder.path() / "direct.glb"));
}

TEST_CASE("A clean file keeps its stretch and its limbs when it is opened, and its leaves are no joints") {
  const test::TemporaryFolder folder;
  const Document source = opened(dummyPath);
  const Document before = stretched(source, {"left-arm", 12.0, 27.0, 2.0});
  const Document clean = opened(saved(before, folder.path() / "clean.glb", true));
  CHECK(clean.trails.empty());
  CHECK(sameLimbs(clean, source));
  CHECK_FALSE(clean.scene->bindChains.empty());
  CHECK(clean.scene->skins.front().joints == source.scene->skins.front().joints);
  CHECK(worstDifference(clean, before) <= 1e-4 * source.body.height);
}

TEST_CASE("A clean file that is stretched again uses its leaves again and keeps the stretch that it had") {
  const test::TemporaryFolder folder;
  const Document source = opened(dummyPath);
  const Document clean =
      opened(saved(stretched(source, {"left-arm", 12.0, 27.0, 2.0}), folder.path() / "clean.glb", true));
  const Document live = GENERATE_COPY(stretched(clean, {"left-arm", 40.0, 50.0, 1.5}),
                                      stretched(clean, {"left-arm", 16.0, 30.0, 0.6}));
  const Document twice = opened(saved(live, folder.path() / "twice.glb", true));
  // A second leaf may join where the stretched axis turns now; none hangs below another chain.
  CHECK(twice.scene->bindChains.size() == clean.scene->bindChains.size());
  CHECK(countLeaves(twice) <= 2 * static_cast<std::ptrdiff_t>(clean.scene->bindChains.size()));
  CHECK(worstDifference(live, clean) > 0.05 * source.body.height);
  CHECK(worstDifference(twice, live) <= 1e-4 * source.body.height);
}

TEST_CASE("An arm that ends in no joint is stretched from where a clean file has it") {
  const test::TemporaryFolder folder;
  const Document once = stretched(withoutHand(opened(dummyPath)), {"left-arm", 21.0, 27.0, 2.0});
  const Document before = withoutHand(opened(saved(once, folder.path() / "clean.glb", true)));
  CHECK(armLength(before, 27.0) == Approx(armLength(once, 27.0)).epsilon(1e-4));
  CHECK(worstDifference(before, stretched(before, {"left-arm", 21.0, 27.0, 1.0})) < 1e-6);
  const Document again = stretched(before, {"left-arm", 21.0, 27.0, 1.5});
  CHECK(armLength(again, 27.0) == Approx(1.5 * armLength(before, 27.0)).epsilon(1e-4));
}

TEST_CASE("A file whose work is of a later version opens without it, and says so") {
  const test::TemporaryFolder folder;
  const Document before = stretched(opened(dummyPath), {"left-arm", 12.0, 27.0, 2.0});
  const Document own = opened(saved(before, folder / "own.glb"));
  CHECK(own.carriedWork);
  CHECK(own.warnings.empty());
  gltf::Json work = workOf(before);
  work["version"] = 2;
  gltf::Edits edits = editsOf(before, {}).edits;
  edits.work = work;
  REQUIRE(saveEdits(before, edits, folder / "later.glb"));
  const Document later = opened(folder / "later.glb");
  CHECK_FALSE(later.carriedWork);
  CHECK(later.trails.empty());
  REQUIRE(later.warnings.size() == 1);
  CHECK_THAT(later.warnings[0],
             Catch::StartsWith("the work kept in the file could not be taken up: extras.stretch_engine: "
                               "this program does not know this version of the work"));
}
