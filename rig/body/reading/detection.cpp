#include "rig/body/reading/detection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "rig/body/evidence/height.h"
#include "rig/body/evidence/skeletons.h"
#include "rig/body/reading/doubts.h"
#include "rig/body/reading/finding.h"
#include "rig/body/reading/humanoid.h"
#include "rig/body/reading/limb_assembly.h"
#include "rig/body/reading/plan_reading.h"
#include "rig/body/reading/planned_body.h"
#include "rig/body/reading/stance.h"
#include "rig/limb.h"

namespace stretch::rig {

namespace body {

namespace {

constexpr double doubtful = 0.3; // most that a limb of something else gets

bool hasRigidParts(const Scene& scene) {
  return std::ranges::any_of(scene.nodes, [](const Node& node) { return node.mesh >= 0 && node.skin < 0; });
}

// Arms may be rigid pieces on nodes that no skin knows, while the rest is skinned.
bool mayMissParts(const Scene& scene, const Body& found) {
  return hasRigidParts(scene) &&
         (limbAt(found.limbs, biped::leftArm) == nullptr || limbAt(found.limbs, biped::rightArm) == nullptr);
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

Finding findLimbs(const Scene& scene, const BindPose& bindPose) {
  std::optional<Finding> best;
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

void tellMissing(Body& result, std::initializer_list<LimbPlace> usual) {
  std::string missing;
  for (const LimbPlace& place : usual) {
    missing += limbAt(result.limbs, place) == nullptr ? (missing.empty() ? "" : ", ") + limbName(place) : "";
  }
  if (!missing.empty()) {
    result.warnings.push_back("no " + missing + " found: choose a chain of joints if there is one");
  }
}

void warn(const Scene& scene, Finding& finding) {
  Body& result = finding.result;
  const auto allLimbs = {biped::leftArm, biped::rightArm, biped::leftLeg, biped::rightLeg, biped::spine};
  if (result.isBiped) {
    tellMissing(result, allLimbs);
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
  if (!result.limbs.empty()) {
    tellMissing(result, allLimbs);
  }
}

// The joints, else every node that may be one, until `read` answers something.
template <typename Read>
auto readAnyView(const Scene& scene, const BindPose& bindPose, const Read& read,
                 NodeIndex within = NodeIndex::none) {
  for (const Candidates candidates :
       {Candidates::deformJoints, Candidates::skinJoints, Candidates::nodesNoMeshes}) {
    const bool isThere = candidates == Candidates::deformJoints ? hasDeformJoints(scene)
                         : candidates == Candidates::skinJoints ? !scene.skins.empty()
                                                                : true;
    if (!isThere) {
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

bool trunkRises(const Finding& finding) {
  constexpr double leastRise = 0.75; // sine
  return finding.bodyUp.y >= leastRise * glm::length(finding.bodyUp);
}

// Head over hips, and legs that go on where the trunk ends.
bool standsUpright(const Finding& finding) {
  constexpr double leastInLine = 0.8; // cosine
  const Vec3& up = finding.bodyUp;
  const Vec3& legs = finding.legsReach;
  const bool inLine = -glm::dot(up, legs) >= leastInLine * glm::length(up) * glm::length(legs);
  return finding.result.isBiped && trunkRises(finding) && inLine;
}

// Whether a body that may be a biped in an odd pose is rather what it was read as: a bird's legs stand across
// its trunk, a biped that lies has no tail, and none stands on six legs.
bool isRather(const PlanReading& reading, const Finding& finding) {
  // As the trunk of a person who sits does; of a beast that was turned over it tells nothing.
  const bool rises = reading.up.y > 0.5 && trunkRises(finding);
  const bool hasTail = limbAt(reading.limbs, {LimbKind::tail}) != nullptr;
  return reading.plan->legs == 2 || (!rises && (reading.plan->legs > 4 || hasTail));
}

// An ostrich stands as upright as a person: wings where arms would be tell it.
bool hasWings(const PlanReading& reading) {
  return reading.plan->legs == 2 &&
         std::ranges::any_of(reading.limbs, [](const Limb& limb) { return limb.kind == LimbKind::wing; });
}

// Anything but an upright body on two legs: read as one of the other plans, where one fits.
void takeFittingPlan(const Scene& scene, const BindPose& bindPose, Finding& finding) {
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
  // Legs beside a person's own are those of the chair.
  if (reading && reading->plan->legs > 4 && finding.isPerson && trunkRises(finding)) {
    result.isBiped = true;
    return;
  }
  const bool fits = reading && reading->confidence >= sure &&
                    !(finding.isPerson && hasArmInMiddle(*reading, result.limbs)) &&
                    (upright ? hasWings(*reading) : !result.isBiped || isRather(*reading, finding));
  if (fits) {
    const bool lies = mayLie(scene, bindPose, *reading);
    const bool isPerson = mayBePerson(scene, *reading);
    const bool hasOtherLegs = hasArmsForLegs(scene, *reading);
    const bool isRow = mayBeNoSerpent(scene, bindPose, *reading);
    takeReading(std::move(*reading), finding);
    if (lies) {
      doubt(result,
            "its front legs are called arms, and not all legs stand: if it is a person who lies or sits, "
            "choose the plan biped");
    } else if (isPerson) {
      doubt(result,
            "its arms are called so, and nothing is called a tail: if it is a person who lies or bows, "
            "choose the plan biped");
    } else if (hasOtherLegs) {
      doubt(result, "names call its legs arms: if it stands on others, choose another plan");
    } else if (isRow) {
      doubt(result, "one row of joints, read as a serpent: if it is something else, choose another plan");
    }
  }
}

// Whether a skeleton is a body by itself: a person with arms, legs, a trunk and a head, or what another plan
// fits.
bool isWholeBody(const Finding& finding) {
  const std::vector<Limb>& limbs = finding.result.limbs;
  return finding.result.plan == "biped"
             ? finding.result.isBiped && finding.result.head.exists() &&
                   std::ranges::all_of(std::array{biped::leftArm, biped::rightArm, biped::leftLeg,
                                                  biped::rightLeg, biped::spine},
                                       [&](const LimbPlace& place) { return isSure(limbs, place); })
             : finding.result.plan != "other";
}

// A row of joints apart may be hair: it is a serpent only among serpents.
bool isOnLegs(const Finding& finding) {
  return std::ranges::any_of(finding.result.limbs, isLeg);
}

// Whether all skeletons together show but the ends of limbs beyond what one shows alone: feet under the root.
bool addsEnds(const Body& together, const Body& alone) {
  bool adds = false;
  bool isSame = together.plan == alone.plan && together.limbs.size() == alone.limbs.size();
  for (const Limb& limb : alone.limbs) {
    const Limb* const other = limbAt(together.limbs, limb);
    const bool isOpen = !limb.endNode.exists();
    isSame = isSame && other != nullptr && other->joints == limb.joints &&
             (isOpen || limb.endNode == other->endNode);
    adds = adds || (isSame && isOpen && other->endNode.exists());
  }
  return isSame && adds;
}

// Whether no vertex follows a skeleton.
bool isIdle(const Scene& scene, const std::vector<std::vector<Vec3>>& clouds, NodeIndex top) {
  return std::ranges::all_of(withSubtrees(scene, {top}),
                             [&](NodeIndex node) { return clouds[at(node)].empty(); });
}

// Of several skeletons those that vertices follow, if there are any.
std::vector<NodeIndex> notIdle(const Scene& scene, const BindPose& bindPose,
                               std::vector<NodeIndex> skeletons) {
  const std::vector<std::vector<Vec3>> clouds = vertexClouds(scene, bindPose, RigidMeshes::none);
  const auto isMoving = [&](NodeIndex top) { return !isIdle(scene, clouds, top); };
  if (std::ranges::any_of(skeletons, isMoving)) {
    std::erase_if(skeletons, std::not_fn(isMoving));
  }
  return skeletons;
}

// Of several skeletons that are each a body, the one that is read best: limbs of two bodies make none.
// Nothing where none is a body by itself. `plan`: that alone; empty: any.
std::optional<Finding> findOneOfSeveral(const Scene& scene, const BindPose& bindPose,
                                        const std::string& plan = {}) {
  std::vector<NodeIndex> skeletons = skeletonsApart(scene);
  const bool hasOneRoot = skeletons.size() == 1;
  skeletons = hasOneRoot ? skeletonsUnder(scene, skeletons.front()) : std::move(skeletons);
  skeletons = skeletons.size() > 1 ? notIdle(scene, bindPose, std::move(skeletons)) : skeletons;
  std::vector<Finding> bodies;
  for (const NodeIndex top : skeletons.size() < 2 ? std::vector<NodeIndex>{} : skeletons) {
    Finding finding = findWith(scene, bindPose, Candidates::skinJoints, top);
    finding.skeleton = top;
    takeFittingPlan(scene, bindPose, finding);
    if (isWholeBody(finding) && (plan.empty() || finding.result.plan == plan)) {
      bodies.push_back(std::move(finding));
    }
  }
  if (bodies.size() < skeletons.size()) {
    std::erase_if(bodies, [](const Finding& finding) { return !isOnLegs(finding); });
  }
  if (bodies.empty()) {
    return std::nullopt;
  }
  Finding best = bodies.front();
  std::vector<const Finding*> apart;
  for (const Finding& finding : bodies) {
    best = isBetter(finding, best) ? finding : best;
    if (std::ranges::none_of(apart, [&](const Finding* other) {
          return isSamePlace(bindPose, other->result, finding.result);
        })) {
      apart.push_back(&finding);
    }
  }
  // What hangs from one root is one body, but for where two stand side by side.
  if (hasOneRoot && apart.size() < 2) {
    return std::nullopt;
  }
  Finding together = findWith(scene, bindPose, Candidates::skinJoints);
  takeFittingPlan(scene, bindPose, together);
  // A rig of Blender hangs its trunk beside the legs.
  const bool isOneInParts = apart.size() < 2 && hasDeformJoints(scene) && isWholeBody(together);
  if (isOneInParts || addsEnds(together.result, best.result)) {
    return together;
  }
  if (apart.size() > 1) {
    best.result.warnings.push_back("at least " + std::to_string(apart.size()) +
                                   " characters in the file: the limbs are those of " +
                                   nodeNames(scene, {best.skeleton}));
  }
  return best;
}

// As `findOneOfSeveral` leaves it, else of all joints, read as one of the other plans where one fits.
void takePlan(const Scene& scene, const BindPose& bindPose, Finding& finding) {
  Body& result = finding.result;
  takeFittingPlan(scene, bindPose, finding);
  if (result.plan == "biped" && !result.isBiped) {
    const bool lies = finding.isPerson && !trunkRises(finding);
    // A body that is all legs is one: an egg that walks, a mech.
    result.isBiped = lies || finding.standsOnNamedLegs;
    if (lies) {
      doubt(result, "the body lies in its bind pose: are its limbs right?");
    }
  }
  if (result.plan == "biped" && !result.isBiped && (finding.legs > 2 || result.limbs.empty())) {
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
  result.planReasons = {!result.isBiped ? "no plan fits: taken for a biped that is not complete"
                        : makesBiped(result.limbs) || !finding.standsOnNamedLegs
                            ? "two legs, and arms or a spine, on an upright body"
                            : "stands on two legs that are called so"};
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
// from a body that carries both; one far from the hips (a root on the ground) is no centre to turn about.
NodeIndex centreOf(const Scene& scene, const BindPose& bindPose, const Body& found) {
  NodeIndex centre = found.hips;
  double legLength = 0.0;
  for (const Limb& limb : found.limbs) {
    legLength = std::max(legLength, isLeg(limb) ? limb.restLength : 0.0);
  }
  for (const LimbPlace& place : {biped::leftLeg, biped::rightLeg, biped::spine}) {
    if (const Limb* const limb = limbAt(found.limbs, place); limb != nullptr && centre.exists()) {
      centre = commonAncestor(scene, centre, limb->joints.front());
    }
  }
  if (!centre.exists()) {
    return found.hips;
  }
  constexpr double farthest = 0.75; // of a leg
  const auto isNear = [&](NodeIndex node) {
    return glm::distance(positionOf(bindPose.worlds[at(node)]), positionOf(bindPose.worlds[at(found.hips)])) <
           farthest * legLength;
  };
  centre = centre == found.hips || isNear(centre) ? centre : found.hips;
  const NodeIndex above = scene.nodes[at(centre)].parent; // maybe a pelvis that carries the legs by the spine
  const bool isPelvis =
      skinJoints(scene).contains(above) && readName(scene.nodes[at(above)].name).role(Role::hips) >= 0.8;
  return isPelvis && isNear(above) ? above : centre;
}

// What of a biped may be another body.
void tellDoubts(const Scene& scene, const BindPose& bindPose, Finding& finding) {
  Body& result = finding.result;
  if (standsOnFour(bindPose, result, finding.bodyUp)) {
    doubt(result, "its trunk lies, and arms and legs go down: if it is a beast on four legs, choose the "
                  "plan quadruped");
  } else if (hasLegsForArms(scene, result)) {
    doubt(result, "its arms are called legs: if it is a beast on four legs, choose the plan quadruped");
  } else if (hasWingsForArms(scene, result)) {
    doubt(result, "it has wings and no arms: if it is a bird, choose the plan bird");
  } else if (!finding.limbsAreNamed && leansAsABird(bindPose, result, finding.legsReach)) {
    doubt(result,
          "its trunk stands across its legs, and no names tell: if it is a bird, choose the plan bird");
  }
}

// A limb that is hardly likelier than not is never left without a word, nor is a neck that may be among such.
void tellGuesses(Body& result) {
  constexpr double guessed = 0.5;
  const auto isGuessed = [](const Limb& limb) { return limb.confidence < guessed; };
  const auto isAsked = [&](const Limb& limb) {
    return std::ranges::any_of(result.warnings, [&](const std::string& warning) {
      return warning.find(limb.id) != std::string::npos ||
             warning.find(limbName({limb.kind}) + "s ") != std::string::npos; // of both
    });
  };
  std::string limbs;
  for (const Limb& limb : result.limbs) {
    limbs += isGuessed(limb) && !isAsked(limb) ? (limbs.empty() ? "" : ", ") + limb.id : "";
  }
  const bool isAll = std::ranges::all_of(result.limbs, isGuessed); // asked of together
  if (!limbs.empty() && (result.warnings.empty() || !isAll)) {
    result.warnings.push_back("guessed, and not sure: " + limbs);
  }
  const bool hasArms =
      limbAt(result.limbs, biped::leftArm) != nullptr && limbAt(result.limbs, biped::rightArm) != nullptr;
  if (result.plan == "biped" && (!hasArms || std::ranges::any_of(result.limbs, isGuessed))) {
    tellMissing(result, {biped::neck});
  }
}

// Only one of several skeletons in one place is exaggerated.
void tellCopies(const Scene& scene, const BindPose& bindPose, Body& result) {
  std::vector<NodeIndex> joints;
  for (const Limb& limb : result.limbs) {
    const std::vector<NodeIndex> own = jointsAndEnd(limb);
    joints.insert(joints.end(), own.begin(), own.end());
  }
  std::vector<NodeIndex> copies = copiesOf(scene, bindPose, joints);
  if (copies.empty()) {
    return;
  }
  const std::vector<std::vector<Vec3>> clouds = vertexClouds(scene, bindPose, RigidMeshes::none);
  std::erase_if(copies, [&](NodeIndex top) { return isIdle(scene, clouds, top); });
  if (!copies.empty()) {
    result.warnings.push_back(
        "more than one skeleton in the same place: what follows " + nodeNames(scene, copies) +
        " does not follow the limbs; let one skeleton move all meshes, or choose its chains");
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
  const body::HumanoidTable table = body::readHumanoid(scene, bindPose);
  std::optional<body::Finding> one =
      body::findOneOfSeveral(scene, bindPose, table.limbs.empty() ? "" : "biped");
  const bool isOne = one.has_value();
  body::Finding finding = isOne ? *std::move(one) : body::findLimbs(scene, bindPose);
  body::applyHumanoid(finding, table);
  if (table.limbs.empty() && !isOne) {
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
  body::tellGuesses(finding.result);
  body::tellCopies(scene, bindPose, finding.result);
  body::tellLimbsLeftOut(scene, bindPose, finding.result);
  body::measure(scene, bindPose, clip, finding);
  return std::move(finding.result);
}

Body bodyAsPlan(const Scene& scene, const BodyPlan& plan, const Clip* clip) {
  const body::BindPose bindPose = body::placeBindPose(scene);
  std::optional<body::Finding> one = body::findOneOfSeveral(scene, bindPose, plan.id);
  const bool isOne = one.has_value();
  body::Finding finding = isOne ? *std::move(one) : body::findLimbs(scene, bindPose);
  finding.result.warnings.clear();
  if (plan.id == "biped") {
    body::applyHumanoid(finding, body::readHumanoid(scene, bindPose));
    body::addTail(finding);
  } else if (plan.id == "other") {
    body::takeChains(scene, bindPose, finding);
  } else if (!isOne) {
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
