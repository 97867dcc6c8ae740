#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::test {

/// How a made-up person of 1.8 units stands, facing +Z.
struct TubePose {
  double armsDown = 0.0;  ///< Radians from sideways.
  double shoulders = 0.2; ///< From the middle to the shoulder joints.
  bool hasArms = true;
  bool hasRods = false;         ///< Upper arms are thin rods in thick forearms, as of a robot.
  double holdsInRight = 0.0;    ///< Length of a stick beyond the right hand.
  double holdsInLeft = 0.0;     ///< Length of one beyond the left hand.
  std::size_t everyNthHole = 0; ///< Leaves out one of so many triangles; 0: none.
};

/// A mesh of tubes that run into each other, and where its joints are. Shells cross, nothing is welded.
struct TubePerson {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::map<std::string, Vec3> joints; ///< By VRM's names.
};

/// A ring of a tube.
struct TubeRing {
  Vec3 middle{0.0};
  double radius = 0.1;
};

/// Adds a tube through rings, closed at both ends.
void addTube(TubePerson& body, const std::vector<TubeRing>& rings);

/// Made of boxes: limbs without hands and feet, that turn at their ends and in their middles.
[[nodiscard]] TubePerson blockPerson();

[[nodiscard]] TubePerson tubePerson(const TubePose& pose = {});

} // namespace stretch::test
