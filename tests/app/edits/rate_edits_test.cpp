#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/files/saved_work.h"
#include "app/recipe/recipe.h"
#include "app/session.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document exaggerated() {
  NewTrail wanted;
  wanted.limb = "left-arm";
  wanted.settings.startFrame = 5.0;
  wanted.settings.endFrame = 10.0;
  wanted.settings.scale = 2.0;
  wanted.settings.releaseFrames = 4.0;
  wanted.settings.lingerFrames = 1.0;
  wanted.settings.spheres = {{7.5, Vec3(0.0, 0.1, 0.0), Vec3(0.5, 0.0, 0.0)}};
  wanted.connected = true;
  return createTrail(test::boxer(), wanted)->document;
}

double farthestApart(const Document& a, const Document& b) {
  const rig::MotionState motionA = prepareMotion(a, 0);
  const rig::MotionState motionB = prepareMotion(b, 0);
  double farthest = 0.0;
  for (const double seconds : {0.1, 0.2, 0.25, 0.3, 1.0 / 3.0, 0.4, 0.5}) {
    const FrameState frameA = evaluate(a, motionA, seconds);
    const FrameState frameB = evaluate(b, motionB, seconds);
    for (std::size_t node = 0; node < frameA.worlds.size(); ++node) {
      farthest =
          std::max(farthest, glm::length(positionOf(frameA.worlds[node]) - positionOf(frameB.worlds[node])));
    }
  }
  return farthest;
}

/// The boxer's arms swinging to and fro for as long as a dance, with a key on every frame of 60 a second.
Document motionCapture(int frames) {
  Document document = test::boxer();
  Clip clip = clipOf(document, 0);
  const NodeIndex shoulder = findLimb(document, "left-arm")->joints.front();
  Track track;
  track.node = shoulder;
  track.channel = Channel::rotation;
  track.width = 4;
  for (int i = 0; i < frames; ++i) {
    const double seconds = i / 60.0;
    // Swings of changing width, and rests between some of them, a little unsteady as people are.
    const double angle = 0.9 * std::sin(5.0 * seconds) * std::max(0.0, std::sin(0.7 * seconds)) +
                         0.01 * std::sin(37.0 * seconds);
    track.times.push_back(static_cast<float>(seconds));
    for (const double part : {0.0, std::sin(0.5 * angle), 0.0, std::cos(0.5 * angle)}) {
      track.values.push_back(static_cast<float>(part));
    }
  }
  clip.endSeconds = static_cast<double>(track.times.back());
  clip.framesPerSecond = 60.0;
  clip.tracks = {CopyOnWrite<Track>(std::move(track))};
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{std::move(clip)});
  return document;
}

Status runCommand(Session& session, const std::string& id) {
  for (const DocumentCommand& command : documentCommands()) {
    if (command.id == id) {
      return command.run(session);
    }
  }
  return Error{"no such command", id, ""};
}

} // namespace

TEST_CASE("A clip that is worked on at another rate moves as before, its own rate forgets the choice") {
  const Document at30 = exaggerated();
  const Document at24 = workAtRate(at30, 0, 24.0);
  CHECK(clipOf(at24, 0).framesPerSecond == 24.0);
  CHECK(at24.trails.front().settings.startFrame == 4.0);
  CHECK(at24.trails.front().settings.endFrame == 8.0);
  CHECK(*at24.trails.front().settings.releaseFrames == Approx(3.2));
  CHECK(at24.trails.front().settings.lingerFrames == Approx(0.8));
  CHECK(at24.trails.front().settings.spheres.front().frame == 6.0);
  CHECK(clipOf(at24, 0).tracks.front()->times == clipOf(at30, 0).tracks.front()->times);
  CHECK(farthestApart(at30, at24) < 2e-3); // Paths are sampled at the frames.
  CHECK(at24.trails.front().settings.spheres.front().tangent->x == Approx(0.625));
  CHECK(ownRate(at24, 0) == 30.0);
  const Document back = workAtRate(at24, 0, 30.0);
  CHECK(back.rates.empty());
  CHECK(back.trails == at30.trails);
}

TEST_CASE("The range of a limb's weight stays where it is in time at another rate") {
  WeightedLimb arm{"left-arm", 0, true, {}};
  arm.settings.rangeFrames = Vec2(5.0, 15.0);
  const Result<Document> heavy = setWeight(test::boxer(), arm);
  REQUIRE(heavy);
  CHECK(workAtRate(*heavy, 0, 24.0).weights.front().settings.rangeFrames == Vec2(4.0, 12.0));
}

TEST_CASE("The rate that was chosen is kept with the work, and left with it") {
  const Document at24 = workAtRate(exaggerated(), 0, 24.0);
  Document opened = test::boxer();
  REQUIRE(restoreWork(workOf(at24), opened));
  CHECK(clipOf(opened, 0).framesPerSecond == 24.0);
  CHECK(ownRate(opened, 0) == 30.0);
  CHECK(opened.trails == at24.trails);
  CHECK(clipOf(withoutWork(opened), 0).framesPerSecond == 30.0);
}

TEST_CASE("A file saved at a chosen rate opens at it, and its clean copy at its own") {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  const test::TemporaryFolder folder;
  const Document at30 = workAtRate(*opened, 0, 30.0);
  REQUIRE(saveDocument(at30, folder.path() / "work.glb", {}));
  REQUIRE(saveDocument(at30, folder.path() / "clean.glb", {.clean = true}));
  CHECK(clipOf(*openDocument(folder.path() / "work.glb"), 0).framesPerSecond == 30.0);
  CHECK(clipOf(*openDocument(folder.path() / "clean.glb"), 0).framesPerSecond == 24.0);
}

TEST_CASE("A recipe that was saved at a chosen rate means the same on a clip that counts in its own") {
  const Document at24 = workAtRate(exaggerated(), 0, 24.0);
  const gltf::Json json = recipeToJson(at24, 0);
  CHECK(json.at("frames_per_second") == 24.0);
  Document other = test::boxer();
  const Result<Recipe> recipe = recipeFromJson(json, other);
  REQUIRE(recipe);
  CHECK(recipe->trails.front().settings.startFrame == 5.0);
  CHECK(recipe->trails.front().settings.endFrame == 10.0);
  CHECK(recipe->trails.front().settings.spheres.front().frame == 7.5);
  CHECK_FALSE(recipeToJson(exaggerated(), 0).contains("frames_per_second"));
  gltf::Json odd = json;
  odd["frames_per_second"] = 0;
  CHECK_THAT(test::refusal(recipeFromJson(odd, other)), Catch::Contains("frames_per_second"));
}

TEST_CASE("Playhead and range stay where they are in time when the rate changes, and when that is undone") {
  Session session(exaggerated());
  session.view().frame = 10.0;
  session.view().rangeStart = 5.0;
  session.view().rangeEnd = 10.0;
  REQUIRE(session.edit(workAtRate(session.document(), 0, 24.0), "Work at 24 fps"));
  CHECK(session.view().frame == 8.0);
  CHECK(session.view().rangeStart == 4.0);
  CHECK(session.view().rangeEnd == 8.0);
  session.undo();
  CHECK(session.view().frame == 10.0);
  CHECK(session.view().rangeEnd == 10.0);
}

TEST_CASE(
    "Worked on at 24, a clip of 60 frames per second is stepped and stretched on whole frames, and each "
    "of its keys is reached") {
  Session session(motionCapture(2320));
  REQUIRE(runCommand(session, "clip.rate-24"));
  CHECK(lastFrame(session.document(), 0) == 928.0);
  CHECK(clipOf(session.document(), 0).tracks.front()->times.size() == 2320);
  selectLimb(session, "left-arm", false);
  session.view().frame = 40.0;
  REQUIRE(runCommand(session, "time.next-key"));
  CHECK(session.view().frame == Approx(40.4));
  REQUIRE(runCommand(session, "time.previous-key"));
  CHECK(session.view().frame == 40.0);
  session.view().frame = 40.4;
  REQUIRE(runCommand(session, "time.forward"));
  CHECK(session.view().frame == 41.0);
  session.view().frame = 40.0;
  const Result<ExaggerateTargets> made = exaggerateTargets(session);
  REQUIRE(made);
  session.edit(made->document, "Exaggerate");
  const rig::SolvedTrail& solved = session.motion().trails.front();
  CHECK(solved.settings.startFrame == std::round(solved.settings.startFrame));
  CHECK(solved.settings.endFrame == std::round(solved.settings.endFrame));
  for (const double frame : solved.controlFrames) {
    CHECK(frame == Approx(std::round(frame)));
  }
}

TEST_CASE("On motion as long as a dance the stroke at the playhead is proposed, with few spheres") {
  for (const double rate : {24.0, 60.0}) {
    Session session(workAtRate(motionCapture(2320), 0, rate));
    for (double frame = 0.0; frame < lastFrame(session.document(), 0); frame += 97.0) {
      CAPTURE(rate, frame);
      session.view().frame = frame;
      session.view().rangeEnd = -1.0;
      selectTrail(session, 0);
      selectLimb(session, "left-arm", false);
      const Result<ExaggerateTargets> made = exaggerateTargets(session);
      REQUIRE(made);
      const rig::TrailSettings& settings = made->document.trails.front().settings;
      CHECK((settings.endFrame - settings.startFrame) / rate < 1.5); // Seconds.
      const rig::MotionState motion = prepareMotion(made->document, 0);
      CHECK(motion.trails.front().controlFrames.size() <= 12);
      CHECK(motion.trails.front().controlFrames.size() >= 2);
    }
  }
}
