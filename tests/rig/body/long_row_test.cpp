#include "rig/body/reading/long_row.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/rig/joint_views.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::rig::body;

namespace {

/// A row along z whose bones are this long; its joints are 0, 1, 2 and so on.
Extremity rowOfBones(const std::vector<double>& bones) {
  Extremity row;
  row.path = {0};
  row.points = {Vec3(0.0)};
  for (const double bone : bones) {
    row.path.push_back(static_cast<int>(row.path.size()));
    row.points.push_back(row.points.back() + Vec3(0.0, 0.0, bone));
    row.length += bone;
  }
  return row;
}

Axis headAt(int joint) {
  Axis axis;
  axis.head = joint;
  axis.headIsNamed = true;
  return axis;
}

/// A row along z as joints of a body, which the mesh of these follows.
struct SeenRow {
  BodyView view;
  Extremity row;

  SeenRow(const std::vector<double>& bones, const std::vector<int>& meshOf = {}) : row(rowOfBones(bones)) {
    for (std::size_t i = 0; i < row.points.size(); ++i) {
      test::addJoint(view, NodeIndex(i), static_cast<int>(i) - 1, row.points[i]);
    }
    view.hasVertices = !meshOf.empty();
    for (const int joint : meshOf) {
      view.points[static_cast<std::size_t>(joint)] = {view.at(joint)};
    }
  }

  void callFins(int from) {
    for (int joint = from; joint < view.count(); ++joint) {
      view.called[static_cast<std::size_t>(joint)] = "fin_" + std::to_string(joint);
    }
    row.words[static_cast<std::size_t>(PartWord::fin)] = 0.5;
  }
};

} // namespace

TEST_CASE("a row that goes on into a jaw ends at the head, with its points and its length") {
  Extremity row = rowOfBones({1.0, 1.0, 1.0, 0.5, 0.25});
  endAtHead(row, headAt(3));
  CHECK(row.path == std::vector<int>{0, 1, 2, 3});
  REQUIRE(row.points.size() == row.path.size());
  CHECK(row.points.back().z == Approx(3.0));
  CHECK(row.length == Approx(3.0));
}

TEST_CASE("a row that begins at the head goes on") {
  Extremity row = rowOfBones({0.2, 0.2, 1.0, 1.0, 1.0});
  endAtHead(row, headAt(2));
  CHECK(row.path.size() == 6);
  CHECK(row.length == Approx(3.4));
}

TEST_CASE("a row of whose joints none is called a head stays as it is") {
  Extremity row = rowOfBones({1.0, 1.0, 1.0, 0.5});
  Axis axis = headAt(3);
  axis.headIsNamed = false;
  endAtHead(row, axis);
  CHECK(row.path.size() == 5);
}

TEST_CASE("a row that ends at its head loses the tip beyond it") {
  Extremity row = rowOfBones({1.0, 1.0, 1.0});
  row.tip = NodeIndex(9);
  row.points.emplace_back(0.0, 0.0, 3.5);
  row.length = 3.5;
  endAtHead(row, headAt(3));
  CHECK_FALSE(row.tip.exists());
  CHECK(row.points.size() == 4);
  CHECK(row.length == Approx(3.0));
}

TEST_CASE("a row is even where none of its bones is nearly half of it, of a few bones more") {
  CHECK(isEven(rowOfBones({1.0, 1.0, 1.0, 1.0, 1.0, 1.0})));
  CHECK(isEven(rowOfBones({4.4, 1.5, 1.4, 1.4, 1.3})));
  CHECK_FALSE(isEven(rowOfBones({4.6, 1.4, 1.4, 1.3, 1.3})));
  CHECK(isEven(rowOfBones({7.4, 2.6})));
  CHECK_FALSE(isEven(rowOfBones({7.6, 2.4})));
  CHECK(isEven(rowOfBones({7.4, 2.6, 0.0}))); // Joints on one another have no bone between them.
}

TEST_CASE("a row starts at an anchor that moves nothing and hardly has a bone, or one far longer or back") {
  const auto starts = [](const std::vector<double>& bones, const std::vector<int>& meshOf) {
    const SeenRow seen(bones, meshOf);
    return startsAtAnchor(seen.view, seen.row);
  };
  CHECK(starts({1.6, 1.0, 1.0}, {1, 2, 3}));
  CHECK_FALSE(starts({1.4, 1.0, 1.0}, {1, 2, 3}));
  CHECK_FALSE(starts({1.6, 1.0, 1.0}, {0, 1, 2, 3}));
  CHECK_FALSE(starts({1.6, 1.0, 1.0}, {})); // Nothing tells what it moves.
  CHECK(starts({-0.5, 1.0, 1.0}, {1, 2, 3}));
  CHECK_FALSE(starts({-0.5, 1.0, 1.0}, {}));
  const std::vector<double> evenly(9, 1.0);
  std::vector<double> bones{0.5};
  bones.insert(bones.end(), evenly.begin(), evenly.end());
  CHECK(starts(bones, {1, 2, 3})); // less than 0.06 of the row
  CHECK_FALSE(starts(bones, {}));  // and more than 0.3 of a bone
  bones.front() = 0.25;
  CHECK(starts(bones, {}));
}

TEST_CASE("a row ends before the fork of its fins, and a fin that is no fork counts half") {
  SeenRow forked({1.0, 2.0, 4.0, 8.0});
  forked.callFins(3);
  CHECK(trunkLength(forked.view, forked.row) == Approx(7.5));
  test::addJoint(forked.view, NodeIndex(5), 2, Vec3(1.0, 0.0, 7.0)); // the other fluke
  CHECK(isInFork(forked.view, forked.row, 3));
  CHECK_FALSE(isInFork(forked.view, forked.row, 4));
  CHECK(trunkLength(forked.view, forked.row) == Approx(3.0));
  endBeforeFins(forked.view, forked.row);
  CHECK(forked.row.path == std::vector<int>{0, 1, 2});
  CHECK(forked.row.points.size() == 3);
  SeenRow plain({1.0, 2.0, 4.0, 8.0});
  test::addJoint(plain.view, NodeIndex(5), 2, Vec3(1.0, 0.0, 7.0)); // a leg, and no name tells of fins
  CHECK(trunkLength(plain.view, plain.row) == Approx(15.0));
}

TEST_CASE(
    "three limbs that part from a row or above it are branches, fins, short ones and lone joints are none") {
  SeenRow body({1.0, 1.0, 1.0, 1.0});
  const auto add = [&](int parent, const Vec3& way) {
    return test::addJoint(body.view, NodeIndex(body.view.count()), parent, body.view.at(parent) + way);
  };
  const auto call = [&](int joint, const char* name) {
    body.view.called[static_cast<std::size_t>(joint)] = name;
  };
  const int shoulder = add(1, Vec3(0.7, 0.0, 0.0));
  const int hand = add(shoulder, Vec3(0.7, 0.0, 0.0)); // together more than a third of the row
  add(hand, Vec3(0.1, 0.1, 0.0));
  add(hand, Vec3(0.1, -0.1, 0.0)); // fingers are no limbs
  add(add(1, Vec3(-0.7, 0.0, 0.0)), Vec3(-0.7, 0.0, 0.0));
  CHECK_FALSE(hasBranches(body.view, body.row));
  const int third = add(3, Vec3(1.4, 0.0, 0.0));
  CHECK_FALSE(hasBranches(body.view, body.row)); // a handle
  const int end = add(third, Vec3(0.1, 0.0, 0.0));
  CHECK(hasBranches(body.view, body.row));
  call(third, "fin");
  CHECK_FALSE(hasBranches(body.view, body.row));
  call(third, "");
  body.view.position[static_cast<std::size_t>(third)] = body.view.at(3) + Vec3(1.1, 0.0, 0.0);
  body.view.position[static_cast<std::size_t>(end)] = body.view.at(3) + Vec3(1.2, 0.0, 0.0);
  CHECK_FALSE(hasBranches(body.view, body.row));
  const int fork = add(3, Vec3(0.0, 0.5, 0.0));
  add(add(fork, Vec3(0.7, 0.0, 0.0)), Vec3(0.7, 0.0, 0.0));
  CHECK(hasBranches(body.view, body.row));
  call(shoulder, "fin");
  CHECK_FALSE(hasBranches(body.view, body.row));
  add(add(fork, Vec3(-0.7, 0.0, 0.0)), Vec3(-0.7, 0.0, 0.0)); // two limbs part from a joint beside the row
  CHECK(hasBranches(body.view, body.row));
  // Of a row that begins at a hand the other limbs part above it.
  Extremity arm = rowOfBones({0.7});
  arm.path = {shoulder, hand};
  CHECK(hasBranches(body.view, arm));
}

TEST_CASE("a limb is counted though its joints come before those that they hang from") {
  SeenRow body({1.0, 1.0, 1.0, 1.0});
  for (const double side : {1.0, -1.0, 0.5}) {
    const int hand = test::addJoint(body.view, NodeIndex(body.view.count()), 1, Vec3(2.0 * side, 0.0, 1.0));
    const int arm = test::addJoint(body.view, NodeIndex(body.view.count()), 1, Vec3(1.0 * side, 1.0, 1.0));
    body.view.parent[static_cast<std::size_t>(hand)] = arm;
    body.view.depth[static_cast<std::size_t>(hand)] = body.view.depth[static_cast<std::size_t>(arm)] + 1;
  }
  CHECK(hasBranches(body.view, body.row));
}

TEST_CASE("a body has legs by name where both sides have a clear thigh or shin, or a shin below a thigh") {
  SeenRow body({1.0, 1.0, 1.0});
  const auto call = [&](std::size_t joint, Role role, double fit, Side side) {
    body.view.names[joint] = {};
    body.view.names[joint].roles[static_cast<std::size_t>(role)] = fit;
    body.view.names[joint].side = side;
  };
  call(1, Role::thigh, 0.8, Side::left);
  CHECK_FALSE(hasNamedLegs(body.view));
  call(2, Role::shin, 0.8, Side::right);
  CHECK(hasNamedLegs(body.view));
  call(2, Role::shin, 0.79, Side::right);
  CHECK_FALSE(hasNamedLegs(body.view));
  call(2, Role::upperArm, 1.0, Side::right);
  CHECK_FALSE(hasNamedLegs(body.view));
  call(2, Role::thigh, 1.0, Side::left);
  CHECK_FALSE(hasNamedLegs(body.view));
  call(2, Role::shin, 0.8, Side::left);
  CHECK(hasNamedLegs(body.view));
  call(2, Role::shin, 0.79, Side::left);
  CHECK_FALSE(hasNamedLegs(body.view));
  call(1, Role::shin, 1.0, Side::left);
  call(2, Role::thigh, 1.0, Side::left);
  CHECK_FALSE(hasNamedLegs(body.view)); // the thigh hangs from the shin
  call(2, Role::thigh, 0.8, Side::right);
  CHECK(hasNamedLegs(body.view));
  call(1, Role::shin, 0.8, Side::right);
  CHECK_FALSE(hasNamedLegs(body.view));
  call(2, Role::thigh, 0.8, Side::left);
  CHECK(hasNamedLegs(body.view));
  call(3, Role::shin, 1.0, Side::left);
  call(2, Role::upperArm, 1.0, Side::left);
  call(1, Role::thigh, 1.0, Side::left);
  CHECK(hasNamedLegs(body.view)); // with a joint of another name between them
}
