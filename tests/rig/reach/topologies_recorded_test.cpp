#include <algorithm>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rig/limb_nodes.h"
#include "rig/reach/limb_topology.h"
#include "tests/support/nodes.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

std::string keysOf(const MovingBiped& moving, const std::vector<NodeIndex>& nodes) {
  std::string text;
  for (const NodeIndex node : nodes) {
    const auto found = std::ranges::find_if(moving.node, [&](const auto& one) { return one.second == node; });
    text += " " + (found != moving.node.end() ? found->first : moving.scene.nodes[at(node)].name);
  }
  return nodes.empty() ? " nothing" : text;
}

std::string topologyText(const std::string& title, const MovingBiped& moving) {
  const BindPlaces places = bindPlaces(moving.scene);
  std::string text = title + "\n";
  for (const Limb& limb : moving.body.limbs) {
    const LimbTopology topology = limbTopology(moving.scene, limb, moving.body.limbs, places);
    text += fmt::format("  {}{}\n", limb.id, topology.endIsDescendant ? "" : ", its end hangs elsewhere");
    for (const BoneTopology& bone : topology.bones) {
      text += "   " + keysOf(moving, {bone.joint}) + " by" + keysOf(moving, bone.pathNodes) + " , with it" +
              keysOf(moving, bone.twistNodes) + " , on it" + keysOf(moving, bone.hanging) + "\n";
    }
    text += "    stays" + keysOf(moving, topology.staying) + " , goes with the end" +
            keysOf(moving, topology.companions) + " , touched";
    text += fmt::format(" {} nodes\n", touchedNodes(limb, topology).size());
  }
  text += "  belong to limbs:";
  for (const int owner : limbOfNodes(moving.scene, moving.body.limbs, moving.body.hips)) {
    text += fmt::format(" {}", owner);
  }
  return text + "\n";
}

/// A box of rigid mesh beside a joint.
void hangBoxBeside(MovingBiped& moving, const std::string& key, const Vec3& middle, const Vec3& half) {
  const NodeIndex box = addNode(moving.scene, "box on " + key, moving.node.at(key), middle);
  Primitive primitive;
  for (int corner = 0; corner < 8; ++corner) {
    primitive.positions.emplace_back(half * Vec3((corner & 1) != 0 ? 1.0 : -1.0,
                                                 (corner & 2) != 0 ? 1.0 : -1.0,
                                                 (corner & 4) != 0 ? 1.0 : -1.0));
  }
  moving.scene.nodes[at(box)].mesh = static_cast<int>(moving.scene.meshes.size());
  moving.scene.meshes.push_back({"box", {primitive}, {}});
}

} // namespace

TEST_CASE("What belongs to the bones of bodies of every build is as it was looked at") {
  std::string text;
  Row row(9);
  const std::vector<std::pair<std::string, std::string>> bones{{"upperArm.l", "foreArm.l"},
                                                               {"foreArm.r", "hand.r"},
                                                               {"thigh.l", "shin.l"},
                                                               {"shin.r", "foot.r"},
                                                               {"spine0", "spine1"}};
  for (int i = 0; i < 24; ++i) {
    SyntheticBiped body = namedBody({.toes = !row.once(4), .fingers = row.once(3)});
    body.size = row.once(3) ? 0.01 : 1.0;
    for (std::uint32_t twist = row.below(4); twist > 0; --twist) {
      const auto& [from, to] = row.oneOf(bones);
      const std::string key = fmt::format("twist{}", twist);
      addTwist(body, key, from, to, row.between(-0.1, 1.1), row.once(3));
      jointOf(body, key).position += row.vector(row.once(2) ? 0.04 : 0.1);
    }
    if (row.once(3)) { // The heel hangs under the root, as what drives it does.
      body.joints.push_back({"heel.l", "root", Vec3(0.1, 0.03, -0.06) + row.vector(0.12)});
    }
    if (row.once(3)) {
      jointOf(body, "foot.r").parent = "root";
    }
    MovingBiped moving = still(body);
    for (std::uint32_t boxes = row.below(4); boxes > 0; --boxes) {
      hangBoxBeside(moving, row.oneOf(bones).first, body.size * row.vector(0.3),
                    body.size * Vec3(0.05, 0.06, 0.2));
    }
    text += topologyText(fmt::format("{}", i), moving);
  }
  text += topologyText("a horse", pawingHorse()) + topologyText("a snake", strikingSnake());
  for (Creature& creature : creatures()) {
    nameByKeys(creature.body);
    text += topologyText(creature.title, still(creature.body));
  }
  const std::string difference = differenceFromRecord("belonging-to-bones", text);
  INFO(difference);
  CHECK(difference.empty());
}
