// Nodes whose transforms a trail may change: all that lies on a limb, hangs on it or goes along with its end.
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/reach/limb_topology.h"

using namespace stretch;
using namespace stretch::rig;

TEST_CASE(
    "A limb touches its joints, what lies between them, rides on them, hangs on them and goes with its end") {
  const auto node = [](std::size_t index) { return NodeIndex(index); };
  Limb limb;
  limb.joints = {node(4), node(9)};
  limb.endNode = node(12);
  LimbTopology topology;
  topology.bones.resize(2);
  topology.bones[0].pathNodes = {node(6), node(9)};
  topology.bones[0].twistNodes = {node(7)};
  topology.bones[0].hanging = {node(8)};
  topology.bones[1].pathNodes = {node(11), node(12)};
  topology.staying = {node(3)};
  topology.companions = {node(14), node(13)};
  topology.leader = node(2);
  std::vector<NodeIndex> all;
  for (const std::size_t index : {2U, 3U, 4U, 6U, 7U, 8U, 9U, 11U, 12U, 13U, 14U}) {
    all.push_back(node(index));
  }
  CHECK(touchedNodes(limb, topology) == all);
  limb.endNode = NodeIndex::none;
  topology.leader = NodeIndex::none;
  topology.bones[1].pathNodes.clear();
  std::erase_if(all, [&](NodeIndex one) { return one == node(2) || one == node(11) || one == node(12); });
  CHECK(touchedNodes(limb, topology) == all);
}
