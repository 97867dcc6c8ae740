// Where a foot that slides carries the body as well.
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/auto/clip_ground.h"
#include "tests/support/app/auto_clips.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The left leg is turned so at each frame, little enough that its foot stays near the ground; the right one
/// stands.
Document sliding(const std::vector<double>& angles) {
  const Document start = test::twoLeggedStepper();
  Track leg = test::turnsOf(start, "left-leg");
  for (std::size_t frame = 0; frame < angles.size(); ++frame) {
    test::addKey(leg, static_cast<double>(frame), glm::angleAxis(angles[frame], Vec3(1.0, 0.0, 0.0)));
  }
  return test::withTracks(start, {leg});
}

bool slidesAt(const ClipGround& ground, double frame) {
  for (const Vec2& slide : ground.standsOf("left-leg", true)) {
    if (slide.x <= frame && frame <= slide.y) {
      return true;
    }
  }
  return false;
}

} // namespace

TEST_CASE("A foot that slides slowly carries until the frame at which it is torn away, and from where it is "
          "slow again") {
  // Four hundredths a frame, a jump of nearly two tenths between the frames 4 and 5, and on as before.
  const std::vector<double> angles{-0.10, -0.06, -0.02, 0.02, 0.06, -0.12, -0.08, -0.04, 0.0, 0.04, 0.08};
  const Document document = sliding(angles);
  const ClipGround ground = clipGround(document, 0);
  for (const auto& [frame, slides] : {std::pair(0.0, true),
                                      {1.0, true},
                                      {3.0, true},
                                      {4.0, true},
                                      {4.5, false},
                                      {5.0, true},
                                      {7.0, true},
                                      {10.0, true}}) {
    CAPTURE(frame);
    CHECK(slidesAt(ground, frame) == slides);
  }
}

TEST_CASE(
    "A foot slides from where it is lower than a hundredth of the height, and is in the air before that") {
  // At frame 1 it is 0.024 above the ground and at frame 2 it is 0.016, of a body of 1.8.
  const Document document = sliding({-0.26, -0.22, -0.18, -0.14, -0.10, -0.06, -0.02, 0.02});
  const ClipGround ground = clipGround(document, 0);
  CHECK_FALSE(slidesAt(ground, 0.0));
  CHECK_FALSE(slidesAt(ground, 1.0));
  CHECK(slidesAt(ground, 2.0));
  CHECK(slidesAt(ground, 7.0));
}
