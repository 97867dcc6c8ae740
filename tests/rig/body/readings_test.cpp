#include <algorithm>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/support/recorded.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// Everything that is read of a body, by the keys of its joints.
std::string readingOf(const std::string& title, const SyntheticBiped& body) {
  const BuiltBiped built = build(body);
  const Body found = detectBody(built.scene);
  const auto key = [&](NodeIndex node) {
    const auto at = std::ranges::find_if(built.node, [&](const auto& one) { return one.second == node; });
    return at == built.node.end() ? std::string("none") : at->first;
  };
  std::string text = fmt::format("{}\n  {} {:.3f} , height {:.3f} , hips {} , head {}\n", title, found.plan,
                                 found.planConfidence, found.height, key(found.hips), key(found.head));
  for (const Limb& limb : found.limbs) {
    text += "  " + limb.id;
    for (const NodeIndex joint : limb.joints) {
      text += " " + key(joint);
    }
    text +=
        fmt::format(" -> {} , {:.3f} long, {:.3f} sure", key(limb.endNode), limb.restLength, limb.confidence);
    for (std::size_t i = 0; i < limb.reasons.size(); ++i) {
      text += (i == 0 ? ": " : "; ") + limb.reasons[i];
    }
    text += "\n";
  }
  for (const std::string& reason : found.planReasons) {
    text += "  because: " + reason + "\n";
  }
  for (const std::string& warning : found.warnings) {
    text += "  warns: " + warning + "\n";
  }
  return text;
}

bool isUnder(const SyntheticBiped& body, std::string key, const std::string& above) {
  while (!key.empty() && key != above) {
    const auto found = std::ranges::find(body.joints, key, &SyntheticJoint::key);
    key = found == body.joints.end() ? "" : found->parent;
  }
  return key == above;
}

/// Takes a joint away with all below it.
void cutOff(SyntheticBiped& body, const std::string& key) {
  const SyntheticBiped whole = body;
  std::erase_if(body.joints, [&](const SyntheticJoint& joint) { return isUnder(whole, joint.key, key); });
}

/// Some joints stand elsewhere, lack their names, their vertices or are gone; a few joints are more.
SyntheticBiped damaged(SyntheticBiped body, Row& row) {
  for (SyntheticJoint& joint : body.joints) {
    joint.position += row.vector(0.02);
    joint.movesMesh = !row.once(12);
    if (row.once(6)) {
      body.names.erase(joint.key);
    }
  }
  for (std::uint32_t gone = row.below(3); gone > 0; --gone) {
    cutOff(body, body.joints[1 + row.below(static_cast<std::uint32_t>(body.joints.size() - 1))].key);
  }
  for (std::uint32_t more = row.below(4); more > 0; --more) {
    const SyntheticJoint above = row.oneOf(body.joints);
    body.joints.push_back({"more" + std::to_string(more), above.key, above.position + row.vector(0.2)});
  }
  body.facesBackwards = row.once(2);
  body.withMesh = !row.once(5);
  body.feetPointBack = row.once(6);
  return body;
}

} // namespace

TEST_CASE("What is read of bipeds by any naming and of any build is as it was looked at") {
  std::string text;
  for (const NamingScheme& scheme : namingSchemes()) {
    text += readingOf(scheme.title, makeNamedBody(scheme.title));
  }
  for (const char* const title : {"Mixamo", "no names"}) {
    const std::string start = std::string(title) + ", ";
    text += readingOf(start + "no clavicles", makeNamedBody(title, {.clavicles = false}));
    text += readingOf(start + "no hands", makeNamedBody(title, {.hands = false, .fingers = false}));
    text += readingOf(start + "no feet", makeNamedBody(title, {.feet = false, .toes = false}));
    text += readingOf(start + "no toes", makeNamedBody(title, {.toes = false}));
    text += readingOf(start + "one spine joint", makeNamedBody(title, {.spineJoints = 1}));
    text += readingOf(start + "five spine and two neck joints",
                      makeNamedBody(title, {.spineJoints = 5, .neckJoints = 2}));
    text += readingOf(start + "tips", makeNamedBody(title, {.tips = true}));
    for (const char* const limb : {"upperArm.l", "thigh.r", "neck0", "spine0", "hand.l", "shin.l"}) {
      SyntheticBiped body = makeNamedBody(title);
      cutOff(body, limb);
      text += readingOf(start + "without " + limb, body);
    }
  }
  const std::string difference = differenceFromRecord("readings-of-bipeds", text);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("What is read of other creatures, with names and without, is as it was looked at") {
  std::string text;
  for (Creature& creature : creatures()) {
    nameByKeys(creature.body);
    text += readingOf(creature.title, creature.body);
    creature.body.names.clear();
    text += readingOf(creature.title + ", no names", creature.body);
    creature.body.facesBackwards = true;
    text += readingOf(creature.title + ", no names, facing back", creature.body);
    creature.body.withMesh = false;
    text += readingOf(creature.title + ", no names, no mesh", creature.body);
  }
  const std::string difference = differenceFromRecord("readings-of-creatures", text);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("What is read of damaged bodies is as it was looked at") {
  std::string text;
  Row row(7);
  std::vector<Creature> bodies = creatures();
  for (Creature& creature : bodies) {
    nameByKeys(creature.body);
  }
  bodies.push_back({"biped", "biped", makeNamedBody("Mixamo")});
  bodies.push_back({"biped of other names", "biped", makeNamedBody("Unreal")});
  bodies.push_back({"biped without names", "biped", makeNamedBody("no names")});
  for (int i = 0; i < 40; ++i) {
    const Creature& creature = row.oneOf(bodies);
    text += readingOf(fmt::format("{}: {}", i, creature.title), damaged(creature.body, row));
  }
  const std::string difference = differenceFromRecord("readings-of-damaged-bodies", text);
  INFO(difference);
  CHECK(difference.empty());
}
