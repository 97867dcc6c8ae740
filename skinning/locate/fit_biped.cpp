#include "skinning/locate/fit_biped.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "skinning/locate/arm_joints.h"
#include "skinning/locate/body_ends.h"
#include "skinning/locate/leg_joints.h"
#include "skinning/locate/trunk_joints.h"

namespace stretch::skinning {

namespace {

// A body with its limbs, in its own space; "left" is +X whichever way it faces.
struct BodyJoints {
  TrunkJoints trunk;
  ArmJoints leftArm;
  ArmJoints rightArm;
  LegJoints leftLeg;
  LegJoints rightLeg;
  double facing = 1.0;
};

struct Found {
  LegLines legs;
  ArmPair arms;
};

double shoulderHeightOf(const ArmPair& arms) {
  constexpr double usual = 0.8;
  double sum = 0.0;
  double count = 0.0;
  for (const std::optional<ArmJoints>* arm : {&arms.left, &arms.right}) {
    sum += *arm ? (*arm)->shoulder.place.y : 0.0;
    count += *arm ? 1.0 : 0.0;
  }
  return count > 0.0 ? sum / count : usual;
}

double halfWidthOf(const ArmPair& arms) {
  constexpr double usual = 0.1;
  constexpr double least = 0.05;
  double width = 0.0;
  for (const std::optional<ArmJoints>* arm : {&arms.left, &arms.right}) {
    width = *arm ? std::max(width, std::abs((*arm)->shoulder.place.x)) : width;
  }
  return width > 0.0 ? std::max(width, least) : usual;
}

BodyJoints bodyJoints(const StandingBody& body, const Found& found) {
  constexpr double usualCrotch = 0.47;
  constexpr double hipsOverHips = 0.01;
  constexpr double touching = 0.12; // legs that part no higher than that are boots: trousers touch each other
  constexpr double ofShoulders = 0.5;
  const auto& [legs, arms] = found;
  const double crotch = legs.found() ? legs.crotch : usualCrotch;
  const double shoulders = shoulderHeightOf(arms);
  BodyJoints joints;
  constexpr double backwards = -0.05; // feet of robots have heels: characters face +Z unless theirs clearly
                                      // do not
  joints.facing = facingOf(legs) < backwards ? -1.0 : 1.0;
  joints.trunk = trunkJoints(body, crotch, shoulders, halfWidthOf(arms));
  const bool touch = legs.found() && crotch < touching;
  const double hips = touch            ? ofShoulders * shoulders
                      : areBoxes(legs) ? crotch
                                       : hipHeightOf(crotch, joints.trunk.neck.place.y);
  joints.trunk.hips.place.y = hips + hipsOverHips;
  joints.trunk.hips.confidence = legs.found() ? (touch ? 0.4 : 0.8) : 0.3;
  joints.leftLeg =
      legs.found() ? legJoints(legs.left, hips, joints.facing) : guessedLeg(hips, 1.0, joints.facing);
  joints.rightLeg =
      legs.found() ? legJoints(legs.right, hips, joints.facing) : guessedLeg(hips, -1.0, joints.facing);
  joints.leftArm = arms.left    ? *arms.left
                   : arms.right ? mirroredArm(*arms.right)
                                : guessedArm(shoulders, 1.0);
  joints.rightArm = arms.right  ? *arms.right
                    : arms.left ? mirroredArm(*arms.left)
                                : guessedArm(shoulders, -1.0);
  return joints;
}

Placed between(const Placed& a, const Placed& b, double part) {
  return {glm::mix(a.place, b.place, part), std::min(a.confidence, b.confidence)};
}

// The collar bone begins beside the neck, before the shoulder.
Placed collar(const Placed& neck, const Placed& shoulder, double facing) {
  constexpr double part = 0.2;
  constexpr double before = 0.02;
  Placed collar = shoulder;
  collar.place.x = glm::mix(neck.place.x, shoulder.place.x, part);
  collar.place.z += facing * before;
  collar.confidence = std::min(shoulder.confidence, 0.6);
  return collar;
}

class JointList {
public:
  explicit JointList(const Upright& upright) : upright_(upright) {}
  void add(const std::string& name, const Placed& placed) {
    joints_.push_back({name, upright_.toScene(placed.place), placed.confidence});
  }
  void addSide(const std::string& side, const ArmJoints& arm, const LegJoints& leg, const Placed& collar) {
    add(side + "Shoulder", collar);
    add(side + "UpperArm", arm.shoulder);
    add(side + "LowerArm", arm.elbow);
    add(side + "Hand", arm.wrist);
    add(side + "UpperLeg", leg.hip);
    add(side + "LowerLeg", leg.knee);
    add(side + "Foot", leg.ankle);
    add(side + "Toes", leg.toes);
  }
  [[nodiscard]] const std::vector<FittedJoint>& joints() const { return joints_; }

private:
  const Upright& upright_;
  std::vector<FittedJoint> joints_;
};

std::vector<FittedJoint> named(const BodyJoints& body, const Upright& upright) {
  const TrunkJoints& trunk = body.trunk;
  JointList list(upright);
  list.add("hips", trunk.hips);
  list.add("spine", between(trunk.hips, trunk.neck, 0.22));
  list.add("chest", between(trunk.hips, trunk.neck, 0.45));
  list.add("upperChest", between(trunk.hips, trunk.neck, 0.7));
  list.add("neck", trunk.neck);
  list.add("head", trunk.head);
  const auto addSide = [&](const std::string& side, const ArmJoints& arm, const LegJoints& leg) {
    list.addSide(side, arm, leg, collar(trunk.neck, arm.shoulder, body.facing));
  };
  const bool isTurned = body.facing < 0.0;
  addSide("left", isTurned ? body.rightArm : body.leftArm, isTurned ? body.rightLeg : body.leftLeg);
  addSide("right", isTurned ? body.leftArm : body.rightArm, isTurned ? body.leftLeg : body.rightLeg);
  return list.joints();
}

std::vector<std::string> missing(const Found& found, bool isTurned) {
  std::vector<std::string> warnings;
  const auto tell = [&](const std::string& what, const std::string& which) {
    warnings.push_back(what + "; set " + which + " by hand");
  };
  if (!found.legs.found()) {
    tell("no two legs with a gap between them show in the mesh",
         "UpperLeg, LowerLeg, Foot and Toes of both sides");
  }
  if (!found.arms.left && !found.arms.right) {
    tell("no arms show in the mesh apart from the trunk", "UpperArm, LowerArm and Hand of both sides");
  } else if (!found.arms.left || !found.arms.right) {
    const std::string side = found.arms.left.has_value() == isTurned ? "left" : "right";
    tell("no " + side + " arm shows in the mesh apart from the trunk",
         side + "UpperArm, " + side + "LowerArm and " + side + "Hand");
  }
  return warnings;
}

// What has more limbs than a person, or a trunk that lies, gets a biped's joints all the same, but none of
// them is sure.
void doubtOtherBodies(const StandingBody& body, const Found& found, FittedBiped& fitted) {
  constexpr std::size_t tooManyLegs = 4; // a person may have a stick or a cloak to the ground beside the feet
  constexpr std::size_t tooManyEnds = 8; // head, hands, feet, and two ears or a sword
  const double upright = found.arms.left || found.arms.right ? 1.5 : 0.8; // what leans and lacks arms may be
                                                                          // a bird
  constexpr double guess = 0.3;
  const std::size_t legs = legsUnder(body);
  const std::size_t ends = endsOf(body);
  const bool lies =
      found.legs.found() && depthForHeight(body, found.legs.crotch, halfWidthOf(found.arms)) > upright;
  fitted.doubt = found.legs.found() ? "" : "no two legs with a gap between them show";
  if (legs < tooManyLegs && ends < tooManyEnds && !lies) {
    return;
  }
  const std::string why = legs >= tooManyLegs   ? fmt::format("it stands on {} legs", legs)
                          : ends >= tooManyEnds ? fmt::format("{} limbs or tips reach out of it", ends)
                                                : "its trunk lies on its legs, as a bird's";
  fitted.doubt = why;
  fitted.warnings.push_back(
      fmt::format("this is no biped: {}; the joints are only a guess, set all locators by hand", why));
  for (FittedJoint& joint : fitted.joints) {
    joint.confidence = std::min(joint.confidence, guess);
  }
}

Error noBiped() {
  return {"the mesh shows neither two legs nor two arms", "", byHand};
}

FittedBiped fitted(const StandingBody& body, const Found& found) {
  const BodyJoints joints = bodyJoints(body, found);
  constexpr double same = 0.99;
  FittedBiped result{
      named(joints, body.upright), missing(found, joints.facing < 0.0), {}, body.upright.axes[1].y > same};
  doubtOtherBodies(body, found, result);
  return result;
}

Result<FittedBiped> fitStanding(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                                UpAxis up, const Proceed& proceed) {
  const Result<StandingBody> body = standingIn(positions, triangles, up, proceed);
  if (!body) {
    return body.error();
  }
  Found found;
  found.legs = legLines(*body);
  found.arms = armPair(*body, found.legs);
  const bool shows = found.legs.found() || (found.arms.left && found.arms.right);
  return shows ? Result<FittedBiped>(fitted(*body, found)) : Result<FittedBiped>(noBiped());
}

} // namespace

// What looks like two legs may be two barrels on a back: another axis than the scene's has to show a whole
// biped.
Result<FittedBiped> fitBiped(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                             const Proceed& proceed) {
  Result<FittedBiped> best = fitStanding(positions, triangles, UpAxis::anyOfScene, proceed);
  if (best && best->warnings.empty()) {
    return best;
  }
  Result<FittedBiped> other = fitStanding(positions, triangles, UpAxis::ofScene, proceed);
  return other ? other : best;
}

} // namespace stretch::skinning
