#include "skinning/locate/creature/creature_ends.h"

#include <algorithm>
#include <iterator>

#include <glm/geometric.hpp>

namespace stretch::skinning {

namespace {

// Toes meet on the ground, legs above it.
bool isLegEnd(const StandingBody& body, const BodyEnd& end) {
  constexpr double lowest = 0.1; // of the height: its tip
  constexpr double rises = 0.06; // to where it meets the body
  const Vec3 tip = body.middleOf(end.cell);
  return tip.y < lowest && end.root.y - tip.y > rises;
}

double apart(const StandingBody& body, const BodyEnd& a, const BodyEnd& b) {
  return glm::distance(body.middleOf(a.cell), Vec3(-1.0, 1.0, 1.0) * body.middleOf(b.cell));
}

const BodyEnd* mirrorOf(const StandingBody& body, const BodyEnd& one, const std::vector<BodyEnd>& ends) {
  const BodyEnd* nearest = nullptr;
  for (const BodyEnd& other : ends) {
    const bool isOpposite = body.middleOf(one.cell).x * body.middleOf(other.cell).x < 0.0;
    if (isOpposite && (nearest == nullptr || apart(body, one, other) < apart(body, one, *nearest))) {
      nearest = &other;
    }
  }
  return nearest;
}

// Ends that are each other's nearest mirror images.
std::vector<EndPair> pairsOf(const StandingBody& body, const std::vector<BodyEnd>& ends) {
  constexpr double nearby = 0.5; // of the shorter one's length, or of the height
  std::vector<EndPair> pairs;
  for (const BodyEnd& left : ends) {
    if (body.middleOf(left.cell).x < 2.0 * body.cubes.grid.size) {
      continue;
    }
    const BodyEnd* const right = mirrorOf(body, left, ends);
    if (right != nullptr && mirrorOf(body, *right, ends) == &left &&
        apart(body, left, *right) < nearby * std::max(1.0, std::min(left.length, right->length))) {
      pairs.push_back({left, *right});
    }
  }
  return pairs;
}

std::vector<EndPair> legPairs(const StandingBody& body, const std::vector<BodyEnd>& ends, int rows) {
  constexpr double shortLeg = 0.4; // of the middle one's length: a feeler
  std::vector<BodyEnd> standing;
  std::ranges::copy_if(ends, std::back_inserter(standing),
                       [&](const BodyEnd& end) { return isLegEnd(body, end); });
  std::vector<EndPair> pairs = pairsOf(body, standing);
  std::ranges::stable_sort(pairs, std::ranges::greater{}, &EndPair::length);
  if (!pairs.empty()) {
    const double usual = pairs[pairs.size() / 2].length();
    std::erase_if(pairs, [&](const EndPair& pair) { return pair.length() < shortLeg * usual; });
  }
  if (rows > 0 && pairs.size() > static_cast<std::size_t>(rows)) {
    pairs.resize(static_cast<std::size_t>(rows));
  }
  std::ranges::stable_sort(pairs, {}, [&](const EndPair& pair) {
    return body.middleOf(pair.left.cell).z + body.middleOf(pair.right.cell).z;
  });
  return pairs;
}

bool isOf(const std::vector<EndPair>& pairs, const BodyEnd& end) {
  return std::ranges::any_of(
      pairs, [&](const EndPair& pair) { return pair.left.cell == end.cell || pair.right.cell == end.cell; });
}

} // namespace

std::vector<BodyEnd> CreatureEnds::all() const {
  std::vector<BodyEnd> ends = middle;
  for (const std::vector<EndPair>* const pairs : {&legs, &others}) {
    for (const EndPair& pair : *pairs) {
      ends.push_back(pair.left);
      ends.push_back(pair.right);
    }
  }
  return ends;
}

CreatureEnds creatureEnds(const StandingBody& body, const std::vector<double>& ways, int rows) {
  constexpr double shortest = 0.02; // of the farthest way
  constexpr double least = 0.15;    // of the height: ears and toes are shorter
  constexpr double alike = 0.35;    // two tips of one tail differ more: they meet each other first
  std::vector<BodyEnd> all = bodyEnds(body, ways, shortest);
  CreatureEnds ends;
  ends.legs = legPairs(body, all, rows);
  std::erase_if(all, [&](const BodyEnd& end) { return end.length < least || isOf(ends.legs, end); });
  for (const EndPair& pair : pairsOf(body, all)) {
    if (pair.length() > alike * std::max(pair.left.length, pair.right.length)) {
      ends.others.push_back(pair);
    }
  }
  std::ranges::copy_if(all, std::back_inserter(ends.middle),
                       [&](const BodyEnd& end) { return !isOf(ends.others, end); });
  return ends;
}

} // namespace stretch::skinning
