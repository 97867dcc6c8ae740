#include "assets/dummy/skeleton.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"

namespace stretch::assets {

namespace {

struct Place {
  const char* name;
  const char* parent;
  Vec3 position;
};

constexpr std::array<Place, 6> trunk{{
    {"Hips", "", {0.0, 0.93, 0.0}},
    {"Spine", "Hips", {0.0, 1.025, 0.0}},
    {"Spine1", "Spine", {0.0, 1.13, -0.004}},
    {"Spine2", "Spine1", {0.0, 1.24, -0.01}},
    {"Neck", "Spine2", {0.0, 1.405, -0.016}},
    {"Head", "Neck", {0.0, 1.463, -0.006}},
}};

/// One side's limbs, without the side's name in front; positions of the left side.
constexpr std::array<Place, 10> limbs{{
    {"Shoulder", "Spine2", {0.045, 1.372, -0.004}},
    {"Arm", "Shoulder", {0.182, 1.366, -0.012}},
    {"ForeArm", "Arm", {0.386, 1.186, -0.030}},
    {"Hand", "ForeArm", {0.570, 1.020, 0.022}},
    {"HandMiddle1", "Hand", {0.648, 0.950, 0.044}},
    {"HandThumb1", "Hand", {0.602, 1.000, 0.080}},
    {"UpLeg", "Hips", {0.092, 0.895, 0.0}},
    {"Leg", "UpLeg", {0.112, 0.492, 0.016}},
    {"Foot", "Leg", {0.124, 0.098, -0.022}},
    {"ToeBase", "Foot", {0.138, 0.030, 0.100}},
}};

bool isTrunk(std::string_view name) {
  return std::any_of(trunk.begin(), trunk.end(), [&](const Place& place) { return name == place.name; });
}

void addSide(std::vector<Joint>& skeleton, const std::string& side) {
  for (const Place& place : limbs) {
    const std::string parent = isTrunk(place.parent) ? place.parent : side + place.parent;
    const Vec3 position = side == "Left" ? place.position : mirrored(place.position);
    skeleton.push_back({side + place.name, jointIndex(skeleton, parent), position});
  }
}

} // namespace

std::vector<Joint> dummySkeleton() {
  std::vector<Joint> skeleton;
  for (const Place& place : trunk) {
    const int parent = skeleton.empty() ? -1 : jointIndex(skeleton, place.parent);
    skeleton.push_back({place.name, parent, place.position});
  }
  addSide(skeleton, "Left");
  addSide(skeleton, "Right");
  return skeleton;
}

int jointIndex(const std::vector<Joint>& skeleton, std::string_view name) {
  const auto found =
      std::find_if(skeleton.begin(), skeleton.end(), [&](const Joint& joint) { return joint.name == name; });
  check(found != skeleton.end(), "the skeleton has no joint of that name");
  return static_cast<int>(found - skeleton.begin());
}

Vec3 jointPosition(const std::vector<Joint>& skeleton, std::string_view name) {
  return skeleton[static_cast<std::size_t>(jointIndex(skeleton, name))].position;
}

} // namespace stretch::assets
