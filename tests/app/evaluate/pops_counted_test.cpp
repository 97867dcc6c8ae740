// Limbs that pop and limbs that flip, against a count by the words of pops.h.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/pops.h"
#include "core/math/rotation.h"
#include "rig/motion/evaluate.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::app;

namespace {

using Points = std::vector<std::vector<Vec3>>; ///< For each frame those of a limb.

/// The punching biped, whose own clip moves; its hips sink and come back by offsets.
Document sinking(double share, double rate, bool alsoHops) {
  const test::MovingBiped moving = test::punchingBiped();
  Document document;
  document.scene = std::make_shared<const Scene>(moving.scene);
  document.body = moving.body;
  Clip clip = moving.clip;
  clip.framesPerSecond = rate;
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  rig::Adjustment hips{"hips", 0, std::nullopt, {}};
  const double last = std::floor(clip.endSeconds * rate);
  for (const auto& [part, low] :
       {std::pair(0.0, 0.0), {0.5, share}, {0.75, 0.0}, {1.0, alsoHops ? share : 0.0}}) {
    rig::OffsetKey key;
    key.frame = std::round(part * last);
    key.move = Vec3(0.0, -low, 0.0);
    hips.keys.push_back(key);
  }
  const Result<Document> posed = placeAdjustments(document, std::vector<rig::Adjustment>{hips});
  REQUIRE(posed);
  return *posed;
}

double bent(const Points& points, std::size_t frame, std::size_t joint) {
  return glm::length(points[frame - 1][joint] - 2.0 * points[frame][joint] + points[frame + 1][joint]);
}

/// The hardest of some joints over a frame and those beside it, as far as these have neighbours.
double hardest(const Points& points, std::size_t frame, const std::vector<std::size_t>& joints) {
  double most = 0.0;
  for (std::size_t near = std::max<std::size_t>(frame, 2) - 1; near <= frame + 1; ++near) {
    for (const std::size_t joint : joints) {
      most = near + 1 < points.size() ? std::max(most, bent(points, near, joint)) : most;
    }
  }
  return most;
}

double turned(const Points& points, std::size_t frame) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < points[frame].size(); ++i) {
    most = std::max(most, angleBetween(points[frame - 1][i + 1] - points[frame - 1][i],
                                       points[frame][i + 1] - points[frame][i]));
  }
  return most * 180.0 / pi;
}

/// The pop and the flips of a limb, as far as there are.
std::vector<LimbPop> counted(const rig::Limb& limb, const Points& source, const Points& moved, double rate) {
  std::vector<LimbPop> told;
  std::vector<std::size_t> inner;
  for (std::size_t i = 1; i + 1 < moved[0].size(); ++i) {
    inner.push_back(i);
  }
  const std::vector<std::size_t> ends{0, moved[0].size() - 1};
  for (std::size_t frame = 1; frame + 1 < moved.size(); ++frame) {
    double joint = 0.0;
    for (const std::size_t i : inner) {
      joint = std::max(joint, bent(moved, frame, i));
    }
    const double end = std::max(hardest(moved, frame, ends), 0.001 * limb.restLength);
    const bool isOurs = joint > 2.0 * hardest(source, frame, inner);
    if (isOurs && joint > 0.01 * limb.restLength && joint > 4.0 * end &&
        (told.empty() || joint / end > told[0].times)) {
      told = {{limb.id, static_cast<double>(frame), joint / end, 0.0, 0.0, {}, {}}};
    }
  }
  LimbPop flips{limb.id, 0.0, 0.0, 0.0, 0.0, {}, {}};
  for (std::size_t frame = 1; frame < moved.size(); ++frame) {
    double before = 0.0;
    for (std::size_t near = std::max<std::size_t>(frame, 2) - 1; near <= frame + 1; ++near) {
      before = near < source.size() ? std::max(before, turned(source, near)) : before;
    }
    const double now = turned(moved, frame);
    if (now - 2.0 * before <= std::max(45.0, 45.0 * 24.0 / rate)) {
      continue;
    }
    flips.flipFrames.push_back(static_cast<std::int64_t>(frame));
    if (now - 2.0 * before > flips.turnDegrees - 2.0 * flips.sourceDegrees) {
      flips.frame = static_cast<double>(frame);
      flips.turnDegrees = now;
      flips.sourceDegrees = before;
    }
  }
  if (!flips.flipFrames.empty()) {
    told.push_back(flips);
  }
  return told;
}

std::vector<LimbPop> countedIn(const Document& document, std::int64_t first, std::int64_t last) {
  const Clip& clip = clipOf(document, 0);
  const rig::MotionState motion = prepareMotion(document, 0);
  std::vector<LimbPop> pops;
  for (const rig::Limb& limb : document.body.limbs) {
    if (!rig::hasElbowOrKnee(limb)) {
      continue;
    }
    Points source;
    Points moved;
    for (std::int64_t frame = first; frame <= last; ++frame) {
      const double seconds = static_cast<double>(frame) / clip.framesPerSecond;
      source.push_back(rig::limbPoints(limb, rig::sampledFrame(*document.scene, clip, seconds)));
      moved.push_back(rig::limbPoints(limb, rig::evaluateMotion(*document.scene, clip, motion, seconds)));
    }
    for (LimbPop& pop : counted(limb, source, moved, clip.framesPerSecond)) {
      pop.frame += static_cast<double>(first);
      std::ranges::for_each(pop.flipFrames, [&](std::int64_t& frame) { frame += first; });
      pops.push_back(pop);
    }
  }
  return pops;
}

} // namespace

TEST_CASE(
    "What pops and what flips is what a count over every frame says, at any rate and in any part of a clip") {
  std::size_t popped = 0;
  std::size_t flipped = 0;
  std::size_t still = 0;
  for (const double rate : {12.0, 24.0, 60.0}) {
    for (const double share : {0.0, 0.02, 0.1, 0.9, 1.2}) {
      const bool alsoHops = share > 0.5;
      const Document document = sinking(share, rate, alsoHops);
      const auto last = static_cast<std::int64_t>(rate);
      for (const auto& [from, to] :
           {std::pair<std::int64_t, std::int64_t>(0, last), {last / 3, last}, {0, last / 2}}) {
        CAPTURE(rate, share, from, to);
        const std::vector<LimbPop> wanted = countedIn(document, from, to);
        const std::vector<LimbPop> found = limbPops(document, prepareMotion(document, 0), {from, to});
        REQUIRE(found.size() == wanted.size());
        still += found.empty() ? 1 : 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
          CHECK(found[i].limb == wanted[i].limb);
          CHECK(found[i].freeFrames == wanted[i].freeFrames);
          CHECK(found[i].flipFrames == wanted[i].flipFrames);
          CHECK(found[i].frame == wanted[i].frame);
          CHECK(found[i].times == Approx(wanted[i].times));
          CHECK(found[i].turnDegrees == Approx(wanted[i].turnDegrees));
          CHECK(found[i].sourceDegrees == Approx(wanted[i].sourceDegrees).margin(1e-9));
          popped += found[i].times > 0.0 ? 1 : 0;
          flipped += found[i].flipFrames.empty() ? 0 : 1;
        }
      }
    }
  }
  CHECK(popped > 5);
  CHECK(flipped > 1);
  CHECK(still > 3);
}

TEST_CASE("What pops in a clip itself is its own, whatever offsets stand beside it") {
  test::MovingBiped moving = test::still(test::namedBody());
  for (const auto& [joint, angle] : {std::pair("thigh.l", -0.12), {"shin.l", 0.24}}) { // for one frame
    const auto turned = [most = angle](double share) { return axisAngle(Vec3(1.0, 0.0, 0.0), share * most); };
    moving.clip.tracks.emplace_back(test::rotationTrack(moving.node.at(joint), Interpolation::linear,
                                                        {{0.0, turned(0.0)},
                                                         {9.0 / 24.0, turned(0.0)},
                                                         {10.0 / 24.0, turned(1.0)},
                                                         {11.0 / 24.0, turned(0.0)},
                                                         {1.0, turned(0.0)}}));
  }
  moving.clip.endSeconds = 1.0;
  Document document;
  document.scene = std::make_shared<const Scene>(moving.scene);
  document.body = moving.body;
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{moving.clip});
  Points knee;
  for (int frame = 0; frame <= 24; ++frame) {
    knee.push_back(rig::limbPoints(*findLimb(document, "left-leg"),
                                   rig::sampledFrame(moving.scene, moving.clip, frame / 24.0)));
  }
  const std::size_t last = knee[10].size() - 1;
  REQUIRE(bent(knee, 10, 1) > 4.0 * std::max(bent(knee, 10, 0), bent(knee, 10, last))); // it would be told
  rig::Adjustment lean{"spine-top", 0, std::nullopt, {rig::OffsetKey{}}};
  lean.keys[0].turn = Vec3(0.0, 0.0, 0.1);
  const Result<Document> leaning = placeAdjustments(document, std::vector<rig::Adjustment>{lean});
  REQUIRE(leaning);
  for (const Document& one : {document, *leaning}) {
    CHECK(limbPops(one, prepareMotion(one, 0), {}).empty());
  }
}
