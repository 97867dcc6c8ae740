#include <algorithm>

#include <fmt/format.h>

#include "tests/support/rig/families/biped_draft.h"

namespace stretch::test {

namespace {

// Turns trunk, arms and legs as in the middle of an action, each side by itself.
std::string drawAction(Draft& draft) {
  Row& row = draft.row;
  const Poser poser{draft};
  const Vec3 x(1, 0, 0);
  const Vec3 y(0, 1, 0);
  const Vec3 z(0, 0, 1);
  for (const std::string& side : bothSides) {
    const double sign = signOf(side);
    poser.turn("hand" + side, x, row.around(50));
    poser.turn("foreArm" + side, y, -sign * row.between(0, 140));
    poser.turn("upperArm" + side, y, -sign * row.between(-40, 120));
    poser.turn("upperArm" + side, z, -sign * row.between(-70, 85));
    poser.turn("clavicle" + side, z, sign * row.between(-10, 25));
    poser.turn("foot" + side, x, row.between(-20, 40));
    poser.turn("shin" + side, x, row.between(0, 130));
    poser.turn("thigh" + side, z, sign * row.between(-10, 45));
    poser.turn("thigh" + side, x, row.between(-110, 35));
  }
  const double bend = row.between(-20, 75);
  const double aside = row.around(50);
  const double twist = row.around(60);
  const int joints = draft.has("spine2") ? 3 : draft.has("spine1") ? 2 : 1;
  for (int i = joints - 1; i >= 0; --i) {
    const std::string key = fmt::format("spine{}", i);
    poser.turn(key, x, bend / joints);
    poser.turn(key, z, aside / joints);
    poser.turn(key, y, twist / joints);
  }
  poser.turn("neck0", y, row.around(40));
  poser.turn("neck0", x, row.around(30));
  const double lean = row.between(-20, 50);
  const double yaw = row.once(2) ? row.around(60) : 0.0;
  poser.turn("hips", x, lean);
  poser.turn("hips", y, yaw);
  return fmt::format("bent {:.0f}, aside {:.0f}, twisted {:.0f}, leaning {:.0f}, yaw {:.0f}", bend, aside,
                     twist, lean, yaw);
}

} // namespace

std::vector<FamilyRig> bipedsInAction(int each) {
  std::vector<FamilyRig> rigs;
  Row row(1871);
  for (int i = 0; i < each; ++i) {
    const BodyOptions options = drawOptions(row);
    Draft draft{makeBody(options), row};
    wantLimbs(draft, options);
    giveFlesh(draft, options);
    const std::string pose = drawAction(draft);
    standOn(draft.body, 0.0);
    const DrawnNames names = drawNames(draft.body, row);
    draft.body.tubes = true;
    draft.body.withMesh = !options.hands || !options.feet || !row.once(8);
    rigs.push_back(
        {names.tell ? "in the middle of an action, named" : "in the middle of an action, without names",
         fmt::format("{}, {}, spine {}, neck {}{}{}{}{}{}", names.title, pose, options.spineJoints,
                     options.neckJoints, options.clavicles ? "" : ", no clavicles",
                     options.hands ? "" : ", no hands",
                     options.feet ? options.toes ? "" : ", no toes" : ", no feet",
                     options.fingers ? ", fingers" : "", draft.body.withMesh ? "" : ", no mesh"),
         "biped", std::move(draft.body), std::move(draft.wanted), std::move(draft.absent)});
  }
  std::ranges::stable_sort(rigs, {}, &FamilyRig::family);
  return rigs;
}

} // namespace stretch::test
