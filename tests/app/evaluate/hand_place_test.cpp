#include "app/evaluate/hand_place.h"

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "core/math/transform.h"
#include "rig/limb.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

PropFile clubFor(const std::vector<std::string>& hands, double frame) {
  return {.path = "club.glb", .hands = hands, .clip = 0, .frame = frame};
}

Vec3 placeOfClub(const Document& document, const PropFile& file) {
  const Result<Vec3> place = placeInHands(document, file);
  INFO(test::refusal(place));
  REQUIRE(place);
  return *place;
}

} // namespace

TEST_CASE("A thing is put where the hand is at its frame, and into the middle of two") {
  const Document document = test::boxer();
  const auto handAt = [&](const char* arm, double frame) {
    return rig::endPosition(*findLimb(document, arm), evaluateOriginal(document, 0, frame / 30.0));
  };
  const Vec3 left = handAt("left-arm", 10.0);
  const Vec3 right = handAt("right-arm", 10.0);
  REQUIRE(glm::distance(left, handAt("left-arm", 0.0)) > 0.3);
  CHECK(glm::distance(placeOfClub(document, clubFor({"left-arm"}, 10.0)), left) < 1e-9);
  CHECK(glm::distance(placeOfClub(document, clubFor({"right-arm"}, 10.0)), right) < 1e-9);
  CHECK(glm::distance(placeOfClub(document, clubFor({"left-arm", "right-arm"}, 10.0)), 0.5 * (left + right)) <
        1e-9);
}

TEST_CASE("A thing is put into the middle of the mesh that follows the hand") {
  Document document = test::boxer();
  Scene scene = *document.scene;
  Primitive mitten;
  mitten.positions = {{0.0F, -0.1F, 0.0F}, {0.2F, 0.0F, 0.0F}, {0.0F, 0.1F, 0.1F}};
  mitten.indices = {0, 1, 2};
  scene.meshes.push_back({"mitten", {mitten}, {}});
  const NodeIndex hand = findLimb(document, "left-arm")->endNode;
  scene.nodes[at(hand)].mesh = 0;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const FrameState frame = evaluateOriginal(document, 0, 10.0 / 30.0);
  const Vec3 middle = transformPoint(frame.worlds[at(hand)], Vec3(0.1, 0.0, 0.05));
  CHECK(glm::distance(placeOfClub(document, clubFor({"left-arm"}, 10.0)), middle) < 1e-6);
}

TEST_CASE("A thing that cannot be put into a hand is told why") {
  const Document document = test::boxer();
  const auto refusalOf = [&](const PropFile& file) { return test::refusal(placeInHands(document, file)); };
  using Catch::StartsWith;
  for (const int clip : {-1, 1}) {
    PropFile file = clubFor({"left-arm"}, 0.0);
    file.clip = clip;
    CHECK_THAT(refusalOf(file), StartsWith("clip " + std::to_string(clip) + ": the file has no such clip"));
  }
  CHECK_THAT(refusalOf(clubFor({}, 0.0)), StartsWith("club.glb: no hand is to hold it"));
  CHECK_THAT(refusalOf(clubFor({"left-arm"}, std::numeric_limits<double>::infinity())),
             StartsWith("club.glb: the frame at which it is taken is no number"));
  CHECK_THAT(refusalOf(clubFor({"left-arm", "tail"}, 0.0)),
             StartsWith("tail: the character has no such limb"));
  Document still = document;
  still.clips = nullptr;
  CHECK_THAT(test::refusal(placeInHands(still, clubFor({"left-arm"}, 0.0))),
             StartsWith("clip 0: the file has no such clip"));
}
