#include "rig/body/reading/detection.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "rig/body/evidence/height.h"
#include "rig/body/evidence/skeletons.h"
#include "rig/body/reading/biped_tail.h"
#include "rig/body/reading/doubts.h"
#include "rig/body/reading/humanoid.h"
#include "rig/body/reading/limb_assembly.h"
#include "rig/body/reading/plan_reading.h"
#include "rig/body/reading/planned_body.h"
#include "rig/body/reading/stance.h"
#include "rig/limb.h"

namespace stretch::rig {

namespace body {

namespace {

constexpr double leastConfidence = 0.25; // below it a limb is not reported
constexpr double sureConfidence = 0.35;  // from it on a limb counts towards a biped
constexpr double doubtful = 0.3;         // most that a limb of something else gets

// What one way of choosing candidates found.
struct Finding {
  Body result;
  std::optional<Limb> tail; // of a biped
  int legs = 0;             // that it stands on
  Vec3 bodyUp{0.0};
  Vec3 legsReach{0.0}; // from the hips to the feet
  bool limbsAreNamed = false;
  NodeIndex skeleton; // topmost joint of the one of several that it is of

  [[nodiscard]] double weight() const {
    double sum = 0.0;
    for (const Limb& limb : result.limbs) {
      sum += limb.confidence;
    }
    return sum;
  }
};

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

Finding findWith(const Scene& scene, const BindPose& bindPose, Candidates candidates,
                 NodeIndex within = NodeIndex::none) {
  const BodyView view = viewBody(scene, bindPose, candidates, within);
  const MirrorPlane plane = findMirrorPlane(view);
  const BipedReading reading = readBiped(view, plane);
  Finding finding;
  if (!reading.arms && !reading.legs) {
    return finding;
  }
  const Sides sides = findSides(view, plane, reading);
  const Trunk trunk = readTrunk(view, plane, reading);
  Body& result = finding.result;
  result.limbs = limbsOfReading(scene, view, reading, sides, bindPose);
  doubtPairs(reading, result);
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

bool hasRigidParts(const Scene& scene) {
  return std::ranges::any_of(scene.nodes, [](const Node& node) { return node.mesh >= 0 && node.skin < 0; });
}

// Arms may be rigid pieces on nodes that no skin knows, while the rest is skinned.
bool mayMissParts(const Scene& scene, const Body& found) {
  return hasRigidParts(scene) &&
         (limbAt(found.limbs, biped::leftArm) == nullptr || limbAt(found.limbs, biped::rightArm) == nullptr);
}

bool isBetter(const Finding& finding, const Finding& than) {
  if (finding.result.isBiped != than.result.isBiped) {
    return finding.result.isBiped;
  }
  return finding.weight() > than.weight() + 1e-9;
}

// Whether two bodies stand in one place, as clothes with a skeleton of their own do.
bool isSamePlace(const BindPose& bindPose, const Body& a, const Body& b) {
  constexpr double near = 0.1; // of a limb
  return std::ranges::any_of(a.limbs, [&](const Limb& limb) {
    const Limb* const other = limbAt(b.limbs, limb);
    return other != nullptr &&
           glm::distance(positionOf(bindPose.worlds[at(limb.joints.front())]),
                         positionOf(bindPose.worlds[at(other->joints.front())])) < near * limb.restLength;
  });
}

// Of several skeletons that are each a biped, the one that is read best: limbs of two bodies make none.
std::optional<Finding> findOneOfSeveral(const Scene& scene, const BindPose& bindPose) {
  const std::vector<NodeIndex> skeletons = skeletonsApart(scene);
  if (skeletons.size() < 2) {
    return std::nullopt;
  }
  std::vector<Finding> bipeds;
  for (const NodeIndex top : skeletons) {
    Finding finding = findWith(scene, bindPose, Candidates::skinJoints, top);
    finding.skeleton = top;
    const bool isKnown = std::ranges::any_of(
        bipeds, [&](const Finding& other) { return isSamePlace(bindPose, other.result, finding.result); });
    if (finding.result.isBiped && !isKnown) {
      bipeds.push_back(std::move(finding));
    }
  }
  if (bipeds.size() < 2) {
    return std::nullopt;
  }
  Finding best = bipeds.front();
  for (const Finding& finding : bipeds) {
    best = isBetter(finding, best) ? finding : best;
  }
  best.result.warnings.push_back("at least " + std::to_string(bipeds.size()) +
                                 " characters in the file: the limbs are those of " +
                                 nodeNames(scene, {best.skeleton}));
  return best;
}

Finding findLimbs(const Scene& scene, const BindPose& bindPose) {
  std::optional<Finding> best = findOneOfSeveral(scene, bindPose);
  if (best) {
    return *std::move(best);
  }
  for (const Candidates candidates :
       {Candidates::skinJoints, Candidates::nodesNoMeshes, Candidates::allNodes}) {
    if (candidates == Candidates::skinJoints && scene.skins.empty()) {
      continue;
    }
    Finding finding = findWith(scene, bindPose, candidates);
    const bool isWhole = finding.result.isBiped && !mayMissParts(scene, finding.result);
    const bool isFirst = !best;
    if (isFirst || isBetter(finding, *best)) {
      best = std::move(finding);
    }
    if (isWhole || (isFirst && best->legs > 2)) {
      break;
    }
  }
  return *std::move(best);
}

// The limb that was found without the table and stands in for one that the table lacks: of the same sort,
// whichever side it was taken for, and none of the table's own.
const Limb* standIn(const std::vector<Limb>& found, const std::vector<Limb>& table,
                    const LimbPlace& missing) {
  const auto matches = [&](const Limb& limb) {
    return limb.kind == missing.kind && std::ranges::none_of(table, [&](const Limb& entry) {
             return std::ranges::find(entry.joints, limb.joints.front()) != entry.joints.end();
           });
  };
  const auto match = std::ranges::find_if(found, matches);
  return match == found.end() ? nullptr : &*match;
}

// A biped's tail, where none of its limbs has a joint of it.
void addTail(Finding& finding) {
  Body& result = finding.result;
  if (result.plan == "biped" && result.isBiped && finding.tail && isSound(*finding.tail) &&
      std::ranges::none_of(result.limbs, [&](const Limb& limb) {
        return std::ranges::find(limb.joints, finding.tail->joints.front()) != limb.joints.end();
      })) {
    result.limbs.push_back(*finding.tail);
    std::ranges::stable_sort(result.limbs, std::less<>());
  }
}

// The table's limbs, and what it leaves out as it was found without it.
void applyHumanoid(Finding& finding, const HumanoidTable& table) {
  if (table.limbs.empty()) {
    return;
  }
  Body& result = finding.result;
  result.warnings.clear(); // of joints and sides that the table answers
  std::vector<Limb> limbs = table.limbs;
  // The table leaves the neck out where there is none; the others it must name.
  for (const LimbPlace& missing :
       {biped::leftArm, biped::rightArm, biped::leftLeg, biped::rightLeg, biped::spine}) {
    const Limb* limb = limbAt(limbs, missing) == nullptr ? standIn(result.limbs, limbs, missing) : nullptr;
    if (limb != nullptr) {
      limbs.push_back(*limb);
      static_cast<LimbPlace&>(limbs.back()) = missing;
      limbs.back().id = limbName(missing);
      result.warnings.push_back("the VRM humanoid table names no complete " + limbs.back().id +
                                ": found without it");
    }
  }
  std::ranges::stable_sort(limbs, std::less<>());
  result.limbs = std::move(limbs);
  result.hips = table.hips.exists() ? table.hips : result.hips;
  result.head = table.head.exists() ? table.head : result.head;
  result.isBiped = makesBiped(result.limbs);
  finding.legs = 2;
}

std::string legCount(int legs) {
  return legs == 4   ? "four legs"
         : legs == 6 ? "six legs"
         : legs == 8 ? "eight legs"
                     : std::to_string(legs) + " legs";
}

bool movesMorphTargets(const Scene& scene) {
  return scene.skins.empty() &&
         std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return !mesh.morphWeights.empty(); });
}

void warn(const Scene& scene, Finding& finding) {
  Body& result = finding.result;
  if (result.isBiped) {
    for (const LimbPlace& usual :
         {biped::leftArm, biped::rightArm, biped::leftLeg, biped::rightLeg, biped::spine}) {
      if (limbAt(result.limbs, usual) == nullptr) {
        result.warnings.push_back("no " + limbName(usual) +
                                  " found: choose a chain of joints if there is one");
      }
    }
    return;
  }
  if (result.plan != "biped" && !result.limbs.empty()) {
    return;
  }
  for (Limb& limb : result.limbs) {
    limb.confidence = std::min(limb.confidence, doubtful);
  }
  result.warnings.emplace_back(
      result.limbs.empty() && movesMorphTargets(scene)
          ? "no joints found, but morph targets: make a skinned clip of its meshes by compress"
      : result.limbs.empty() && scene.skins.empty() && !scene.meshes.empty()
          ? "no skeleton found: bind the mesh first"
      : result.limbs.empty() ? "no biped found: choose chains of joints by hand"
                             : "no complete biped found: check the limbs by hand");
}

// The joints, else every node that may be one, until `read` answers something.
template <typename Read>
auto readAnyView(const Scene& scene, const BindPose& bindPose, const Read& read,
                 NodeIndex within = NodeIndex::none) {
  for (const Candidates candidates : {Candidates::skinJoints, Candidates::nodesNoMeshes}) {
    if (candidates == Candidates::skinJoints && scene.skins.empty()) {
      continue;
    }
    if (auto found = read(viewBody(scene, bindPose, candidates, within))) {
      return found;
    }
  }
  return read(viewBody(scene, bindPose, Candidates::allNodes, within));
}

void takeReading(PlanReading reading, Finding& finding) {
  Body& result = finding.result;
  result.plan = reading.plan->id;
  result.planConfidence = reading.confidence;
  finding.bodyUp = reading.up;
  result.planReasons = std::move(reading.reasons);
  result.limbs = std::move(reading.limbs);
  result.hips = reading.hips;
  result.head = reading.head;
  result.warnings = std::move(reading.warnings);
  result.isBiped = false;
}

void takeChains(const Scene& scene, const BindPose& bindPose, Finding& finding) {
  Body& result = finding.result;
  result.plan = "other";
  result.planReasons = {"its limbs are the rows of joints between branchings"};
  result.isBiped = false;
  const auto chains = readAnyView(scene, bindPose, [&](const BodyView& view) {
    std::vector<Limb> found = chainsOfTree(scene, bindPose, view);
    return found.empty() ? std::nullopt : std::optional(std::move(found));
  });
  result.limbs = chains.value_or(std::vector<Limb>{});
  result.planConfidence = result.limbs.empty() ? 0.0 : 1.0;
}

constexpr double leastRise = 0.75; // sine, of a trunk that stands

// Head over hips, and legs that go on where the trunk ends.
bool standsUpright(const Finding& finding) {
  constexpr double leastInLine = 0.8; // cosine
  const Vec3& up = finding.bodyUp;
  const Vec3& legs = finding.legsReach;
  const bool inLine = -glm::dot(up, legs) >= leastInLine * glm::length(up) * glm::length(legs);
  return finding.result.isBiped && up.y >= leastRise * glm::length(up) && inLine;
}

// Whether a body that may be a biped in an odd pose is rather what it was read as: a bird's legs stand across
// its trunk, a biped that lies has no tail, and none stands on six legs.
bool isRather(const PlanReading& reading, const Finding& finding) {
  // As the trunk of a person who sits does; of a beast that was turned over it tells nothing.
  const bool rises = reading.up.y > 0.5 && finding.bodyUp.y >= leastRise * glm::length(finding.bodyUp);
  const bool hasTail = limbAt(reading.limbs, {LimbKind::tail}) != nullptr;
  return reading.plan->legs == 2 || (!rises && (reading.plan->legs > 4 || hasTail));
}

// An ostrich stands as upright as a person: wings where arms would be tell it.
bool hasWings(const PlanReading& reading) {
  return reading.plan->legs == 2 &&
         std::ranges::any_of(reading.limbs, [](const Limb& limb) { return limb.kind == LimbKind::wing; });
}

// Anything but an upright body on two legs: read as one of the other plans, where one fits.
void takePlan(const Scene& scene, const BindPose& bindPose, Finding& finding) {
  Body& result = finding.result;
  const bool upright = standsUpright(finding);
  const bool armless =
      limbAt(result.limbs, biped::leftArm) == nullptr && limbAt(result.limbs, biped::rightArm) == nullptr;
  if (upright && !armless) {
    return;
  }
  constexpr double sure = 0.5;
  std::optional<PlanReading> reading = readAnyView(
      scene, bindPose, [&](const BodyView& view) { return readPlan(scene, bindPose, view); },
      finding.skeleton);
  const bool fits = reading && reading->confidence >= sure &&
                    (upright ? hasWings(*reading) : !result.isBiped || isRather(*reading, finding));
  if (fits) {
    const bool lies = mayLie(scene, bindPose, *reading);
    const bool isPerson = mayBePerson(scene, *reading);
    takeReading(std::move(*reading), finding);
    if (lies) {
      doubt(result,
            "its front legs are called arms, and not all legs stand: if it is a person who lies or sits, "
            "choose the plan biped");
    } else if (isPerson) {
      doubt(result,
            "its arms are called so, and nothing is called a tail: if it is a person who lies or bows, "
            "choose the plan biped");
    }
  } else if (!result.isBiped && (finding.legs > 2 || result.limbs.empty())) {
    takeChains(scene, bindPose, finding);
    result.planReasons.emplace_back(finding.legs > 2 ? "it stands on " + legCount(finding.legs) +
                                                           ", and no other plan fits"
                                                     : "no plan fits");
    if (!result.limbs.empty()) {
      doubt(result, "no body plan fits, so its limbs are rows of joints: choose a plan if it has one");
    }
  }
}

void tellBiped(Finding& finding) {
  Body& result = finding.result;
  result.planReasons = {result.isBiped ? "two legs, and arms or a spine, on an upright body"
                                       : "no plan fits: taken for a biped that is not complete"};
  double sum = 0.0;
  for (const Limb& limb : result.limbs) {
    sum += limb.confidence;
  }
  result.planConfidence = result.limbs.empty() ? 0.0 : sum / static_cast<double>(result.limbs.size());
  if (result.isBiped && limbAt(result.limbs, biped::leftArm) == nullptr &&
      limbAt(result.limbs, biped::rightArm) == nullptr) {
    constexpr double withoutArms = 0.75;
    result.planConfidence *= withoutArms;
    result.planReasons.emplace_back("no arms: it may be a bird");
  }
}

// The joint that carries trunk and legs. Many rigs call the torso's root hips and hang the legs beside it,
// from a body that carries both; one that stands far from the hips (a root on the ground) is no centre to
// turn about.
NodeIndex centreOf(const Scene& scene, const BindPose& bindPose, const Body& found) {
  NodeIndex centre = found.hips;
  double legLength = 0.0;
  for (const LimbPlace& place : {biped::leftLeg, biped::rightLeg, biped::spine}) {
    if (const Limb* const limb = limbAt(found.limbs, place); limb != nullptr && centre.exists()) {
      const bool isSpine = place == biped::spine && limb->joints.front() != centre;
      legLength = std::max(legLength, isLeg(*limb) ? limb->restLength : 0.0);
      centre = isLeg(*limb) || isSpine ? commonAncestor(scene, centre, limb->joints.front()) : centre;
    }
  }
  if (!centre.exists() || centre == found.hips) {
    return found.hips;
  }
  constexpr double farthest = 0.75; // of a leg
  const double away =
      glm::distance(positionOf(bindPose.worlds[at(centre)]), positionOf(bindPose.worlds[at(found.hips)]));
  return away < farthest * legLength ? centre : found.hips;
}

// What of a biped may be another body.
void tellDoubts(const Scene& scene, const BindPose& bindPose, Finding& finding) {
  Body& result = finding.result;
  if (standsOnFour(bindPose, result, finding.bodyUp)) {
    doubt(result, "its trunk lies, and arms and legs go down: if it is a beast on four legs, choose the "
                  "plan quadruped");
  } else if (hasLegsForArms(scene, result)) {
    doubt(result, "its arms are called legs: if it is a beast on four legs, choose the plan quadruped");
  } else if (!finding.limbsAreNamed && leansAsABird(bindPose, result, finding.legsReach)) {
    doubt(result,
          "its trunk stands across its legs, and no names tell: if it is a bird, choose the plan bird");
  }
}

void measure(const Scene& scene, const BindPose& bindPose, const Clip* clip, Finding& finding) {
  Body& result = finding.result;
  BodyParts parts{result.hips, {}, finding.bodyUp};
  for (const Limb& limb : result.limbs) {
    if (limb.kind == LimbKind::arm && limb.endNode.exists()) {
      parts.hands.push_back(limb.endNode);
    }
  }
  const double start = clip == nullptr ? 0.0 : clip->startSeconds;
  const Pose pose = clip == nullptr ? restPose(scene) : samplePose(scene, *clip, start);
  const CharacterExtent extent = characterExtent(scene, bindPose, parts, frameOf(scene, pose, start));
  result.height = extent.height;
  result.size = result.isBiped ? extent.stature : extent.largest;
}

} // namespace

} // namespace body

Body detectBody(const Scene& scene, const Clip* clip) {
  const body::BindPose bindPose = body::placeBindPose(scene);
  body::Finding finding = body::findLimbs(scene, bindPose);
  const body::HumanoidTable table = body::readHumanoid(scene, bindPose);
  body::applyHumanoid(finding, table);
  if (table.limbs.empty()) {
    body::takePlan(scene, bindPose, finding);
  }
  body::addTail(finding);
  finding.result.hips = body::centreOf(scene, bindPose, finding.result);
  setLeadingEnds(bindPose.worlds, finding.result);
  body::warn(scene, finding);
  if (finding.result.plan == "biped") {
    body::tellBiped(finding);
  }
  if (table.limbs.empty()) {
    body::tellDoubts(scene, bindPose, finding);
  }
  body::measure(scene, bindPose, clip, finding);
  return std::move(finding.result);
}

Body bodyAsPlan(const Scene& scene, const BodyPlan& plan, const Clip* clip) {
  const body::BindPose bindPose = body::placeBindPose(scene);
  body::Finding finding = body::findLimbs(scene, bindPose);
  finding.result.warnings.clear();
  if (plan.id == "biped") {
    body::applyHumanoid(finding, body::readHumanoid(scene, bindPose));
    body::addTail(finding);
  } else if (plan.id == "other") {
    body::takeChains(scene, bindPose, finding);
  } else {
    const auto reading = body::readAnyView(scene, bindPose, [&](const body::BodyView& view) {
      body::PlanReading found = body::readAsPlan(scene, bindPose, view, plan);
      return found.limbs.empty() ? std::nullopt : std::optional(std::move(found));
    });
    finding.result = Body{};
    finding.result.plan = plan.id;
    if (reading) {
      body::takeReading(*reading, finding);
    }
  }
  Body& result = finding.result;
  setLeadingEnds(bindPose.worlds, result);
  if (result.limbs.empty()) {
    result.warnings = {"no limb of " + plan.title + " found: choose another body plan, or chains of joints"};
  }
  result.planConfidence = 1.0;
  result.planReasons = {"chosen by hand"};
  body::measure(scene, bindPose, clip, finding);
  return std::move(result);
}

} // namespace stretch::rig
