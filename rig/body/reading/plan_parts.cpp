#include "rig/body/reading/plan_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "rig/body/reading/middle_parts.h"
#include "rig/body/reading/stance.h"

namespace stretch::rig::body {

namespace {

class PartFinder {
public:
  PartFinder(const BodyView& view, const MirrorPlane& plane, const Vec3& up, std::optional<int> legPairs)
      : view_(view), plane_(plane), up_(up), legPairs_(legPairs) {}

  PlanParts run(Extremities extremities) {
    parts_.extremities = std::move(extremities);
    sortPairs();
    findHeadRow();
    dropAntlers();
    nameChains();
    findForward();
    orderPairs();
    findTrunk();
    parts_.axis.tail = tailOf(view_, parts_);
    return std::move(parts_);
  }

private:
  static std::size_t index(int candidate) { return static_cast<std::size_t>(candidate); }
  [[nodiscard]] double height() const {
    return std::max(parts_.extremities.top - parts_.extremities.floor, 1e-9 * view_.size);
  }

  // Reaches the ground from well above it.
  [[nodiscard]] bool stands(const ExtremityPair& pair) const {
    const auto one = [&](const Extremity& limb) {
      return limb.lowest < parts_.extremities.floor + 0.12 * height() &&
             limb.highest - limb.lowest > std::max(0.2 * height(), 0.06 * view_.size) &&
             limb.length > 0.08 * view_.size;
    };
    return one(pair.negative) && one(pair.positive);
  }

  // By name, else by what it does; nothing for ears, teeth and what is too small to be a limb.
  [[nodiscard]] std::optional<LimbKind> kindOf(const ExtremityPair& pair) const {
    const bool large = pair.length() > 0.08 * view_.size;
    const bool isStanding = stands(pair);
    if (pair.length() > 0.03 * view_.size) {
      for (const auto& [word, kind] :
           {std::pair(PartWord::wing, LimbKind::wing), std::pair(PartWord::fin, LimbKind::fin),
            std::pair(PartWord::feeler, LimbKind::feeler)}) {
        if (isNamed(pair, word)) {
          return kind;
        }
      }
    }
    if (!large || isNamed(pair, PartWord::ornament) || isNamed(pair, PartWord::head)) {
      return std::nullopt;
    }
    if (isStanding || isNamed(pair, PartWord::leg)) {
      return LimbKind::leg;
    }
    return isNamed(pair, PartWord::arm) ? LimbKind::arm : LimbKind::chain; // to be told by the others
  }

  void sortPairs() {
    for (const ExtremityPair& pair : parts_.extremities.pairs) {
      if (const std::optional<LimbKind> kind = kindOf(pair)) {
        parts_.pairs.push_back({*kind, pair, stands(pair)});
      } else {
        ornaments_.push_back(&pair);
      }
    }
    dropStrayLegs(parts_.pairs);
    dropFlatLegs();
    dropShortLegs();
    dropTrunkPieces();
    if (legPairs_) {
      chooseLegs(static_cast<std::size_t>(*legPairs_));
    }
  }

  // What stands out of the head of a body with four legs or two, and is called no limb, is none: antlers,
  // ears, whiskers.
  void dropAntlers() {
    const int head = parts_.axis.head;
    const auto legCount = legs().size();
    if (head < 0 || legCount == 0 || legCount > 2) {
      return;
    }
    std::erase_if(parts_.pairs, [&](const KindredPair& one) {
      return one.kind == LimbKind::chain && view_.isAboveOrSelf(head, carrierOf(view_, one.pair));
    });
  }

  // What no name tells is told by the number of legs.
  void nameChains() {
    const auto legCount = legs().size();
    for (KindredPair& one : parts_.pairs) {
      const bool isPincer = one.kind == LimbKind::arm || isClaw(one);
      if (isPincer && legCount - (one.kind == LimbKind::leg ? 1 : 0) >= 3) {
        one.kind = LimbKind::feeler;
      } else if (one.kind == LimbKind::chain) {
        one.kind = legCount == 0   ? LimbKind::fin
                   : legCount >= 3 ? feelerOrWing(one.pair)
                                   : armOrWing(one.pair);
        one.isGuessed = legCount == 1 || one.kind == LimbKind::wing;
      }
    }
  }

  // Beside the legs of a crab, and not at the end of one.
  [[nodiscard]] static bool isClaw(const KindredPair& one) {
    const bool mayBe = one.kind == LimbKind::chain || one.kind == LimbKind::leg;
    return mayBe && isNamed(one.pair, PartWord::claw) && one.pair.word(PartWord::leg) == 0.0;
  }

  // One pair alone carries the body only where it goes down: the fins of a fish that lies reach its lowest
  // point as well.
  void dropFlatLegs() {
    constexpr double leastSteepness = 0.5; // sine
    if (std::ranges::count(parts_.pairs, true, &KindredPair::stands) != 1) {
      return;
    }
    KindredPair& only = *std::ranges::find(parts_.pairs, true, &KindredPair::stands);
    const std::vector<Vec3>& points = only.pair.positive.points;
    const Vec3 reach = points.back() - points.front();
    if (-glm::dot(reach, up_) < leastSteepness * glm::length(reach)) {
      only.stands = false;
      only.kind = isNamed(only.pair, PartWord::leg) ? LimbKind::leg : LimbKind::chain;
    }
  }

  // Joints that move the flanks of a body on four legs: short, or along it.
  void dropTrunkPieces() {
    constexpr double shorter = 0.5; // than the shortest leg
    constexpr double along = 0.9;   // cosine
    if (std::ranges::count(parts_.pairs, true, &KindredPair::stands) != 2) {
      return;
    }
    double leg = std::numeric_limits<double>::max();
    for (const KindredPair& one : parts_.pairs) {
      leg = one.stands ? std::min(leg, one.pair.length()) : leg;
    }
    const Vec3 ahead = glm::cross(plane_.normal, up_);
    const auto liesAlong = [&](const Extremity& row) {
      const Vec3 reach = row.points.back() - row.points.front();
      return std::abs(glm::dot(reach, ahead)) > along * glm::length(reach);
    };
    std::erase_if(parts_.pairs, [&](const KindredPair& one) {
      return one.kind == LimbKind::chain &&
             one.pair.length() < (liesAlong(one.pair.positive) ? leg : shorter * leg);
    });
  }

  // "Front legs" that are far shorter than those that carry the body, and end well above the ground, are
  // arms.
  void dropShortLegs() {
    constexpr double shorter = 0.7;
    constexpr double above = 0.25; // of the body's height
    double longest = 0.0;
    for (const KindredPair& one : parts_.pairs) {
      longest = std::max(longest, one.kind == LimbKind::leg && one.stands ? one.pair.length() : 0.0);
    }
    for (KindredPair& one : parts_.pairs) {
      const double lowest = std::min(one.pair.negative.lowest, one.pair.positive.lowest);
      if (one.kind == LimbKind::leg && !one.stands && one.pair.length() < shorter * longest &&
          lowest > parts_.extremities.floor + above * height()) {
        one.kind = LimbKind::arm;
      }
    }
  }

  // Of a body on six or eight legs: what spreads beside them are wings, what the head carries none.
  [[nodiscard]] LimbKind feelerOrWing(const ExtremityPair& pair) const {
    const Vec3 along = pair.positive.points.back() - pair.positive.points.front();
    const bool isAtHead =
        parts_.axis.head >= 0 && view_.isAboveOrSelf(parts_.axis.head, carrierOf(view_, pair));
    const bool spreads = std::abs(glm::dot(along, plane_.normal)) > 0.7 * glm::length(along);
    return spreads && !isAtHead && pair.length() > 0.25 * view_.size ? LimbKind::wing : LimbKind::feeler;
  }

  [[nodiscard]] LimbKind armOrWing(const ExtremityPair& pair) const {
    const Vec3 along = pair.positive.points.back() - pair.positive.points.front();
    constexpr double onUprightTrunk = 0.25; // of the body, above the legs
    double legHeight = 0.0;
    for (const KindredPair* leg : legs()) {
      legHeight += glm::dot(baseOf(leg->pair), up_) / static_cast<double>(legs().size());
    }
    const bool isHigh = glm::dot(baseOf(pair), up_) - legHeight > onUprightTrunk * view_.size;
    const bool spreads = !isHigh && std::abs(glm::dot(along, plane_.normal)) > 0.7 * glm::length(along);
    return spreads && pair.length() > 0.25 * view_.size ? LimbKind::wing : LimbKind::arm;
  }

  // The pairs that are likeliest legs become them, the others none.
  void chooseLegs(std::size_t count) {
    std::ranges::stable_sort(parts_.pairs, std::ranges::greater{}, [](const KindredPair& one) {
      return std::tuple(one.kind == LimbKind::leg && one.stands, one.kind == LimbKind::leg,
                        one.kind == LimbKind::chain || one.kind == LimbKind::arm, one.pair.length());
    });
    for (std::size_t i = 0; i < parts_.pairs.size(); ++i) {
      LimbKind& kind = parts_.pairs[i].kind;
      kind = i < count ? LimbKind::leg : kind == LimbKind::leg ? LimbKind::chain : kind;
    }
  }

  [[nodiscard]] bool isOn(const std::vector<int>& row, int joint) const {
    return std::ranges::find(row, joint) != row.end();
  }

  // The joint of the row after which legs stand that hang from nothing.
  [[nodiscard]] int lastBefore(const std::vector<int>& row, const Vec3& place) const {
    const Vec3 along = view_.at(row.back()) - view_.at(row.front());
    const auto next =
        std::ranges::find_if(row, [&](int joint) { return glm::dot(view_.at(joint) - place, along) > 0.0; });
    return std::max(0, static_cast<int>(next - row.begin()) - 1);
  }

  // Where a pair hangs on the row: its carrier or the nearest joint above that is of the row; -1: nowhere.
  [[nodiscard]] int placeOn(const std::vector<int>& row, int joint) const {
    while (joint >= 0 && !isOn(row, joint)) {
      joint = view_.parentOf(joint);
    }
    return joint < 0 ? -1 : static_cast<int>(std::ranges::find(row, joint) - row.begin());
  }

  [[nodiscard]] double headness(const Extremity& row) const {
    const double says = isPieceOfFace(row) ? -1.0 : row.word(PartWord::head) > 0.0 ? 1.0 : 0.0;
    double score =
        2.0 * says - 2.0 * (row.word(PartWord::tail) > 0.0 ? 1.0 : 0.0) + 0.1 * row.length / view_.size;
    for (const KindredPair& one : parts_.pairs) {
      score += isOn(row.path, carrierOf(view_, one.pair)) ? 0.5 : 0.0;
    }
    for (const ExtremityPair* ornament : ornaments_) {
      score += isOn(row.path, carrierOf(view_, *ornament)) ? 0.5 : 0.0;
    }
    return score - (row.word(PartWord::ornament) > 0.0 ? 0.5 : 0.0);
  }

  // Where joints hang side by side a tongue or a jaw is a row of its own, and short beside the trunk.
  [[nodiscard]] bool isPieceOfFace(const Extremity& row) const {
    constexpr double isShort = 0.25;
    return std::ranges::any_of(parts_.extremities.middle, [&](const Extremity& other) {
      return row.length < isShort * other.length && other.path.front() != row.path.front();
    });
  }

  // On four legs a neck and a tail look much alike; an insect's feelers tell which end its head is.
  [[nodiscard]] bool isUntold(bool headIsNamed) const {
    return !headIsNamed && legs().size() == 2 && up_.y > 0.5;
  }

  [[nodiscard]] Vec3 middleOfLegs() const {
    Vec3 middle(0.0);
    const std::vector<const KindredPair*> all = legs();
    for (const KindredPair* leg : all) {
      middle += baseOf(leg->pair) / static_cast<double>(all.size());
    }
    return middle;
  }

  // Where joints are named left and right: 1 along a direction that leaves the left on its left, -1 against
  // it.
  [[nodiscard]] double sidesAhead(const Vec3& forward) const {
    double votes = 0.0;
    double named = 0.0;
    const auto add = [&](const Extremity& limb, double sign) {
      for (const int joint : limb.path) {
        const Side side = view_.name(joint).side;
        votes += side == Side::none ? 0.0 : side == Side::left ? sign : -sign;
        named += side == Side::none ? 0.0 : 1.0;
      }
    };
    const double left = glm::dot(glm::cross(up_, forward), plane_.normal) > 0.0 ? 1.0 : -1.0;
    for (const KindredPair& one : parts_.pairs) {
      add(one.pair.positive, left);
      add(one.pair.negative, -left);
    }
    return named < 2.0 || std::abs(votes) < 0.5 * named ? 0.0 : std::copysign(1.0, votes);
  }

  // Feet point ahead of their joints, and a head has more to it than the end of a tail: in -1..1 each.
  [[nodiscard]] double shapeAhead(const Vec3& forward) const {
    double feet = 0.0;
    for (const KindredPair* leg : legs()) {
      for (const Extremity* one : {&leg->pair.positive, &leg->pair.negative}) {
        Vec3 toes(0.0);
        for (const Vec3& point : view_.points[index(one->path.back())]) {
          toes += point - view_.at(one->path.back());
        }
        const Vec3 on = one->points.back() - one->points[std::max<std::size_t>(one->points.size(), 2) - 2];
        const double reach = std::max(glm::length(toes), 1e-3 * view_.size);
        feet += glm::dot(toes, forward) / reach +
                glm::dot(on, forward) / std::max(glm::length(on), 1e-9 * view_.size);
      }
    }
    double bulks = 0.0;
    double all = 0.0;
    for (const Extremity& row : parts_.extremities.middle) {
      const double ahead = glm::dot(row.points.back() - middleOfLegs(), forward);
      const double size = bulk(view_, row.path.back()) +
                          (row.path.size() > 1 ? bulk(view_, row.path[row.path.size() - 2]) : 0.0);
      bulks += size * std::clamp(ahead / (0.05 * view_.size), -1.0, 1.0);
      all += size;
    }
    return std::clamp(feet / static_cast<double>(2 * legs().size()), -1.0, 1.0) +
           (all > 0.0 ? bulks / all : 0.0);
  }

  // The way a body on four legs faces, none of whose joints is called head: as legs are called front and hind
  // ones and joints left and right, else by its shape, or as glTF has it.
  [[nodiscard]] Vec3 unnamedForward() const {
    constexpr double convention = 0.3;
    const Vec3 forward = levelInPlane();
    for (const double told : {namedAhead(forward).value_or(0.0), sidesAhead(forward)}) {
      if (told != 0.0) {
        return told * forward;
      }
    }
    return shapeAhead(forward) + convention * forward.z < 0.0 ? -forward : forward;
  }

  void findHeadRow() {
    const std::vector<Extremity>& rows = parts_.extremities.middle;
    auto head = std::ranges::max_element(rows, {}, [&](const Extremity& row) { return headness(row); });
    if (head != rows.end() && isUntold(head->word(PartWord::head) > 0.0)) {
      const Vec3 forward = unnamedForward();
      head = std::ranges::max_element(rows, {}, [&](const Extremity& row) {
        return headness(row) +
               2.0 * std::clamp(glm::dot(row.points.back() - middleOfLegs(), forward), -1.0, 1.0);
      });
      parts_.axis.forward = forward;
    }
    if (head != rows.end() && legs().size() > 2 && head->word(PartWord::tail) > 0.0 &&
        head->word(PartWord::head) <= 0.0) {
      takeAwayFromTail(*head);
    } else if (head != rows.end()) {
      parts_.axis.row = head->path;
      parts_.axis.headIsNamed = head->word(PartWord::head) > 0.0;
      parts_.axis.head = headOf(*head);
      endAtHeadBeside(view_, parts_);
      parts_.axis.frontIsTold = isHeadAside(view_, parts_.axis, middleOfLegs(), up_) || isFrontTold(*head);
    }
  }

  // Of a body on many legs whose only row in the middle is its abdomen: the head is what carries that.
  void takeAwayFromTail(const Extremity& row) {
    Axis& axis = parts_.axis;
    const auto isOfTail = [&](int joint) { return isCalledTail(view_, joint); };
    axis.row.assign(row.path.begin(), std::ranges::find_if(row.path, isOfTail));
    if (axis.row.empty()) {
      axis.row = {row.path.front()};
    }
    axis.head = axis.row.back();
    const Vec3 ahead = levelInPlane();
    axis.forward = glm::dot(row.points.back() - middleOfLegs(), ahead) > 0.0 ? -ahead : ahead;
    isTurnedFromTail_ = true;
  }

  // Whether the joints ahead, left and right by their names or the shape tell which end of a body on legs is
  // the head. Of one that does not stand on them it is doubted anyway.
  [[nodiscard]] bool isFrontTold(const Extremity& head) const {
    constexpr double clearShape = 0.4;
    constexpr double clearRow = 0.4; // less than one limb or ear that hangs on the row
    const Vec3 ahead = levelInPlane();
    const bool isDoubtedAnyway = up_.y <= 0.5; // it lies or stands upside down
    if (legs().empty() || isDoubtedAnyway || namedAhead(ahead).value_or(0.0) != 0.0 ||
        sidesAhead(ahead) != 0.0) {
      return true;
    }
    if (isUntold(false) || parts_.axis.headIsNamed) { // in the middle
      return std::abs(shapeAhead(ahead)) >= clearShape;
    }
    return std::ranges::none_of(parts_.extremities.middle, [&](const Extremity& row) {
      return &row != &head && headness(row) > headness(head) - clearRow;
    });
  }

  // Unit, level, in the mirror plane.
  [[nodiscard]] Vec3 levelInPlane() const {
    const Vec3 across = glm::cross(plane_.normal, up_);
    return glm::length(across) > 1e-6 ? glm::normalize(across) : Vec3(0.0, 0.0, 1.0);
  }

  // The last joint of a row, or the one before where the last one carries little: a jaw, a tip.
  [[nodiscard]] int lastOf(const std::vector<int>& row) const {
    constexpr double little = 0.4;
    const int before = row.size() > 1 ? row[row.size() - 2] : row.back();
    const bool isTip =
        !carriesLimb(view_, parts_, before, false) && bulk(view_, row.back()) < little * bulk(view_, before);
    return isTip ? before : row.back();
  }

  // The last joint that is named head, else the one behind the neck at which ears and jaws branch off, else
  // the last one.
  [[nodiscard]] int headOf(const Extremity& row) const {
    int named = -1;
    int branching = -1;
    for (const int joint : row.path) {
      const NameEvidence& name = view_.name(joint);
      named = name.role(Role::head) >= clearRole ? joint : named;
      branching = name.role(Role::neck) >= clearRole ? -1 : branching;
      if (branching < 0 && !carriesLimb(view_, parts_, joint) && view_.childrenOf(joint).size() > 1) {
        branching = joint;
      }
    }
    return named >= 0 ? named : branching >= 0 ? branching : lastOf(row.path);
  }

  [[nodiscard]] std::vector<const KindredPair*> legs() const {
    std::vector<const KindredPair*> found;
    for (const KindredPair& one : parts_.pairs) {
      if (one.kind == LimbKind::leg) {
        found.push_back(&one);
      }
    }
    return found;
  }

  [[nodiscard]] static Vec3 baseOf(const ExtremityPair& pair) {
    return (pair.negative.points.front() + pair.positive.points.front()) / 2.0;
  }

  // 1 for what is called a front one, -1 for a hind one.
  [[nodiscard]] static int namedRow(const ExtremityPair& pair) {
    return (isNamed(pair, PartWord::front) ? 1 : 0) - (isNamed(pair, PartWord::back) ? 1 : 0);
  }

  // Legs that are called front and hind ones tell: 1 along a direction, -1 against it, 0 in one place.
  [[nodiscard]] std::optional<double> namedAhead(const Vec3& forward) const {
    std::array<double, 2> places{}; // of front and hind ones
    std::array<int, 2> counts{};
    for (const KindredPair* leg : legs()) {
      if (const int row = namedRow(leg->pair); row != 0) {
        places[row > 0 ? 0 : 1] += glm::dot(baseOf(leg->pair), forward);
        ++counts[row > 0 ? 0 : 1];
      }
    }
    if (counts[0] == 0 || counts[1] == 0) {
      return std::nullopt;
    }
    const double apart = places[0] / counts[0] - places[1] / counts[1];
    return std::abs(apart) < 0.05 * view_.size ? 0.0 : std::copysign(1.0, apart);
  }

  void findForward() {
    const Vec3 forward = levelInPlane();
    Vec3 middle(0.0);
    double count = 0.0;
    for (const Extremity& row : parts_.extremities.middle) {
      if (legs().empty() || !isOn(row.path, parts_.axis.head)) { // what a face has lies about the head
        middle += row.points.back();
        count += 1.0;
      }
    }
    for (const KindredPair* leg : legs()) {
      middle += baseOf(leg->pair);
      count += 1.0;
    }
    if (const double named = namedAhead(forward).value_or(0.0); named != 0.0) {
      parts_.axis.forward = named < 0.0 ? -forward : forward;
      return;
    }
    if (isTurnedFromTail_ || isUntold(parts_.axis.headIsNamed)) {
      return; // found with the head
    }
    const int head = parts_.axis.head;
    const double ahead = head >= 0 && count > 0.0 ? glm::dot(view_.at(head) - middle / count, forward) : 0.0;
    const bool backwards = std::abs(ahead) > 0.02 * view_.size ? ahead < 0.0 : forward.z < 0.0;
    parts_.axis.forward = backwards ? -forward : forward;
  }

  void orderPairs() {
    const bool hasFrontLegs = legs().size() > 2;
    const bool isFlat = namedAhead(parts_.axis.forward) == 0.0; // then names tell the rows
    const auto ahead = [&](const KindredPair& one) {
      const Vec3 ends = one.pair.negative.points.back() + one.pair.positive.points.back();
      const bool isLeg = one.kind == LimbKind::leg && hasFrontLegs;
      const Vec3 middle = isLeg ? (baseOf(one.pair) + ends / 2.0) / 2.0 : baseOf(one.pair);
      const double named = isFlat && one.kind == LimbKind::leg ? namedRow(one.pair) * view_.size : 0.0;
      return std::pair(one.kind, -glm::dot(middle, parts_.axis.forward) - named);
    };
    std::ranges::stable_sort(parts_.pairs, {}, ahead);
  }

  // Places on the row where the legs hang, and what else carries limbs before the head.
  struct Hangs {
    int first = -1;
    int last = -1;
  };
  [[nodiscard]] Hangs hangs() const {
    Hangs hangs;
    const auto legCount = legs().size();
    const bool hasNeck =
        std::ranges::any_of(parts_.axis.row, [&](int joint) { return isNeck(view_, joint); });
    for (const KindredPair& one : parts_.pairs) {
      const bool counts = one.kind == LimbKind::leg || (legCount < 2 && one.kind != LimbKind::feeler);
      const int carrier = carrierOf(view_, one.pair);
      const int place = !counts                   ? -1
                        : carrier < 0 && !hasNeck ? lastBefore(parts_.axis.row, baseOf(one.pair))
                                                  : placeOn(parts_.axis.row, carrier);
      if (place < 0) {
        continue;
      }
      if (one.kind == LimbKind::leg || legCount == 0) {
        hangs.first = hangs.first < 0 ? place : std::min(hangs.first, place);
      }
      hangs.last = std::max(hangs.last, place);
    }
    return hangs;
  }

  void findTrunk() {
    Axis& axis = parts_.axis;
    if (axis.row.empty()) {
      return;
    }
    const int head = placeOn(axis.row, axis.head);
    Hangs joints = hangs();
    const int first = std::clamp(joints.first, 0, std::max(head, 0));
    int chest = std::clamp(joints.last, first, std::max(head, first));
    axis.hips = axis.row[index(first)];
    const auto row = [&](int from, int to) {
      return from > to ? std::vector<int>{}
                       : std::vector<int>(axis.row.begin() + from, axis.row.begin() + to + 1);
    };
    if (legs().empty() || legs().size() > 2) {
      axis.spine = row(first + 1, head - 1);
      axis.spineEnd = axis.head;
      if (axis.spine.empty() && first < head) {
        axis.spine = {axis.hips};
      }
      return;
    }
    if (joints.first < 0 && head > 0 && legs().size() == 2 && isNeck(view_, axis.row.front())) {
      takeNeckAlone(view_, parts_);
      return;
    }
    const std::vector<int> hindTrunk =
        chest == first && legs().size() == 2 ? trunkBehind(view_, parts_) : std::vector<int>{};
    if (chest == first) {
      chest = neckStart(first, head) - 1;
    }
    axis.neck = row(chest + 1, head - 1);
    axis.spine = row(first + 1, chest - 1);
    axis.spineEnd = chest > first ? axis.row[index(chest)] : -1;
    if (axis.spine.empty() && chest > first) { // one joint above the hips
      axis.spine = {axis.row[index(chest)]};
      axis.spineEnd = chest < head ? axis.row[index(chest + 1)] : -1;
    }
    if (axis.spineEnd < 0 && first < head) {
      axis.spine = {axis.hips};
      axis.spineEnd = axis.row[index(first + 1)];
    }
    if (!hindTrunk.empty()) { // the body is rooted where its front legs hang
      axis.spineEnd = hindTrunk.back();
      axis.spine.assign(hindTrunk.begin(), hindTrunk.end() - 1);
    }
  }

  // Of the first joint that is named so; without names the upper half of what lies before the head.
  [[nodiscard]] int neckStart(int first, int head) const {
    for (int place = first + 1; place < head; ++place) {
      if (isNeck(view_, parts_.axis.row[index(place)])) {
        return place;
      }
    }
    return std::max(first + 1, (first + head + 1) / 2);
  }

  const BodyView& view_;
  const MirrorPlane& plane_;
  Vec3 up_;
  std::optional<int> legPairs_;
  PlanParts parts_;
  std::vector<const ExtremityPair*> ornaments_;
  bool isTurnedFromTail_ = false;
};

} // namespace

int PlanParts::standingLegs() const {
  return 2 * static_cast<int>(std::ranges::count_if(
                 pairs, [](const KindredPair& one) { return one.kind == LimbKind::leg && one.stands; }));
}

PlanParts partsOfBody(const Scene& scene, const BindPose& bindPose, const BodyView& view,
                      const MirrorPlane& plane, const Vec3& up, std::optional<int> legPairs) {
  return PartFinder(view, plane, up, legPairs).run(takeApart(scene, bindPose, view, plane, up));
}

} // namespace stretch::rig::body
