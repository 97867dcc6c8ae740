#include "rig/body/reading/extremities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "core/math/finite.h"
#include "core/math/polyline.h"
#include "rig/body/evidence/name_text.h"
#include "rig/body/evidence/name_words.h"
#include "rig/body/reading/limb_end.h"

namespace stretch::rig::body {

namespace {

struct PartEntry {
  std::string_view text;
  PartWord word;
};

// clang-format off
constexpr std::array partEntries = std::to_array<PartEntry>({
    {"leg", PartWord::leg}, {"legs", PartWord::leg}, {"foot", PartWord::leg}, {"feet", PartWord::leg},
    {"paw", PartWord::leg}, {"hoof", PartWord::leg}, {"hock", PartWord::leg}, {"toe", PartWord::leg},
    {"toes", PartWord::leg}, {"thigh", PartWord::leg}, {"shin", PartWord::leg}, {"calf", PartWord::leg},
    {"knee", PartWord::leg}, {"femur", PartWord::leg}, {"tibia", PartWord::leg}, {"tarsus", PartWord::leg},
    {"metatarsus", PartWord::leg}, {"coxa", PartWord::leg}, {"ankle", PartWord::leg},
    {"upleg", PartWord::leg}, {"patte", PartWord::leg}, {"jambe", PartWord::leg}, {"bein", PartWord::leg},
    {"arm", PartWord::arm}, {"forearm", PartWord::arm}, {"upperarm", PartWord::arm},
    {"hand", PartWord::arm}, {"wrist", PartWord::arm}, {"elbow", PartWord::arm}, {"bras", PartWord::arm},
    {"wing", PartWord::wing}, {"wings", PartWord::wing}, {"feather", PartWord::wing},
    {"aile", PartWord::wing}, {"ala", PartWord::wing}, {"fluegel", PartWord::wing},
    {"flugel", PartWord::wing},
    {"fin", PartWord::fin}, {"fins", PartWord::fin}, {"flipper", PartWord::fin}, {"fluke", PartWord::fin},
    {"pectoral", PartWord::fin}, {"dorsal", PartWord::fin}, {"nageoire", PartWord::fin},
    {"antenna", PartWord::feeler}, {"antennae", PartWord::feeler}, {"feeler", PartWord::feeler},
    {"tentacle", PartWord::feeler}, {"palp", PartWord::feeler}, {"pedipalp", PartWord::feeler},
    {"claw", PartWord::claw}, {"claws", PartWord::claw}, {"pincer", PartWord::claw},
    {"pincers", PartWord::claw}, {"chela", PartWord::claw}, {"chelae", PartWord::claw},
    {"tail", PartWord::tail}, {"queue", PartWord::tail}, {"schwanz", PartWord::tail},
    {"cola", PartWord::tail}, {"coda", PartWord::tail}, {"cauda", PartWord::tail},
    {"rabo", PartWord::tail}, {"хвост", PartWord::tail}, {"尾巴", PartWord::tail}, {"尻尾", PartWord::tail}, {"abdomen", PartWord::tail},
    {"head", PartWord::head}, {"neck", PartWord::head}, {"skull", PartWord::head},
    {"jaw", PartWord::head}, {"mouth", PartWord::head}, {"tongue", PartWord::head},
    {"tete", PartWord::head}, {"cou", PartWord::head}, {"kopf", PartWord::head}, {"hals", PartWord::head},
    {"ear", PartWord::ornament}, {"ears", PartWord::ornament}, {"horn", PartWord::ornament}, {"antler", PartWord::ornament},
    {"horns", PartWord::ornament}, {"antlers", PartWord::ornament},
    {"eye", PartWord::ornament}, {"eyes", PartWord::ornament}, {"teeth", PartWord::ornament},
    {"tooth", PartWord::ornament}, {"fang", PartWord::ornament}, {"mandible", PartWord::ornament},
    {"whisker", PartWord::ornament}, {"brow", PartWord::ornament}, {"lid", PartWord::ornament},
    {"hair", PartWord::ornament}, {"mane", PartWord::ornament}, {"saddle", PartWord::ornament},
    {"front", PartWord::front}, {"fore", PartWord::front}, {"avant", PartWord::front},
    {"back", PartWord::back}, {"hind", PartWord::back}, {"rear", PartWord::back},
    {"arriere", PartWord::back}, {"hinten", PartWord::back},
    {"beak", PartWord::ornament}, {"lip", PartWord::ornament}, {"cheek", PartWord::ornament},
});
// clang-format on

// Joints farther from the mirror plane than this stand on a side; in sizes of the body.
constexpr double offMiddle = 0.004;

// Of rows that names call left and right, in whatever pose; in lengths.
constexpr double calledAlikeError = 0.1;

// No body has more limbs, ears and teeth on a side; keeps a file that has more from costing much.
constexpr std::size_t mostOfOneSide = 64;

// FL and "f.l" are the front left leg, RF the other one, BR, HR, RR and "r.r" the hind right one.
void addRowLetters(const std::vector<NameChunk>& chunks, std::set<PartWord>& words) {
  std::string before;
  for (const NameChunk& chunk : chunks) {
    const std::string code = (chunk.whole.size() == 1 && before.size() == 1 ? before : "") + chunk.whole;
    if (const std::optional<RowLetters> letters = rowLetters(code); letters && letters->row != 'm') {
      words.insert(letters->row == 'f' ? PartWord::front : PartWord::back);
    }
    before = chunk.whole;
  }
}

class Dissection {
public:
  Dissection(const Scene& scene, const BindPose& bindPose, const BodyView& view, const MirrorPlane& plane,
             const Vec3& up)
      : scene_(scene), bindPose_(bindPose), view_(view), plane_(plane), up_(up),
        sided_(static_cast<std::size_t>(view.count()), false) {
    findSided();
  }

  Extremities run() {
    Extremities result;
    measureHeights(result);
    std::vector<Extremity> left;
    std::vector<Extremity> right;
    for (int joint = 0; joint < view_.count(); ++joint) {
      const int parent = view_.parentOf(joint);
      if (isSided(joint) && (parent < 0 || !isSided(parent))) {
        collect(joint, parent, sideSum_[index(joint)] > 0.0 ? left : right);
      }
    }
    for (std::vector<Extremity>* side : {&left, &right}) {
      std::erase_if(*side, [&](const Extremity& row) { return isWorn(row); });
    }
    dropLoneJoints(left, right);
    keepLongest(left);
    keepLongest(right);
    result.pairs = pairUp(std::move(right), std::move(left));
    result.middle = middleRows();
    return result;
  }

private:
  // Joints of a face by the hundred are no limbs.
  static void keepLongest(std::vector<Extremity>& rows) {
    if (rows.size() > mostOfOneSide) {
      std::ranges::stable_sort(rows, std::ranges::greater{}, &Extremity::length);
      rows.resize(mostOfOneSide);
    }
  }

  static std::size_t index(int candidate) { return static_cast<std::size_t>(candidate); }
  [[nodiscard]] bool isSided(int candidate) const { return sided_[index(candidate)]; }
  [[nodiscard]] double heightOf(const Vec3& point) const { return glm::dot(point, up_); }

  // A joint whose whole subtree stands on one side.
  void findSided() {
    const double tolerance = offMiddle * view_.size;
    std::vector<double> least(sided_.size());
    std::vector<double> most(sided_.size());
    sideSum_.assign(sided_.size(), 0.0);
    below_.assign(sided_.size(), 0.0);
    for (int joint = 0; joint < view_.count(); ++joint) {
      const double lateral = plane_.lateral(view_.at(joint));
      least[index(joint)] = most[index(joint)] = sideSum_[index(joint)] = lateral;
      deepestFirst_.push_back(joint);
    }
    std::ranges::stable_sort(deepestFirst_, std::ranges::greater{},
                             [&](int joint) { return view_.depth[index(joint)]; });
    for (const int joint : deepestFirst_) {
      sided_[index(joint)] = (least[index(joint)] > -tolerance && most[index(joint)] > 3.0 * tolerance) ||
                             (most[index(joint)] < tolerance && least[index(joint)] < -3.0 * tolerance);
      const int parent = view_.parentOf(joint);
      if (parent >= 0) {
        least[index(parent)] = std::min(least[index(parent)], least[index(joint)]);
        most[index(parent)] = std::max(most[index(parent)], most[index(joint)]);
        sideSum_[index(parent)] += sideSum_[index(joint)];
        below_[index(parent)] = std::max(
            below_[index(parent)], below_[index(joint)] + glm::distance(view_.at(joint), view_.at(parent)));
      }
    }
    findNamedSides();
  }

  // In the middle of an action a limb may reach across the plane: names tell its side, where they call
  // another one alike.
  void findNamedSides() {
    double leftIsPositive = 0.0;
    std::set<std::pair<std::string, Side>> called;
    std::vector<bool> hasLeft(sided_.size(), false);
    std::vector<bool> hasRight(sided_.size(), false);
    for (const int joint : deepestFirst_) {
      const Side side = view_.name(joint).side;
      called.emplace(view_.name(joint).key, side);
      hasLeft[index(joint)] = hasLeft[index(joint)] || side == Side::left;
      hasRight[index(joint)] = hasRight[index(joint)] || side == Side::right;
      const double lateral = plane_.lateral(view_.at(joint));
      leftIsPositive += side == Side::left ? lateral : side == Side::right ? -lateral : 0.0;
      if (const int parent = view_.parentOf(joint); parent >= 0) {
        hasLeft[index(parent)] = hasLeft[index(parent)] || hasLeft[index(joint)];
        hasRight[index(parent)] = hasRight[index(parent)] || hasRight[index(joint)];
      }
    }
    for (const int joint : deepestFirst_) {
      const Side side = view_.name(joint).side;
      const Side other = side == Side::left ? Side::right : Side::left;
      if (side != Side::none && !view_.name(joint).key.empty() &&
          hasLeft[index(joint)] != hasRight[index(joint)] &&
          called.contains({view_.name(joint).key, other})) {
        sided_[index(joint)] = true;
        sideSum_[index(joint)] = std::copysign(1.0, leftIsPositive) * (side == Side::left ? 1.0 : -1.0);
      }
    }
  }

  [[nodiscard]] double reachOf(int from, int child) const {
    return below_[index(child)] + glm::distance(view_.at(from), view_.at(child));
  }

  // A hem, a staff, a strand of hair: named so, and nothing else.
  [[nodiscard]] bool isWorn(const Extremity& row) const {
    const auto worn = std::ranges::count_if(row.path, [&](int joint) { return view_.name(joint).accessory; });
    return 2 * static_cast<std::size_t>(worn) > row.path.size() && !isNamedPart(row);
  }

  [[nodiscard]] static bool isNamedPart(const Extremity& row) {
    return std::ranges::any_of(std::array{PartWord::leg, PartWord::arm, PartWord::wing, PartWord::fin,
                                          PartWord::feeler, PartWord::tail, PartWord::head,
                                          PartWord::ornament},
                               [&](PartWord word) { return row.word(word) > 0.0; });
  }

  // Follows the longest way down; where several long ones start near the beginning, each is one of its own.
  void collect(int base, int attach, std::vector<Extremity>& found) {
    constexpr std::size_t most = 400;
    std::vector<int> path{base};
    double length = 0.0;
    const double whole = below_[index(base)];
    while (!view_.childrenOf(path.back()).empty()) {
      const int here = path.back();
      std::vector<int> children = view_.childrenOf(here);
      const bool goesOn = std::ranges::any_of(children, [&](int child) { return !isFeather(child); });
      if (goesOn || path.size() > 2) { // A wing ends at its tip, not at a feather that hangs from it.
        std::erase_if(children, [&](int child) { return isFeather(child) && !isFeather(here); });
      }
      if (children.empty()) {
        break;
      }
      std::ranges::stable_sort(children, std::ranges::greater{}, [&](int c) { return reachOf(here, c); });
      const double longest = reachOf(here, children.front());
      const auto isLong = [&](int child) { return reachOf(here, child) >= 0.5 * longest; };
      if (std::ranges::count_if(children, isLong) > 1 && length <= 0.2 * whole && found.size() < most) {
        for (const int child : children) {
          if (isLong(child)) {
            collect(child, attach, found);
          }
        }
        return;
      }
      length += glm::distance(view_.at(here), view_.at(children.front()));
      path.push_back(children.front());
    }
    found.push_back(withEstimatedEnd(view_, extremityOf(trimmed(std::move(path)), attach)));
  }

  [[nodiscard]] bool isFeather(int joint) const {
    const std::vector<NameChunk> chunks = nameChunks(view_.called[index(joint)]);
    return std::ranges::any_of(
        chunks, [](const NameChunk& chunk) { return chunk.whole.find("feather") != std::string::npos; });
  }

  // Anchors: joints in the middle, or with hardly a bone of their own, that no name calls a base.
  [[nodiscard]] std::vector<int> trimmed(std::vector<int> path) const {
    const double shortBone = 0.14 * below_[index(path.front())];
    const auto isAnchor = [&] {
      const bool inMiddle = std::abs(plane_.lateral(view_.at(path[0]))) <= offMiddle * view_.size;
      return !isNamedBase(path) && (inMiddle || (firstBone(path) < shortBone && !isHalved(path)));
    };
    while (path.size() > 2 && isAnchor()) {
      path.erase(path.begin());
    }
    return path;
  }

  [[nodiscard]] double firstBone(const std::vector<int>& path) const {
    return glm::distance(view_.at(path[0]), view_.at(path[1]));
  }

  // A thigh may start in the middle of the body, if what has a name below it is none.
  [[nodiscard]] bool isNamedBase(const std::vector<int>& path) const {
    return std::ranges::any_of(std::array{Role::thigh, Role::upperArm}, [&](Role role) {
      const double base = view_.name(path[0]).role(role);
      return base >= 0.8 && view_.name(path[1]).role(role) < base && !view_.called[index(path[1])].empty();
    });
  }

  // The first bone is a half of one that goes on in the same direction.
  [[nodiscard]] bool isHalved(const std::vector<int>& path) const {
    constexpr double inLine = 0.985; // cosine
    constexpr double alike = 0.6;    // of the longer one
    const Vec3 first = view_.at(path[1]) - view_.at(path[0]);
    const Vec3 next = view_.at(path[2]) - view_.at(path[1]);
    const double a = glm::length(first);
    const double b = glm::length(next);
    return glm::dot(first, next) > inLine * a * b && std::min(a, b) > alike * std::max(a, b);
  }

  [[nodiscard]] double lengthOf(const std::vector<int>& path) const {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      length += glm::distance(view_.at(path[i - 1]), view_.at(path[i]));
    }
    return length;
  }

  // The longest part of a row whose joints hang from each other in the file: some rigs hang them side by
  // side.
  [[nodiscard]] std::vector<int> inOneLine(const std::vector<int>& path) const {
    std::vector<std::vector<int>> parts{{path.front()}};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const bool isFoot = view_.isDetached[index(path[i])];
      if (!isFoot &&
          !isAncestorOrSelf(scene_, view_.nodes[index(path[i - 1])], view_.nodes[index(path[i])])) {
        parts.emplace_back();
      }
      parts.back().push_back(path[i]);
    }
    std::ranges::reverse(parts); // of equals the last one
    return *std::ranges::max_element(parts, {}, [&](const std::vector<int>& part) { return lengthOf(part); });
  }

  // The farthest node below a joint that is no candidate: a tip.
  [[nodiscard]] NodeIndex tipBelow(int last) const {
    const NodeIndex joint = view_.nodes[index(last)];
    const Vec3 from = view_.at(last);
    NodeIndex best;
    double farthest = 0.01 * view_.size;
    std::vector<NodeIndex> open = scene_.nodes[at(joint)].children;
    for (std::size_t i = 0; i < open.size() && i < 64; ++i) {
      const Node& node = scene_.nodes[at(open[i])];
      const Vec3 place = positionOf(bindPose_.worlds[at(open[i])]);
      if (node.mesh >= 0 || node.isBindLeaf || view_.candidateOfNode[at(open[i])] >= 0 || !isFinite(place)) {
        continue;
      }
      if (glm::distance(place, from) > farthest) {
        farthest = glm::distance(place, from);
        best = open[i];
      }
      open.insert(open.end(), node.children.begin(), node.children.end());
    }
    return best;
  }

  [[nodiscard]] Extremity extremityOf(const std::vector<int>& path, int attach) const {
    Extremity extremity;
    extremity.attach = attach;
    extremity.path = inOneLine(path);
    extremity.tip = tipBelow(extremity.path.back());
    extremity.lowest = std::numeric_limits<double>::max();
    extremity.highest = std::numeric_limits<double>::lowest();
    for (const int joint : extremity.path) {
      addJoint(joint, extremity);
    }
    if (extremity.tip.exists()) {
      extremity.points.push_back(positionOf(bindPose_.worlds[at(extremity.tip)]));
      extremity.lowest = std::min(extremity.lowest, heightOf(extremity.points.back()));
    }
    extremity.length = polylineLength(extremity.points);
    for (double& share : extremity.words) {
      share /= static_cast<double>(extremity.path.size());
    }
    return extremity;
  }

  void addJoint(int joint, Extremity& extremity) const {
    const Vec3& place = view_.at(joint);
    extremity.points.push_back(place);
    extremity.lateral += plane_.lateral(place) / static_cast<double>(extremity.path.size());
    extremity.lowest = std::min(extremity.lowest, heightOf(place));
    extremity.highest = std::max(extremity.highest, heightOf(place));
    for (const Vec3& point : view_.points[index(joint)]) {
      extremity.lowest = std::min(extremity.lowest, heightOf(point));
    }
    std::set<PartWord> words = partWords(view_.called[index(joint)]);
    if (std::ranges::any_of(view_.childrenOf(joint), [&](int child) { return isFeather(child); })) {
      words.insert(PartWord::wing); // whatever it is called
    }
    for (const PartWord word : words) {
      extremity.words[static_cast<std::size_t>(word)] += 1.0;
    }
  }

  void measureHeights(Extremities& result) const {
    double floor = std::numeric_limits<double>::max();
    double lowest = floor;
    double top = std::numeric_limits<double>::lowest();
    for (int joint = 0; joint < view_.count(); ++joint) {
      // A tail or a cape in the middle may hang through the ground: nothing stands on it.
      const bool mayStand = isSided(joint) || !view_.name(joint).accessory;
      const auto add = [&](const Vec3& point) {
        floor = mayStand ? std::min(floor, heightOf(point)) : floor;
        lowest = std::min(lowest, heightOf(point));
        top = std::max(top, heightOf(point));
      };
      const bool isRoot = view_.parentOf(joint) < 0 && view_.points[index(joint)].empty();
      if (view_.movesMesh(joint) && !isRoot) {
        add(view_.at(joint));
      }
      std::ranges::for_each(view_.points[index(joint)], add);
      std::ranges::for_each(view_.tips[index(joint)], add);
    }
    result.floor = floor > top ? lowest : floor;
    result.top = std::max(result.floor, top);
  }

  // A point of an extremity by its share of the length.
  [[nodiscard]] static Vec3 pointAlong(const Extremity& extremity, double share) {
    double left = share * extremity.length;
    for (std::size_t i = 1; i < extremity.points.size(); ++i) {
      const double bone = glm::distance(extremity.points[i - 1], extremity.points[i]);
      if (left <= bone && bone > 0.0) {
        return glm::mix(extremity.points[i - 1], extremity.points[i], left / bone);
      }
      left -= bone;
    }
    return extremity.points.back();
  }

  [[nodiscard]] double mirrorError(const Extremity& a, const Extremity& b) const {
    const double size = std::max(a.length, b.length);
    if (!(size > 0.0)) {
      return std::numeric_limits<double>::max();
    }
    double sum = 0.0;
    for (const double share : {0.0, 0.33, 0.67, 1.0}) {
      sum += glm::distance(plane_.mirrored(pointAlong(a, share)), pointAlong(b, share)) / 4.0;
    }
    const double apart = a.attach == b.attach ? 0.0 : 0.02;
    return sum / size + apart;
  }

  // As mirrorError, but for rows as long as each other that names call left and right.
  [[nodiscard]] double pairError(const Extremity& a, const Extremity& b) const {
    constexpr double longer = 1.3;
    const double error = mirrorError(a, b);
    const bool areAlike =
        areCalledAlike(a, b) && std::max(a.length, b.length) < longer * std::min(a.length, b.length);
    return areAlike ? std::min(error, calledAlikeError) : error;
  }

  // Whether names call the first joints of two rows left and right, and alike but for that.
  [[nodiscard]] bool areCalledAlike(const Extremity& a, const Extremity& b) const {
    const NameEvidence& one = view_.name(a.path.front());
    const NameEvidence& other = view_.name(b.path.front());
    return one.side != Side::none && other.side != Side::none && one.side != other.side && !one.key.empty() &&
           one.key == other.key;
  }

  struct Match {
    double error = 0.0;
    std::size_t negative = 0;
    std::size_t positive = 0;
  };

  // Best matches first; what is left over is no pair.
  [[nodiscard]] std::vector<ExtremityPair> pairUp(std::vector<Extremity> negative,
                                                  std::vector<Extremity> positive) {
    constexpr double mostError = 0.4;
    std::vector<Match> matches;
    for (std::size_t a = 0; a < negative.size(); ++a) {
      for (std::size_t b = 0; b < positive.size(); ++b) {
        const double error = pairError(negative[a], positive[b]);
        if (error < mostError) {
          matches.push_back({error, a, b});
        }
      }
    }
    std::ranges::stable_sort(matches, {}, &Match::error);
    std::vector<bool> negativeTaken(negative.size(), false);
    std::vector<bool> positiveTaken(positive.size(), false);
    std::vector<ExtremityPair> pairs;
    for (const Match& match : matches) {
      if (!negativeTaken[match.negative] && !positiveTaken[match.positive]) {
        negativeTaken[match.negative] = positiveTaken[match.positive] = true;
        pairs.push_back({negative[match.negative], positive[match.positive], match.error});
        evenOut(pairs.back());
      }
    }
    markPaired(pairs);
    return pairs;
  }

  // A joint that stands a little off the middle on one side and in it on the other is an anchor on both.
  void evenOut(ExtremityPair& pair) const {
    Extremity& longer = pair.negative.path.size() > pair.positive.path.size() ? pair.negative : pair.positive;
    const Extremity& other = &longer == &pair.negative ? pair.positive : pair.negative;
    double before = mirrorError(pair.negative, pair.positive);
    while (longer.path.size() > std::max<std::size_t>(other.path.size(), 2)) {
      Extremity shorter = extremityOf({longer.path.begin() + 1, longer.path.end()}, longer.attach);
      const double error = mirrorError(shorter, other);
      if (error >= before) {
        break;
      }
      longer = std::move(shorter);
      before = error;
      pair.mirrorError = std::min(pair.mirrorError, error);
    }
  }

  // The joints of the pairs, and what hangs above and below them.
  void markPaired(const std::vector<ExtremityPair>& pairs) {
    std::vector<bool> paired(sided_.size(), false);
    for (const ExtremityPair& pair : pairs) {
      for (const Extremity* one : {&pair.negative, &pair.positive}) {
        for (const int joint : one->path) {
          paired[index(joint)] = true;
        }
      }
    }
    std::vector<bool> below = paired;
    std::vector<bool> above = paired;
    for (auto joint = deepestFirst_.rbegin(); joint != deepestFirst_.rend(); ++joint) {
      const int parent = view_.parentOf(*joint);
      below[index(*joint)] = below[index(*joint)] || (parent >= 0 && below[index(parent)]);
    }
    for (const int joint : deepestFirst_) {
      const int parent = view_.parentOf(joint);
      if (parent >= 0 && above[index(joint)]) {
        above[index(parent)] = true;
      }
    }
    carriesPaired_.resize(paired.size());
    for (std::size_t joint = 0; joint < paired.size(); ++joint) {
      carriesPaired_[joint] = below[joint] || above[joint];
    }
  }

  // Of the joints on no side, and of the rows without a counterpart.
  [[nodiscard]] std::vector<Extremity> middleRows() const {
    const auto isMiddle = [&](int joint) {
      return !isSided(joint) || (!carriesPaired(joint) && !hasCounterpart(joint));
    };
    std::vector<Extremity> rows;
    for (int joint = 0; joint < view_.count() && rows.size() < 200; ++joint) {
      const auto& children = view_.childrenOf(joint);
      if (!isMiddle(joint) || std::ranges::any_of(children, isMiddle)) {
        continue;
      }
      int top = joint;
      while (view_.parentOf(top) >= 0) {
        top = view_.parentOf(top);
      }
      Extremity row = extremityOf(view_.path(top, joint), -1);
      if (view_.name(joint).accessory && !isNamedPart(row)) {
        continue;
      }
      rows.push_back(std::move(row));
    }
    return rows;
  }

  // Whether the joint is called as one that stands at its image on the other side is, as an eye without
  // length.
  [[nodiscard]] bool hasCounterpart(int joint) const {
    constexpr double near = 0.05; // of the body
    const NameEvidence& name = view_.name(joint);
    const Vec3 image = plane_.mirrored(view_.at(joint));
    for (int other = 0; other < view_.count() && name.side != Side::none; ++other) {
      const NameEvidence& ofOther = view_.name(other);
      if (ofOther.side != Side::none && ofOther.side != name.side && ofOther.key == name.key &&
          glm::distance(view_.at(other), image) < near * view_.size) {
        return true;
      }
    }
    return false;
  }

  // Whether the joint belongs to a row with a counterpart, or hangs above or below it on its side.
  [[nodiscard]] bool carriesPaired(int joint) const { return carriesPaired_[index(joint)]; }

  const Scene& scene_;
  const BindPose& bindPose_;
  const BodyView& view_;
  const MirrorPlane& plane_;
  Vec3 up_;
  std::vector<bool> sided_;
  std::vector<double> sideSum_; // of signed distances, of the joint and all below it
  std::vector<double> below_;   // length of the longest row below
  std::vector<int> deepestFirst_;
  std::vector<bool> carriesPaired_;
};

} // namespace

Extremities takeApart(const Scene& scene, const BindPose& bindPose, const BodyView& view,
                      const MirrorPlane& plane, const Vec3& up) {
  return Dissection(scene, bindPose, view, plane, up).run();
}

std::set<PartWord> partWords(std::string_view name) {
  std::set<PartWord> words;
  const auto add = [&](std::string_view text) {
    const auto* const found = std::ranges::find(partEntries, text, &PartEntry::text);
    if (found != partEntries.end()) {
      words.insert(found->word);
    }
    return found != partEntries.end();
  };
  const auto knows = [](std::string_view text) {
    return lookUpWord(text) || std::ranges::find(partEntries, text, &PartEntry::text) != partEntries.end();
  };
  const std::vector<NameChunk> chunks = nameChunks(name);
  for (const NameChunk& chunk : chunks) {
    add(chunk.whole);
    for (const std::string& part : chunk.parts) {
      if (!add(part)) {
        std::ranges::for_each(cutIntoWords(part, knows), add);
      }
    }
  }
  if (words.contains(PartWord::leg)) {
    addRowLetters(chunks, words);
  }
  return words;
}

} // namespace stretch::rig::body
