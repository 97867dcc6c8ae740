#include "assets/dummy/dummy.h"

#include "assets/dummy/body.h"
#include "assets/dummy/face.h"
#include "assets/dummy/keying.h"
#include "assets/dummy/leap.h"
#include "assets/dummy/props.h"
#include "assets/dummy/punch.h"
#include "assets/dummy/swing.h"

namespace stretch::assets {

namespace {

Character withoutMotion() {
  Character dummy;
  dummy.skeleton = dummySkeleton();
  dummy.parts.push_back({"Body", 0.62, makeBody(dummy.skeleton)});
  dummy.parts.push_back({"Face", 0.35, makeFace(jointIndex(dummy.skeleton, "Head"))});
  return dummy;
}

Character boxing(Character dummy) {
  dummy.motions.push_back(keyPoses("One-two punch", dummy.skeleton, punchPoses(), punchFramesPerSecond));
  dummy.motions.push_back(bakePoses("Guard", dummy.skeleton, guardPoses(), punchFramesPerSecond));
  return dummy;
}

Character batting(Character dummy) {
  dummy.props.push_back(makeBat());
  dummy.motions.push_back(swingMotion(dummy.skeleton, propNode(dummy.skeleton, 0)));
  dummy.props.front().position = batPlace(swingPoses().front()).position;
  return dummy;
}

Character leaping(Character dummy) {
  dummy.props = leapBlocks();
  dummy.motions.push_back(leapMotion(dummy.skeleton));
  return dummy;
}

} // namespace

std::vector<BundledFile> bundledFiles() {
  const Character still = withoutMotion();
  return {
      {"dummy.glb", boxing(still)}, {"dummy_swing.glb", batting(still)}, {"dummy_leap.glb", leaping(still)}};
}

} // namespace stretch::assets
