#include "assets/dummy/dummy.h"

#include "assets/dummy/body.h"
#include "assets/dummy/face.h"
#include "assets/dummy/keying.h"
#include "assets/dummy/punch.h"

namespace stretch::assets {

Character makeDummy() {
  Character dummy;
  dummy.skeleton = dummySkeleton();
  dummy.parts.push_back({"Body", 0.62, makeBody(dummy.skeleton)});
  dummy.parts.push_back({"Face", 0.35, makeFace(jointIndex(dummy.skeleton, "Head"))});
  dummy.motions.push_back(keyPoses("One-two punch", dummy.skeleton, punchPoses(), punchFramesPerSecond));
  dummy.motions.push_back(bakePoses("Guard", dummy.skeleton, guardPoses(), punchFramesPerSecond));
  return dummy;
}

} // namespace stretch::assets
