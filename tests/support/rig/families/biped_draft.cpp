#include "tests/support/rig/families/biped_draft.h"

namespace stretch::test {

double signOf(const std::string& side) {
  return side == ".l" ? 1.0 : -1.0;
}

std::string idOf(const std::string& side, const std::string& limb) {
  return (side == ".l" ? "left-" : "right-") + limb;
}

BodyOptions drawOptions(Row& row) {
  BodyOptions options;
  options.spineJoints = static_cast<int>(row.once(5) ? row.below(2) : 2 + row.below(4));
  options.neckJoints = row.once(4) ? static_cast<int>(row.below(2)) * 2 : 1;
  options.clavicles = !row.once(4);
  options.hands = !row.once(8);
  options.feet = !row.once(10);
  options.toes = options.feet && !row.once(3);
  options.fingers = options.hands && row.once(2);
  return options;
}

void wantLimbs(Draft& draft, const BodyOptions& options) {
  draft.absent.emplace_back("tail");
  for (const std::string& side : bothSides) {
    draft.wanted[idOf(side, "arm")] = {"upperArm" + side, "foreArm" + side,
                                       options.hands ? "hand" + side : "estimated"};
    draft.wanted[idOf(side, "leg")] = {"thigh" + side, "shin" + side,
                                       options.feet ? "foot" + side : "estimated"};
  }
  if (options.spineJoints > 0) {
    const std::string last = "spine" + std::to_string(options.spineJoints - 1);
    draft.wanted["spine"] = {"spine0", "", last + "|neck0|head|estimated"};
  }
  if (options.neckJoints > 0) {
    draft.wanted["neck"] = {"neck0", "", "head"};
  } else {
    draft.absent.emplace_back("neck");
  }
}

void giveFlesh(Draft& draft, const BodyOptions& options) {
  for (SyntheticJoint& joint : draft.body.joints) {
    const std::string stem = joint.key.substr(0, joint.key.find('.'));
    joint.flesh = stem == "foot" && !options.toes       ? Vec3(0, -0.06, 0.16)
                  : stem == "foot"                      ? Vec3(0, -0.06, -0.04)
                  : stem == "toe"                       ? Vec3(0, -0.01, 0.08)
                  : stem == "shin" && !options.feet     ? Vec3(0, -0.42, 0.02)
                  : stem == "foreArm" && !options.hands ? Vec3(joint.position.x > 0 ? 0.28 : -0.28, 0, 0)
                  : stem == "hand" && !options.fingers  ? Vec3(joint.position.x > 0 ? 0.14 : -0.14, 0, 0)
                                                        : Vec3(0.0);
  }
}

} // namespace stretch::test
