#include "rig/body/reading/detection.h"

#include <catch2/catch.hpp>

#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

void checkLimbs(const BuiltBiped& built, const std::string& spine, const std::string& neck) {
  const Body biped = detectBody(built.scene);
  checkArmsAndLegs(built, biped);
  CHECK(describe(built, biped, biped::spine) == spine);
  CHECK(describe(built, biped, biped::neck) == neck);
}

const std::string threeSpines = "spine0 spine1 -> spine2";
const std::string oneNeck = "neck0 -> head";

} // namespace

TEST_CASE("a biped of any naming scheme has the limbs that its joints are") {
  for (const NamingScheme& scheme : namingSchemes()) {
    DYNAMIC_SECTION(scheme.title) {
      SyntheticBiped body = makeBody();
      applyNames(body, scheme);
      checkLimbs(build(body), threeSpines, oneNeck);
    }
    DYNAMIC_SECTION(
        scheme.title << " facing -Z, armature scale 0.01, nodes shuffled, rest pose not the bind pose") {
      SyntheticBiped body = makeBody({.tips = true});
      applyNames(body, scheme);
      body.facesBackwards = true;
      body.armatureScale = 0.01;
      body.shuffled = true;
      body.posedAtRest = true;
      checkLimbs(build(body), threeSpines, oneNeck);
    }
    DYNAMIC_SECTION(scheme.title << " without clavicles, fingers and mesh") {
      SyntheticBiped body = makeBody({.spineJoints = 2, .clavicles = false, .fingers = false});
      applyNames(body, scheme);
      body.withMesh = false;
      checkLimbs(build(body), "spine0 -> spine1", oneNeck);
    }
  }
}
