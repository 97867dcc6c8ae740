// Poses made from poses.
#include "app/edits/pose/pose_edits.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/files/save.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::app;
using stretch::test::Row;

namespace {

using Names = std::vector<std::string>;

Document bundledBoxer() {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  return std::move(opened).value();
}

/// Linear keys of a controller or an attribute: move, turn and value all grow by the numbers.
Document keyed(Document document, const std::string& id, const std::vector<std::pair<double, double>>& keys,
               const std::optional<Vec2>& range = std::nullopt, int clip = 0) {
  rig::Adjustment adjustment;
  adjustment.controller = id;
  adjustment.clip = clip;
  adjustment.rangeFrames = range;
  for (const auto& [frame, number] : keys) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = Vec3(number, 2.0 * number, 0.0);
    key.turn = Vec3(0.0, 0.0, 0.5 * number);
    key.value = number;
    key.interpolation = rig::KeyInterpolation::linear;
    adjustment.keys.push_back(key);
  }
  document.adjustments.push_back(adjustment);
  return document;
}

OffsetPose tween(const Document& document, double frame, double between, const Names& ids) {
  return tweenedPose(document, 0, frame, ids, between);
}

Names idsOf(const std::vector<rig::Attribute>& attributes) {
  Names ids;
  for (const rig::Attribute& attribute : attributes) {
    ids.push_back(attribute.id);
  }
  return ids;
}

std::string swapped(std::string id) {
  const bool isLeft = id.starts_with("left-");
  return isLeft ? "right-" + id.substr(5) : id.starts_with("right-") ? "left-" + id.substr(6) : id;
}

} // namespace

TEST_CASE("The controller at the end of a limb has all of its attributes, and no other one has any") {
  const Document document = bundledBoxer();
  const rig::ControllerList list = controllersOf(document);
  const std::set<std::string> ends{"left-hand", "right-hand", "left-foot", "right-foot", "head", "spine-top"};
  std::size_t found = 0;
  for (const rig::Controller& controller : list.controllers) {
    Names told;
    for (const rig::Attribute& attribute : list.attributes) {
      if (ends.contains(controller.id) && attribute.limb == controller.limb) {
        told.push_back(attribute.id);
      }
    }
    CAPTURE(controller.id);
    CHECK(idsOf(attributesHeldBy(list, controller)) == told);
    CHECK(told.empty() != ends.contains(controller.id));
    found += told.size();
  }
  CHECK(found == list.attributes.size());
  CHECK(list.controllers.size() > ends.size() + 4);
  rig::ControllerList tail;
  tail.attributes = {{"tail.stretch", rig::AttributeKind::stretch, "tail"}, list.attributes.front()};
  const rig::Controller tip{"tail-tip", rig::ControllerKind::tip, NodeIndex(1), "tail"};
  CHECK(idsOf(attributesHeldBy(tail, tip)) == Names{"tail.stretch"});
}

TEST_CASE("What is on the other side of the body is named after it, and what is in the middle is its own") {
  const Document document = bundledBoxer();
  const rig::ControllerList list = controllersOf(document);
  for (const rig::Controller& controller : list.controllers) {
    CHECK(otherSideOf(document, controller.id) == swapped(controller.id));
  }
  for (const rig::Attribute& attribute : list.attributes) {
    CHECK(otherSideOf(document, attribute.id) == swapped(attribute.id));
  }
  CHECK(otherSideOf(document, "no such thing").empty());
  Document oneArmed = test::boxer();
  std::erase_if(oneArmed.body.limbs, [](const rig::Limb& limb) { return limb.id == "right-arm"; });
  CHECK(otherSideOf(oneArmed, "left-hand").empty());
  CHECK(otherSideOf(oneArmed, "left-arm.stretch").empty());
  CHECK(otherSideOf(oneArmed, "hips") == "hips");
}

TEST_CASE("A mirrored pose has every offset reflected and its turns the other way round, with its values") {
  Row row(61);
  const Document document = test::boxer(); // It faces +Z: left is at +X.
  OffsetPose pose;
  for (const char* const id : {"left-hand", "right-elbow", "spine-top", "hips", "body"}) {
    pose.offsets.push_back({id, row.vector(1.0), row.vector(1.0)});
  }
  pose.values = {{"left-arm.stretch", 0.3}, {"right-arm.volume", 0.6}, {"spine.stretch", 0.9}};
  const Result<OffsetPose> mirrored = mirroredPose(document, 0, 4.0, pose);
  REQUIRE(mirrored);
  REQUIRE(mirrored->offsets.size() == pose.offsets.size());
  for (std::size_t i = 0; i < pose.offsets.size(); ++i) {
    const ControllerOffset& before = pose.offsets[i];
    const ControllerOffset& after = mirrored->offsets[i];
    CAPTURE(before.id);
    CHECK(after.id == swapped(before.id));
    CHECK(glm::length(after.move - before.move * Vec3(-1.0, 1.0, 1.0)) < 1e-9);
    CHECK(glm::length(after.turn - before.turn * Vec3(1.0, -1.0, -1.0)) < 1e-9);
  }
  CHECK(mirrored->values == std::vector<AttributeValue>{{"right-arm.stretch", 0.3},
                                                        {"left-arm.volume", 0.6},
                                                        {"spine.stretch", 0.9}});
}

TEST_CASE("An offset without another side refuses to be mirrored, a value without one is left out") {
  Document oneArmed = test::boxer();
  std::erase_if(oneArmed.body.limbs, [](const rig::Limb& limb) { return limb.id == "right-arm"; });
  const OffsetPose fitting{{{"hips", Vec3(0.1), {}}}, {{"left-arm.stretch", 0.5}, {"spine.stretch", 0.2}}};
  const Result<OffsetPose> mirrored = mirroredPose(oneArmed, 0, 0.0, fitting);
  REQUIRE(mirrored);
  CHECK(mirrored->values == std::vector<AttributeValue>{{"spine.stretch", 0.2}});
  OffsetPose hand = fitting;
  hand.offsets.push_back({"left-hand", Vec3(0.1), {}});
  CHECK(test::refusal(mirroredPose(oneArmed, 0, 0.0, hand)) ==
        "left-hand: has no other side; take it out of the selection");
}

TEST_CASE("A pose in lengths of its controllers fits a character of another size, less what that lacks") {
  const Document document = test::boxer();
  Document larger = document;
  for (rig::Limb& limb : larger.body.limbs) {
    limb.restLength *= 2.0;
  }
  const OffsetPose pose{{{"left-hand", {0.3, 0.6, 0.0}, {0.1, 0.2, 0.3}},
                         {"left-elbow", {0.0, 0.3, 0.0}, {0.1, 0.0, 0.0}},
                         {"LeftHand", {0.5, 0.0, 0.0}, {0.0, 0.4, 0.0}},
                         {"tail-tip", {1.0, 0.0, 0.0}, {}},
                         {"hips", {0.0, -0.6, 0.0}, {0.0, 0.5, 0.0}}},
                        {{"left-arm.stretch", 0.4}, {"tail.stretch", 0.7}, {"spine.volume", 0.1}}};
  const OffsetPose counted = inLengths(document, pose);
  CHECK(counted.values == pose.values);
  const OffsetPose fitted = inWorldUnits(larger, counted);
  CHECK(fitted.values == std::vector<AttributeValue>{{"left-arm.stretch", 0.4}, {"spine.volume", 0.1}});
  const auto offset = [](const OffsetPose& in, const std::string& id) {
    const auto found = std::ranges::find(in.offsets, id, &ControllerOffset::id);
    REQUIRE(found != in.offsets.end());
    return *found;
  };
  CHECK(glm::length(offset(counted, "left-hand").move - Vec3(0.5, 1.0, 0.0)) < 1e-12);
  CHECK(offset(counted, "left-hand").turn == Vec3(0.1, 0.2, 0.3));
  CHECK(glm::length(offset(fitted, "left-hand").move - Vec3(0.6, 1.2, 0.0)) < 1e-12);
  CHECK(offset(fitted, "left-hand").turn == Vec3(0.1, 0.2, 0.3));
  CHECK(glm::length(offset(fitted, "left-elbow").move - Vec3(0.0, 0.6, 0.0)) < 1e-12);
  CHECK(offset(fitted, "left-elbow").turn == Vec3(0.0)); // It moves and does not turn.
  CHECK(glm::length(offset(fitted, "hips").move - Vec3(0.0, -1.2, 0.0)) < 1e-12);
  CHECK(std::ranges::count(counted.offsets, "tail-tip", &ControllerOffset::id) == 0);
  CHECK(std::ranges::count(fitted.offsets, "tail-tip", &ControllerOffset::id) == 0);
}

TEST_CASE("A tween is so much of the way from the key before the frame to the one after, past them as well") {
  Document document = keyed(test::boxer(), "hips", {{2.0, 0.1}, {6.0, 0.3}, {10.0, 0.9}});
  for (const double between : {-0.5, 0.0, 0.25, 0.5, 1.0, 1.5}) {
    for (const auto& [frame, from, to] :
         {std::tuple{2.5, 0.1, 0.3}, {5.0, 0.1, 0.3}, {7.0, 0.3, 0.9}, {6.0, 0.1, 0.9}}) {
      const OffsetPose tweened = tween(document, frame, between, {"hips"});
      CAPTURE(between, frame);
      REQUIRE(tweened.offsets.size() == 1);
      CHECK(tweened.values.empty());
      const double told = from + between * (to - from);
      CHECK(tweened.offsets[0].id == "hips");
      CHECK(glm::length(tweened.offsets[0].move - Vec3(told, 2.0 * told, 0.0)) < 1e-9);
      CHECK(glm::length(tweened.offsets[0].turn - Vec3(0.0, 0.0, 0.5 * told)) < 1e-9);
    }
    for (const double outside : {0.0, 2.0, 10.0, 15.0}) {
      CAPTURE(between, outside);
      CHECK(tween(document, outside, between, {"hips"}).empty());
    }
  }
}

TEST_CASE("The ends of a range are keys without an offset for a tween, and of the standard for a value") {
  Document document = keyed(test::boxer(), "hips", {{6.0, 0.4}}, Vec2(2.0, 10.0));
  document = keyed(document, "left-arm.stretch", {{6.0, 0.2}}, Vec2(2.0, 10.0));
  for (const double frame : {4.0, 8.0}) {
    const double nearKey = frame < 6.0 ? 0.25 : 0.75;
    const OffsetPose tweened = tween(document, frame, nearKey, {"left-arm.stretch", "hips"});
    REQUIRE(tweened.offsets.size() == 1);
    REQUIRE(tweened.values.size() == 1);
    CHECK(glm::length(tweened.offsets[0].move - Vec3(0.1, 0.2, 0.0)) < 1e-9);
    CHECK(tweened.values[0].value == Approx(1.0 + 0.25 * (0.2 - 1.0)));
  }
}

TEST_CASE("A tweened value is held to what its attribute may be, and what is not keyed is left out") {
  Document document = keyed(test::boxer(), "left-arm.stretch", {{2.0, 0.2}, {6.0, 0.8}});
  document = keyed(document, "right-arm.stretch", {{2.0, 0.2}, {6.0, 0.8}}, std::nullopt, 1);
  const Names all{"hips", "right-arm.stretch", "left-arm.stretch", "no such thing"};
  for (const auto& [between, told] :
       {std::pair{-1.0, 0.0}, {0.0, 0.2}, {0.5, 0.5}, {1.0, 0.8}, {1.2, 0.92}, {2.0, 1.0}}) {
    const OffsetPose tweened = tween(document, 4.0, between, all);
    CAPTURE(between);
    CHECK(tweened.offsets.empty());
    REQUIRE(tweened.values.size() == 1);
    CHECK(tweened.values[0].id == "left-arm.stretch");
    CHECK(tweened.values[0].value == Approx(told).margin(1e-12));
  }
}
