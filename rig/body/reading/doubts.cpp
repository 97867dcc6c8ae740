#include "rig/body/reading/doubts.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "rig/body/evidence/name_evidence.h"
#include "rig/body/evidence/name_words.h"
#include "rig/body/evidence/own_names.h"
#include "rig/body/reading/extremities.h"
#include "rig/body/reading/limb_assembly.h"

namespace stretch::rig::body {

void doubt(Body& result, const std::string& why) {
  constexpr double guessed = 0.4;
  result.planConfidence = std::min(result.planConfidence, guessed);
  for (Limb& limb : result.limbs) {
    limb.confidence = std::min(limb.confidence, guessed);
  }
  result.warnings.push_back(why);
}

bool mayLie(const Scene& scene, const BindPose& bindPose, const PlanReading& reading) {
  const std::vector<std::string> names = ownNames(scene);
  constexpr double leastDrop = 0.35;  // of the limb
  constexpr double leastStart = 0.25; // of its first bone
  bool hasArms = false;
  bool hasUpperArms = false;
  bool goesDown = true;
  bool startsDown = true;
  for (const Limb& limb : reading.limbs) {
    if (limb.kind == LimbKind::leg) {
      const std::string& called = names[at(limb.joints.front())];
      const NameEvidence name = readName(called);
      // A front leg is what a biped's arm would be, and no arm.
      const bool isUpperArm = name.role(Role::upperArm) >= 0.5 && !partWords(called).contains(PartWord::leg);
      const bool isArm = isUpperArm || name.role(Role::clavicle) >= 0.5;
      const std::vector<Vec3> points = limbPoints(limb, bindPose.worlds);
      const Vec3 first = points[0] - points[1];
      hasArms = hasArms || isArm;
      hasUpperArms = hasUpperArms || isUpperArm;
      goesDown = goesDown && points.front().y - points.back().y >= leastDrop * limb.restLength;
      startsDown = startsDown && (isArm || first.y >= leastStart * glm::length(first));
    }
  }
  const bool hasLegsOfPerson = reading.plan->legs == 4 || reading.plan->legs == 6; // twice the same, for
                                                                                   // helpers
  const bool hasTail = limbAt(reading.limbs, {LimbKind::tail}) != nullptr;
  const bool lies = !goesDown && (hasUpperArms || (hasArms && !hasTail));
  const bool sits = !startsDown && hasUpperArms;
  return hasLegsOfPerson && (lies || sits);
}

bool mayBePerson(const Scene& scene, const PlanReading& reading) {
  const std::vector<std::string> names = ownNames(scene);
  bool hasArms = false;
  bool hasTail = false;
  double longestArm = 0.0;
  for (const Limb& limb : reading.limbs) {
    longestArm = isArm(limb) ? std::max(longestArm, limb.restLength) : longestArm;
  }
  for (const Limb& limb : reading.limbs) {
    hasTail = hasTail || (limb.kind == LimbKind::tail && limb.restLength > longestArm);
    for (const NodeIndex joint : limb.joints) {
      const std::string& name = names[at(joint)];
      hasArms = hasArms ||
                ((isArm(limb) || limb.kind == LimbKind::wing) && readName(name).role(Role::upperArm) >= 0.5);
      hasTail = hasTail || (limb.kind == LimbKind::tail && partWords(name).contains(PartWord::tail));
    }
  }
  return reading.plan->legs == 2 && hasArms && !hasTail;
}

PlanReading turnedOver(PlanReading reading, const Vec3& up) {
  reading.confidence *= 0.8;
  reading.up = up;
  const char* const how = up.y < 0.0 ? "stands upside down" : up.y > 0.5 ? "leans" : "lies";
  reading.warnings.push_back(fmt::format("the body {} in its bind pose: are its limbs right?", how));
  return reading;
}

bool hasGuessedWings(const PlanReading& reading) {
  constexpr double named = 0.8;
  return reading.confidence < named && std::ranges::any_of(reading.limbs, [](const Limb& limb) {
           return limb.kind == LimbKind::wing || isArm(limb);
         });
}

bool hasArmsForLegs(const Scene& scene, const PlanReading& reading) {
  constexpr double clear = 0.8;
  const std::vector<std::string> names = ownNames(scene);
  const bool isInsect = reading.plan->legs == 6;
  return (isInsect || reading.plan->legs == 2) && std::ranges::any_of(reading.limbs, [&](const Limb& limb) {
           return isLeg(limb) && std::ranges::any_of(limb.joints, [&](NodeIndex joint) {
                    const std::string& name = names[at(joint)];
                    return readName(name).role(Role::upperArm) >= clear ||
                           (isInsect && partWords(name).contains(PartWord::arm));
                  });
         });
}

bool hasArmInMiddle(const PlanReading& reading, const std::vector<Limb>& ofPerson) {
  return std::ranges::any_of(reading.limbs, [&](const Limb& middle) {
    return middle.side == LimbSide::middle && std::ranges::any_of(ofPerson, [&](const Limb& limb) {
             return isArm(limb) &&
                    std::ranges::find_first_of(limb.joints, middle.joints) != limb.joints.end();
           });
  });
}

bool mayBeNoSerpent(const Scene& scene, const BindPose& bindPose, const PlanReading& reading) {
  constexpr double steep = 0.7; // sine
  const Limb* const row = limbAt(reading.limbs, biped::spine);
  if (reading.plan->legs > 0 || row == nullptr) {
    return false;
  }
  const std::vector<std::string> names = ownNames(scene);
  std::size_t joints = 0;
  for (const Limb& limb : reading.limbs) {
    joints += limb.joints.size();
  }
  const auto areCalled = [](const std::vector<std::string>& called, std::initializer_list<PartWord> parts) {
    return std::ranges::any_of(called, [&](const std::string& name) {
      const std::set<PartWord> words = partWords(name);
      return std::ranges::any_of(parts, [&](PartWord part) { return words.contains(part); });
    });
  };
  std::vector<std::string> ofRow;
  std::ranges::transform(jointsAndEnd(*row), std::back_inserter(ofRow),
                         [&](NodeIndex node) { return names[at(node)]; });
  const std::vector<Vec3> points = limbPoints(*row, bindPose.worlds);
  const Vec3 along = points.back() - points.front();
  const bool stands = std::abs(along.y) > steep * glm::length(along);
  const bool isPart = 2 * joints < skinJoints(scene).size() && !areCalled(names, {PartWord::head});
  return areCalled(ofRow, {PartWord::leg, PartWord::arm, PartWord::wing, PartWord::ornament}) ||
         ((stands || isPart) && !areCalled(names, {PartWord::tail, PartWord::fin}));
}

bool standsOnFour(const BindPose& bindPose, const Body& body, const Vec3& bodyUp) {
  constexpr double flattest = 0.5;  // sine, of a trunk that does not lie
  constexpr double leastDrop = 0.6; // of the limb
  const auto goesDown = [&](const Limb& limb) {
    const double base = positionOf(bindPose.worlds[at(limb.joints.front())]).y;
    return base - endPosition(limb, bindPose.worlds).y > leastDrop * limb.restLength;
  };
  const auto downwards = std::ranges::count_if(
      body.limbs, [&](const Limb& limb) { return (isArm(limb) || isLeg(limb)) && goesDown(limb); });
  return body.isBiped && downwards == 4 && std::abs(bodyUp.y) < flattest * glm::length(bodyUp);
}

bool hasLegsForArms(const Scene& scene, const Body& body) {
  constexpr double shorter = 0.7; // than the legs: nothing stands on such arms
  const std::vector<std::string> names = ownNames(scene);
  int legs = 0;
  int arms = 0;
  double armLength = 0.0;
  double legLength = 0.0;
  for (const Limb& limb : body.limbs) {
    armLength = isArm(limb) ? std::max(armLength, limb.restLength) : armLength;
    legLength = isLeg(limb) ? std::max(legLength, limb.restLength) : legLength;
    for (const NodeIndex joint : isArm(limb) ? jointsAndEnd(limb) : std::vector<NodeIndex>{}) {
      const std::set<PartWord> words = partWords(names[at(joint)]);
      legs += words.contains(PartWord::leg) ? 1 : 0;
      arms += words.contains(PartWord::arm) ? 1 : 0;
    }
  }
  return body.isBiped && armLength > shorter * legLength && legs >= 2 && legs > arms;
}

bool hasWingsForArms(const Scene& scene, const Body& body) {
  return body.isBiped && std::ranges::none_of(body.limbs, isArm) &&
         std::ranges::any_of(ownNames(scene), [](const std::string& name) {
           return partWords(name).contains(PartWord::wing);
         });
}

namespace {

struct Bone {
  Vec3 start{0.0};
  Vec3 end{0.0};
};

std::vector<Bone> bonesOf(const std::vector<Limb>& limbs, const BindPose& bindPose) {
  std::vector<Bone> bones;
  for (const Limb& limb : limbs) {
    const std::vector<Vec3> points = limbPoints(limb, bindPose.worlds);
    for (std::size_t i = 1; i < points.size(); ++i) {
      bones.push_back({points[i - 1], points[i]});
    }
  }
  return bones;
}

double distanceTo(const Bone& bone, const Vec3& place) {
  const Vec3 along = bone.end - bone.start;
  const double square = glm::dot(along, along);
  const double share =
      square > 0.0 ? std::clamp(glm::dot(place - bone.start, along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(place, bone.start + share * along);
}

// Limbs, what carries them, and what they carry: hands, claws, gear.
std::vector<bool> nodesOfLimbs(const Scene& scene, const Body& body) {
  std::vector<bool> isTaken(scene.nodes.size(), false);
  std::vector<bool> isCarried(scene.nodes.size(), false);
  for (const Limb& limb : body.limbs) {
    for (const NodeIndex joint : jointsAndEnd(limb)) {
      isCarried[at(joint)] = isCarried[at(joint)] || !isTrunk(limb);
      for (NodeIndex node = joint; node.exists() && !isTaken[at(node)]; node = scene.nodes[at(node)].parent) {
        isTaken[at(node)] = true;
      }
    }
  }
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    isCarried[at(node)] = isCarried[at(node)] || (parent.exists() && isCarried[at(parent)]);
    isTaken[at(node)] = isTaken[at(node)] || isCarried[at(node)];
  }
  return isTaken;
}

// Clothes, hair and gear, whatever limbs their names name as well: a pony tail, the wing of a collar.
bool isCalledGear(const std::string& called) {
  std::string before;
  for (const NameChunk& chunk : nameChunks(called)) {
    std::vector<std::string> parts = chunk.parts;
    parts.insert(parts.end(), {chunk.whole, before + chunk.whole});
    for (const std::string& part : parts) {
      const std::set<PartWord> words = partWords(part);
      const bool isOfBeast = words.contains(PartWord::wing) || words.contains(PartWord::tail);
      if (part.starts_with("feather") || (lookUpWord(part) == Word::accessory && !isOfBeast)) {
        return true;
      }
    }
    before = chunk.whole;
  }
  return false;
}

// Whether each word of a name is known: "thigh_plate" may be anything about a thigh.
bool isKnownThroughout(const std::string& called) {
  const auto isKnown = [](const std::string& part) {
    return part.size() < 2 || lookUpWord(part) || !partWords(part).empty() || rowLetters(part) ||
           !cutIntoWords(part, [](std::string_view word) { return lookUpWord(word).has_value(); }).empty();
  };
  const std::vector<NameChunk> chunks = nameChunks(called);
  return std::ranges::all_of(
      chunks, [&](const NameChunk& chunk) { return std::ranges::all_of(chunk.parts, isKnown); });
}

bool isCalledLimb(const std::string& called, const Body& body) {
  const NameEvidence name = readName(called);
  const std::set<PartWord> words = partWords(called);
  const auto has = [&](PartWord word) { return words.contains(word); };
  const bool isGear = name.twist || name.control || name.end || name.finger || name.palm || name.face ||
                      has(PartWord::ornament) || has(PartWord::head) || isCalledGear(called);
  const auto legs = std::ranges::count_if(body.limbs, [](const Limb& limb) { return isLeg(limb); });
  const bool isBelly = called.find("bdomen") != std::string::npos && legs <= 4;
  const bool hasArms = std::ranges::any_of(body.limbs, isArm); // and so a muscle for each fin
  const bool hasWings = std::ranges::count(body.limbs, LimbKind::wing, &Limb::kind) > 0;
  return !isGear && ((has(PartWord::wing) && !hasWings) || (has(PartWord::tail) && !isBelly) ||
                     (has(PartWord::fin) && !hasArms) || has(PartWord::arm) || has(PartWord::leg));
}

// Joints of skins by what they are called and where they hang.
std::vector<bool> isCalledLimbInNone(const Scene& scene, const Body& body) {
  std::vector<bool> isLeft(scene.nodes.size(), false);
  const std::vector<std::string> names = ownNames(scene);
  const std::vector<bool> isTaken = nodesOfLimbs(scene, body);
  const std::set<NodeIndex> joints = skinJoints(scene);
  for (const NodeIndex joint : joints) {
    const std::vector<NodeIndex>& children = scene.nodes[at(joint)].children;
    const bool isLone =
        std::ranges::none_of(children, [&](NodeIndex child) { return joints.contains(child); });
    isLeft[at(joint)] = !isTaken[at(joint)] && isCalledLimb(names[at(joint)], body) &&
                        (!isLone || isKnownThroughout(names[at(joint)])) &&
                        !(body.head.exists() && isAncestorOrSelf(scene, body.head, joint)); // hair
  }
  return isLeft;
}

std::vector<NodeIndex> calledLimbsLeftOut(const Scene& scene, const BindPose& bindPose, const Body& body) {
  const std::vector<bool> isLeft = isCalledLimbInNone(scene, body);
  const std::vector<Bone> bones = bonesOf(body.limbs, bindPose);
  if (bones.empty() || std::ranges::count(isLeft, true) == 0) {
    return {};
  }
  constexpr double away = 0.1; // of the body
  double size = 0.0;
  for (const Bone& bone : bones) {
    size = std::max(size, glm::distance(bones.front().start, bone.end));
  }
  const auto standsOut = [&](const Vec3& place) {
    return std::ranges::all_of(bones,
                               [&](const Bone& bone) { return distanceTo(bone, place) > away * size; });
  };
  const std::vector<std::vector<Vec3>> clouds = vertexClouds(scene, bindPose, RigidMeshes::none);
  std::vector<bool> isOfRow(scene.nodes.size(), false);
  std::vector<NodeIndex> tops;
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    const bool goesOn = parent.exists() && isOfRow[at(parent)];
    const bool begins = isLeft[at(node)] && std::ranges::any_of(clouds[at(node)], standsOut);
    isOfRow[at(node)] = goesOn || begins;
    if (begins && !goesOn) {
      tops.push_back(node);
    }
  }
  return tops;
}

} // namespace

void tellLimbsLeftOut(const Scene& scene, const BindPose& bindPose, Body& body) {
  // Of other bodies, of copies and of rows of joints it is told already that they are left out.
  const bool isTold = body.plan == "other" || std::ranges::any_of(body.warnings, [](const std::string& told) {
                        return told.find("characters in the file") != std::string::npos ||
                               told.find("more than one skeleton") != std::string::npos;
                      });
  std::vector<NodeIndex> tops = isTold ? std::vector<NodeIndex>{} : calledLimbsLeftOut(scene, bindPose, body);
  if (!tops.empty()) {
    constexpr std::size_t most = 8;
    const std::size_t further = tops.size() - std::min(most, tops.size());
    tops.resize(tops.size() - further);
    body.warnings.push_back("left out, though called limbs: " + nodeNames(scene, tops) +
                            (further > 0 ? " and " + std::to_string(further) + " more" : "") +
                            "; choose chains of joints if they are to be some");
  }
  // Where front legs hang on the joint that is called neck it would swing them.
  const NodeIndex above = body.head.exists() ? scene.nodes[at(body.head)].parent : NodeIndex::none;
  const bool isInNone = std::ranges::none_of(
      body.limbs, [&](const Limb& limb) { return std::ranges::count(limb.joints, above) > 0; });
  if (body.plan != "other" && isInNone && above.exists() &&
      readName(scene.nodes[at(above)].name).role(Role::neck) >= 0.8) {
    body.warnings.push_back("no neck found, though " + nodeNames(scene, {above}) +
                            " is called one: choose a chain of joints if it is to be one");
  }
}

bool leansAsABird(const BindPose& bindPose, const Body& body, const Vec3& legsReach) {
  constexpr double leastInLine = 0.5; // cosine
  const Limb* const spine = limbAt(body.limbs, biped::spine);
  if (!body.isBiped || spine == nullptr) {
    return false;
  }
  const std::vector<Vec3> points = limbPoints(*spine, bindPose.worlds);
  const Vec3 trunk = points.back() - points.front();
  return -glm::dot(trunk, legsReach) < leastInLine * glm::length(trunk) * glm::length(legsReach);
}

} // namespace stretch::rig::body
