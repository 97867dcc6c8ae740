#include "tests/support/app/boxer.h"

#include <glm/gtc/quaternion.hpp>

#include "tests/support/nodes.h"

namespace stretch::test {

namespace {

rig::Limb makeLimb(const rig::LimbPlace& place, std::vector<NodeIndex> joints, NodeIndex end) {
  rig::Limb limb;
  static_cast<rig::LimbPlace&>(limb) = place;
  limb.id = rig::limbName(place);
  limb.joints = std::move(joints);
  limb.endNode = end;
  limb.restLength = 0.6;
  return limb;
}

void addKey(Track& track, double frame, double angleRadians) {
  const Quat turn = glm::angleAxis(angleRadians, Vec3(0.0, -1.0, 0.0));
  track.times.push_back(static_cast<float>(frame / 30.0));
  for (const double value : {turn.x, turn.y, turn.z, turn.w}) {
    track.values.push_back(static_cast<float>(value));
  }
}

Clip punch(NodeIndex upperArm) {
  Track track;
  track.node = upperArm;
  track.channel = Channel::rotation;
  track.width = 4;
  addKey(track, 0.0, 0.0);
  addKey(track, 5.0, 0.4);
  addKey(track, 10.0, 1.4);
  addKey(track, 20.0, 0.1);
  Clip clip;
  clip.name = "punch";
  clip.sourceIndex = 0;
  clip.endSeconds = static_cast<double>(track.times.back());
  clip.tracks.emplace_back(std::move(track));
  return clip;
}

} // namespace

app::Document boxer() {
  Scene scene;
  const NodeIndex hips = addNode(scene, "Hips", NodeIndex::none, {0.0, 1.0, 0.0});
  const NodeIndex spine = addNode(scene, "Spine", hips, {0.0, 0.2, 0.0});
  const NodeIndex chest = addNode(scene, "Chest", spine, {0.0, 0.2, 0.0});
  const NodeIndex leftArm = addNode(scene, "LeftArm", chest, {0.2, 0.1, 0.0});
  const NodeIndex leftElbow = addNode(scene, "LeftForeArm", leftArm, {0.3, 0.0, 0.0});
  const NodeIndex leftHand = addNode(scene, "LeftHand", leftElbow, {0.3, 0.0, 0.0});
  const NodeIndex rightArm = addNode(scene, "RightArm", chest, {-0.2, 0.1, 0.0});
  const NodeIndex rightElbow = addNode(scene, "RightForeArm", rightArm, {-0.3, 0.0, 0.0});
  const NodeIndex rightHand = addNode(scene, "RightHand", rightElbow, {-0.3, 0.0, 0.0});

  app::Document document;
  document.source = std::make_shared<const gltf::Source>();
  document.scene = std::make_shared<const Scene>(std::move(scene));
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{punch(leftArm)});
  document.body.hips = hips;
  document.body.height = 1.8;
  document.body.limbs = {makeLimb(rig::biped::leftArm, {leftArm, leftElbow}, leftHand),
                         makeLimb(rig::biped::rightArm, {rightArm, rightElbow}, rightHand),
                         makeLimb(rig::biped::spine, {spine}, chest)};
  return document;
}

} // namespace stretch::test
