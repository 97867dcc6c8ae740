#include "rig/adjust/controller_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/rotation.h"
#include "rig/body/evidence/body_view.h"
#include "rig/limb_nodes.h"

namespace stretch::rig {

namespace {

using Points = std::vector<Vec3>;

constexpr int pointsAround = 40;
constexpr double gap = 1.1; // from the flesh to the line around it

const Vec3 skywards(0.0, 1.0, 0.0);

// A plane through a point: two unit vectors at right angles.
struct FlatPlace {
  Vec3 centre{0.0};
  Vec3 right{1.0, 0.0, 0.0};
  Vec3 up{0.0, 1.0, 0.0};

  [[nodiscard]] Vec2 seen(const Vec3& point) const {
    return {glm::dot(point - centre, right), glm::dot(point - centre, up)};
  }
  [[nodiscard]] Vec3 point(const Vec2& flat) const { return centre + flat.x * right + flat.y * up; }
};

// The bind pose with its flesh, part by part.
class Flesh {
public:
  Flesh(const Scene& scene, const std::vector<Limb>& limbs, const AdjustedBody& body)
      : scene_(scene), limbs_(limbs), owners_(limbOfNodes(scene, limbs, body.hips)),
        clouds_(body::vertexClouds(scene, body::placeBindPose(scene), body::RigidMeshes::bodyParts)) {}

  /// Of the limbs of these kinds, ends included.
  [[nodiscard]] Points of(std::initializer_list<LimbKind> kinds) const {
    return where([&](std::size_t node) {
      return owners_[node] >= 0 &&
             std::ranges::find(kinds, limbs_[static_cast<std::size_t>(owners_[node])].kind) != kinds.end();
    });
  }

  /// Of a hand, foot or head.
  [[nodiscard]] Points atEnd(const Limb& limb) const {
    return where([&](std::size_t node) { return isAtEnd(scene_, limb, NodeIndex(node)); });
  }

  [[nodiscard]] double height() const {
    Bounds bounds;
    for (const Points& cloud : clouds_) {
      std::ranges::for_each(cloud, [&](const Vec3& point) { bounds.add(point); });
    }
    return bounds.empty() ? 0.0 : bounds.high.y - bounds.low.y;
  }

private:
  template <typename Wanted>
  [[nodiscard]] Points where(Wanted&& wanted) const {
    Points points;
    for (std::size_t node = 0; node < clouds_.size(); ++node) {
      if (wanted(node)) {
        points.insert(points.end(), clouds_[node].begin(), clouds_[node].end());
      }
    }
    return points;
  }

  const Scene& scene_;
  const std::vector<Limb>& limbs_;
  std::vector<int> owners_;
  std::vector<Points> clouds_;
};

// What lies within `half` of the plane through a point.
Points slab(const Points& points, const Vec3& through, const Vec3& normal, double half) {
  Points some;
  std::ranges::copy_if(points, std::back_inserter(some), [&](const Vec3& point) {
    return std::abs(glm::dot(point - through, normal)) <= half;
  });
  return some;
}

// The same, so much thicker that it holds enough to tell the shape: few vertices make a coarse body.
Points filledSlab(const Points& points, const Vec3& through, const Vec3& normal, double half) {
  constexpr std::size_t enough = 12;
  constexpr int mostTimes = 4;
  Points some = slab(points, through, normal, half);
  for (int times = 0; times < mostTimes && some.size() < enough; ++times) {
    half *= 2.0;
    some = slab(points, through, normal, half);
  }
  return some;
}

Points ellipse(const FlatPlace& flat, const Vec2& radii) {
  Points line;
  for (int i = 0; i <= pointsAround; ++i) {
    const double angle = 2.0 * pi * i / pointsAround;
    line.push_back(flat.point({radii.x * std::cos(angle), radii.y * std::sin(angle)}));
  }
  line.back() = line.front();
  return line;
}

// Around all of the points, as wide as they are; a circle of `radius` where there are hardly any.
Points around(const Points& points, FlatPlace flat, double radius) {
  constexpr std::size_t few = 6;
  if (points.size() < few) {
    return ellipse(flat, Vec2(radius));
  }
  Vec2 low(1e300);
  Vec2 high(-1e300);
  for (const Vec3& point : points) {
    low = glm::min(low, flat.seen(point));
    high = glm::max(high, flat.seen(point));
  }
  const Vec2 half = glm::max(0.5 * (high - low), Vec2(0.2 * radius));
  flat.centre = flat.point(0.5 * (low + high));
  double reach = 0.0;
  for (const Vec3& point : points) {
    reach = std::max(reach, glm::length(flat.seen(point) / half));
  }
  return ellipse(flat, gap * reach * half);
}

// The directions in which points reach farthest and least.
FlatPlace alongReach(const Points& points, FlatPlace flat) {
  Vec2 middle(0.0);
  for (const Vec3& point : points) {
    middle += flat.seen(point) / static_cast<double>(points.size());
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Vec3& point : points) {
    const Vec2 away = flat.seen(point) - middle;
    xx += away.x * away.x;
    xy += away.x * away.y;
    yy += away.y * away.y;
  }
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const Vec3 right = std::cos(angle) * flat.right + std::sin(angle) * flat.up;
  const Vec3 up = -std::sin(angle) * flat.right + std::cos(angle) * flat.up;
  return {flat.centre, right, up};
}

// The way around points on the floor (A. M. Andrew, "Another efficient algorithm for convex hulls in two
// dimensions", 1979).
std::vector<Vec2> hullOf(std::vector<Vec2> points) {
  std::ranges::sort(points,
                    [](const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2> hull;
  const auto walk = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= start + 2) {
        const Vec2 last = hull.back() - hull[hull.size() - 2];
        const Vec2 next = *point - hull[hull.size() - 2];
        if (last.x * next.y - last.y * next.x > 0.0) {
          break;
        }
        hull.pop_back();
      }
      hull.push_back(*point);
    }
    hull.pop_back();
  };
  walk(points.begin(), points.end());
  walk(points.rbegin(), points.rend());
  return hull;
}

void moveBy(std::vector<Points>& lines, const Vec3& move) {
  for (Points& line : lines) {
    for (Vec3& point : line) {
      point += move;
    }
  }
}

class ShapeMaker {
public:
  ShapeMaker(const Scene& scene, const std::vector<Limb>& limbs, const AdjustedBody& body)
      : body_(body), flesh_(scene, limbs, body), left_(glm::cross(skywards, body.forward)),
        leg_(std::max(legLength(limbs), leastLegOfHeight * flesh_.height())) {}

  [[nodiscard]] std::vector<Points> linesOf(const Controller& controller) const {
    switch (controller.kind) {
    case ControllerKind::body:
      return floorArrows();
    case ControllerKind::hips:
      return box();
    case ControllerKind::spineLow:
      return {torsoCircle(0.12)};
    case ControllerKind::spineMiddle:
      return {torsoCircle(0.5)};
    case ControllerKind::spineTop:
      return {torsoCircle(0.9)};
    case ControllerKind::head:
      return {crescent(*body_.neck)};
    case ControllerKind::hand:
    case ControllerKind::tip:
      return {handLoop(limbNamed(controller.limb))};
    case ControllerKind::foot:
      return {sole(limbNamed(controller.limb))};
    case ControllerKind::pole:
    case ControllerKind::joint:
      break;
    }
    return {};
  }

  /// Where the controller stands in the bind pose.
  [[nodiscard]] Vec3 placeOf(const Controller& controller) const {
    switch (controller.kind) {
    case ControllerKind::body:
      return hips() * Vec3(1.0, 0.0, 1.0);
    case ControllerKind::hips:
      return hips();
    case ControllerKind::spineLow:
      return alongSpine(0.0);
    case ControllerKind::spineMiddle:
      return alongSpine(0.5);
    case ControllerKind::spineTop:
      return alongSpine(1.0);
    case ControllerKind::head:
      return endPosition(body_.neck->limb, body_.places.worlds);
    default:
      return endPosition(limbNamed(controller.limb).limb, body_.places.worlds);
    }
  }

private:
  static constexpr double leastLegOfHeight = 0.4; // toys have short legs under large bodies

  static double legLength(const std::vector<Limb>& limbs) {
    double length = 0.0;
    for (const Limb& limb : limbs) {
      length = std::max(length, isLeg(limb) ? limb.restLength : 0.0);
    }
    for (const Limb& limb : limbs) {
      length = length > 0.0 ? length : limb.restLength;
    }
    return length;
  }

  [[nodiscard]] Vec3 hips() const { return positionOf(body_.places.worlds[at(body_.hips)]); }

  [[nodiscard]] const AdjustedLimb& limbNamed(const std::string& id) const {
    return *std::ranges::find_if(body_.limbs, [&](const AdjustedLimb& limb) { return limb.limb.id == id; });
  }

  [[nodiscard]] Vec3 alongSpine(double share) const {
    const Points points = limbPoints(body_.spine->limb, body_.places.worlds);
    const std::vector<double>& along = body_.spine->along;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (share <= along[i] && along[i] > along[i - 1]) {
        return glm::mix(points[i - 1], points[i], (share - along[i - 1]) / (along[i] - along[i - 1]));
      }
    }
    return points.back();
  }

  [[nodiscard]] Points torso() const { return flesh_.of({LimbKind::spine}); }

  // A closed arrow that lies on the floor.
  [[nodiscard]] Points floorArrow(const Vec3& towards, double from) const {
    const Vec3 across = glm::cross(skywards, towards);
    const double length = 0.22 * leg_;
    constexpr std::array<Vec2, 8> outline{{{0.0, 0.16},
                                           {0.5, 0.16},
                                           {0.5, 0.42},
                                           {1.0, 0.0},
                                           {0.5, -0.42},
                                           {0.5, -0.16},
                                           {0.0, -0.16},
                                           {0.0, 0.16}}};
    Points line;
    for (const Vec2& corner : outline) {
      line.push_back((from + length * corner.x) * towards + length * corner.y * across);
    }
    return line;
  }

  [[nodiscard]] std::vector<Points> floorArrows() const {
    const Vec3 under = hips() * Vec3(1.0, 0.0, 1.0);
    double reach = 0.3 * leg_;
    for (const Vec3& point : flesh_.of({LimbKind::leg})) {
      reach = std::max(reach, glm::length((point - under) * Vec3(1.0, 0.0, 1.0)));
    }
    std::vector<Points> arrows;
    for (const Vec3& towards : {body_.forward, left_, -body_.forward, -left_}) {
      arrows.push_back(floorArrow(towards, gap * reach));
    }
    moveBy(arrows, under);
    return arrows;
  }

  // Around the pelvis: what of trunk and legs is as high as the hips.
  [[nodiscard]] std::vector<Points> box() const {
    const double half = 0.11 * leg_;
    Vec3 low = hips() - Vec3(0.15 * leg_, half, 0.15 * leg_);
    Vec3 high = hips() + Vec3(0.15 * leg_, half, 0.15 * leg_);
    const Points pelvis = filledSlab(flesh_.of({LimbKind::spine, LimbKind::leg}), hips(), skywards, half);
    if (!pelvis.empty()) {
      Bounds bounds;
      std::ranges::for_each(pelvis, [&](const Vec3& point) { bounds.add(point); });
      const Vec3 room = 0.5 * (gap - 1.0) * (bounds.high - bounds.low);
      low = {bounds.low.x - room.x, low.y, bounds.low.z - room.z};
      high = {bounds.high.x + room.x, high.y, bounds.high.z + room.z};
    }
    return boxLines(low, high);
  }

  static std::vector<Points> boxLines(const Vec3& low, const Vec3& high) {
    std::vector<Points> lines;
    for (const double y : {low.y, high.y}) {
      lines.push_back({{low.x, y, low.z},
                       {high.x, y, low.z},
                       {high.x, y, high.z},
                       {low.x, y, high.z},
                       {low.x, y, low.z}});
    }
    for (std::size_t corner = 0; corner < 4; ++corner) {
      lines.push_back({lines[0][corner], lines[1][corner]});
    }
    return lines;
  }

  [[nodiscard]] Points torsoCircle(double share) const {
    const Vec3 line = alongSpine(1.0) - alongSpine(0.0);
    const Vec3 normal = glm::length(line) > 0.0 ? glm::normalize(line) : skywards;
    const Vec3 across = glm::cross(normal, body_.forward);
    FlatPlace flat;
    flat.centre = alongSpine(share);
    flat.right = glm::length(across) > 0.0 ? glm::normalize(across) : left_;
    flat.up = glm::cross(normal, flat.right);
    return around(filledSlab(torso(), flat.centre, normal, 0.04 * leg_), flat, 0.2 * leg_);
  }

  // A sickle over the crown, seen from the front.
  [[nodiscard]] Points crescent(const AdjustedLimb& neck) const {
    const Points points = flesh_.atEnd(neck.limb);
    Bounds bounds;
    std::ranges::for_each(points, [&](const Vec3& point) { bounds.add(point); });
    FlatPlace flat{endPosition(neck.limb, body_.places.worlds) + 0.1 * leg_ * skywards, left_, skywards};
    Vec2 reach(0.12 * leg_);
    if (!points.empty()) {
      flat.centre = 0.5 * (bounds.low + bounds.high);
      reach = Vec2(0.0);
      for (const Vec3& point : points) {
        reach = glm::max(reach, glm::abs(flat.seen(point)));
      }
    }
    constexpr double fromRadians = 0.2 * pi;
    constexpr double thickness = 0.2;
    Points line;
    const auto add = [&](int i, double bulge) {
      const double share = static_cast<double>(i) / pointsAround;
      const double angle = fromRadians + share * (pi - 2.0 * fromRadians);
      const Vec2 radius = gap * (1.0 + bulge * std::sin(pi * share)) * reach;
      line.push_back(flat.point({radius.x * std::cos(angle), radius.y * std::sin(angle)}));
    };
    for (int i = 0; i <= pointsAround; ++i) {
      add(i, thickness);
    }
    for (int i = pointsAround - 1; i >= 0; --i) {
      add(i, 0.0);
    }
    return line;
  }

  // Across the hand, around its palm.
  [[nodiscard]] Points handLoop(const AdjustedLimb& arm) const {
    const Points joints = limbPoints(arm.limb, body_.places.worlds);
    const Points hand = flesh_.atEnd(arm.limb);
    Vec3 middle(0.0);
    for (const Vec3& point : hand) {
      middle += point / static_cast<double>(hand.size());
    }
    const Vec3 along = hand.empty() ? joints.back() - joints[joints.size() - 2] : middle - joints.back();
    const Vec3 normal = glm::length(along) > 0.0 ? glm::normalize(along) : left_;
    FlatPlace flat;
    flat.right = anyPerpendicular(normal);
    flat.up = glm::cross(normal, flat.right);
    flat.centre = hand.empty() ? joints.back() : joints.back() + 0.9 * along;
    const Points palm = slab(hand, flat.centre, normal, 0.5 * glm::length(along));
    return around(palm, palm.empty() ? flat : alongReach(palm, flat), 0.12 * arm.limb.restLength);
  }

  // Around what of the foot is near the floor.
  [[nodiscard]] Points sole(const AdjustedLimb& leg) const {
    const Points foot = flesh_.atEnd(leg.limb);
    const Vec3 ankle = endPosition(leg.limb, body_.places.worlds);
    Bounds bounds;
    std::ranges::for_each(foot, [&](const Vec3& point) { bounds.add(point); });
    if (foot.size() < 3) {
      return ellipse({ankle, left_, body_.forward}, leg.limb.restLength * Vec2(0.07, 0.15));
    }
    const double ground = bounds.low.y;
    std::vector<Vec2> low;
    for (const Vec3& point : foot) {
      if (point.y <= glm::mix(ground, bounds.high.y, 0.4)) {
        low.emplace_back(point.x, point.z);
      }
    }
    std::vector<Vec2> hull = hullOf(low);
    Vec2 middle(0.0);
    for (const Vec2& corner : hull) {
      middle += corner / static_cast<double>(hull.size());
    }
    Points line;
    for (const Vec2& corner : hull) {
      const Vec2 wide = middle + gap * (corner - middle);
      line.emplace_back(wide.x, ground, wide.y);
    }
    line.push_back(line.front());
    return line;
  }

  const AdjustedBody& body_;
  Flesh flesh_;
  Vec3 left_{1.0, 0.0, 0.0};
  double leg_ = 1.0; // what sizes count in where there is no flesh to measure
};

} // namespace

std::vector<ControllerShape> controllerShapes(const Scene& scene, const std::vector<Limb>& limbs,
                                              const AdjustedBody& body) {
  const ShapeMaker maker(scene, limbs, body);
  std::vector<ControllerShape> shapes;
  for (const Controller& controller : body.list.controllers) {
    if (controller.kind == ControllerKind::pole) {
      continue;
    }
    ControllerShape shape{controller.id, maker.linesOf(controller)};
    moveBy(shape.lines, -maker.placeOf(controller));
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

} // namespace stretch::rig
