#include "tests/support/app/things_of_clip.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "tests/support/app/boxer.h"
#include "tests/support/nodes.h"

namespace stretch::test {

namespace {

rig::HoldTime holdTime() {
  return {{3.0, 12.0}, {1.0, 2.0}};
}

rig::OffsetKey keyOf(double value, const Vec3& move = Vec3(0.0)) {
  rig::OffsetKey key;
  key.frame = 8.0;
  key.value = value;
  key.move = move;
  return key;
}

} // namespace

app::Document twoPunches() {
  app::Document document = boxer();
  Scene scene = *document.scene;
  addNode(scene, "Stick", NodeIndex::none, {0.0, 0.5, 0.5});
  document.scene = std::make_shared<const Scene>(std::move(scene));
  Clip second = document.clips->front();
  second.name = "second punch";
  second.sourceIndex = 1;
  document.clips =
      std::make_shared<const std::vector<Clip>>(std::vector<Clip>{document.clips->front(), second});
  return document;
}

app::Things oneOfEach(int clip, double amount) {
  app::Things things;
  rig::Trail trail;
  trail.limb = "left-arm";
  trail.clip = clip;
  trail.settings.endFrame = 10.0;
  trail.settings.scale = 1.0 + amount;
  things.trails = {trail};
  things.adjustments = {{"hips", clip, Vec2(2.0, 16.0), {keyOf(0.0, {0.0, 0.1 * amount, 0.0})}},
                        {"right-arm.stretch", clip, std::nullopt, {keyOf(amount)}}};
  rig::Pin pin;
  pin.limb = "right-arm";
  pin.clip = clip;
  pin.time = holdTime();
  pin.stretch = amount;
  rig::Grip grip;
  grip.follower = "right-arm";
  grip.leader = "left-arm";
  grip.clip = clip;
  grip.time = holdTime();
  grip.time.rangeFrames += Vec2(12.0, 6.0);
  grip.stretch = amount;
  rig::Prop prop;
  prop.node = "Stick";
  prop.clip = clip;
  prop.move.y = amount;
  prop.hands = {{"left-arm", {keyOf(amount)}}};
  things.holds = {{pin}, {grip}, {prop}};
  app::WeightedLimb weight;
  weight.limb = "right-arm";
  weight.clip = clip;
  weight.settings.amount = amount;
  things.weights = {weight};
  return things;
}

} // namespace stretch::test
