#include <catch2/catch.hpp>

#include <limits>
#include <string>
#include <utility>

#include "app/edits/trail/trail_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

NewTrail punchTrail(double start, double end) {
  NewTrail wanted;
  wanted.limb = "left-arm";
  wanted.settings.startFrame = start;
  wanted.settings.endFrame = end;
  wanted.settings.scale = 2.0;
  return wanted;
}

CreatedTrail made(const Document& document, const NewTrail& wanted) {
  Result<CreatedTrail> created = createTrail(document, wanted);
  REQUIRE(created);
  return std::move(created).value();
}

} // namespace

TEST_CASE("A new trail gets an id of its own and leaves the old document alone") {
  const Document start = test::boxer();
  const CreatedTrail first = made(start, punchTrail(0, 10));
  const CreatedTrail second = made(first.document, punchTrail(12, 20));
  CHECK(start.trails.empty());
  REQUIRE(second.document.trails.size() == 2);
  CHECK(first.trailId != second.trailId);
  CHECK(findTrail(second.document, second.trailId)->settings.startFrame == 12);
  CHECK(second.document.trails[0].colour != second.document.trails[1].colour);
}

TEST_CASE("An id is not given out again after its trail is deleted") {
  const CreatedTrail first = made(test::boxer(), punchTrail(0, 10));
  const Result<Document> without = deleteTrail(first.document, first.trailId);
  REQUIRE(without);
  CHECK(made(*without, punchTrail(0, 10)).trailId != first.trailId);
}

TEST_CASE("Two trails on one limb may not overlap in time") {
  const CreatedTrail first = made(test::boxer(), punchTrail(4, 10));
  const std::string overlap = "two trails of one limb may not overlap in time: there is one from 4 to 10";
  for (const auto& [start, end] : {std::pair(8, 12), std::pair(5, 6), std::pair(0, 20)}) {
    CHECK_THAT(test::refusal(createTrail(first.document, punchTrail(start, end))), Catch::Contains(overlap));
  }

  SECTION("but may touch") {
    CHECK(createTrail(first.document, punchTrail(10, 14)));
  }
  SECTION("and other limbs are free") {
    NewTrail other = punchTrail(4, 10);
    other.limb = "right-arm";
    CHECK(createTrail(first.document, other));
  }
  SECTION("also not by moving a range later") {
    const CreatedTrail second = made(first.document, punchTrail(10, 14));
    rig::TrailSettings settings = findTrail(second.document, second.trailId)->settings;
    settings.startFrame = 9.5;
    CHECK_THAT(test::refusal(setTrailSettings(second.document, second.trailId, settings)),
               Catch::Contains(overlap));
    settings.startFrame = 10.5;
    CHECK(setTrailSettings(second.document, second.trailId, settings));
  }
}

TEST_CASE("A trail needs a limb, a clip, a range with a length and numbers that are numbers") {
  const Document document = test::boxer();
  NewTrail wanted = punchTrail(0, 10);
  std::string reason = "left-arm: a setting of the trail is not a number";
  SECTION("limb") {
    wanted.limb = "tail";
    reason = "tail: the character has no such limb";
  }
  SECTION("clip") {
    wanted.clip = 1;
    reason = "clip 1: the file has no such clip";
  }
  SECTION("negative clip") {
    wanted.clip = -1;
    reason = "clip -1: the file has no such clip";
  }
  SECTION("no length") {
    wanted.settings.endFrame = 0;
    reason = "left-arm: the range 0 to 0 has no length";
  }
  SECTION("turned round") {
    wanted.settings.startFrame = 11;
    reason = "left-arm: the range 11 to 10 has no length";
  }
  SECTION("scale") {
    reason = "scale: nan is not possible";
    wanted.settings.scale = std::numeric_limits<double>::quiet_NaN();
  }
  SECTION("sphere") {
    wanted.settings.spheres = {{3.0, Vec3(0.0, std::numeric_limits<double>::infinity(), 0.0)}};
  }
  CHECK_THAT(test::refusal(createTrail(document, wanted)), Catch::StartsWith(reason));
}

TEST_CASE("Connecting makes the exaggerated copy") {
  const CreatedTrail created = made(test::boxer(), punchTrail(0, 10));
  const Result<Document> connected = setConnected(created.document, created.trailId, true);
  REQUIRE(connected);
  CHECK(findTrail(*connected, created.trailId)->exaggerated);
}

TEST_CASE("Apply remembers what the clip was re-keyed with") {
  const CreatedTrail created = made(test::boxer(), punchTrail(0, 10));
  const Result<Document> applied = applyTrail(created.document, created.trailId);
  REQUIRE(applied);
  const rig::Trail& trail = *findTrail(*applied, created.trailId);
  CHECK(trail.connected);
  CHECK(trail.applied);
}

TEST_CASE("Deleting the trails of a limb leaves those of other limbs and clips") {
  const CreatedTrail first = made(test::boxer(), punchTrail(0, 5));
  const CreatedTrail second = made(first.document, punchTrail(6, 10));
  NewTrail other = punchTrail(0, 10);
  other.limb = "right-arm";
  const Document all = made(second.document, other).document;
  const Document rest = deleteTrailsOfLimb(all, "left-arm", 0);
  REQUIRE(rest.trails.size() == 1);
  CHECK(rest.trails.front().limb == "right-arm");
  CHECK(deleteTrailsOfLimb(all, "left-arm", 1).trails.size() == 3);
}

TEST_CASE("A pasted trail keeps its range on a free limb and takes the range of the trail that is there") {
  NewTrail wanted = punchTrail(2, 8);
  wanted.settings.spheres = {{4.0, Vec3(0.1, 0.0, 0.0)}, {8.0, Vec3(0.2, 0.0, 0.0)}};
  const CreatedTrail source = made(test::boxer(), wanted);
  const rig::Trail copied = *findTrail(source.document, source.trailId);

  SECTION("free limb") {
    const Result<CreatedTrail> pasted = pasteTrail(source.document, copied, "right-arm", 0);
    REQUIRE(pasted);
    CHECK(findTrail(pasted->document, pasted->trailId)->settings == copied.settings);
  }
  SECTION("taken limb") {
    NewTrail there = punchTrail(5, 9);
    there.limb = "right-arm";
    there.settings.scale = 1.0;
    const CreatedTrail both = made(source.document, there);
    const Result<CreatedTrail> pasted = pasteTrail(both.document, copied, "right-arm", 0);
    REQUIRE(pasted);
    CHECK(pasted->trailId == both.trailId);
    const rig::TrailSettings& settings = findTrail(pasted->document, both.trailId)->settings;
    CHECK(settings.scale == 2.0);
    CHECK(settings.startFrame == 5.0);
    REQUIRE(settings.spheres.size() == 1); // The one that would lie past the end is left out.
    CHECK(settings.spheres.front().frame == 7.0);
  }
  SECTION("a limb whose trail was applied: what is pasted is not yet") {
    NewTrail there = punchTrail(5, 9);
    there.limb = "right-arm";
    const CreatedTrail both = made(source.document, there);
    const Result<Document> applied = applyTrail(both.document, both.trailId);
    REQUIRE(applied);
    const Result<CreatedTrail> pasted = pasteTrail(*applied, copied, "right-arm", 0);
    REQUIRE(pasted);
    CHECK_FALSE(findTrail(pasted->document, both.trailId)->applied);
  }
}

TEST_CASE("Edits of a trail that is not there are refused") {
  const Document document = test::boxer();
  for (const Result<Document>& refused :
       {setTrailSettings(document, 7, {}), setConnected(document, 7, true), setFollow(document, 7, true),
        setBlend(document, 7, 1.0), applyTrail(document, 7), deleteTrail(document, 7)}) {
    CHECK(test::refusal(refused) == "trail 7: there is no such trail; select a trail");
  }
}

TEST_CASE("A clip is marked as a loop once and unmarked again") {
  const Document once = setLooping(setLooping(test::boxer(), 0, true), 0, true);
  CHECK(once.loopingClips == std::vector<int>{0});
  CHECK(setLooping(once, 0, false).loopingClips.empty());
  const Document both = setLooping(setLooping(test::boxer(), 1, true), 0, true);
  CHECK(both.loopingClips == std::vector<int>{0, 1}); // in whatever order they were marked
  CHECK(setLooping(both, 0, false).loopingClips == std::vector<int>{1});
}

TEST_CASE("A trail that is pasted on a clip of another rate lies at the same time there") {
  Document start = made(test::boxer(), punchTrail(5, 10)).document;
  std::vector<Clip> clips = *start.clips;
  clips.push_back(clips.front());
  clips.back().framesPerSecond *= 2.0;
  start.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  start.trails.front().settings.releaseFrames = 3.0;
  const Result<CreatedTrail> pasted = pasteTrail(start, start.trails.front(), "left-arm", 1);
  REQUIRE(pasted);
  const rig::Trail& trail = *findTrail(pasted->document, pasted->trailId);
  CHECK(trail.clip == 1);
  CHECK(trail.settings.startFrame == 10.0);
  CHECK(trail.settings.endFrame == 20.0);
  CHECK(trail.settings.releaseFrames == 6.0);
}

TEST_CASE("A trail that was copied from a clip that is gone is pasted at the frames that it had") {
  rig::Trail copied = made(test::boxer(), punchTrail(5, 10)).document.trails.front();
  copied.clip = 3; // imported, and undone since
  const Result<CreatedTrail> pasted = pasteTrail(test::boxer(), copied, "right-arm", 0);
  INFO(test::refusal(pasted));
  REQUIRE(pasted);
  const rig::Trail& trail = *findTrail(pasted->document, pasted->trailId);
  CHECK(trail.clip == 0);
  CHECK(trail.limb == "right-arm");
  CHECK(trail.settings.startFrame == 5.0);
  CHECK(trail.settings.endFrame == 10.0);
}

TEST_CASE("A new trail gets the colour that its clip's trails use least, the next in turn of equal ones") {
  Document document = test::boxer();
  CHECK(freeColour(document, 0) == 0);
  document.trails.resize(1);
  CHECK(freeColour(document, 0) == 1);
  CHECK(freeColour(document, 1) == 0);           // those of another clip are not seen beside it
  document.trails.front().colour = dealtColours; // looks as the first one
  CHECK(freeColour(document, 0) == 1);
  document.nextTrailId = 3;
  CHECK(freeColour(document, 0) == 2);
  document.nextTrailId = dealtColours;
  CHECK(freeColour(document, 0) == dealtColours - 1);
  document.trails.front().colour = dealtColours - 1;
  CHECK(freeColour(document, 0) == 0);
}

TEST_CASE("A blend or a colour beyond those that there are is the nearest one that there is") {
  const CreatedTrail created = made(test::boxer(), punchTrail(0, 10));
  for (const auto& [asked, given] : {std::pair(3.0, 2.0), std::pair(-1.0, 0.0), std::pair(0.5, 0.5)}) {
    const Result<Document> blended = setBlend(created.document, created.trailId, asked);
    REQUIRE(blended);
    CHECK(findTrail(*blended, created.trailId)->settings.blend == given);
  }
  const Result<Document> shown = setTrailDisplay(created.document, created.trailId, {-2, false, true});
  REQUIRE(shown);
  const rig::Trail& trail = *findTrail(*shown, created.trailId);
  CHECK(trail.colour == 0);
  CHECK_FALSE(trail.visible);
  CHECK(trail.pinned);
}

TEST_CASE("What is pasted moves the character as what was copied does, and has its spheres") {
  NewTrail wanted = punchTrail(2, 8);
  wanted.exaggerated = true; // and not connected
  wanted.settings.spheres = {{2.0, Vec3(0.1, 0.0, 0.0)}, {8.0, Vec3(0.2, 0.0, 0.0)}};
  Document start = made(test::boxer(), wanted).document;
  start.trails.front().controlFrames = {2.0, 5.0, 8.0};
  const rig::Trail copied = start.trails.front();
  const Result<CreatedTrail> beside = pasteTrail(start, copied, "right-arm", 0);
  REQUIRE(beside);
  const rig::Trail& fresh = *findTrail(beside->document, beside->trailId);
  CHECK(fresh.controlFrames == std::vector<double>{2.0, 5.0, 8.0});
  CHECK(fresh.exaggerated);
  CHECK_FALSE(fresh.connected);
  for (const bool isConnected : {true, false}) {
    NewTrail there = punchTrail(4, 10);
    there.limb = "right-arm";
    there.connected = isConnected;
    const CreatedTrail both = made(start, there);
    const Result<CreatedTrail> onto = pasteTrail(both.document, copied, "right-arm", 0);
    REQUIRE(onto);
    const rig::Trail& changed = *findTrail(onto->document, both.trailId);
    CHECK(changed.exaggerated);
    CHECK_FALSE(changed.connected);
    REQUIRE(changed.settings.spheres.size() == 2); // at both of its ends, which are within it
    CHECK(changed.settings.spheres[0].frame == 4.0);
    CHECK(changed.settings.spheres[1].frame == 10.0);
  }
}
