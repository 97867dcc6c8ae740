#include "rig/retarget/joint_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/rotation.h"
#include "core/math/transform.h"

namespace stretch::rig {

namespace {

class Pairing {
public:
  Pairing(const Skeleton& from, const Skeleton& to) : from_(from), to_(to) {
    const Quat turn = glm::normalize(glm::quat_cast(from.axes * glm::transpose(to.axes)));
    const bool standsBoth = from.isUpright && to.isUpright;
    result_.world = standsBoth ? glm::inverse(turn) : Quat(1.0, 0.0, 0.0, 0.0);
    body_ = standsBoth ? Quat(1.0, 0.0, 0.0, 0.0) : turn;
  }

  JointPairs pair() {
    add(to_.carrier, from_.hips, body_);
    add(to_.hips, from_.hips, body_);
    pairTrunk();
    pairNeck();
    for (const std::size_t side : {leftSide, rightSide}) {
      pairArm(side);
      pairLeg(side);
    }
    return std::move(result_);
  }

private:
  void add(NodeIndex joint, NodeIndex from, const Quat& stance) {
    addBetween(joint, from, from, 0.0, stance);
  }

  void addBetween(NodeIndex joint, NodeIndex from, NodeIndex towards, double share, const Quat& stance) {
    if (joint.exists() && from.exists() && paired_.insert(joint).second) {
      result_.pairs.push_back({joint, from, towards, share, stance});
    }
  }

  void lack(const std::string& what) {
    if (std::ranges::find(result_.left, what) == result_.left.end()) {
      result_.left.push_back(what);
    }
  }

  // Joint number `index` of `count` along a row of followed joints, the first of which stands before it.
  void addAlong(NodeIndex joint, double place, const std::vector<NodeIndex>& row) {
    const auto last = static_cast<double>(row.size() - 1);
    const double clamped = std::clamp(place, 0.0, last);
    const auto lower = static_cast<std::size_t>(std::floor(clamped + 1e-9));
    const std::size_t upper = std::min(lower + 1, row.size() - 1);
    addBetween(joint, row[lower], row[upper], std::max(0.0, clamped - static_cast<double>(lower)), body_);
  }

  void pairTrunk() {
    std::vector<NodeIndex> row{from_.hips};
    row.insert(row.end(), from_.spine.begin(), from_.spine.end());
    const auto count = static_cast<double>(to_.spine.size());
    for (std::size_t i = 0; i < to_.spine.size(); ++i) {
      const double share = static_cast<double>(i + 1) / count;
      addAlong(to_.spine[i], share * static_cast<double>(row.size() - 1), row);
    }
  }

  void pairNeck() {
    std::vector<NodeIndex> row{from_.spine.empty() ? from_.hips : from_.spine.back()};
    row.insert(row.end(), from_.neck.begin(), from_.neck.end());
    if (from_.head.exists()) {
      row.push_back(from_.head);
      add(to_.head, from_.head, body_);
    }
    const auto parts = static_cast<double>(to_.neck.size() + 1);
    for (std::size_t i = 0; i < to_.neck.size(); ++i) {
      addAlong(to_.neck[i], static_cast<double>(i + 1) / parts * static_cast<double>(row.size() - 1), row);
    }
    if (from_.head.exists() && !to_.head.exists()) {
      lack("the head");
    }
  }

  // The bones of a limb, each in the direction of the one that it follows; answers the stance of the last.
  Quat pairBones(const Limb& from, const Limb& to, std::vector<Quat>& stances) {
    const std::vector<Vec3> followed = limbPoints(from, from_.bind);
    const std::vector<Vec3> own = limbPoints(to, to_.bind);
    Quat stance = body_;
    for (std::size_t i = 0; i < to.joints.size(); ++i) {
      const std::size_t bone = std::min(i, from.joints.size() - 1);
      const bool isLast = i + 1 == to.joints.size();
      // A single bone for two: from the base to the end.
      const Vec3& start = followed[bone];
      const Vec3& end = isLast ? followed.back() : followed[bone + 1];
      const Vec3 wanted = result_.world * (end - start);
      stance = glm::normalize(shortestArc(stance * (own[i + 1] - own[i]), wanted) * stance);
      stances.push_back(stance);
    }
    return stance;
  }

  void addBones(const Limb& from, const Limb& to, const std::vector<Quat>& stances) {
    for (std::size_t i = 0; i < to.joints.size(); ++i) {
      add(to.joints[i], from.joints[std::min(i, from.joints.size() - 1)], stances[i]);
    }
  }

  static Vec3 placeOf(const Skeleton& skeleton, NodeIndex node) {
    return positionOf(skeleton.bind[at(node)]);
  }

  // Front and side of a hand by its fingers: false where they do not tell.
  static bool handAxes(const Skeleton& skeleton, const SkeletonArm& arm, Mat3& axes) {
    const auto index = arm.fingers.find("index");
    const auto little =
        arm.fingers.contains("little") ? arm.fingers.find("little") : arm.fingers.find("ring");
    if (index == arm.fingers.end() || little == arm.fingers.end() || !arm.limb.endNode.exists()) {
      return false;
    }
    const Vec3 first = placeOf(skeleton, index->second.front());
    const Vec3 last = placeOf(skeleton, little->second.front());
    const Vec3 ahead = 0.5 * (first + last) - placeOf(skeleton, arm.limb.endNode);
    const Vec3 normal = glm::cross(ahead, last - first);
    if (!(glm::length(normal) > 1e-6 * glm::dot(ahead, ahead))) {
      return false;
    }
    const Vec3 front = glm::normalize(ahead);
    const Vec3 above = glm::normalize(normal);
    axes = Mat3(front, above, glm::cross(front, above));
    return true;
  }

  // The hand in the stance of the followed one; where its palm looks elsewhere the forearm takes half of the
  // twist.
  Quat handStance(const SkeletonArm& from, const SkeletonArm& to, std::vector<Quat>& stances) {
    Mat3 followed(1.0);
    Mat3 own(1.0);
    const Quat carried = stances.back();
    if (!handAxes(from_, from, followed) || !handAxes(to_, to, own)) {
      return carried;
    }
    const Quat hand = glm::normalize(result_.world * glm::quat_cast(followed * glm::transpose(own)));
    const Quat rest = glm::normalize(hand * glm::inverse(carried));
    const std::vector<Vec3> points = limbPoints(to.limb, to_.bind);
    const Vec3 bone = carried * (points[points.size() - 1] - points[points.size() - 2]);
    if (glm::length(bone) > 0.0) {
      const Vec3 axis = glm::normalize(bone);
      double angle = 2.0 * std::atan2(glm::dot(Vec3(rest.x, rest.y, rest.z), axis), rest.w);
      angle = angle > pi ? angle - 2.0 * pi : angle < -pi ? angle + 2.0 * pi : angle;
      stances.back() = glm::normalize(axisAngle(axis, 0.5 * angle) * carried);
    }
    return hand;
  }

  void pairArm(std::size_t side) {
    const std::string arm = side == leftSide ? "the left arm" : "the right arm";
    if (!from_.arms[side] || !to_.arms[side]) {
      if (from_.arms[side]) {
        lack(arm);
      }
      return;
    }
    const SkeletonArm& from = *from_.arms[side];
    const SkeletonArm& to = *to_.arms[side];
    add(to.shoulder, from.shoulder, body_);
    if (from.shoulder.exists() && !to.shoulder.exists()) {
      lack("shoulders");
    }
    std::vector<Quat> stances;
    pairBones(from.limb, to.limb, stances);
    const Quat hand = handStance(from, to, stances);
    addBones(from.limb, to.limb, stances);
    add(to.limb.endNode, from.limb.endNode, hand);
    pairFingers(from, to, hand);
  }

  void pairFingers(const SkeletonArm& from, const SkeletonArm& to, const Quat& hand) {
    for (const auto& [finger, joints] : from.fingers) {
      const auto own = to.fingers.find(finger);
      if (own == to.fingers.end()) {
        lack(to.fingers.empty() ? "fingers" : "the " + finger + (finger == "thumb" ? "" : " finger"));
        continue;
      }
      for (std::size_t i = 0; i < std::min(own->second.size(), joints.size()); ++i) {
        add(own->second[i], joints[i], hand);
      }
    }
  }

  void pairLeg(std::size_t side) {
    const SkeletonLeg& from = from_.legs[side];
    const SkeletonLeg& to = to_.legs[side];
    std::vector<Quat> stances;
    pairBones(from.limb, to.limb, stances);
    addBones(from.limb, to.limb, stances);
    // A foot that stands flat in the one bind pose stands flat in the other.
    const bool hasFoot = from.limb.endNode.exists();
    add(to.limb.endNode, hasFoot ? from.limb.endNode : from.limb.joints.back(), body_);
    if (!hasFoot && from_.isUpright && result_.pairs.back().joint == to.limb.endNode) {
      result_.pairs.back().standsOn = side;
    }
    add(to.toes, from.toes, body_);
    if (from.toes.exists() && !to.toes.exists()) {
      lack("toes");
    }
  }

  const Skeleton& from_;
  const Skeleton& to_;
  JointPairs result_;
  Quat body_{1.0, 0.0, 0.0, 0.0};
  std::set<NodeIndex> paired_;
};

} // namespace

JointPairs pairJoints(const Skeleton& from, const Skeleton& to) {
  return Pairing(from, to).pair();
}

} // namespace stretch::rig
