#include "rig/body/reading/finding.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rig/body/reading/biped_reading.h"
#include "rig/body/reading/biped_tail.h"
#include "rig/body/reading/extremities.h"
#include "rig/body/reading/limb_assembly.h"
#include "rig/body/reading/stance.h"

namespace stretch::rig::body {

namespace {

constexpr double leastConfidence = 0.25; // below it a limb is not reported
constexpr double sureConfidence = 0.35;  // from it on a limb counts towards a biped

} // namespace

bool isSure(const std::vector<Limb>& limbs, const LimbPlace& place) {
  const Limb* limb = limbAt(limbs, place);
  return limb != nullptr && limb->confidence >= sureConfidence;
}

bool makesBiped(const std::vector<Limb>& limbs) {
  const bool legs = isSure(limbs, biped::leftLeg) && isSure(limbs, biped::rightLeg);
  const bool arms = isSure(limbs, biped::leftArm) && isSure(limbs, biped::rightArm);
  const bool trunk = isSure(limbs, biped::spine);
  // A robe may hide the legs of a body that has everything else.
  const bool wearsRobe = arms && isSure(limbs, biped::neck);
  return (legs && (arms || trunk)) || wearsRobe;
}

namespace {

Vec3 bodyUpOf(const BodyView& view, const BipedReading& reading, const Trunk& trunk) {
  if (trunk.hips >= 0 && trunk.head >= 0) {
    return view.at(trunk.head) - view.at(trunk.hips);
  }
  if (reading.legs) {
    return (reading.arms ? meanBase(view, *reading.arms) : meanBase(view, *reading.legs)) -
           meanEnd(*reading.legs);
  }
  return Vec3(0.0);
}

// Where other rows of joints make as good a pair, wings or strips of cloth beside arms or legs, and no names
// tell them apart, that is said.
void doubtPairs(const BipedReading& reading, Body& result) {
  constexpr double clearly = 1.3;
  constexpr double doubted = 0.45;
  for (const auto& [pair, ahead, kind] : {std::tuple(&reading.arms, reading.armsAhead, LimbKind::arm),
                                          std::tuple(&reading.legs, reading.legsAhead, LimbKind::leg)}) {
    if (!*pair || ahead >= clearly || isNamed(**pair)) {
      continue;
    }
    for (Limb& limb : result.limbs) {
      limb.confidence = limb.kind == kind ? std::min(limb.confidence, doubted) : limb.confidence;
    }
    const std::string limbs = kind == LimbKind::arm ? "arms" : "legs";
    result.warnings.push_back("other rows of joints may as well be the " + limbs +
                              ", and no names tell: are the " + limbs + " right?");
  }
}

// A negative scale swaps left and right of what is shown, and names keep what they were.
void doubtMirrored(const BindPose& bindPose, const BodyView& view, const BipedReading& reading,
                   Sides& sides) {
  const std::optional<LimbPair>& pair = reading.legs ? reading.legs : reading.arms;
  const LimbGuess& limb = pair->negative ? *pair->negative : *pair->positive;
  const NodeIndex joint = view.nodes[static_cast<std::size_t>(limb.base)];
  if (sides.areNamesAlone && glm::determinant(Mat3(bindPose.worlds[stretch::at(joint)])) < 0.0) {
    sides.contradicted = true;
    sides.warnings.emplace_back(
        "a negative scale mirrors the skeleton, and nothing but names tells left from "
        "right: are the sides right?");
  }
}

// A second pair of arms has no place in a biped.
void tellOtherArms(const BipedReading& reading, Body& result) {
  if (reading.hasOtherArms) {
    result.warnings.emplace_back(
        "another pair of arms is called so as well: choose chains of joints for its limbs");
  }
}

bool legsGoDown(const BodyView& view, const LimbPair& legs) {
  constexpr double steep = 0.7; // sine
  const Vec3 reach = meanEnd(legs) - meanBase(view, legs);
  return -reach.y > steep * glm::length(reach);
}

// Whether names call no joints but those of a pair of legs thighs or shins, as of a beast they call those of
// two, and none of a leg that hangs from the body itself, as the front legs of a centaur do.
bool areOnlyLegs(const BodyView& view, const LimbPair& arms, const LimbPair& legs) {
  const int body = view.commonAncestor(meetingJoint(view, arms), meetingJoint(view, legs));
  for (int joint = 0; joint < view.count(); ++joint) {
    const bool isOfLeg =
        std::ranges::any_of(std::array{&legs.negative, &legs.positive}, [&](const auto* leg) {
          return *leg && (view.isAboveOrSelf((*leg)->base, joint) || view.isAboveOrSelf(joint, (*leg)->base));
        });
    const double role = std::max(view.name(joint).role(Role::thigh), view.name(joint).role(Role::shin));
    const bool isCalled = partWords(view.called[stretch::at(joint)]).contains(PartWord::leg);
    const bool isOfBody = body < 0 || view.isAboveOrSelf(body, joint);
    if (!isOfLeg && (role >= 0.8 || (isCalled && isOfBody))) {
      return false;
    }
  }
  return true;
}

bool isPerson(const BodyView& view, const BipedReading& reading, const Body& found) {
  return found.head.exists() && reading.arms && reading.legs && isNamed(*reading.arms) &&
         isNamed(*reading.legs) && areOnlyLegs(view, *reading.arms, *reading.legs) &&
         std::ranges::all_of(
             std::array{biped::leftArm, biped::rightArm, biped::leftLeg, biped::rightLeg, biped::spine},
             [&](const LimbPlace& place) { return isSure(found.limbs, place); });
}

// Fins make no person, unless it stands on legs, as a penguin does.
bool hasFinsAlone(const BodyView& view, const BipedReading& reading, const Body& found) {
  const auto isFin = [&](const std::optional<LimbGuess>& arm) { return arm && view.name(arm->base).fin; };
  return !(isSure(found.limbs, biped::leftLeg) && isSure(found.limbs, biped::rightLeg)) && reading.arms &&
         (isFin(reading.arms->negative) || isFin(reading.arms->positive));
}

} // namespace

Finding findWith(const Scene& scene, const BindPose& bindPose, Candidates candidates, NodeIndex within) {
  const BodyView view = viewBody(scene, bindPose, candidates, within);
  const MirrorPlane plane = findMirrorPlane(view);
  const BipedReading reading = readBiped(view, plane);
  Finding finding;
  if (!reading.arms && !reading.legs) {
    return finding;
  }
  Sides sides = findSides(view, plane, reading);
  doubtMirrored(bindPose, view, reading, sides);
  const Trunk trunk = readTrunk(view, plane, reading);
  Body& result = finding.result;
  result.limbs = limbsOfReading(scene, view, reading, sides, bindPose);
  doubtPairs(reading, result);
  tellOtherArms(reading, result);
  finding.limbsAreNamed =
      (reading.arms && isNamed(*reading.arms)) || (reading.legs && isNamed(*reading.legs));
  std::ranges::move(limbsOfTrunk(scene, view, reading, trunk, bindPose), std::back_inserter(result.limbs));
  std::erase_if(result.limbs,
                [](const Limb& limb) { return limb.confidence < leastConfidence || !isSound(limb); });
  const std::vector<int> tail = tailOfBiped(view, plane, sides, trunk, result.limbs);
  if (!tail.empty()) {
    std::vector<NodeIndex> joints;
    std::ranges::transform(tail, std::back_inserter(joints),
                           [&](int joint) { return view.nodes[stretch::at(joint)]; });
    const LimbEnd end{.node = joints.back()};
    joints.pop_back();
    finding.tail = makeLimb({LimbKind::tail}, std::move(joints), end, bindPose.worlds);
    const bool isNamed = isNamedTail(view, tail);
    finding.tail->confidence = isNamed ? 0.95 : 0.7;
    finding.tail->reasons = {isNamed ? "is named so" : "goes back from the trunk",
                             nodeNames(scene, finding.tail->joints)};
  }
  result.hips = trunk.hips < 0 ? NodeIndex::none : view.nodes[stretch::at(trunk.hips)];
  result.head = trunk.head < 0 ? NodeIndex::none : view.nodes[stretch::at(trunk.head)];
  // Limbs without an upright body between them are no biped's, unless it stands on two of them.
  constexpr double leastRelation = 0.6;
  finding.legs = standingLegs(view, plane, reading);
  const bool upright = !reading.arms || !reading.legs || reading.relation >= leastRelation ||
                       (finding.legs == 2 && reading.relation >= 0.0);
  result.isBiped = finding.legs <= 2 && upright && makesBiped(result.limbs);
  finding.isPerson = isPerson(view, reading, result);
  finding.standsOnNamedLegs = finding.legs == 2 && isSure(result.limbs, biped::leftLeg) &&
                              isSure(result.limbs, biped::rightLeg) && isNamed(*reading.legs) &&
                              legsGoDown(view, *reading.legs);
  if (hasFinsAlone(view, reading, result)) {
    return {};
  }
  if (finding.legs <= 2) {
    std::ranges::copy(sides.warnings, std::back_inserter(result.warnings));
  } else {
    result.warnings.clear();
  }
  finding.bodyUp = bodyUpOf(view, reading, trunk);
  if (reading.legs) {
    finding.legsReach = meanEnd(*reading.legs) - meanBase(view, *reading.legs);
  }
  return finding;
}

bool isBetter(const Finding& finding, const Finding& than) {
  if (finding.result.isBiped != than.result.isBiped) {
    return finding.result.isBiped;
  }
  return finding.weight() > than.weight() + 1e-9;
}

} // namespace stretch::rig::body
