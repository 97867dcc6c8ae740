#include "rig/body/reading/humanoid.h"

#include <array>
#include <optional>
#include <string>

#include "rig/body/reading/limb_assembly.h"

namespace stretch::rig::body {

namespace {

constexpr double tableConfidence = 0.98;

struct TableLimb {
  LimbPlace place;
  std::array<const char*, 3> bones; // base, middle, end
};

constexpr std::array tableLimbs = std::to_array<TableLimb>({
    {biped::leftArm, {"leftUpperArm", "leftLowerArm", "leftHand"}},
    {biped::rightArm, {"rightUpperArm", "rightLowerArm", "rightHand"}},
    {biped::leftLeg, {"leftUpperLeg", "leftLowerLeg", "leftFoot"}},
    {biped::rightLeg, {"rightUpperLeg", "rightLowerLeg", "rightFoot"}},
});

// The entries of a row of bones that exist, each below the one before.
std::vector<NodeIndex> chainOf(const Scene& scene, std::initializer_list<const char*> bones) {
  std::vector<NodeIndex> chain;
  for (const char* bone : bones) {
    const NodeIndex node = humanoidNode(scene, bone);
    const bool below = chain.empty() || (node != chain.back() && isAncestorOrSelf(scene, chain.back(), node));
    if (node.exists() && below) {
      chain.push_back(node);
    }
  }
  return chain;
}

Limb tableLimb(const LimbPlace& place, std::vector<NodeIndex> joints, NodeIndex end,
               const BindPose& bindPose) {
  Limb limb = makeLimb(place, std::move(joints), {.node = end}, bindPose.worlds);
  limb.confidence = tableConfidence;
  limb.reasons = {"the VRM humanoid table of the file"};
  return limb;
}

std::optional<Limb> spineOf(const Scene& scene, const BindPose& bindPose) {
  std::vector<NodeIndex> chain = chainOf(scene, {"spine", "chest", "upperChest"});
  if (chain.size() == 1) {
    const std::vector<NodeIndex> above = chainOf(scene, {"spine", "neck", "head"});
    if (above.size() > 1) {
      chain.push_back(above[1]);
    }
  }
  if (chain.size() < 2) {
    return std::nullopt;
  }
  const NodeIndex tip = chain.back();
  chain.pop_back();
  return tableLimb(biped::spine, std::move(chain), tip, bindPose);
}

} // namespace

HumanoidTable readHumanoid(const Scene& scene, const BindPose& bindPose) {
  HumanoidTable table;
  table.hips = humanoidNode(scene, "hips");
  table.head = humanoidNode(scene, "head");
  for (const TableLimb& entry : tableLimbs) {
    const std::vector<NodeIndex> chain = chainOf(scene, {entry.bones[0], entry.bones[1], entry.bones[2]});
    if (chain.size() == 3) {
      table.limbs.push_back(tableLimb(entry.place, {chain[0], chain[1]}, chain[2], bindPose));
    }
  }
  if (std::optional<Limb> spine = spineOf(scene, bindPose)) {
    table.limbs.push_back(std::move(*spine));
  }
  const std::vector<NodeIndex> neck = chainOf(scene, {"neck", "head"});
  if (neck.size() == 2) {
    table.limbs.push_back(tableLimb(biped::neck, {neck[0]}, neck[1], bindPose));
  }
  std::erase_if(table.limbs, [](const Limb& limb) { return !isSound(limb); });
  return table;
}

} // namespace stretch::rig::body
