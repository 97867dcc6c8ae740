#include "rig/body/reading/middle_parts.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/polyline.h"
#include "rig/body/reading/limb_end.h"

namespace stretch::rig::body {

namespace {

bool carriesLeg(const BodyView& view, const PlanParts& parts, int joint) {
  return std::ranges::any_of(parts.pairs, [&](const KindredPair& one) {
    return one.kind == LimbKind::leg && view.isAboveOrSelf(joint, carrierOf(view, one.pair));
  });
}

// What a row has beside the row of the head, from where it carries no leg.
Extremity restOf(const BodyView& view, const PlanParts& parts, const Extremity& other) {
  Extremity rest = other;
  auto first = std::ranges::mismatch(parts.axis.row, other.path).in2;
  while (first != other.path.end() && carriesLeg(view, parts, *first)) {
    ++first;
  }
  rest.path.assign(first, other.path.end());
  rest.points.erase(rest.points.begin(), rest.points.begin() + (first - other.path.begin()));
  rest.length = polylineLength(rest.points);
  return rest;
}

void leaveOutRump(const BodyView& view, Extremity& tail) {
  const auto rump = static_cast<std::ptrdiff_t>(jointsOfRump(view, tail.path));
  tail.path.erase(tail.path.begin(), tail.path.begin() + rump);
  tail.points.erase(tail.points.begin(), tail.points.begin() + rump);
  tail.length = polylineLength(tail.points);
}

// A tail of one joint reaches as far as its mesh; an insect's abdomen is no tail of another body.
void estimateLoneTail(const BodyView& view, Extremity& tail) {
  const std::string& name = view.called[static_cast<std::size_t>(tail.path.back())];
  const bool isLone = tail.points.size() == 1 && name.find("bdomen") == std::string::npos;
  if (const std::optional<EstimatedEnd> end = isLone ? estimateEnd(view, tail.path.back()) : std::nullopt) {
    tail.points.push_back(end->position);
    tail.length = polylineLength(tail.points);
  }
}

} // namespace

int carrierOf(const BodyView& view, const ExtremityPair& pair) {
  const int carrier = view.commonAncestor(pair.negative.attach, pair.positive.attach);
  return carrier >= 0 ? carrier : pair.positive.attach;
}

std::vector<int> trunkBehind(const BodyView& view, const PlanParts& parts) {
  const std::vector<int>& row = parts.axis.row;
  std::vector<int> longest;
  for (const KindredPair& one : parts.pairs) {
    const int carrier = one.kind == LimbKind::leg ? carrierOf(view, one.pair) : -1;
    const int branching = carrier < 0 ? -1 : view.commonAncestor(row.back(), carrier);
    if (branching < 0 || branching == carrier) {
      continue;
    }
    const std::vector<int> path = view.path(branching, carrier);
    longest = path.size() > longest.size() ? path : longest;
  }
  return longest;
}

bool isCalledTail(const BodyView& view, int joint) {
  return partWords(view.called[static_cast<std::size_t>(joint)]).contains(PartWord::tail);
}

std::size_t jointsOfRump(const BodyView& view, const std::vector<int>& tail) {
  constexpr std::ptrdiff_t most = 2;
  const auto first = std::ranges::find_if(tail, [&](int joint) {
    return isCalledTail(view, joint) || view.called[static_cast<std::size_t>(joint)].empty();
  });
  const std::ptrdiff_t before = first - tail.begin();
  return before > most ? 0 : static_cast<std::size_t>(before);
}

std::optional<Extremity> tailOf(const BodyView& view, const PlanParts& parts) {
  const Axis& axis = parts.axis;
  std::optional<Extremity> tail;
  double best = 0.0;
  for (const Extremity& other : parts.extremities.middle) {
    Extremity rest = restOf(view, parts, other);
    const bool isHeadRow = std::ranges::mismatch(axis.row, other.path).in1 == axis.row.end();
    if (rest.path.empty() || isHeadRow) {
      continue;
    }
    const bool named = std::ranges::any_of(rest.path, [&](int joint) { return isCalledTail(view, joint); });
    const bool isOrnament = rest.word(PartWord::ornament) > 0.0;
    if (named) {
      leaveOutRump(view, rest);
    }
    // What hangs on the head is hair, or a crest.
    const int carrier = view.parentOf(rest.path.front());
    const bool isOnHead = axis.head >= 0 && carrier >= 0 && view.isAboveOrSelf(axis.head, carrier);
    if (named && !isOnHead && !isOrnament) {
      estimateLoneTail(view, rest);
    }
    const bool fromTip = axis.hips >= 0 && hangsFromTip(view, axis, rest);
    const bool back =
        !isOnHead && (fromTip || glm::dot(rest.points.back() - rest.points.front(), axis.forward) < 0.0);
    const double gap = fromTip ? glm::distance(rest.points.back(), view.at(axis.hips)) : 0.0;
    const double least = (named ? 0.03 : 0.12) * view.size;
    const double score = rest.length + (named ? view.size : 0.0);
    if (rest.length + gap > least && (named || (back && !isOrnament)) && score > best) {
      best = score;
      tail = rest;
    }
  }
  return tail;
}

bool isHeadAside(const BodyView& view, const Axis& axis, const Vec3& middleOfLegs, const Vec3& up) {
  constexpr double inMiddle = 0.02; // of the body
  const Vec3 offset = view.at(std::max(axis.head, 0)) - middleOfLegs;
  return axis.headIsNamed && glm::length(offset - up * glm::dot(offset, up)) > inMiddle * view.size;
}

bool hangsFromTip(const BodyView& view, const Axis& axis, const Extremity& tail) {
  const Vec3& hips = view.at(std::max(axis.hips, 0));
  return view.parentOf(tail.path.front()) < 0 &&
         glm::distance(tail.points.back(), hips) < 0.5 * glm::distance(tail.points.front(), hips);
}

std::optional<std::string> doubtOfHead(const BodyView& view, const PlanParts& parts, const Vec3& up) {
  constexpr double higher = 0.25; // of the body
  const Axis& axis = parts.axis;
  const auto risesBeyondHead = [&](const Extremity& row) {
    return std::ranges::find(row.path, axis.head) == row.path.end() &&
           glm::dot(row.points.back() - view.at(axis.head), up) > higher * view.size;
  };
  const bool hangs =
      !axis.headIsNamed && axis.head >= 0 && std::ranges::any_of(parts.extremities.middle, risesBeyondHead);
  return hangs ? std::optional<std::string>(
                     "the joint names of left and right put the head at an end that hangs: are front and "
                     "hind limbs, and left and right, right?")
               : std::nullopt;
}

bool isRootOnFloor(const BodyView& view, const PlanParts& parts, int joint, const Vec3& up) {
  constexpr double low = 0.05; // of the body's height
  const Extremities& extremities = parts.extremities;
  return view.hasVertices && parts.standingLegs() > 0 &&
         view.points[static_cast<std::size_t>(joint)].empty() &&
         glm::dot(view.at(joint), up) - extremities.floor < low * (extremities.top - extremities.floor);
}

bool carriesLimb(const BodyView& view, const PlanParts& parts, int joint, bool countsChains) {
  return std::ranges::any_of(parts.pairs, [&](const KindredPair& one) {
    return (countsChains || one.kind != LimbKind::chain) &&
           view.isAboveOrSelf(joint, carrierOf(view, one.pair));
  });
}

bool isNeck(const BodyView& view, int joint) {
  return view.name(joint).role(Role::neck) >= clearRole;
}

double bulk(const BodyView& view, int joint) {
  Vec3 low(std::numeric_limits<double>::max());
  Vec3 high(std::numeric_limits<double>::lowest());
  for (const Vec3& point : view.points[static_cast<std::size_t>(joint)]) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return high.x >= low.x ? glm::distance(low, high) : 0.0;
}

void endAtHeadBeside(const BodyView& view, PlanParts& parts) {
  Axis& axis = parts.axis;
  const auto isHead = [&](int joint) {
    return view.name(joint).role(Role::head) >= clearRole && view.name(joint).side == Side::none;
  };
  if (std::ranges::any_of(axis.row, isHead)) {
    return;
  }
  for (auto carrier = axis.row.rbegin(); carrier != axis.row.rend(); ++carrier) {
    const std::vector<int>& children = view.childrenOf(*carrier);
    const auto head = std::ranges::find_if(children, isHead);
    if (head != children.end() && !carriesLimb(view, parts, *carrier)) {
      axis.head = *head;
      axis.row.erase(carrier.base(), axis.row.end());
      axis.row.push_back(axis.head);
      return;
    }
  }
}

void takeNeckAlone(const BodyView& view, PlanParts& parts) {
  Axis& axis = parts.axis;
  axis.neck.assign(axis.row.begin(), std::ranges::find(axis.row, axis.head));
  const auto hindLeg = std::find_if(parts.pairs.rbegin(), parts.pairs.rend(),
                                    [](const KindredPair& one) { return one.kind == LimbKind::leg; });
  for (int joint = carrierOf(view, hindLeg->pair); joint >= 0; joint = view.parentOf(joint)) {
    axis.spine.insert(axis.spine.begin(), joint);
  }
  if (!axis.spine.empty()) {
    axis.hips = axis.spineEnd = axis.spine.back();
    axis.spine.pop_back();
  }
}

} // namespace stretch::rig::body
