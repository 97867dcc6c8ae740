#include "app/forecast/clip_changes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "tests/support/app/posed_file.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr int guardClip = 1; // a loop

NodeIndex nodeNamed(const Document& document, const char* name) {
  const auto found = std::ranges::find(document.scene->nodes, name, &Node::name);
  REQUIRE(found != document.scene->nodes.end());
  return NodeIndex(static_cast<std::size_t>(found - document.scene->nodes.begin()));
}

Document withClips(Document document, const std::function<void(std::vector<Clip>&)>& change) {
  std::vector<Clip> clips = *document.clips;
  change(clips);
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  return document;
}

Document withTrack(const Document& document, int clip, const char* node, Channel channel,
                   const std::function<void(Track&)>& change) {
  return withClips(document, [&](std::vector<Clip>& clips) {
    Clip& changed = clips[static_cast<std::size_t>(clip)];
    const int place = findTrack(changed, nodeNamed(document, node), channel);
    REQUIRE(place >= 0);
    changed.tracks[static_cast<std::size_t>(place)].edit(change);
  });
}

std::size_t widthOf(const Track& track) {
  return static_cast<std::size_t>(track.width);
}

Vec4 keyOf(const Track& track, std::size_t key) {
  Vec4 value(0.0);
  for (std::size_t i = 0; i < widthOf(track); ++i) {
    value[static_cast<glm::length_t>(i)] = static_cast<double>(track.values[widthOf(track) * key + i]);
  }
  return value;
}

void setKey(Track& track, std::size_t key, const Vec4& value) {
  for (std::size_t i = 0; i < widthOf(track); ++i) {
    track.values[widthOf(track) * key + i] = static_cast<float>(value[static_cast<glm::length_t>(i)]);
  }
}

/// Turns a key about the x axis of the joint's parent.
void turnKey(Track& track, std::size_t key, double degrees) {
  const Vec4 value = keyOf(track, key);
  const Quat turned =
      axisAngle({1.0, 0.0, 0.0}, degrees * pi / 180.0) * Quat(value.w, value.x, value.y, value.z);
  setKey(track, key, {turned.x, turned.y, turned.z, turned.w});
}

/// The bundled character, whose guard keeps its first pose.
Document standing() {
  return withClips(test::openedFile(test::posedCharacter), [](std::vector<Clip>& clips) {
    for (CopyOnWrite<Track>& track : clips[guardClip].tracks) {
      track.edit([](Track& still) {
        for (std::size_t key = 1; key < still.times.size(); ++key) {
          setKey(still, key, keyOf(still, 0));
        }
      });
    }
  });
}

std::vector<ClipChange> worse(const Document& result, const Document& source) {
  const Result<FileChanges> changes = worseThanFile(result, source);
  REQUIRE(changes);
  return changes->worse;
}

std::optional<ClipChange> told(const std::vector<ClipChange>& changes, const std::string& id,
                               const std::string& limb = "") {
  const auto found = std::ranges::find_if(
      changes, [&](const ClipChange& change) { return change.id == id && change.limb == limb; });
  return found == changes.end() ? std::nullopt : std::optional(*found);
}

} // namespace

TEST_CASE("A foot that is moved while it stands slides, told of its leg and of no other") {
  const Document source = standing();
  for (const bool isLeft : {true, false}) {
    const Document result = withTrack(source, guardClip, isLeft ? "LeftUpLeg" : "RightUpLeg",
                                      Channel::rotation, [](Track& track) { turnKey(track, 8, 3.0); });
    const std::vector<ClipChange> changes = worse(result, source);
    const std::optional<ClipChange> slide = told(changes, "foot-slide", isLeft ? "left-leg" : "right-leg");
    REQUIRE(slide);
    CHECK(slide->clip == "Guard");
    CHECK(slide->source == Approx(0.0).margin(1e-6));
    // The leg is 0.8 long and a little bent.
    CHECK(slide->result == Approx(100.0 * 0.8 * 3.0 * pi / 180.0 / source.body.height).epsilon(0.15));
    CHECK_FALSE(told(changes, "foot-slide", isLeft ? "right-leg" : "left-leg"));
  }
}

TEST_CASE("The worst of several stands is told, not the last") {
  const auto turned = [](const Document& document, std::size_t first, std::size_t last, double degrees) {
    return withTrack(document, guardClip, "LeftUpLeg", Channel::rotation, [&](Track& track) {
      for (std::size_t key = first; key <= last; ++key) {
        turnKey(track, key, degrees);
      }
    });
  };
  const Document source = turned(standing(), 6, 10, -50.0); // the foot is lifted between two stands
  const auto slideOf = [&](const Document& result) {
    const std::optional<ClipChange> slide = told(worse(result, source), "foot-slide", "left-leg");
    return slide ? slide->result : 0.0;
  };
  const double early = slideOf(turned(source, 2, 2, 4.0));
  CHECK(early > 1.0);
  CHECK(slideOf(turned(turned(source, 2, 2, 4.0), 14, 14, 1.0)) == Approx(early));
  CHECK(slideOf(turned(turned(source, 2, 2, 1.0), 14, 14, 4.0)) == Approx(early).epsilon(0.01));
}

TEST_CASE("A body that is lowered is below the floor by as much, and one that is raised is not told") {
  const Document source = test::openedFile(test::posedCharacter);
  const auto lowered = [&](double by) {
    return withTrack(source, guardClip, "Hips", Channel::translation, [&](Track& track) {
      for (std::size_t key = 0; key < track.times.size(); ++key) {
        setKey(track, key, keyOf(track, key) - Vec4(0.0, by, 0.0, 0.0));
      }
    });
  };
  const std::optional<ClipChange> below = told(worse(lowered(0.1), source), "below-floor");
  REQUIRE(below);
  CHECK(below->result - below->source == Approx(100.0 * 0.1 / source.body.height).epsilon(0.05));
  CHECK_FALSE(told(worse(lowered(-0.1), source), "below-floor"));
  CHECK_FALSE(told(worse(lowered(0.0005), source), "below-floor"));
}

TEST_CASE("A loop whose last pose is moved, turned or left faster closes worse by that much") {
  const Document source = test::openedFile(test::posedCharacter);
  const Document moved = withTrack(source, guardClip, "Hips", Channel::translation, [](Track& track) {
    const std::size_t last = track.times.size() - 1;
    setKey(track, last, keyOf(track, last) + Vec4(0.05, 0.0, 0.0, 0.0));
  });
  const std::optional<ClipChange> place = told(worse(moved, source), "loop-seam-place");
  REQUIRE(place);
  CHECK(place->result - place->source == Approx(100.0 * 0.05 / source.body.height).epsilon(0.05));
  const Document turned = withTrack(source, guardClip, "Head", Channel::rotation,
                                    [](Track& track) { turnKey(track, track.times.size() - 1, 8.0); });
  const std::optional<ClipChange> turn = told(worse(turned, source), "loop-seam-turn");
  REQUIRE(turn);
  CHECK(turn->result == Approx(8.0).epsilon(0.05));
  const Document faster = withTrack(source, guardClip, "Hips", Channel::translation, [](Track& track) {
    setKey(track, 1, keyOf(track, 1) + Vec4(0.02, 0.0, 0.0, 0.0));
  });
  const std::vector<ClipChange> changes = worse(faster, source);
  CHECK(told(changes, "loop-seam-speed"));
  CHECK_FALSE(told(changes, "loop-seam-place"));
  CHECK_FALSE(told(changes, "loop-seam-turn"));
}

TEST_CASE("Keys that change the hemisphere are counted") {
  const Document source = test::openedFile(test::posedCharacter);
  const Document result = withTrack(source, guardClip, "Spine", Channel::rotation,
                                    [](Track& track) { setKey(track, 2, -keyOf(track, 2)); });
  const std::optional<ClipChange> flips = told(worse(result, source), "hemisphere-flips");
  REQUIRE(flips);
  CHECK(flips->result - flips->source == 2.0);
  const Document once = withTrack(source, guardClip, "Spine", Channel::rotation, [](Track& track) {
    setKey(track, track.times.size() - 1, -keyOf(track, track.times.size() - 1));
  });
  const std::optional<ClipChange> one = told(worse(once, source), "hemisphere-flips");
  REQUIRE(one);
  CHECK(one->result - one->source == 1.0);
}

TEST_CASE("Clips are compared by their names, wherever they stand, and one that is gone with none") {
  const Document source = test::openedFile(test::posedCharacter);
  const Document swapped = withClips(source, [](std::vector<Clip>& clips) { std::swap(clips[0], clips[1]); });
  CHECK(worse(swapped, source).empty());
  const Document renamed =
      withClips(source, [](std::vector<Clip>& clips) { clips[0].name = "Something else"; });
  CHECK(worse(renamed, source).empty());
  // Of two with one name each is compared with the one at its place.
  const auto sameNames = [](std::vector<Clip>& clips) { clips[1].name = clips[0].name; };
  CHECK(worse(withClips(source, sameNames), withClips(source, sameNames)).empty());
}

TEST_CASE("Clips of one of two files alone are told, each of its file") {
  const Document source = test::openedFile(test::posedCharacter);
  const std::string first = clipOf(source, 0).name;
  const std::string second = clipOf(source, 1).name;
  const Document result = withClips(source, [](std::vector<Clip>& clips) {
    clips = {clips[1], clips[0], clips[1]};
    clips[0].name = "Added";
    clips[2].name = "Added, too";
  });
  const Result<FileChanges> changes = worseThanFile(result, source);
  REQUIRE(changes);
  CHECK(changes->compared == std::vector<std::string>{first});
  CHECK(changes->gone == std::vector<std::string>{second});
  CHECK(changes->added == std::vector<std::string>{"Added", "Added, too"});
}

TEST_CASE("A file whose limbs have other joints is refused by its name") {
  const Document source = test::openedFile(test::posedCharacter);
  Document other = source;
  Scene scene = *source.scene;
  scene.nodes[at(source.body.limbs.back().joints.back())].name = "Other";
  other.scene = std::make_shared<const Scene>(std::move(scene));
  const Result<FileChanges> changes = worseThanFile(other, source);
  REQUIRE_FALSE(changes);
  CHECK_THAT(changes.error().line(),
             Catch::Contains("is not the file that the other was made from") && Catch::Contains("dummy.glb"));
}

TEST_CASE(
    "How sharply a loop turns at its seam is told in heights a second, on whichever side of it that is") {
  const Document source = standing();
  const auto turns = [&](double second, double beforeLast) {
    const Document result = withTrack(source, guardClip, "Hips", Channel::translation, [&](Track& track) {
      const std::size_t before = track.times.size() - 2;
      setKey(track, 1, keyOf(track, 1) + Vec4(second, 0.0, 0.0, 0.0));
      setKey(track, before, keyOf(track, before) + Vec4(beforeLast, 0.0, 0.0, 0.0));
    });
    const std::optional<ClipChange> speed = told(worse(result, source), "loop-seam-speed");
    return speed ? speed->result - speed->source : 0.0;
  };
  const double once = 100.0 * 0.02 * 24.0 / source.body.height; // at 24 fps
  CHECK(turns(0.02, 0.0) == Approx(once).epsilon(1e-3));
  CHECK(turns(0.0, 0.02) == Approx(once).epsilon(1e-3));
  CHECK(turns(0.02, 0.02) == Approx(2.0 * once).epsilon(1e-3));
  CHECK(turns(0.02, -0.02) == 0.0); // It goes on over the seam as it comes to it.
}

TEST_CASE("A body that morph targets may change is as far below the floor as one without") {
  const auto morphing = [](Document document) {
    Scene scene = *document.scene;
    scene.meshes.front().primitives.front().morphTargets.emplace_back();
    document.scene = std::make_shared<const Scene>(std::move(scene));
    REQUIRE(wholeSurface(*document.scene) == nullptr);
    return document;
  };
  const Document source = test::openedFile(test::posedCharacter);
  const Document lowered = withTrack(source, guardClip, "Hips", Channel::translation, [](Track& track) {
    for (std::size_t key = 0; key < track.times.size(); ++key) {
      setKey(track, key, keyOf(track, key) - Vec4(0.0, 0.1, 0.0, 0.0));
    }
  });
  const std::optional<ClipChange> plain = told(worse(lowered, source), "below-floor");
  const std::optional<ClipChange> morphed = told(worse(morphing(lowered), morphing(source)), "below-floor");
  REQUIRE(plain);
  REQUIRE(morphed);
  CHECK(morphed->result == Approx(plain->result).epsilon(1e-3));
  CHECK(morphed->source == Approx(plain->source).epsilon(1e-3).margin(1e-3));
}

TEST_CASE(
    "What closes a loop worse is told from a thousandth of the height, half a degree and a hundredth of the "
    "height a second on") {
  const Document source = standing();
  const double height = source.body.height;
  const auto isTold = [&](const Document& result, const char* id) {
    return told(worse(result, source), id).has_value();
  };
  const auto moved = [&](std::size_t keysBeforeLast, double by) {
    return withTrack(source, guardClip, "Hips", Channel::translation, [&](Track& track) {
      const std::size_t key = track.times.size() - 1 - keysBeforeLast;
      setKey(track, key, keyOf(track, key) + Vec4(by, 0.0, 0.0, 0.0));
    });
  };
  const auto turned = [&](double degrees) {
    return withTrack(source, guardClip, "Head", Channel::rotation,
                     [&](Track& track) { turnKey(track, track.times.size() - 1, degrees); });
  };
  CHECK(isTold(moved(0, 0.0011 * height), "loop-seam-place"));
  CHECK_FALSE(isTold(moved(0, 0.0009 * height), "loop-seam-place"));
  CHECK(isTold(turned(0.55), "loop-seam-turn"));
  CHECK_FALSE(isTold(turned(0.45), "loop-seam-turn"));
  // Of a frame of 1/24 s.
  CHECK(isTold(moved(1, 0.011 * height / 24.0), "loop-seam-speed"));
  CHECK_FALSE(isTold(moved(1, 0.009 * height / 24.0), "loop-seam-speed"));
}
