#include "rig/body/evidence/symmetry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"

namespace stretch::rig::body {

namespace {

struct Pair {
  Vec3 direction{0.0}; // unit, from one to the other
  Vec3 middle{0.0};
  double weight = 0.0;
  bool isPosed = false; // far out on limbs, where a pose moves them
};

// What stands below a joint, the joint included.
struct Subtree {
  Vec3 positionSum{0.0};
  double joints = 0.0;
  double length = 0.0; // of all bones below, and the bone that leads to it
  [[nodiscard]] Vec3 centre() const { return positionSum / joints; }
};

std::vector<Subtree> subtrees(const BodyView& view) {
  std::vector<int> deepestFirst(static_cast<std::size_t>(view.count()));
  for (int i = 0; i < view.count(); ++i) {
    deepestFirst[static_cast<std::size_t>(i)] = i;
  }
  std::ranges::stable_sort(deepestFirst, std::ranges::greater{},
                           [&](int candidate) { return view.depth[static_cast<std::size_t>(candidate)]; });
  std::vector<Subtree> trees(deepestFirst.size());
  for (const int candidate : deepestFirst) {
    Subtree& tree = trees[static_cast<std::size_t>(candidate)];
    tree.positionSum += view.at(candidate);
    tree.joints += 1.0;
    const int parent = view.parentOf(candidate);
    if (parent >= 0) {
      tree.length += glm::distance(view.at(candidate), view.at(parent));
      Subtree& above = trees[static_cast<std::size_t>(parent)];
      above.positionSum += tree.positionSum;
      above.joints += tree.joints;
      above.length += tree.length;
    }
  }
  return trees;
}

double likeness(double a, double b) {
  return std::max(a, b) > 0.0 ? std::min(a, b) / std::max(a, b) : 1.0;
}

void addPair(std::vector<Pair>& pairs, const Vec3& a, const Vec3& b, double weight, double size,
             bool isPosed = false) {
  const double distance = glm::distance(a, b);
  if (distance > 1e-3 * size) {
    pairs.push_back({(a - b) / distance, (a + b) / 2.0, weight * distance, isPosed});
  }
}

// Siblings that mirror each other stand equally far from what carries them: a neck may be as long as a
// foreleg, and no image of it.
bool equallyFar(const BodyView& view, int a, int b) {
  const int parent = view.parentOf(a);
  if (parent < 0 || parent != view.parentOf(b)) {
    return true;
  }
  const double toA = glm::distance(view.at(parent), view.at(a));
  const double toB = glm::distance(view.at(parent), view.at(b));
  return std::abs(toA - toB) <= 0.1 * std::max(toA, toB) + 2e-3 * view.size;
}

// Where limbs are posed out of symmetry, only their first joints tell of the body's.
void addSiblings(std::vector<Pair>& pairs, const BodyView& view, const std::vector<Subtree>& trees, int a,
                 int b) {
  const Subtree& ofA = trees[static_cast<std::size_t>(a)];
  const Subtree& ofB = trees[static_cast<std::size_t>(b)];
  const double weight = ofA.length + ofB.length + 1e-2 * view.size;
  // On two that begin at one place, as collar bones do, the first joints that stand apart.
  const auto areApart = [&] { return glm::distance(view.at(a), view.at(b)) > 0.02 * view.size; };
  while (!areApart() && view.childrenOf(a).size() == 1 && view.childrenOf(b).size() == 1) {
    a = view.childrenOf(a).front();
    b = view.childrenOf(b).front();
  }
  if (areApart()) {
    addPair(pairs, view.at(a), view.at(b), weight, view.size);
  } else {
    addPair(pairs, ofA.centre(), ofB.centre(), weight, view.size);
  }
}

// Joints that names put on the same side mirror none of each other.
bool mayMirror(const BodyView& view, int a, int b) {
  const Side ofA = view.name(a).side;
  return ofA == Side::none || ofA != view.name(b).side;
}

void addSiblingPairs(std::vector<Pair>& pairs, const BodyView& view, const std::vector<Subtree>& trees,
                     std::vector<int> siblings) {
  constexpr std::size_t mostSiblings = 48;
  std::ranges::stable_sort(siblings, std::ranges::greater{},
                           [&](int candidate) { return trees[static_cast<std::size_t>(candidate)].length; });
  siblings.resize(std::min(siblings.size(), mostSiblings));
  for (std::size_t i = 0; i < siblings.size(); ++i) {
    for (std::size_t j = i + 1; j < siblings.size(); ++j) {
      const Subtree& a = trees[static_cast<std::size_t>(siblings[i])];
      const Subtree& b = trees[static_cast<std::size_t>(siblings[j])];
      if (likeness(a.joints, b.joints) >= 0.7 && likeness(a.length, b.length) >= 0.75 &&
          equallyFar(view, siblings[i], siblings[j]) && mayMirror(view, siblings[i], siblings[j])) {
        addSiblings(pairs, view, trees, siblings[i], siblings[j]);
      }
    }
  }
}

// Levels from a joint up to the first that carries another one as well.
int levelsApart(const BodyView& view, int joint, int other) {
  int levels = 0;
  for (int above = view.parentOf(joint); above >= 0 && !view.isAboveOrSelf(above, other); ++levels) {
    above = view.parentOf(above);
  }
  return levels;
}

// A key without its last number, which an exporter may have appended to tell all joints apart.
std::string withoutLastNumber(const std::string& key) {
  const std::size_t mark = key.rfind('#');
  return mark == std::string::npos ? key : key.substr(0, mark);
}

// Joints by what two of a pair are called alike.
using ByKey = std::map<std::string, std::vector<int>>;

ByKey jointsByKey(const BodyView& view, Side side, bool withLastNumber) {
  ByKey joints;
  for (int i = 0; i < view.count(); ++i) {
    if (view.name(i).side == side) {
      joints[withLastNumber ? view.name(i).key : withoutLastNumber(view.name(i).key)].push_back(i);
    }
  }
  return joints;
}

int addNamedPairs(std::vector<Pair>& pairs, const BodyView& view, bool withLastNumber) {
  const ByKey left = jointsByKey(view, Side::left, withLastNumber);
  int added = 0;
  for (const auto& [key, joints] : jointsByKey(view, Side::right, withLastNumber)) {
    const auto found = left.find(key);
    if (found == left.end() || found->second.size() != 1) {
      continue;
    }
    for (const int joint : joints) {
      const int other = found->second.front();
      const NameEvidence& name = view.name(joint);
      // The farther out, the more a pose moves them, and the more there are of them: fingers.
      const bool isEnd = std::max(name.role(Role::ankle), name.role(Role::wrist)) >= 0.8;
      const int levels = std::max(levelsApart(view, joint, other), isEnd ? 2 : 0); // feet may hang from the
                                                                                   // root
      const double weight = levels == 0 ? 0.3 : 0.12 * std::pow(0.5, levels);
      addPair(pairs, view.at(joint), view.at(other), weight * view.size, view.size, levels > 0);
      ++added;
    }
  }
  return added;
}

std::vector<Pair> mirrorPairs(const BodyView& view) {
  const std::vector<Subtree> trees = subtrees(view);
  std::vector<Pair> pairs;
  std::vector<int> roots;
  for (int i = 0; i < view.count(); ++i) {
    if (view.parentOf(i) < 0) {
      roots.push_back(i);
    }
    addSiblingPairs(pairs, view, trees, view.childrenOf(i));
  }
  addSiblingPairs(pairs, view, trees, roots);
  if (addNamedPairs(pairs, view, true) == 0) {
    addNamedPairs(pairs, view, false);
  }
  std::ranges::stable_sort(pairs, std::ranges::greater{}, &Pair::weight);
  return pairs;
}

// How much of the pairs' weight lies along an axis, deviations up to about 25 degrees counting in part.
double support(const std::vector<Pair>& pairs, const Vec3& axis) {
  double sum = 0.0;
  for (const Pair& pair : pairs) {
    sum += pair.weight * std::max(0.0, std::abs(glm::dot(pair.direction, axis)) - 0.9) / 0.1;
  }
  return sum;
}

double weightedMedian(std::vector<std::pair<double, double>> values) {
  std::ranges::sort(values);
  double total = 0.0;
  for (const auto& value : values) {
    total += value.second;
  }
  double sum = 0.0;
  for (const auto& value : values) {
    sum += value.second;
    if (sum >= total / 2.0) {
      return value.first;
    }
  }
  return 0.0;
}

double offsetAlong(const std::vector<Pair>& pairs, const BodyView& view, const Vec3& normal) {
  std::vector<std::pair<double, double>> offsets;
  // A raised arm with its fingers moves the middle of its pairs aside: they count where there are no others.
  for (const bool posed : {false, true}) {
    for (const Pair& pair : pairs) {
      const bool isAcross = std::abs(glm::dot(pair.direction, normal)) > 0.9;
      if (isAcross && pair.isPosed == posed) {
        offsets.emplace_back(glm::dot(pair.middle, normal), pair.weight);
      }
    }
    if (!offsets.empty()) {
      break;
    }
  }
  if (offsets.empty()) {
    for (int i = 0; i < view.count(); ++i) {
      offsets.emplace_back(glm::dot(view.at(i), normal), 1.0);
    }
  }
  return weightedMedian(std::move(offsets));
}

// What lies off a plane, in the length of bones, and the share of it that has a counterpart beyond: the fore
// half of a body is no image of the hind one, however alike their legs are.
struct Images {
  double outside = 0.0;
  double share = 0.0;
  bool isHeadOff = false; // a joint that is called head or neck stands beside the plane
};

bool isCalledHead(const NameEvidence& name) {
  constexpr double clear = 0.8;
  return name.side == Side::none && std::max(name.role(Role::head), name.role(Role::neck)) >= clear;
}

Images imagesIn(const BodyView& view, const MirrorPlane& plane) {
  constexpr double off = 0.02;   // of the body
  constexpr double near = 0.03;  // of the body
  constexpr double beside = 0.1; // of the body
  constexpr int most = 400;      // joints that are looked at
  const int step = 1 + view.count() / most;
  double outside = 0.0;
  double met = 0.0;
  bool isHeadOff = false;
  for (int joint = 0; joint < view.count(); joint += step) {
    const int parent = view.parentOf(joint);
    if (parent < 0 || std::abs(plane.lateral(view.at(joint))) < off * view.size) {
      continue;
    }
    const double bone = glm::distance(view.at(joint), view.at(parent));
    const Vec3 image = plane.mirrored(view.at(joint));
    const bool isMet = std::ranges::any_of(
        view.position, [&](const Vec3& other) { return glm::distance(other, image) < near * view.size; });
    outside += bone;
    met += isMet ? bone : 0.0;
    isHeadOff = isHeadOff || (isCalledHead(view.name(joint)) &&
                              std::abs(plane.lateral(view.at(joint))) > beside * view.size);
  }
  return {outside, outside > 0.0 ? met / outside : 0.0, isHeadOff};
}

// A limb at rest out of symmetry tilts a mean by a few degrees; characters are made along the axes, or stand
// upright at least: a plane that leans has both feet on one side.
Vec3 straightened(const Vec3& axis) {
  constexpr double nearAxis = 0.99;
  constexpr double upright = 0.14; // sine
  for (const Vec3& world : {Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
    if (std::abs(glm::dot(axis, world)) > nearAxis) {
      return glm::dot(axis, world) > 0.0 ? world : -world;
    }
  }
  return std::abs(axis.y) < upright ? glm::normalize(Vec3(axis.x, 0.0, axis.z)) : axis;
}

Vec3 bestAxis(const std::vector<Pair>& pairs, const BodyView& view) {
  constexpr double clearly = 0.25; // a larger share of images
  // Where all has an image, as much lies off the plane and no names tell left from right: the middle legs of
  // an insect lie in the plane across it, and its head and abdomen have no image there.
  constexpr double whole = 0.95;
  constexpr double slightly = 0.08; // a larger share of images
  const bool isNamed =
      std::ranges::any_of(view.names, [](const NameEvidence& name) { return name.side != Side::none; });
  constexpr double least = 0.2; // of the best support
  double total = 0.0;
  for (const Pair& pair : pairs) {
    total += pair.weight;
  }
  Vec3 best(1, 0, 0);
  double bestSupport = support(pairs, best) + 0.1 * total; // glTF characters face along Z
  const std::size_t hypotheses = std::min<std::size_t>(pairs.size(), 60);
  std::vector<std::pair<double, Vec3>> others{{bestSupport, best}};
  for (std::size_t i = 0; i < hypotheses; ++i) {
    // Hardly a character lies on its side.
    const double here = support(pairs, pairs[i].direction) * (1.0 - 0.4 * std::abs(pairs[i].direction.y));
    others.emplace_back(here, pairs[i].direction);
    if (here > bestSupport * (1.0 + 1e-9)) {
      bestSupport = here;
      best = pairs[i].direction;
    }
  }
  constexpr double asMuch = 0.8;
  const Images ofBest = imagesIn(view, {best, offsetAlong(pairs, view, best)});
  double mostAhead = 0.0;
  Vec3 chosen = best;
  for (const auto& [here, direction] : others) {
    const bool isOther = std::abs(glm::dot(direction, best)) < 0.9;
    // Where the head is beside the plane, any other direction may be across the body.
    const Images images = isOther && (ofBest.isHeadOff || here > least * bestSupport)
                              ? imagesIn(view, {direction, offsetAlong(pairs, view, direction)})
                              : Images{};
    const bool isWhole = images.share > whole && images.outside > asMuch * ofBest.outside && !isNamed;
    const bool hasHead = ofBest.isHeadOff && !images.isHeadOff;
    const double ahead = images.share - ofBest.share - (hasHead ? 0.0 : isWhole ? slightly : clearly);
    if (ahead > mostAhead) {
      mostAhead = ahead;
      chosen = direction;
    }
  }
  best = chosen;
  Vec3 mean(0.0);
  for (const Pair& pair : pairs) {
    const double along = glm::dot(pair.direction, best);
    if (std::abs(along) > 0.95) {
      mean += pair.direction * (along > 0.0 ? pair.weight : -pair.weight);
    }
  }
  const Vec3 axis = glm::length(mean) > 0.0 ? glm::normalize(mean) : best;
  return straightened(axis);
}

// A body without pairs, as a snake's, lies along its plane.
Vec3 narrowAxis(const BodyView& view) {
  constexpr double longer = 2.0; // than wide and high
  Bounds bounds;
  for (const Vec3& place : view.position) {
    bounds.add(place);
  }
  const Vec3 extent = bounds.empty() ? Vec3(0.0) : bounds.high - bounds.low;
  return extent.x > longer * std::max(extent.y, extent.z) ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
}

} // namespace

double MirrorPlane::lateral(const Vec3& point) const {
  return glm::dot(normal, point) - offset;
}

Vec3 MirrorPlane::mirrored(const Vec3& point) const {
  return point - 2.0 * lateral(point) * normal;
}

MirrorPlane findMirrorPlane(const BodyView& view) {
  const std::vector<Pair> pairs = mirrorPairs(view);
  const Vec3 normal = pairs.empty() ? narrowAxis(view) : bestAxis(pairs, view);
  return {normal, offsetAlong(pairs, view, normal)};
}

} // namespace stretch::rig::body
