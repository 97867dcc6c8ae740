#include "rig/body/evidence/body_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/finite.h"
#include "core/scene/scene.h"
#include "rig/body/evidence/own_names.h"
#include "rig/body/evidence/skeletons.h"

namespace stretch::rig::body {

namespace {

// Beyond what any character has; keeps a file that is no character from costing much.
constexpr int mostCandidates = 3000;
constexpr int mostForFeet = 800; // joints of a tree in which feet are looked for elsewhere

std::vector<std::size_t> countBelow(const Scene& scene, const std::vector<NodeIndex>& order,
                                    const std::vector<std::vector<Vec3>>& clouds) {
  std::vector<std::size_t> below(scene.nodes.size(), 0);
  for (auto lowest = order.rbegin(); lowest != order.rend(); ++lowest) {
    const auto index = at(*lowest);
    below[index] += clouds[index].size();
    if (scene.nodes[index].parent.exists()) {
      below[at(scene.nodes[index].parent)] += below[index];
    }
  }
  return below;
}

// A joint that may be the foot of a leg whose last joint does not carry it.
struct DetachedFoot {
  int joint = -1;
  int leg = -1;        // the leg's last joint
  double gap = 0.0;    // between their meshes, in bones of the leg
  bool isSure = false; // near, or named so
};

class ViewBuilder {
public:
  ViewBuilder(const Scene& scene, const BindPose& bindPose, Candidates candidates, NodeIndex within)
      : scene_(scene), bindPose_(bindPose), order_(parentsFirst(scene)), ownNames_(ownNames(scene)),
        clouds_(
            vertexClouds(scene, bindPose, isOfSkins(candidates) ? RigidMeshes::bodyParts : RigidMeshes::all)),
        possible_(possibleNodes(scene, bindPose, candidates, clouds_)) {
    if (within.exists()) {
      leaveOutAllBut(withSubtrees(scene, {within}));
    }
    below_ = countBelow(scene, order_, clouds_);
  }

  BodyView build() {
    view_.candidateOfNode.assign(scene_.nodes.size(), -1);
    for (const auto& cloud : clouds_) {
      view_.hasVertices = view_.hasVertices || !cloud.empty();
    }
    measure();
    for (const NodeIndex node : order_) {
      const NameEvidence name = readName(ownNames_[at(node)]);
      if (view_.count() < mostCandidates && isCandidate(node, name)) {
        add(node, name);
      }
    }
    gatherCarried();
    hangFromStandIns();
    view_.isDetached.assign(static_cast<std::size_t>(view_.count()), false);
    hangDetachedFeet();
    link();
    markSplits();
    gather();
    return std::move(view_);
  }

private:
  // `own`: ascending.
  void leaveOutAllBut(const std::vector<NodeIndex>& own) {
    for (std::size_t node = 0; node < clouds_.size(); ++node) {
      if (!std::ranges::binary_search(own, NodeIndex(node))) {
        clouds_[node].clear();
        possible_[node] = false;
      }
    }
  }

  void measure() {
    Bounds flesh;
    for (const std::vector<Vec3>& cloud : clouds_) {
      for (const Vec3& point : cloud) {
        flesh.add(point);
      }
    }
    // A root or a handle that stands far from everything that is seen says nothing about the body's size.
    const double reach = flesh.empty() ? 0.0 : flesh.largestExtent();
    Bounds bounds = flesh;
    for (std::size_t i = 0; i < clouds_.size(); ++i) {
      const Vec3 place = positionOf(bindPose_.worlds[i]);
      const bool isNear =
          !(reach > 0.0) || glm::distance(place, glm::clamp(place, flesh.low, flesh.high)) < reach;
      if (possible_[i] && isNear) {
        bounds.add(place);
      }
    }
    const double extent = bounds.largestExtent();
    view_.size = extent > 0.0 && std::isfinite(extent) ? extent : 1.0;
  }

  [[nodiscard]] bool isCandidate(NodeIndex node, const NameEvidence& name) const {
    const auto index = at(node);
    if (!possible_[index] || (name.end && isTip(node, name))) {
      return false;
    }
    const bool idle = view_.hasVertices && below_[index] == 0;
    const bool handle = name.control && clouds_[index].empty();
    // An ankle or wrist may move nothing itself; a handle beside the body must not pass for one.
    return !handle && (!idle || hangsFromMovingJoint(node));
  }

  // The last joint of an arm may be called its end as well: a mesh follows it, or fingers hang from it. What
  // moves a mesh and carries what does, or an end, is in the middle of a row, whatever is called its end.
  [[nodiscard]] bool isTip(NodeIndex node, const NameEvidence& name) const {
    const std::vector<NodeIndex>& children = scene_.nodes[at(node)].children;
    if (!clouds_[at(node)].empty() && std::ranges::any_of(children, [&](NodeIndex child) {
          return (possible_[at(child)] && below_[at(child)] > 0) || readName(ownNames_[at(child)]).end;
        })) {
      return false;
    }
    const bool carries = !clouds_[at(node)].empty() ||
                         std::ranges::any_of(children, [&](NodeIndex child) { return possible_[at(child)]; });
    return !carries || std::max(name.role(Role::upperArm), name.role(Role::shin)) <= 0.0;
  }

  [[nodiscard]] bool hangsFromMovingJoint(NodeIndex node) const {
    const NodeIndex parent = scene_.nodes[at(node)].parent;
    return parent.exists() && !clouds_[at(parent)].empty();
  }

  void add(NodeIndex node, const NameEvidence& name) {
    view_.candidateOfNode[at(node)] = view_.count();
    view_.nodes.push_back(node);
    view_.called.push_back(ownNames_[at(node)]);
    view_.names.push_back(name);
    view_.position.push_back(positionOf(bindPose_.worlds[at(node)]));
    NodeIndex above = scene_.nodes[at(node)].parent;
    while (above.exists() && view_.candidateOfNode[at(above)] < 0) {
      above = scene_.nodes[at(above)].parent;
    }
    view_.parent.push_back(above.exists() ? view_.candidateOfNode[at(above)] : -1);
  }

  // A joint whose master was left out hangs from the joint that stands where the master's parent stands.
  void hangFromStandIns() {
    for (int candidate = 0; candidate < view_.count(); ++candidate) {
      auto& parent = view_.parent[static_cast<std::size_t>(candidate)];
      const bool isRoot = parent < 0;
      NodeIndex above = scene_.nodes[at(view_.nodes[static_cast<std::size_t>(candidate)])].parent;
      for (int steps = 0; above.exists() && view_.candidateOfNode[at(above)] < 0 && steps < 8; ++steps) {
        const int instead = possible_[at(above)] || !isRoot ? standIn(above, candidate) : -1;
        if (instead >= 0) {
          parent = instead;
          break;
        }
        above = scene_.nodes[at(above)].parent;
      }
    }
  }

  [[nodiscard]] int standIn(NodeIndex node, int forCandidate) const {
    const Vec3 place = positionOf(bindPose_.worlds[at(node)]);
    const double near = 1e-3 * view_.size;
    if (!isFinite(place) || glm::distance(place, view_.at(forCandidate)) < near) {
      return -1;
    }
    for (int other = 0; other < view_.count(); ++other) {
      if (glm::distance(place, view_.at(other)) < near && !view_.isAboveOrSelf(forCandidate, other)) {
        return other;
      }
    }
    return -1;
  }

  // Of a joint, or of the rigid meshes that hang on it.
  [[nodiscard]] const std::vector<Vec3>& cloudOf(int candidate) const {
    const NodeIndex node = view_.nodes[static_cast<std::size_t>(candidate)];
    const auto carried = carried_.find(node);
    return carried == carried_.end() ? clouds_[at(node)] : carried->second;
  }

  void gatherCarried() {
    for (const NodeIndex node : view_.nodes) {
      std::vector<Vec3> points;
      for (const NodeIndex child : scene_.nodes[at(node)].children) {
        const bool isMesh = scene_.nodes[at(child)].mesh >= 0 && view_.candidateOfNode[at(child)] < 0;
        if (isMesh && clouds_[at(node)].empty()) {
          points.insert(points.end(), clouds_[at(child)].begin(), clouds_[at(child)].end());
        }
      }
      if (!points.empty()) {
        carried_.emplace(node, std::move(points));
      }
    }
  }

  // Some of a joint's vertices, evenly picked: enough to tell where its mesh is, whatever the file holds.
  [[nodiscard]] std::vector<Vec3> someOfMesh(int candidate) const {
    constexpr std::size_t most = 60;
    const std::vector<Vec3>& cloud = cloudOf(candidate);
    const std::size_t step = 1 + cloud.size() / most;
    std::vector<Vec3> some;
    for (std::size_t i = 0; i < cloud.size(); i += step) {
      some.push_back(cloud[i]);
    }
    return some;
  }

  // Distance of two joints' meshes, the joint before the ground counted to its own.
  [[nodiscard]] double meshGap(int last, int foot) const {
    std::vector<Vec3> above = someOfMesh(last);
    above.push_back(view_.at(last));
    double gap = glm::distance(view_.at(last), view_.at(foot));
    for (const Vec3& point : someOfMesh(foot)) {
      for (const Vec3& other : above) {
        gap = std::min(gap, glm::distance(other, point));
      }
    }
    return gap;
  }

  // How far the joints below a joint are from it.
  [[nodiscard]] double farthestBelow(int joint) const {
    double farthest = 0.0;
    for (int other = joint + 1; other < view_.count(); ++other) {
      if (view_.isAboveOrSelf(joint, other)) {
        farthest = std::max(farthest, glm::distance(view_.at(joint), view_.at(other)));
      }
    }
    return farthest;
  }

  // Stands on the ground and hangs from nothing that moves a mesh.
  [[nodiscard]] bool mayBeDetachedFoot(int candidate, double floor, double top) const {
    constexpr double nearGround = 0.15; // of the body, which may be far wider than high: wings
    const double height = std::min(view_.size, 1.5 * (top - floor));
    const NameEvidence& name = view_.names[static_cast<std::size_t>(candidate)];
    const int parent = view_.parentOf(candidate);
    return (parent < 0 || cloudOf(parent).empty()) && !name.accessory && !name.finger &&
           view_.at(candidate).y < floor + nearGround * height;
  }

  // Not by a tip that moves nothing, nor by what lies about the joint itself, as a knee's guard does.
  [[nodiscard]] bool goesOnByLeaf(int joint, int leaf) const {
    constexpr double about = 0.25; // of the bone before
    const int above = view_.parentOf(joint);
    const double bone = above < 0 ? 0.0 : glm::distance(view_.at(above), view_.at(joint));
    return !cloudOf(leaf).empty() && glm::distance(view_.at(joint), view_.at(leaf)) > about * bone;
  }

  // Last joints of rows of at least two bones.
  [[nodiscard]] std::vector<int> lastJoints() const {
    std::vector<bool> isLeaf(static_cast<std::size_t>(view_.count()), true);
    for (const int parent : view_.parent) {
      if (parent >= 0) {
        isLeaf[static_cast<std::size_t>(parent)] = false;
      }
    }
    std::vector<bool> goesOn(isLeaf.size(), false);
    for (int candidate = 0; candidate < view_.count(); ++candidate) {
      const int parent = view_.parentOf(candidate);
      if (parent >= 0 && (!isLeaf[static_cast<std::size_t>(candidate)] || goesOnByLeaf(parent, candidate))) {
        goesOn[static_cast<std::size_t>(parent)] = true;
      }
    }
    std::vector<int> last;
    for (int candidate = 0; candidate < view_.count(); ++candidate) {
      const int parent = view_.parentOf(candidate);
      const NameEvidence& name = view_.names[static_cast<std::size_t>(candidate)];
      if (!goesOn[static_cast<std::size_t>(candidate)] && parent >= 0 && view_.parentOf(parent) >= 0 &&
          !cloudOf(candidate).empty() && !name.accessory && !name.finger) {
        last.push_back(candidate);
      }
    }
    return last;
  }

  // The joint at which the last bone begins, its halves counted as one.
  [[nodiscard]] const Vec3& startOfBone(int last) const {
    constexpr double inLine = 0.97; // cosine
    int start = view_.parentOf(last);
    for (int above = view_.parentOf(start); above >= 0; above = view_.parentOf(above)) {
      const Vec3 bone = view_.at(last) - view_.at(start);
      const Vec3 before = view_.at(start) - view_.at(above);
      const bool isShort = glm::length(before) < 0.7 * glm::distance(view_.at(last), view_.at(above));
      if (!isShort || glm::dot(bone, before) < inLine * glm::length(bone) * glm::length(before)) {
        break;
      }
      start = above;
    }
    return view_.at(start);
  }

  // Nothing where the foot, as long as `footLength`, is not what comes next after a last joint.
  [[nodiscard]] std::optional<DetachedFoot> footOf(int last, int foot, double footLength) const {
    constexpr double widest = 0.35;
    // Where one foot of a pair shows what it is, the other one may be farther from its leg.
    constexpr double farther = 0.56;
    const Vec3& joint = view_.at(last);
    const Vec3& before = startOfBone(last);
    const double bone = glm::distance(before, joint);
    const Side side = view_.names[static_cast<std::size_t>(last)].side;
    const Side footSide = view_.names[static_cast<std::size_t>(foot)].side;
    const bool otherSide = side != Side::none && footSide != Side::none && side != footSide;
    const double away = glm::distance(joint, view_.at(foot));
    const bool goesOn = glm::distance(before, view_.at(foot)) > away && view_.at(foot).y < joint.y;
    if (otherSide || !goesOn || !(bone > 0.0) || away > 3.0 * bone || footLength > bone) {
      return std::nullopt;
    }
    // A coarse mesh has no vertices between the two: then its name has to say what it is.
    const NameEvidence& name = view_.names[static_cast<std::size_t>(foot)];
    const bool saysFoot = std::max(name.role(Role::ankle), name.role(Role::wrist)) > 0.0; // a front foot
    const bool isNamed = saysFoot && away < 1.3 * bone;
    const double gap = isNamed ? away / bone : meshGap(last, foot) / bone;
    const bool isFoot = isNamed || gap < farther;
    return isFoot ? std::optional(DetachedFoot{foot, last, gap, isNamed || gap < widest}) : std::nullopt;
  }

  void hangDetachedFeet() {
    if (!view_.hasVertices || view_.count() > mostForFeet) {
      return;
    }
    double floor = std::numeric_limits<double>::max();
    double top = std::numeric_limits<double>::lowest();
    for (const auto& cloud : clouds_) {
      for (const Vec3& point : cloud) {
        floor = std::min(floor, point.y);
        top = std::max(top, point.y);
      }
    }
    std::vector<DetachedFoot> feet = possibleFeet(floor, top);
    std::set<int> carriers; // of feet that are sure
    for (const DetachedFoot& foot : feet) {
      if (foot.isSure && view_.parentOf(foot.joint) >= 0) {
        carriers.insert(view_.parentOf(foot.joint));
      }
    }
    std::erase_if(feet, [&](const DetachedFoot& foot) {
      return !foot.isSure && !carriers.contains(view_.parentOf(foot.joint));
    });
    std::set<int> legsWithFeet;
    // Each leg its foot first, then what is beside one, as a heel.
    for (const bool isBeside : {false, true}) {
      for (const DetachedFoot& foot : feet) {
        if (!view_.isDetached[static_cast<std::size_t>(foot.joint)] && (!isBeside || foot.isSure) &&
            legsWithFeet.contains(foot.leg) == isBeside && !view_.isAboveOrSelf(foot.joint, foot.leg)) {
          view_.parent[static_cast<std::size_t>(foot.joint)] = foot.leg;
          view_.isDetached[static_cast<std::size_t>(foot.joint)] = true;
          legsWithFeet.insert(foot.leg);
        }
      }
    }
  }

  // What stands on the ground and may go on from a row of joints, with each such row; the likeliest first.
  [[nodiscard]] std::vector<DetachedFoot> possibleFeet(double floor, double top) const {
    const std::vector<int> rows = lastJoints();
    std::vector<DetachedFoot> feet;
    for (int foot = 0; foot < view_.count(); ++foot) {
      if (!mayBeDetachedFoot(foot, floor, top)) {
        continue;
      }
      const double footLength = farthestBelow(foot);
      for (const int last : rows) {
        const bool isBeside = view_.parentOf(foot) >= 0 && view_.parentOf(foot) == view_.parentOf(last);
        const bool isApart = !isBeside && !view_.isAboveOrSelf(foot, last);
        if (const auto found = isApart ? footOf(last, foot, footLength) : std::nullopt) {
          feet.push_back(*found);
        }
      }
    }
    std::ranges::stable_sort(feet, {},
                             [](const DetachedFoot& foot) { return std::pair(!foot.isSure, foot.gap); });
    return feet;
  }

  // Puts parents before children again (stand-ins may come later) and fills children and depths.
  void link() {
    const auto count = static_cast<std::size_t>(view_.count());
    view_.children.assign(count, {});
    view_.depth.assign(count, 0);
    std::vector<int> next;
    for (int candidate = 0; candidate < view_.count(); ++candidate) {
      const int parent = view_.parentOf(candidate);
      if (parent < 0) {
        next.push_back(candidate);
      } else {
        view_.children[static_cast<std::size_t>(parent)].push_back(candidate);
      }
    }
    for (std::size_t i = 0; i < next.size(); ++i) {
      for (const int child : view_.childrenOf(next[i])) {
        view_.depth[static_cast<std::size_t>(child)] = view_.depth[static_cast<std::size_t>(next[i])] + 1;
        next.push_back(child);
      }
    }
    topDown_ = std::move(next);
  }

  // Whether a joint lies on the bone between two others.
  [[nodiscard]] bool liesBetween(int joint, int from, int to) const {
    constexpr double aside = 0.1; // of the bone
    const Vec3 bone = view_.at(to) - view_.at(from);
    const Vec3 there = view_.at(joint) - view_.at(from);
    const double length = glm::length(bone);
    const double along = length > 0.0 ? glm::dot(there, bone) / length : 0.0;
    return along > aside * length && along < (1.0 - aside) * length &&
           glm::length(there - bone * (along / length)) < aside * length;
  }

  [[nodiscard]] bool sharesRole(int a, int b, std::initializer_list<Role> roles) const {
    constexpr double clear = 0.8;
    return std::ranges::any_of(roles, [&](Role role) {
      return std::min(view_.names[static_cast<std::size_t>(a)].role(role),
                      view_.names[static_cast<std::size_t>(b)].role(role)) >= clear;
    });
  }

  // Whether a joint is called as another one is, and something beside it or a number.
  [[nodiscard]] bool isCalledAfter(int joint, int other) const {
    const std::string& name = view_.names[static_cast<std::size_t>(joint)].key;
    const std::string& stem = view_.names[static_cast<std::size_t>(other)].key;
    return name.starts_with(stem.substr(0, stem.find('#'))) &&
           sharesRole(joint, other,
                      {Role::thigh, Role::shin, Role::upperArm, Role::foreArm, Role::ankle, Role::wrist});
  }

  // Parts of a bone are called as the bone is and lie on it: below its joint ("Hip", "HipPart1") or beside
  // the next one ("Ankle_Assist", "Ankle"). They twist with it, whatever else their names say.
  void markSplits() {
    for (int joint = 0; joint < view_.count(); ++joint) {
      const int parent = view_.parentOf(joint);
      if (parent < 0) {
        continue;
      }
      const auto isPartOf = [&](int next) {
        return isCalledAfter(joint, parent) && liesBetween(joint, parent, next);
      };
      const auto isBeside = [&](int other) {
        return view_.childrenOf(joint).empty() && isCalledAfter(joint, other) &&
               liesBetween(joint, parent, other);
      };
      if (std::ranges::any_of(view_.childrenOf(joint), isPartOf) ||
          std::ranges::any_of(view_.childrenOf(parent), isBeside)) {
        view_.names[static_cast<std::size_t>(joint)].twist = true;
      }
    }
  }

  void gather() {
    const auto count = static_cast<std::size_t>(view_.count());
    view_.points.assign(count, {});
    view_.tips.assign(count, {});
    std::vector<int> owners(scene_.nodes.size(), -1); // the nearest candidate at or above each node
    for (const NodeIndex node : order_) {
      const NodeIndex parent = scene_.nodes[at(node)].parent;
      const int own = view_.candidateOfNode[at(node)];
      const int owner = own >= 0 || !parent.exists() ? own : owners[at(parent)];
      owners[at(node)] = owner;
      if (owner < 0) {
        continue;
      }
      auto& points = view_.points[static_cast<std::size_t>(owner)];
      const auto& cloud = clouds_[at(node)];
      points.insert(points.end(), cloud.begin(), cloud.end());
      if (possible_[at(node)] && view_.candidateOfNode[at(node)] < 0 &&
          !readName(ownNames_[at(node)]).control) {
        view_.tips[static_cast<std::size_t>(owner)].push_back(positionOf(bindPose_.worlds[at(node)]));
      }
    }
    gatherReach();
  }

  void gatherReach() {
    const auto count = static_cast<std::size_t>(view_.count());
    view_.verticesBelow.assign(count, 0);
    view_.reach.assign(count, 0.0);
    for (auto lowest = topDown_.rbegin(); lowest != topDown_.rend(); ++lowest) {
      const int candidate = *lowest;
      const auto index = static_cast<std::size_t>(candidate);
      view_.verticesBelow[index] += view_.points[index].size();
      if (view_.parent[index] >= 0) {
        view_.verticesBelow[static_cast<std::size_t>(view_.parent[index])] += view_.verticesBelow[index];
      }
      constexpr int highest = 12; // a hand is never deeper below its limb's base
      for (int steps = 0, above = candidate; above >= 0 && steps < highest;
           ++steps, above = view_.parentOf(above)) {
        double& reach = view_.reach[static_cast<std::size_t>(above)];
        reach = std::max(reach, reachTo(view_.at(above), index));
      }
    }
  }

  [[nodiscard]] double reachTo(const Vec3& from, std::size_t candidate) const {
    double farthest = glm::distance(from, view_.position[candidate]);
    for (const Vec3& point : view_.points[candidate]) {
      farthest = std::max(farthest, glm::distance(from, point));
    }
    for (const Vec3& tip : view_.tips[candidate]) {
      farthest = std::max(farthest, glm::distance(from, tip));
    }
    return farthest;
  }

  const Scene& scene_;
  const BindPose& bindPose_;
  std::vector<NodeIndex> order_;
  std::vector<std::string> ownNames_;
  std::vector<std::vector<Vec3>> clouds_;
  std::vector<bool> possible_;
  std::vector<std::size_t> below_;
  std::map<NodeIndex, std::vector<Vec3>> carried_; // of rigid meshes on a joint that moves none itself
  std::vector<int> topDown_;
  BodyView view_;
};

} // namespace

bool BodyView::isAboveOrSelf(int above, int candidate) const {
  while (candidate >= 0 && candidate != above) {
    candidate = parentOf(candidate);
  }
  return candidate == above;
}

int BodyView::commonAncestor(int a, int b) const {
  while (a >= 0 && !isAboveOrSelf(a, b)) {
    a = parentOf(a);
  }
  return a;
}

std::vector<int> BodyView::path(int above, int candidate) const {
  std::vector<int> upwards;
  while (candidate >= 0 && candidate != above) {
    upwards.push_back(candidate);
    candidate = parentOf(candidate);
  }
  if (candidate < 0) {
    return {};
  }
  upwards.push_back(above);
  std::ranges::reverse(upwards);
  return upwards;
}

BodyView viewBody(const Scene& scene, const BindPose& bindPose, Candidates candidates, NodeIndex within) {
  return ViewBuilder(scene, bindPose, candidates, within).build();
}

} // namespace stretch::rig::body
