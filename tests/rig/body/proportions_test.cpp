#include <catch2/catch.hpp>

#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

struct Proportions {
  std::string title;
  double arms = 1.0; ///< Factor on the arms' lengths.
  double legs = 1.0; ///< Factor on the legs' lengths: the body comes down with them.
  double width = 1.0;
  double droop = 0.0; ///< Radians that the arms hang below the T-pose.
};

const std::vector<Proportions> builds{{"adult"},
                                      {"child", 0.8, 0.7, 1.2, 0.0},
                                      {"chibi", 0.8, 0.45, 1.3, 0.0},
                                      {"ape", 1.5, 0.6, 1.3, 0.5},
                                      {"giraffe", 1.0, 1.5, 0.8, 0.0},
                                      {"A-pose", 1.0, 1.0, 1.0, 0.7},
                                      {"arms at the sides", 1.0, 1.0, 1.0, 1.4}};

bool isArm(const std::string& key) {
  return key.starts_with("foreArm") || key.starts_with("hand") || key.starts_with("finger");
}

bool isLeg(const std::string& key) {
  return key.starts_with("thigh") || key.starts_with("shin") || key.starts_with("foot") ||
         key.starts_with("toe");
}

void reshape(SyntheticBiped& body, const Proportions& build) {
  const double lowered = 0.92 * (1.0 - build.legs);
  for (SyntheticJoint& joint : body.joints) {
    const double sign = joint.position.x < 0.0 ? -1.0 : 1.0;
    Vec3& p = joint.position;
    if (isArm(joint.key)) {
      const double along = (std::abs(p.x) - 0.18) * build.arms;
      p = Vec3(sign * (0.18 + along * std::cos(build.droop)), 1.43 - along * std::sin(build.droop), p.z);
    }
    p.y = isLeg(joint.key) ? p.y * build.legs : joint.key == "root" ? 0.0 : p.y - lowered;
    p.x += sign * (std::abs(p.x) > 0.0 ? (build.width - 1.0) * 0.1 : 0.0);
  }
}

} // namespace

TEST_CASE("limbs are found whatever the proportions, with names and without") {
  for (const Proportions& proportions : builds) {
    for (const std::string scheme : {"Unreal", "no names"}) {
      for (const bool withMesh : {true, false}) {
        for (const int necks : {1, 2}) {
          DYNAMIC_SECTION(proportions.title << ", " << scheme << (withMesh ? ", mesh, " : ", no mesh, ")
                                            << necks << " necks") {
            SyntheticBiped body = makeBody({.spineJoints = 4, .neckJoints = necks, .tips = true});
            reshape(body, proportions);
            applyNames(body, namingScheme(scheme));
            body.withMesh = withMesh;
            const BuiltBiped built = build(body);
            const Body biped = detectBody(built.scene);
            checkArmsAndLegs(built, biped);
            CHECK(describe(built, biped, biped::spine) == "spine0 spine1 spine2 -> spine3");
            CHECK(describe(built, biped, biped::neck) ==
                  (necks == 1 ? "neck0 -> head" : "neck0 neck1 -> head"));
          }
        }
      }
    }
  }
}
