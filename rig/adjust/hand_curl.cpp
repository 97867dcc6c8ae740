#include "rig/adjust/hand_curl.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/controllers/finger_joints.h"
#include "rig/reach/pose_writer.h"

namespace stretch::rig {

namespace {

// From the knuckle outwards, for a fist.
constexpr std::array fistDegrees{80.0, 95.0, 60.0};

struct Finger {
  std::vector<NodeIndex> joints; // base first
  std::vector<Vec3> points;      // of the joints, and the tip
  bool isThumb = false;

  [[nodiscard]] Vec3 direction() const { return points.back() - points.front(); }
};

bool isNamed(const Scene& scene, NodeIndex node, const char* word) {
  std::string name = scene.nodes[at(node)].name;
  std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return name.find(word) != std::string::npos;
}

bool movesMesh(const BindPlaces& places, NodeIndex node) {
  return !places.meshes[at(node)].empty();
}

// A last joint that moves no mesh is the finger's tip; else the tip is guessed from the mesh or the bone
// before.
Finger fingerOf(const Scene& scene, std::vector<NodeIndex> chain, const BindPlaces& places) {
  Finger finger;
  finger.isThumb = isNamed(scene, chain.front(), "thumb");
  for (const NodeIndex node : chain) {
    finger.points.push_back(positionOf(places.worlds[at(node)]));
  }
  if (chain.size() > 1 && !movesMesh(places, chain.back())) {
    chain.pop_back();
  } else if (chain.size() > 1) {
    finger.points.push_back(2.0 * finger.points.back() - finger.points[finger.points.size() - 2]);
  } else {
    const Bounds& mesh = places.meshes[at(chain.front())];
    finger.points.push_back(mesh.empty() ? finger.points.front() : 0.5 * (mesh.low + mesh.high));
  }
  // The first of four or more lies in the palm, and so does one that is named after it.
  const bool isPalmNamed = chain.size() > 1 && (isNamed(scene, chain.front(), "palm") ||
                                                isNamed(scene, chain.front(), "metacarp"));
  if (chain.size() > fistDegrees.size() || isPalmNamed) {
    const auto palm =
        std::max<std::ptrdiff_t>(isPalmNamed ? 1 : 0, static_cast<std::ptrdiff_t>(chain.size()) -
                                                          static_cast<std::ptrdiff_t>(fistDegrees.size()));
    chain.erase(chain.begin(), chain.begin() + palm);
    finger.points.erase(finger.points.begin(), finger.points.begin() + palm);
  }
  finger.joints = std::move(chain);
  return finger;
}

// Sum of the bends of a finger, each as long as the sine of its angle.
Vec3 fingerBend(const Finger& finger) {
  Vec3 bend(0.0);
  for (std::size_t i = 2; i < finger.points.size(); ++i) {
    const Vec3 before = finger.points[i - 1] - finger.points[i - 2];
    const Vec3 after = finger.points[i] - finger.points[i - 1];
    const double lengths = glm::length(before) * glm::length(after);
    bend += lengths > 0.0 ? glm::cross(before, after) / lengths : Vec3(0.0);
  }
  return bend;
}

Vec3 unitOrNone(const Vec3& vector) {
  const double length = glm::length(vector);
  return length > 1e-12 ? vector / length : Vec3(0.0);
}

// The side to which the fingers close, out of the palm: a unit vector across them.
Vec3 palmSide(const std::vector<Finger>& fingers, const Vec3& wrist) {
  Vec3 along(0.0);
  Vec3 bend(0.0);
  Vec3 thumb(0.0);
  for (const Finger& finger : fingers) {
    if (finger.isThumb) {
      thumb = finger.points.back() - wrist;
    } else {
      along += unitOrNone(finger.points.front() - wrist + finger.direction());
      bend += fingerBend(finger);
    }
  }
  along = unitOrNone(along);
  const Vec3 down(0.0, -1.0, 0.0);
  const Vec3 closed = glm::cross(unitOrNone(bend), along); // a bend about b takes f towards b x f
  const Vec3 downwards = down - along * glm::dot(down, along);
  constexpr double clearBend = 0.1;
  const bool bendTells =
      glm::length(bend) > clearBend * static_cast<double>(std::max<std::size_t>(1, fingers.size()));
  const Vec3 side = unitOrNone(bendTells ? closed : downwards);
  return glm::length(side) > 0.0 ? side : unitOrNone(thumb - along * glm::dot(thumb, along));
}

Vec3 closingAxis(const Finger& finger, std::size_t joint, const Vec3& palm, const Vec3& palmMiddle) {
  const Vec3 own = fingerBend(finger);
  constexpr double clearBend = 0.15; // radians, over the whole finger
  const Vec3 bone = finger.points[joint + 1] - finger.points[joint];
  const Vec3 towards =
      finger.isThumb ? palmMiddle - finger.points.front() + 0.3 * glm::length(bone) * palm : palm;
  const Vec3 across = unitOrNone(glm::cross(bone, towards));
  const bool agrees = glm::dot(own, across) > 0.0;
  return glm::length(own) > clearBend && agrees ? unitOrNone(own) : across;
}

// The axis of a turn in the world, in the space in which the joint's rotation is followed by another: below a
// mirror that turns the other way.
Vec3 axisInJoint(const Scene& scene, const BindPlaces& places, NodeIndex joint, const Vec3& axis) {
  const NodeIndex parent = scene.nodes[at(joint)].parent;
  const Mat4 carrier = parent.exists() ? places.worlds[at(parent)] : Mat4(1.0);
  const Quat turn = rotationOf(inverseOf(carrier) * places.worlds[at(joint)]);
  const Mat3 space = Mat3(carrier) * glm::mat3_cast(turn);
  return glm::normalize(inverseOf(space) * axis) * (glm::determinant(space) < 0.0 ? -1.0 : 1.0);
}

} // namespace

std::vector<FingerJoint> handCurl(const Scene& scene, const Limb& arm, const BindPlaces& places) {
  std::vector<Finger> fingers;
  for (std::vector<NodeIndex>& chain : fingerChains(scene, arm)) {
    fingers.push_back(fingerOf(scene, std::move(chain), places));
  }
  std::vector<FingerJoint> joints;
  if (fingers.empty()) {
    return joints;
  }
  const Vec3 wrist = arm.endNode.exists() ? positionOf(places.worlds[at(arm.endNode)])
                                          : limbPoints(arm, places.worlds).back();
  const Vec3 palm = palmSide(fingers, wrist);
  Vec3 middle(0.0);
  for (const Finger& finger : fingers) {
    middle += finger.points.front() / static_cast<double>(fingers.size());
  }
  for (const Finger& finger : fingers) {
    for (std::size_t i = 0; i < finger.joints.size(); ++i) {
      const Vec3 axis = closingAxis(finger, i, palm, middle);
      if (glm::length(axis) > 0.0) {
        joints.push_back({finger.joints[i], axisInJoint(scene, places, finger.joints[i], axis),
                          fistDegrees[i] * pi / 180.0 * (finger.isThumb ? 0.5 : 1.0)});
      }
    }
  }
  return joints;
}

void applyCurl(const Scene& scene, const std::vector<FingerJoint>& fingers, double curl, FrameState& frame) {
  if (curl == 0.0 || fingers.empty()) {
    return;
  }
  PoseWriter writer(scene, frame);
  for (const FingerJoint& finger : fingers) {
    Transform& local = writer.local(finger.node);
    local.rotation = glm::normalize(local.rotation * axisAngle(finger.axis, curl * finger.fistRadians));
  }
  for (const FingerJoint& finger : fingers) {
    writer.refreshSubtree(finger.node);
  }
}

} // namespace stretch::rig
