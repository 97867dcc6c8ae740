#include "rig/body/reading/long_row.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

#include "core/math/polyline.h"

namespace stretch::rig::body {

bool isEven(const Extremity& row) {
  constexpr double shortest = 0.01; // of the row: joints that stand on one another have no bone between
                                    // them
  double longest = 0.0;
  double bones = 0.0;
  for (std::size_t i = 1; i < row.points.size(); ++i) {
    const double bone = glm::distance(row.points[i - 1], row.points[i]);
    longest = std::max(longest, bone);
    bones += bone > shortest * row.length ? 1.0 : 0.0;
  }
  return longest < std::max(0.45, 1.5 / bones) * row.length;
}

bool hasNamedLegs(const BodyView& view) {
  constexpr double clear = 0.8;
  std::vector<bool> isBelowThigh(view.names.size(), false);
  bool hasLeft = false;
  bool hasRight = false;
  for (std::size_t joint = 0; joint < view.names.size(); ++joint) { // parents come first
    const NameEvidence& name = view.names[joint];
    const int above = view.parent[joint];
    const bool isThigh = name.role(Role::thigh) >= clear;
    const bool isShin = name.role(Role::shin) >= clear;
    const bool hangsFromThigh = above >= 0 && isBelowThigh[static_cast<std::size_t>(above)];
    if (isShin && hangsFromThigh) {
      return true;
    }
    isBelowThigh[joint] = isThigh || hangsFromThigh;
    hasLeft = hasLeft || (name.side == Side::left && (isThigh || isShin));
    hasRight = hasRight || (name.side == Side::right && (isThigh || isShin));
  }
  return hasLeft && hasRight;
}

bool hasLongLimbs(const BodyView& view, const std::vector<ExtremityPair>& pairs) {
  constexpr double longest = 0.25; // of the body
  return std::ranges::count_if(pairs, [&](const ExtremityPair& pair) {
           return pair.length() > longest * view.size && pair.word(PartWord::fin) == 0.0;
         }) > 1;
}

bool hasBranches(const BodyView& view, const Extremity& row) {
  constexpr double least = 0.33;                       // of the row
  std::vector<bool> isOfRow(view.names.size(), false); // or above it
  for (const int joint : row.path) {
    isOfRow[static_cast<std::size_t>(joint)] = true;
  }
  for (int joint = view.parentOf(row.path.front()); joint >= 0; joint = view.parentOf(joint)) {
    isOfRow[static_cast<std::size_t>(joint)] = true;
  }
  std::vector<double> reach(view.names.size(), 0.0); // along the bones
  std::vector<int> limbs(view.names.size(), 0);      // that end below a joint
  int branches = 0;
  std::vector<int> deepestFirst(view.names.size());
  std::iota(deepestFirst.begin(), deepestFirst.end(), 0);
  std::ranges::stable_sort(deepestFirst, std::greater<>(),
                           [&](int joint) { return view.depth[static_cast<std::size_t>(joint)]; });
  for (const int joint : deepestFirst) {
    const auto own = static_cast<std::size_t>(joint);
    if (isOfRow[own]) {
      continue;
    }
    const int parent = view.parentOf(joint);
    const double bone = parent < 0 ? 0.0 : glm::distance(view.at(parent), view.at(joint));
    const bool isFin = partWords(view.called[own]).contains(PartWord::fin);
    const bool isLimb = reach[own] > 0.0 && reach[own] + bone > least * row.length && !isFin;
    const int ends = isLimb ? std::max(1, limbs[own]) : 0;
    if (parent < 0 || isOfRow[static_cast<std::size_t>(parent)]) {
      branches += ends;
    } else {
      const auto above = static_cast<std::size_t>(parent);
      reach[above] = std::max(reach[above], reach[own] + bone);
      limbs[above] += ends;
    }
  }
  return branches >= 3;
}

bool startsAtAnchor(const BodyView& view, const Extremity& row) {
  constexpr double longer = 1.5; // than any other bone
  if (!view.points[static_cast<std::size_t>(row.path.front())].empty()) {
    return false;
  }
  const Vec3 first = row.points[1] - row.points[0];
  double longest = 0.0;
  for (std::size_t i = 2; i < row.points.size(); ++i) {
    longest = std::max(longest, glm::distance(row.points[i - 1], row.points[i]));
  }
  // Where nothing tells which joints move vertices, only a bone far shorter than the others is no bone.
  const double meanBone = row.length / static_cast<double>(row.points.size() - 1);
  const double shortBone = 0.06 * row.length;
  const double hardlyABone = view.hasVertices ? shortBone : std::min(shortBone, 0.3 * meanBone);
  const bool turnsBack = glm::dot(first, row.points[2] - row.points[1]) < 0.0;
  const bool isOff = view.hasVertices && (glm::length(first) > longer * longest || turnsBack);
  return glm::length(first) < hardlyABone || isOff;
}

namespace {

void endBefore(Extremity& row, std::size_t place) {
  row.tip = NodeIndex::none;
  row.path.resize(place);
  row.points.resize(place);
  row.length = polylineLength(row.points);
}

} // namespace

void endAtHead(Extremity& row, const Axis& axis) {
  const auto head = std::ranges::find(row.path, axis.head);
  if (!axis.headIsNamed || head == row.path.end() || (head + 1 == row.path.end() && !row.tip.exists())) {
    return;
  }
  Extremity body = row;
  endBefore(body, static_cast<std::size_t>(head - row.path.begin()) + 1);
  if (body.path.size() > 2 && 2.0 * body.length > row.length) { // else the row begins at the head
    row = std::move(body);
  }
}

bool isInFork(const BodyView& view, const Extremity& row, std::size_t place) {
  return place > 1 && place < row.path.size() && view.childrenOf(view.parentOf(row.path[place])).size() > 1;
}

void endBeforeFins(const BodyView& view, Extremity& row) {
  std::size_t first = row.path.size();
  while (first > 0 &&
         partWords(view.called[static_cast<std::size_t>(row.path[first - 1])]).contains(PartWord::fin)) {
    --first;
  }
  while (first < row.path.size() && !isInFork(view, row, first)) {
    ++first;
  }
  if (first < row.path.size()) {
    endBefore(row, first);
  }
}

double trunkLength(const BodyView& view, const Extremity& row) {
  Extremity trunk = row;
  endBeforeFins(view, trunk);
  const bool isFin = row.word(PartWord::fin) > 0.0 && trunk.path.size() == row.path.size();
  return (isFin ? 0.5 : 1.0) * trunk.length; // a fin may be longer than what it ends
}

} // namespace stretch::rig::body
