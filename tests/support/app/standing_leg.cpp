#include "tests/support/app/standing_leg.h"

#include <memory>
#include <utility>

#include "tests/support/nodes.h"

namespace stretch::test {

void addStandingLeg(app::Document& document) {
  Scene scene = *document.scene;
  const NodeIndex hip = addNode(scene, "LeftUpLeg", document.body.hips, {0.1, 0.0, 0.0});
  const NodeIndex knee = addNode(scene, "LeftLeg", hip, {0.0, -0.5, 0.0});
  const NodeIndex foot = addNode(scene, "LeftFoot", knee, {0.0, -0.5, 0.0});
  rig::Limb leg;
  leg.kind = rig::LimbKind::leg;
  leg.id = "left-leg";
  leg.joints = {hip, knee};
  leg.endNode = foot;
  leg.restLength = 1.0;
  document.body.limbs.push_back(leg);
  document.scene = std::make_shared<const Scene>(std::move(scene));
}

} // namespace stretch::test
