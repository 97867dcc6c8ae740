#include "rig/body/reading/hind_part.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/math/polyline.h"

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

std::optional<Extremity> tailOf(const BodyView& view, const PlanParts& parts) {
  const Axis& axis = parts.axis;
  std::optional<Extremity> tail;
  double best = 0.0;
  for (const Extremity& other : parts.extremities.middle) {
    const Extremity rest = restOf(view, parts, other);
    const bool isHeadRow = std::ranges::mismatch(axis.row, other.path).in1 == axis.row.end();
    if (rest.path.empty() || isHeadRow) {
      continue;
    }
    const bool named = std::ranges::any_of(rest.path, [&](int joint) {
      return partWords(view.called[static_cast<std::size_t>(joint)]).contains(PartWord::tail);
    });
    // What hangs on the head is hair, or a crest.
    const int carrier = view.parentOf(rest.path.front());
    const bool isOnHead = axis.head >= 0 && carrier >= 0 && view.isAboveOrSelf(axis.head, carrier);
    const bool back = !isOnHead && glm::dot(rest.points.back() - rest.points.front(), axis.forward) < 0.0;
    const bool isOrnament = rest.word(PartWord::ornament) > 0.0;
    const double least = (named ? 0.03 : 0.12) * view.size;
    const double score = rest.length + (named ? view.size : 0.0);
    if (rest.length > least && (named || (back && !isOrnament)) && score > best) {
      best = score;
      tail = rest;
    }
  }
  return tail;
}

} // namespace stretch::rig::body
