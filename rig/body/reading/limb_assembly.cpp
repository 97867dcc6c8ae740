#include "rig/body/reading/limb_assembly.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/polyline.h"

namespace stretch::rig::body {

namespace {

double lengthOf(const std::vector<NodeIndex>& joints, const Vec3& end, const std::vector<Mat4>& worlds) {
  std::vector<Vec3> points;
  points.reserve(joints.size() + 1);
  for (const NodeIndex joint : joints) {
    points.push_back(positionOf(worlds[at(joint)]));
  }
  points.push_back(end);
  return polylineLength(points);
}

// Whether a joint within a path stands off the bone between its ends by more than a twist joint would: it
// bends the limb as well.
bool bends(const BodyView& view, const std::vector<int>& path, std::size_t i) {
  constexpr double leastOffset = 0.08; // of the bone
  const Vec3 bone = view.at(path.back()) - view.at(path.front());
  const Vec3 there = view.at(path[i]) - view.at(path.front());
  const Vec3 off = there - bone * (glm::dot(there, bone) / glm::dot(bone, bone));
  return !view.name(path[i]).twist && glm::length(off) > leastOffset * glm::length(bone);
}

// Where one side of a body bends in its bind pose and the other stands straight, both bend at the same
// joints.
std::vector<int> jointsOf(const BodyView& view, const LimbGuess& guess, const LimbGuess& mirrored) {
  std::vector<int> joints{guess.base};
  const auto extend = [&](const std::vector<int>& path, const std::vector<int>& other) {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const bool isMirrored =
          other.size() == path.size() && !view.name(path[i]).twist && bends(view, other, i);
      if (bends(view, path, i) || isMirrored) {
        joints.push_back(path[i]);
      }
    }
  };
  if (guess.middle >= 0) {
    extend(view.path(guess.base, guess.middle), view.path(mirrored.base, mirrored.middle));
    joints.push_back(guess.middle);
    if (guess.end >= 0 && !guess.endDetached) {
      extend(view.path(guess.middle, guess.end), view.path(mirrored.middle, mirrored.end));
    }
  }
  return joints;
}

std::vector<NodeIndex> nodesOf(const BodyView& view, const std::vector<int>& candidates) {
  std::vector<NodeIndex> nodes;
  nodes.reserve(candidates.size());
  for (const int candidate : candidates) {
    nodes.push_back(view.nodes[static_cast<std::size_t>(candidate)]);
  }
  return nodes;
}

LimbEnd jointEnd(const BodyView& view, int candidate) {
  return {view.nodes[static_cast<std::size_t>(candidate)], view.at(candidate)};
}

double combine(double nameShare, double shape) {
  return 1.0 - (1.0 - 0.9 * nameShare) * (1.0 - 0.7 * shape);
}

// Whether names call joints elsewhere the rest of a limb of one bone: all hang side by side in the file.
bool isCutShort(const Scene& scene, const BodyView& view, const LimbGuess& guess, Region region) {
  if (guess.middle >= 0) {
    return false;
  }
  constexpr double clear = 0.8;
  const NodeIndex base = view.nodes[static_cast<std::size_t>(guess.base)];
  return std::ranges::any_of(skinJoints(scene), [&](NodeIndex joint) {
    const NameEvidence name = readName(scene.nodes[at(joint)].name);
    return name.role(region == Region::arm ? Role::foreArm : Role::shin) >= clear &&
           name.side == namedSide(view, guess) && !isAncestorOrSelf(scene, base, joint);
  });
}

// Whether two limbs are far from equally long, which no pose makes them.
bool areUnequal(const LimbPair& pair) {
  constexpr double most = 1.3;
  return pair.negative && pair.positive &&
         std::max(pair.negative->length, pair.positive->length) >
             most * std::min(pair.negative->length, pair.positive->length);
}

double confidenceOf(const Scene& scene, const BodyView& view, const LimbGuess& guess, const LimbPair& pair,
                    Region region, const Sides& sides) {
  // Three joints well named, or the one or two that the limb has.
  const double fullNameFit = guess.middle < 0 ? 0.9 : guess.end < 0 ? 1.7 : 2.6;
  const double names = std::clamp(guess.nameFit / fullNameFit, 0.0, 1.0);
  const bool paired = pair.negative && pair.positive;
  const double mirror = paired ? std::exp(-4.0 * pair.mirrorError) : 0.6;
  // Of two that mirror each other the better shape counts: a prop in one hand makes no difference.
  const bool alike = paired && pair.mirrorError < 0.1;
  const double penalty =
      alike ? std::min(pair.negative->shapePenalty, pair.positive->shapePenalty) : guess.shapePenalty;
  const double shape = std::exp(-0.6 * std::max(0.0, penalty)) * mirror;
  constexpr double contradictedShare = 0.75;
  // At most, of a limb that ends at a thing instead of a hand or foot, or before it.
  constexpr double doubtedShare = 0.45;
  const bool endsAtThing = guess.end >= 0 && (view.name(guess.end).accessory || view.name(guess.end).twist);
  const double most =
      endsAtThing || isCutShort(scene, view, guess, region) || areUnequal(pair) ? doubtedShare : 1.0;
  return std::min(most, combine(names, shape) * (guess.end < 0 ? 0.95 : 1.0) *
                            (0.85 + 0.15 * sides.certainty) * (sides.contradicted ? contradictedShare : 1.0));
}

std::vector<std::string> reasonsOf(const Scene& scene, const BodyView& view, const LimbGuess& guess,
                                   const LimbPair& pair, Region region, const Sides& sides) {
  std::vector<int> joints{guess.base};
  for (const int joint : {guess.middle, guess.end}) {
    if (joint >= 0) {
      joints.push_back(joint);
    }
  }
  std::vector<std::string> reasons;
  const std::string names = nodeNames(scene, nodesOf(view, joints));
  constexpr double someNameFit = 0.8;
  reasons.push_back(guess.nameFit >= someNameFit
                        ? "joint names: " + names
                        : "names say little: found by position and proportions (" + names + ")");
  if (pair.negative && pair.positive) {
    constexpr double goodMirror = 0.1;
    reasons.emplace_back(pair.mirrorError < goodMirror ? "mirrors the limb on the other side"
                                                       : "does not quite mirror the limb on the other side");
  } else {
    reasons.emplace_back("no counterpart on the other side");
  }
  reasons.push_back(sides.reason);
  if (areUnequal(pair)) {
    reasons.emplace_back("far from as long as the limb on the other side");
  }
  if (isCutShort(scene, view, guess, region)) {
    reasons.emplace_back("joints that names call the rest of it hang elsewhere");
  } else if (guess.end < 0) {
    const std::optional<EstimatedEnd> end = estimateEnd(view, guess.middle >= 0 ? guess.middle : guess.base);
    reasons.emplace_back(end && end->fromPalms
                             ? "no end joint: estimated from the palm joints"
                             : "no end joint: estimated from the vertices of the last bone");
  } else if (view.name(guess.end).accessory || view.name(guess.end).twist) {
    reasons.emplace_back("the joint at its end is called another thing than a hand or foot");
  } else if (guess.endDetached) {
    reasons.emplace_back(
        "the end joint is not a descendant of the limb: it follows through its own channels");
  }
  return reasons;
}

// The joint by which a leg that stands on its toes, as a mech's or a satyr's, goes on from its heel to the
// ground; -1 for a foot that is on it.
int jointBeyondHeel(const BodyView& view, const LimbGuess& leg) {
  constexpr double leastHeel = 0.25; // over the ground, of the height of the leg's base
  constexpr double leastDrop = 0.2;  // from the heel to the next joint
  constexpr double steep = 0.6;      // sine
  constexpr double bentKnee = 0.94;  // cosine: 20 degrees
  const Vec3 upper = leg.middle < 0 ? Vec3(0.0) : view.at(leg.middle) - view.at(leg.base);
  const Vec3 lower = leg.middle < 0 ? Vec3(0.0) : leg.endPosition - view.at(leg.middle);
  const bool isBent = glm::dot(upper, lower) < bentKnee * glm::length(upper) * glm::length(lower);
  if (leg.end < 0 || leg.endDetached || !isBent) {
    return -1;
  }
  double floor = leg.endPosition.y;
  for (int joint = 0; joint < view.count(); ++joint) {
    floor = view.movesMesh(joint) ? std::min(floor, view.at(joint).y) : floor;
  }
  const double height = view.at(leg.base).y - floor;
  const double heel = leg.endPosition.y - floor;
  const std::vector<int>& children = view.childrenOf(leg.end);
  const auto lowest = std::ranges::min_element(children, {}, [&](int child) { return view.at(child).y; });
  if (lowest == children.end() || !view.movesMesh(*lowest) || view.name(*lowest).role(Role::toe) >= 0.8) {
    return -1;
  }
  const double drop = leg.endPosition.y - view.at(*lowest).y;
  const bool stands = height - heel > steep * glm::distance(view.at(leg.base), leg.endPosition) &&
                      drop > steep * glm::distance(view.at(*lowest), leg.endPosition);
  return stands && heel > leastHeel * height && drop > leastDrop * height ? *lowest : -1;
}

// Legs of which both stand on their toes end at these.
std::optional<LimbPair> withHeels(const BodyView& view, std::optional<LimbPair> legs) {
  if (!legs || !legs->negative || !legs->positive) {
    return legs;
  }
  const int negative = jointBeyondHeel(view, *legs->negative);
  const int positive = jointBeyondHeel(view, *legs->positive);
  if (negative >= 0 && positive >= 0) {
    for (const auto& [leg, end] :
         {std::pair(&*legs->negative, negative), std::pair(&*legs->positive, positive)}) {
      leg->end = end;
      leg->endPosition = view.at(end);
    }
  }
  return legs;
}

LimbPlace placeOf(Region region, bool left) {
  return {region == Region::arm ? LimbKind::arm : LimbKind::leg, left ? LimbSide::left : LimbSide::right};
}

LimbEnd spineEnd(const BodyView& view, const BipedReading& reading, const Trunk& trunk) {
  if (!trunk.neck.empty()) {
    return jointEnd(view, trunk.neck.front());
  }
  if (trunk.head >= 0) {
    return jointEnd(view, trunk.head);
  }
  return reading.arms ? LimbEnd{NodeIndex::none, meanBase(view, *reading.arms)} : LimbEnd{};
}

std::optional<Limb> spineOf(const Scene& scene, const BodyView& view, const BipedReading& reading,
                            const Trunk& trunk, const BindPose& bindPose) {
  std::vector<int> joints = trunk.spine;
  std::vector<std::string> reasons;
  LimbEnd end;
  if (joints.size() >= 2) {
    end = jointEnd(view, joints.back());
    joints.pop_back();
    reasons.emplace_back("from the first joint above the hips to the last one of the chest");
  } else {
    end = spineEnd(view, reading, trunk);
    reasons.emplace_back(joints.empty() ? "no joint above the hips: starts at the hips"
                                        : "one joint above the hips");
    if (joints.empty() && trunk.hips >= 0) {
      joints.push_back(trunk.hips);
    }
  }
  if (joints.empty() || (!end.node.exists() && !reading.arms)) {
    return std::nullopt;
  }
  Limb limb = makeLimb(biped::spine, nodesOf(view, joints), end, bindPose.worlds);
  if (limb.restLength < 0.02 * view.size) {
    return std::nullopt;
  }
  const double shape = (reading.arms && reading.legs ? 0.9 : 0.4) * (trunk.spine.size() >= 2 ? 1.0 : 0.7);
  limb.confidence = combine(std::clamp(trunk.spineNameFit, 0.0, 1.0), shape);
  reasons.push_back(nodeNames(scene, limb.joints));
  if (!end.node.exists()) {
    reasons.emplace_back("no end joint: estimated between the shoulders");
  }
  limb.reasons = std::move(reasons);
  return limb;
}

std::optional<Limb> neckOf(const Scene& scene, const BodyView& view, const Trunk& trunk,
                           const BindPose& bindPose) {
  if (trunk.neck.empty()) {
    return std::nullopt;
  }
  LimbEnd end;
  if (trunk.head >= 0) {
    end = jointEnd(view, trunk.head);
  } else if (const std::optional<EstimatedEnd> estimated = estimateEnd(view, trunk.neck.back())) {
    end.position = estimated->position;
  } else {
    return std::nullopt;
  }
  Limb limb = makeLimb(biped::neck, nodesOf(view, trunk.neck), end, bindPose.worlds);
  if (limb.restLength < 1e-3 * view.size) {
    return std::nullopt;
  }
  limb.confidence = combine(std::clamp(trunk.neckNameFit, 0.0, 1.0), end.node.exists() ? 0.75 : 0.35);
  limb.reasons = {"between the chest and the head", nodeNames(scene, limb.joints)};
  if (trunk.hasRivalOfNeck) {
    limb.confidence = std::min(limb.confidence, 0.45);
    limb.reasons.emplace_back("another row of joints may be the neck, or goes on from the head");
  }
  if (!end.node.exists()) {
    limb.reasons.emplace_back("no head joint: estimated from the vertices of the last bone");
  }
  return limb;
}

} // namespace

Limb makeLimb(const LimbPlace& place, std::vector<NodeIndex> joints, const LimbEnd& end,
              const std::vector<Mat4>& bindWorlds) {
  Limb limb;
  static_cast<LimbPlace&>(limb) = place;
  limb.id = limbName(place);
  limb.endNode = end.node;
  const Vec3 position = end.node.exists() ? positionOf(bindWorlds[at(end.node)]) : end.position;
  if (!end.node.exists()) {
    const Mat4& last = bindWorlds[at(joints.back())];
    limb.endOffset = transformPoint(glm::inverse(last), position);
  }
  limb.restLength = lengthOf(joints, position, bindWorlds);
  limb.joints = std::move(joints);
  return limb;
}

bool isSound(const Limb& limb) {
  const Vec3& offset = limb.endOffset;
  return limb.restLength > 0.0 && std::isfinite(limb.restLength + offset.x + offset.y + offset.z);
}

std::vector<Limb> limbsOfReading(const Scene& scene, const BodyView& view, const BipedReading& reading,
                                 const Sides& sides, const BindPose& bindPose) {
  std::vector<Limb> limbs;
  for (const Region region : {Region::arm, Region::leg}) {
    const std::optional<LimbPair> pair = region == Region::arm ? reading.arms : withHeels(view, reading.legs);
    for (const bool left : {true, false}) {
      const bool positive = left == sides.leftIsPositive;
      const std::optional<LimbGuess>* guess = !pair ? nullptr : positive ? &pair->positive : &pair->negative;
      if (guess == nullptr || !*guess) {
        continue;
      }
      const LimbGuess mirrored = (positive ? pair->negative : pair->positive).value_or(**guess);
      const LimbEnd end = (*guess)->end >= 0 ? jointEnd(view, (*guess)->end)
                                             : LimbEnd{NodeIndex::none, (*guess)->endPosition};
      limbs.push_back(makeLimb(placeOf(region, left), nodesOf(view, jointsOf(view, **guess, mirrored)), end,
                               bindPose.worlds));
      limbs.back().confidence = confidenceOf(scene, view, **guess, *pair, region, sides);
      limbs.back().reasons = reasonsOf(scene, view, **guess, *pair, region, sides);
    }
  }
  return limbs;
}

std::vector<Limb> limbsOfTrunk(const Scene& scene, const BodyView& view, const BipedReading& reading,
                               const Trunk& trunk, const BindPose& bindPose) {
  std::vector<Limb> limbs;
  if (std::optional<Limb> spine = spineOf(scene, view, reading, trunk, bindPose)) {
    limbs.push_back(std::move(*spine));
  }
  if (std::optional<Limb> neck = neckOf(scene, view, trunk, bindPose)) {
    limbs.push_back(std::move(*neck));
  }
  return limbs;
}

std::string nodeNames(const Scene& scene, const std::vector<NodeIndex>& nodes) {
  std::string text;
  for (const NodeIndex node : nodes) {
    const std::string& name = scene.nodes[at(node)].name;
    text += text.empty() ? "" : ", ";
    text += name.empty() ? fmt::format("#{}", node.value) : name;
  }
  return text;
}

} // namespace stretch::rig::body
