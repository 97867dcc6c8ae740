#include <cmath>

#include <catch2/catch.hpp>

#include "rig/rekey/key_times.h"
#include "rig/rekey/stretch_build.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/soft_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr std::size_t few = 50; // frames: those of some spans between two keys, not of the clip
constexpr std::size_t endless = 1000000;

MovingBiped keyedPunch() {
  MovingBiped moving = punchingBiped();
  moving.clip = keyedOnEveryFrame(moving.clip);
  return moving;
}

MotionState softLimbs(const MovingBiped& moving) {
  const auto swelling = [](double frame) {
    const double swell = std::sin(0.8 * frame);
    return SoftBones{1.0 + 0.15 * swell, 1.0 - 0.08 * swell, 1.0 + 0.06 * swell, Vec3(0.3, 0.5, 0.8), 0.0};
  };
  return softMotion(moving, {},
                    {softLimb(moving, "left-arm", swelling), softLimb(moving, "right-arm", swelling),
                     softLimb(moving, "left-leg", swelling), softLimb(moving, "right-leg", swelling)});
}

// Stretches at the eighths of every frame.
std::vector<StretchWindows> everywhere(const ChosenKeys& chosen, const Clip& clip) {
  std::vector<StretchWindows> stretched;
  for (const auto& [node, frames] : chosen.frames) {
    KeyWindow window{{clip.startSeconds, clip.endSeconds}, {}};
    for (double frame = 0.0; frame <= 24.0; frame += 0.125) {
      window.times.push_back(frame / 24.0);
    }
    stretched.push_back({node, &frames, {window}});
  }
  return stretched;
}

} // namespace

TEST_CASE("frames of a long clip are made once for all limbs that get keys, and not once for each") {
  const MovingBiped moving = keyedPunch();
  const MotionState motion = softLimbs(moving);
  const std::vector<KeyedPart> parts = keyedParts(motion);
  REQUIRE(parts.size() >= 4);
  RekeyOptions options;
  options.places = KeyPlaces::everyFrame; // short spans between keys
  options.tolerance = 0.5e-4 * moving.body.height;
  ExactMotion all(moving.scene, moving.clip, motion, endless);
  ExactMotion some(moving.scene, moving.clip, motion, few);
  const ChosenKeys fromAll = chooseKeys(all, parts, options);
  const ChosenKeys fromSome = chooseKeys(some, parts, options);
  REQUIRE(all.made() > 2 * few);
  CHECK(static_cast<double>(some.made()) < 1.3 * static_cast<double>(all.made()));
  REQUIRE(fromSome.parts.size() == parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(fromSome.parts[i].part == &parts[i]);
    CHECK(fromSome.parts[i].times == fromAll.parts[i].times);
    CHECK(fromSome.parts[i].stretchTimes == fromAll.parts[i].stretchTimes);
  }
}

TEST_CASE("frames of a long clip are made once for the stretches of all joints") {
  const MovingBiped moving = keyedPunch();
  const MotionState motion = softLimbs(moving);
  RekeyOptions options;
  options.tolerance = 0.5e-4 * moving.body.height;
  const std::vector<KeyedPart> parts = keyedParts(motion);
  ExactMotion exact(moving.scene, moving.clip, motion, endless);
  const ChosenKeys chosen = chooseKeys(exact, parts, options);
  REQUIRE(chosen.frames.size() > 3);
  ExactMotion some(moving.scene, moving.clip, motion, 70);
  const std::vector<StretchKeys> built = buildStretches(some, everywhere(chosen, moving.clip));
  CHECK(some.made() <= 24 * 8 + 1);
  REQUIRE(built.size() == chosen.frames.size());
  for (const StretchKeys& keys : built) {
    REQUIRE(keys.times.size() == 24 * 8 + 1);
    for (std::size_t i = 0; i < keys.times.size(); i += 12) {
      CAPTURE(i);
      const auto time = static_cast<double>(i) / 192.0;
      const StretchFrame wanted = chosen.frames.at(keys.node).at(exact, time);
      CHECK(keys.times[i] == static_cast<float>(time));
      CHECK(keys.scales[i] == wanted.factors);
    }
  }
}
