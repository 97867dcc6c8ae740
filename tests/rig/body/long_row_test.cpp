#include "rig/body/reading/long_row.h"

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::rig::body;

namespace {

/// A row along z whose bones are this long; its joints are 0, 1, 2 and so on.
Extremity rowOf(const std::vector<double>& bones) {
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

} // namespace

TEST_CASE("a row that goes on into a jaw ends at the head, with its points and its length") {
  Extremity row = rowOf({1.0, 1.0, 1.0, 0.5, 0.25});
  endAtHead(row, headAt(3));
  CHECK(row.path == std::vector<int>{0, 1, 2, 3});
  REQUIRE(row.points.size() == row.path.size());
  CHECK(row.points.back().z == Approx(3.0));
  CHECK(row.length == Approx(3.0));
}

TEST_CASE("a row that begins at the head goes on") {
  Extremity row = rowOf({0.2, 0.2, 1.0, 1.0, 1.0});
  endAtHead(row, headAt(2));
  CHECK(row.path.size() == 6);
  CHECK(row.length == Approx(3.4));
}

TEST_CASE("a row of whose joints none is called a head stays as it is") {
  Extremity row = rowOf({1.0, 1.0, 1.0, 0.5});
  Axis axis = headAt(3);
  axis.headIsNamed = false;
  endAtHead(row, axis);
  CHECK(row.path.size() == 5);
}
