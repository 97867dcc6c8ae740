#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/body/limb_edits.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/keyed_clip.h"
#include "core/math/rotation.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document orFail(const Result<Document>& edited) {
  INFO((edited ? std::string() : edited.error().line()));
  REQUIRE(edited);
  return *edited;
}

rig::Trail& trailOf(Document& document, const std::string& limb) {
  for (rig::Trail& trail : document.trails) {
    if (trail.limb == limb) {
      return trail;
    }
  }
  FAIL("no trail of " + limb);
  return document.trails.front();
}

Mat3 turnedView(double radians) {
  return glm::mat3_cast(axisAngle(Vec3(0.0, 1.0, 0.0), radians));
}

// A stretched spine that carries a stretched arm, seen from a camera, and weight on the other arm.
Document busyBoxer() {
  Document document = test::boxer();
  for (const char* const limb : {"spine", "left-arm"}) {
    NewTrail wanted;
    wanted.limb = limb;
    wanted.settings.startFrame = 2.0;
    wanted.settings.endFrame = 10.0;
    wanted.settings.scale = 1.5;
    wanted.settings.spheres = {{6.0, Vec3(0.05, 0.1, 0.0)}};
    wanted.connected = true;
    const Result<CreatedTrail> created = createTrail(document, wanted);
    REQUIRE(created);
    document = created->document;
  }
  rig::Trail& arm = trailOf(document, "left-arm");
  arm.settings.space = rig::TrailSpace::view;
  arm.settings.viewAxes = turnedView(0.7);
  arm.settings.axes = {true, false, true};
  return orFail(setWeight(document, {"right-arm", 0, true, {}}));
}

Document withShorterArm(const Document& document, const std::string& id) {
  rig::Limb arm = *findLimb(document, id);
  arm.joints.erase(arm.joints.begin());
  arm.restLength = 0.3;
  return orFail(correctLimb(document, arm));
}

// The clips, with a key of one of them turned on.
std::shared_ptr<const std::vector<Clip>> clipsTurned(const Document& document, std::size_t clip) {
  std::vector<Clip> clips = *document.clips;
  const auto turning = std::ranges::find_if(clips[clip].tracks, [](const auto& track) {
    return track->channel == Channel::rotation && track->times.size() > 2;
  });
  REQUIRE(turning != clips[clip].tracks.end());
  turning->edit([](Track& track) {
    for (std::size_t key = 4; key + 3 < track.values.size(); key += 4) {
      // A turn of 0.6 radians about x, whatever it was.
      std::fill_n(track.values.begin() + static_cast<std::ptrdiff_t>(key), 4, 0.0F);
      track.values[key] = std::sin(0.3F);
      track.values[key + 3] = std::cos(0.3F);
    }
  });
  return std::make_shared<const std::vector<Clip>>(std::move(clips));
}

rig::Adjustment hipsLowered(double frame) {
  rig::Adjustment adjustment;
  adjustment.controller = "hips";
  adjustment.rangeFrames = Vec2(2.0, 16.0);
  adjustment.keys = {{.frame = frame, .move = {0.0, -0.2, 0.1}}};
  return adjustment;
}

// The right hand, which no trail moves and which rests in the clip, held at a place of its own.
rig::Pin pinAt(double startFrame) {
  rig::Pin pin;
  pin.limb = "right-arm";
  pin.time.rangeFrames = Vec2(startFrame, 14.0);
  pin.place = rig::HeldPlace{Vec3(-0.5, 1.2, 0.3), Quat(1.0, 0.0, 0.0, 0.0)};
  return pin;
}

struct Change {
  std::string name;
  std::function<void(Document&)> make;
};

// Everything that a frame is made from, each changed by itself.
std::vector<Change> changes() {
  const auto arm = [](auto&& change) {
    return [change](Document& d) { change(trailOf(d, "left-arm").settings); };
  };
  using Settings = rig::TrailSettings;
  return {
      {"a limb corrected", [](Document& d) { d = withShorterArm(d, "left-arm"); }},
      {"a limb with weight corrected", [](Document& d) { d = withShorterArm(d, "right-arm"); }},
      {"the pivot", arm([](Settings& s) { s.pivot = rig::Pivot::end; })},
      {"the view's axes", arm([](Settings& s) { s.viewAxes = turnedView(-0.4); })},
      {"the space", arm([](Settings& s) { s.space = rig::TrailSpace::root; })},
      {"the end of the range", arm([](Settings& s) { s.endFrame = 14.0; })},
      {"the start of the range", arm([](Settings& s) { s.startFrame = 0.0; })},
      {"the scale", arm([](Settings& s) { s.scale = 0.6; })},
      {"the spheres set by hand",
       [](Document& d) {
         trailOf(d, "left-arm").controlFrames = {2.0, 5.0, 10.0};
       }},
      {"an inner trail", [](Document& d) { trailOf(d, "spine").settings.scale = 0.7; }},
      {"an inner trail let go", [](Document& d) { trailOf(d, "spine").connected = false; }},
      {"a loop",
       [](Document& d) {
         trailOf(d, "left-arm").settings.releaseFrames = 15.0;
         d = setLooping(d, 0, true);
       }},
      {"the frame rate", [](Document& d) { setFramesPerSecond(d, 24.0); }},
      {"the limb that has weight",
       [](Document& d) {
         d = orFail(setWeight(removeWeight(d, "right-arm", 0), {"spine", 0, true, {}}));
       }},
      {"a trail under the weight",
       [](Document& d) {
         NewTrail wanted;
         wanted.limb = "right-arm";
         wanted.settings.endFrame = 10.0;
         wanted.settings.spheres = {{5.0, Vec3(0.0, 0.3, 0.2)}};
         wanted.connected = true;
         const Result<CreatedTrail> created = createTrail(d, wanted);
         REQUIRE(created);
         d = created->document;
       }},
      {"keys of the clip", [](Document& d) { d.clips = clipsTurned(d, 0); }},
      {"a loop alone", [](Document& d) { d = setLooping(d, 0, true); }},
      {"an offset", [](Document& d) { d = orFail(placeAdjustments(d, std::vector{hipsLowered(8.0)})); }},
      {"a pin",
       [](Document& d) {
         d = orFail(placeHolds(d, {{pinAt(8.0)}, {}, {}}));
       }},
      {"how the weight is damped", [](Document& d) { d.weights.front().settings.damping = 0.1; }},
  };
}

void checkAnswers(EvaluationCache& cache, const Document& document) {
  const rig::MotionState motion = prepareMotion(document, 0);
  for (const double frame : {0.0, 5.0, 9.0, 12.0, 17.5}) {
    const double timeSeconds = frame / clipOf(document, 0).framesPerSecond;
    const FrameState fresh = evaluate(document, motion, timeSeconds);
    const FrameState& cached = cache.frame(document, 0, timeSeconds);
    CAPTURE(frame);
    CHECK(cached.worlds == fresh.worlds);
    CHECK(cached.stretch == fresh.stretch);
    const std::vector<rig::PlacedController> placed = EvaluationCache().controllers(document, 0, timeSeconds);
    CHECK(std::ranges::equal(cache.controllers(document, 0, timeSeconds), placed,
                             [](const rig::PlacedController& a, const rig::PlacedController& b) {
                               return a.id == b.id && a.placeWorld == b.placeWorld &&
                                      a.orientationWorld == b.orientationWorld;
                             }));
  }
  CHECK(std::ranges::equal(cache.weightReports(document, 0), weightReports(document, 0), {},
                           &WeightReport::longest, &WeightReport::longest));
  for (const std::size_t samplesPerFrame : {std::size_t{1}, std::size_t{3}}) {
    const std::vector<TrailPaths> fresh = trailPaths(document, motion, samplesPerFrame);
    const std::vector<TrailPaths>& cached = cache.paths(document, 0, samplesPerFrame);
    REQUIRE(cached.size() == fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      CHECK(cached[i].drawn.exaggerated == fresh[i].drawn.exaggerated);
      CHECK(cached[i].drawn.original == fresh[i].drawn.original);
      CHECK(cached[i].spheres.frames == fresh[i].spheres.frames);
      CHECK(cached[i].spheres.exaggerated == fresh[i].spheres.exaggerated);
    }
  }
}

} // namespace

TEST_CASE("the cache sees every change that a frame is made from, and its undoing") {
  const Document before = busyBoxer();
  for (const Change& change : changes()) {
    EvaluationCache cache;
    checkAnswers(cache, before);
    Document after = before;
    change.make(after);
    INFO(change.name);
    checkAnswers(cache, after);
    checkAnswers(cache, before);
  }
}

TEST_CASE("the cache sees a body whose bones are longer, whether or not it is adjusted or held") {
  for (const auto& [name, make] :
       {std::pair<const char*, Document (*)()>{"trails", busyBoxer},
        {"offsets", [] { return orFail(placeAdjustments(busyBoxer(), std::vector{hipsLowered(8.0)})); }},
        {"a pin",
         [] {
           return orFail(placeHolds(busyBoxer(), {{pinAt(8.0)}, {}, {}}));
         }},
        {"nothing", test::boxer}}) {
    INFO(name);
    const Document before = make();
    Document after = before;
    Scene scene = *before.scene;
    scene.nodes[at(findLimb(before, "left-arm")->endNode)].rest.translation.x += 0.2;
    after.scene = std::make_shared<const Scene>(std::move(scene));
    EvaluationCache cache;
    for (const Document& document : {before, after, before}) {
      checkAnswers(cache, document);
      CHECK(cache.original(document, 0, 0.3).worlds == evaluateOriginal(document, 0, 0.3).worlds);
      CHECK(cache.keyed(document, 0) == EvaluationCache().keyed(document, 0));
    }
  }
}

TEST_CASE("the cache sees other hips where a trail is told from them") {
  Document before = busyBoxer();
  trailOf(before, "left-arm").settings.space = rig::TrailSpace::root;
  Document after = before;
  after.body.hips = findLimb(before, "left-arm")->joints.back();
  EvaluationCache cache;
  checkAnswers(cache, before);
  checkAnswers(cache, after);
}

TEST_CASE("the cache sees every part of a pin that changes, and the shown keys follow it") {
  const Document without = busyBoxer();
  const Document before = orFail(placeHolds(without, {{pinAt(8.0)}, {}, {}}));
  const std::vector<std::pair<const char*, std::function<void(rig::Pin&)>>> parts{
      {"range", [](rig::Pin& pin) { pin.time.rangeFrames.x = 5.0; }},
      {"blend", [](rig::Pin& pin) { pin.time.blendFrames = Vec2(2.0, 3.0); }},
      {"place", [](rig::Pin& pin) { pin.place->position.y += 0.1; }},
      {"orientation", [](rig::Pin& pin) { pin.place->orientation = axisAngle(Vec3(0.0, 1.0, 0.0), 0.8); }},
      {"turn", [](rig::Pin& pin) { pin.turns = false; }},
      {"stretch", [](rig::Pin& pin) { pin.stretch = 0.0; }},
      {"limb", [](rig::Pin& pin) { pin.limb = "left-arm"; }}};
  for (const auto& [name, change] : parts) {
    INFO(name);
    rig::Pin pin = pinAt(8.0);
    change(pin);
    const Document after = orFail(placeHolds(without, {{pin}, {}, {}}));
    EvaluationCache cache;
    for (const Document& document : {before, after, without, after, before}) {
      checkAnswers(cache, document);
      CHECK(cache.keyed(document, 0) == EvaluationCache().keyed(document, 0));
    }
    // The hand rests where it is held: there is nothing that these two could change of the keys.
    const bool movesNothing = std::string_view(name) == "turn" || std::string_view(name) == "stretch";
    CHECK((EvaluationCache().keyed(before, 0) == EvaluationCache().keyed(after, 0)) == movesNothing);
  }
}

TEST_CASE("the cache sees that keys are to stand elsewhere") {
  NewTrail bent;
  bent.limb = "left-arm";
  bent.settings.startFrame = 12.0;
  bent.settings.endFrame = 18.0;
  bent.settings.spheres = {{15.0, Vec3(0.0, 0.1, 0.0)}};
  bent.connected = true;
  const Result<CreatedTrail> created = createTrail(test::boxer(), bent);
  REQUIRE(created);
  const Document document = orFail(applyTrail(created->document, created->trailId));
  EvaluationCache cache;
  for (const rig::KeyPlaces places : {rig::KeyPlaces::needed, rig::KeyPlaces::wholeFrames,
                                      rig::KeyPlaces::everyFrame, rig::KeyPlaces::needed}) {
    CHECK(cache.keyed(document, 0, places) == EvaluationCache().keyed(document, 0, places));
  }
  const Clip everyFrame = cache.keyed(document, 0, rig::KeyPlaces::everyFrame);
  CHECK(everyFrame != cache.keyed(document, 0, rig::KeyPlaces::needed));
}

TEST_CASE("the cache tells two clips of one length apart, and the edited clip from its source") {
  Document document = busyBoxer();
  std::vector<Clip> clips = *document.clips;
  clips.push_back(clipsTurned(document, 0)->front());
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  std::vector<rig::Trail> others = document.trails;
  for (rig::Trail& trail : others) {
    trail.id = document.nextTrailId++;
    trail.clip = 1;
    document.trails.push_back(trail);
  }
  for (const int clip : {0, 1}) {
    rig::Adjustment lowered = hipsLowered(8.0);
    lowered.clip = clip;
    document = orFail(placeAdjustments(document, std::vector{lowered}));
  }
  EvaluationCache cache;
  for (const int clip : {0, 1, 0}) {
    const rig::MotionState motion = prepareMotion(document, clip);
    for (const double seconds : {0.1, 0.3, 0.5}) {
      CHECK(cache.frame(document, clip, seconds).worlds == evaluate(document, motion, seconds).worlds);
      CHECK(cache.original(document, clip, seconds).worlds ==
            evaluateOriginal(document, clip, seconds).worlds);
    }
  }
  Document edited = document;
  edited.sourceClips = document.clips;
  edited.clips = clipsTurned(document, 0);
  CHECK(cache.original(edited, 0, 0.3).worlds == cache.original(document, 0, 0.3).worlds);
  CHECK(cache.original(edited, 0, 0.3).worlds == evaluateOriginal(edited, 0, 0.3).worlds);
}

TEST_CASE("the original of a clip is its source, also where the same keys were a source themselves") {
  const Document plain = test::boxer();
  Document edited = plain;
  edited.sourceClips = clipsTurned(plain, 0);
  EvaluationCache cache;
  for (const Document& document : {plain, edited, plain}) {
    CHECK(cache.original(document, 0, 0.3).worlds == evaluateOriginal(document, 0, 0.3).worlds);
  }
  CHECK_FALSE(evaluateOriginal(plain, 0, 0.3).worlds == evaluateOriginal(edited, 0, 0.3).worlds);
}

TEST_CASE("a body is measured once, however often it is posed, and again where its limbs are others") {
  const Document before = orFail(placeAdjustments(test::boxer(), std::vector{hipsLowered(8.0)}));
  EvaluationCache cache;
  const std::vector<rig::ControllerShape>* const shapes = &cache.shapes(before, 0);
  REQUIRE_FALSE(shapes->empty());
  const rig::ControllerShape* const first = shapes->data();
  const Document posed = orFail(placeAdjustments(before, std::vector{hipsLowered(9.0)}));
  CHECK(cache.shapes(posed, 0).data() == first);
  const Document corrected = withShorterArm(before, "left-arm");
  CHECK(cache.shapes(corrected, 0).data() != first);
}
