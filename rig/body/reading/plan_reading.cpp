#include "rig/body/reading/plan_reading.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "rig/body/reading/detection.h"
#include "rig/body/reading/doubts.h"
#include "rig/body/reading/limb_assembly.h"
#include "rig/body/reading/limb_end.h"
#include "rig/body/reading/long_row.h"
#include "rig/body/reading/middle_parts.h"
#include "rig/body/reading/plan_parts.h"
#include "rig/body/reading/stance.h"

namespace stretch::rig::body {

namespace {

// A longer row of joints is no limb, and would cost much at each frame.
constexpr std::size_t mostJoints = 300;

const char* rowWord(int row, int rows) {
  return rows < 2 ? "" : row == 1 ? ", in front" : row == rows ? ", behind" : ", between the others";
}

constexpr const char* sidesFromNames = "sides: from the joint names";

// Which side of the mirror plane is left, and what speaks against it.
struct PlanSides {
  bool leftIsPositive = true;
  std::string reason;
  std::vector<std::string> warnings;
};

class PlanReader {
public:
  PlanReader(const Scene& scene, const BindPose& bindPose, const BodyView& view, const MirrorPlane& plane,
             const Vec3& up, PlanParts parts)
      : scene_(scene), bindPose_(bindPose), view_(view), plane_(plane), up_(up), parts_(std::move(parts)) {
    sides_ = findSides();
  }

  /// Nothing where the plan has no place for what stands out of the body, or lacks what it cannot be without.
  [[nodiscard]] std::optional<PlanReading> fit(const BodyPlan& plan) const {
    const bool hasLegs = plan.legs == parts_.standingLegs() &&
                         std::ranges::count(parts_.pairs, LimbKind::leg, &KindredPair::kind) * 2 == plan.legs;
    if (!hasLegs || !isItsTrunk(plan)) {
      return std::nullopt;
    }
    bool hasOthers = false;
    for (const Placed& placed : places(plan)) {
      if (plannedLimb(plan, placed.place) == nullptr) {
        if (!isBesideNamedLegs(view_, parts_, *placed.pair)) {
          return std::nullopt;
        }
        hasOthers = true;
      }
    }
    PlanReading reading = as(plan);
    if (hasOthers) {
      reading.warnings.emplace_back(
          "a pair of rows of joints is none of its limbs by name: choose a chain of "
          "joints if it is one");
    }
    // What stands on many legs that are called so may be one joint with all of them around it.
    const bool hasTrunk =
        std::ranges::any_of(reading.limbs, isTrunk) || (plan.legs > 4 && areLegsNamed(parts_.pairs));
    return hasTrunk ? std::optional(std::move(reading)) : std::nullopt;
  }

  /// A body whose names call a pair wings, and whose legs have no joints.
  [[nodiscard]] std::optional<PlanReading> fitWinged(const BodyPlan& plan) const {
    const bool hasOthers = std::ranges::any_of(parts_.pairs, [](const KindredPair& one) {
      return one.kind != LimbKind::wing && one.kind != LimbKind::feeler;
    });
    if (parts_.pairs.empty() || hasOthers ||
        std::ranges::count(parts_.pairs, LimbKind::wing, &KindredPair::kind) == 0) {
      return std::nullopt;
    }
    PlanReading reading = as(plan);
    constexpr double guessed = 0.6;
    reading.confidence = std::min(reading.confidence, guessed);
    if (!hasNamedTail()) {
      std::erase_if(reading.limbs, [](const Limb& limb) { return limb.kind == LimbKind::tail; });
    }
    constexpr double doubted = 0.45; // feelers may pass for its trunk
    for (Limb& limb : reading.limbs) {
      limb.confidence = isTrunk(limb) ? std::min(limb.confidence, doubted) : limb.confidence;
    }
    const std::size_t untold = sides_.reason == sidesFromNames ? 0 : 1; // no legs tell which way it faces
    reading.warnings.assign(untold, "no name tells left from right: are the sides right?");
    reading.warnings.emplace_back("no legs found: the joints move none, or choose chains of joints for them");
    return reading;
  }

  [[nodiscard]] bool hasNamedTail() const {
    return parts_.axis.tail && parts_.axis.tail->word(PartWord::tail) > 0.0;
  }

  [[nodiscard]] PlanReading as(const BodyPlan& plan) const {
    PlanReading reading;
    reading.plan = &plan;
    for (const Placed& placed : places(plan)) {
      const PlannedLimb* const planned = plannedLimb(plan, placed.place);
      if (planned != nullptr) {
        addLimb(*planned, placed, reading.limbs);
      }
    }
    addTrunk(plan, reading.limbs);
    std::ranges::stable_sort(reading.limbs, std::less<>());
    reading.hips = nodeOf(parts_.axis.hips);
    reading.head = nodeOf(parts_.axis.head);
    reading.confidence = confidence();
    reading.reasons = reasons(plan);
    reading.warnings = sides_.warnings;
    if (std::ranges::any_of(parts_.pairs, &KindredPair::isGuessed)) {
      reading.warnings.emplace_back(plan.legs < 4 ? "no name tells whether its front limbs are arms or wings"
                                    : plan.legs < 6
                                        ? "no name tells whether a pair of its limbs are arms or wings"
                                        : "no name tells whether a pair of its limbs are wings or feelers");
    }
    return reading;
  }

private:
  struct Placed {
    LimbPlace place;
    const Extremity* limb = nullptr;
    const KindredPair* pair = nullptr;
    int rows = 1;
  };

  [[nodiscard]] NodeIndex nodeOf(int candidate) const {
    return candidate < 0 ? NodeIndex::none : view_.nodes[static_cast<std::size_t>(candidate)];
  }

  // Every limb but those of the trunk; of wings, arms and feelers the longest pair.
  [[nodiscard]] std::vector<Placed> places(const BodyPlan& plan) const {
    std::vector<Placed> placed;
    for (const LimbKind kind :
         {LimbKind::arm, LimbKind::leg, LimbKind::wing, LimbKind::fin, LimbKind::feeler}) {
      std::vector<const KindredPair*> pairs;
      for (const KindredPair& one : parts_.pairs) {
        if (one.kind == kind) {
          pairs.push_back(&one);
        }
      }
      const bool inRows = kind == LimbKind::leg || kind == LimbKind::fin;
      if (!inRows && pairs.size() > 1) {
        pairs = {
            *std::ranges::max_element(pairs, {}, [](const KindredPair* one) { return one->pair.length(); })};
      }
      const int rows = static_cast<int>(pairs.size());
      for (int row = 1; row <= rows; ++row) {
        const bool isInRow = rows > 1 || plannedLimb(plan, {kind, LimbSide::left, 0}) == nullptr;
        const bool isFirstFin = kind == LimbKind::fin && row == 1;
        addPlaced(*pairs[static_cast<std::size_t>(row - 1)],
                  {kind, LimbSide::left, isInRow && !isFirstFin ? row : 0}, rows, placed);
      }
    }
    return placed;
  }

  void addPlaced(const KindredPair& pair, const LimbPlace& place, int rows,
                 std::vector<Placed>& placed) const {
    const Extremity& left = sides_.leftIsPositive ? pair.pair.positive : pair.pair.negative;
    const Extremity& right = sides_.leftIsPositive ? pair.pair.negative : pair.pair.positive;
    placed.push_back({place, &left, &pair, rows});
    placed.push_back({mirrored(place), &right, &pair, rows});
  }

  // A body on two legs that stands upright is a biped; one on none is a long row of joints.
  [[nodiscard]] bool isItsTrunk(const BodyPlan& plan) const {
    const Axis& axis = parts_.axis;
    if (plan.legs == 0) {
      return isLong();
    }
    if (plan.legs > 2) {
      return true;
    }
    if (axis.head < 0 || axis.hips < 0) {
      return false;
    }
    constexpr double steepest = 0.75; // sine
    const auto leg = std::ranges::find(parts_.pairs, LimbKind::leg, &KindredPair::kind);
    const std::vector<Vec3>& points = leg->pair.positive.points;
    const Vec3 trunk = view_.at(axis.head) - points.front();
    const Vec3 reach = points.back() - points.front();
    const bool lies = std::abs(glm::dot(trunk, up_)) < steepest * glm::length(trunk);
    // The legs of a biped that lies go on where its trunk ends.
    const bool across = glm::dot(trunk, reach) > -steepest * glm::length(trunk) * glm::length(reach);
    bool hasWings = false;
    bool winged = true; // by its names: an ostrich stands as upright as a person
    for (const KindredPair& one : parts_.pairs) {
      hasWings = hasWings || one.kind == LimbKind::wing;
      winged = winged && (one.kind == LimbKind::leg || one.pair.word(PartWord::wing) > 0.0);
    }
    winged = winged && hasWings;
    return winged || (lies && across && (axis.tail || hasWings));
  }

  [[nodiscard]] bool isLong() const {
    constexpr std::size_t leastJoints = 5;
    const Extremity* const row = longestRow();
    double others = 0.0;
    for (const ExtremityPair& pair : parts_.extremities.pairs) {
      others = std::max(others, pair.length());
    }
    // Where most joints of the skins move nothing, what is left tells little.
    const bool isMost = 2 * static_cast<std::size_t>(view_.count()) >= skinJoints(scene_).size();
    return isMost && row != nullptr && !hasLongLimbs(view_, parts_.extremities.pairs) &&
           !hasNamedLegs(view_) && isEven(*row) && !hasBranches(view_, *row) &&
           row->path.size() >= leastJoints && row->path.size() <= mostJoints + 1 &&
           row->length > 0.5 * view_.size && others < 0.6 * row->length;
  }

  [[nodiscard]] const Extremity* longestRow() const {
    const auto& rows = parts_.extremities.middle;
    const auto longest =
        std::ranges::max_element(rows, {}, [&](const Extremity& row) { return trunkLength(view_, row); });
    return longest == rows.end() ? nullptr : &*longest;
  }

  // Of the joints' names; else from the way that the head and the feet point.
  [[nodiscard]] PlanSides findSides() const {
    const Vec3 left = glm::cross(up_, parts_.axis.forward);
    PlanSides sides;
    sides.leftIsPositive = glm::dot(left, plane_.normal) >= 0.0;
    sides.reason = "sides: from the way the body faces";
    double votes = 0.0;
    double named = 0.0;
    bool isAcross = false; // a pair whose limbs names put on one side
    for (const KindredPair& one : parts_.pairs) {
      double ofPositive = 0.0;
      double ofNegative = 0.0;
      addVotes(one.pair.positive, 1.0, ofPositive, named);
      addVotes(one.pair.negative, -1.0, ofNegative, named);
      votes += ofPositive + ofNegative;
      isAcross = isAcross || ofPositive * ofNegative < 0.0;
    }
    if (isAcross) {
      sides.warnings.emplace_back(
          "joint names put both limbs of a pair on one side: are front and hind limbs, and "
          "left and right, right?");
    }
    if (named < 2.0 || std::abs(votes) < 0.5 * named) {
      if (!parts_.axis.frontIsTold) {
        sides.warnings.emplace_back(
            "nothing tells which end of the body is the head: are front and hind limbs, "
            "and left and right, right?");
      }
      return sides;
    }
    const bool namesSay = votes > 0.0;
    const bool overruled = namesSay != sides.leftIsPositive && parts_.axis.headIsNamed && feetPointAhead();
    if (overruled) {
      sides.warnings.emplace_back("joint names call the body's right side left: the sides follow the way its "
                                  "head and feet point; are they right?");
      return sides;
    }
    sides.reason = sidesFromNames;
    if (const std::optional<std::string> doubt = doubtOfHead(view_, parts_, up_)) {
      sides.warnings.push_back(*doubt);
    }
    if (namesSay != sides.leftIsPositive) {
      sides.warnings.emplace_back(
          "left and right follow the joint names, but the head is at the other end: are the sides right?");
    }
    sides.leftIsPositive = namesSay;
    return sides;
  }

  void addVotes(const Extremity& limb, double sign, double& votes, double& named) const {
    for (const int joint : limb.path) {
      const Side side = view_.name(joint).side;
      votes += side == Side::none ? 0.0 : side == Side::left ? sign : -sign;
      named += side == Side::none ? 0.0 : 1.0;
    }
  }

  [[nodiscard]] bool feetPointAhead() const {
    double ahead = 0.0;
    for (const KindredPair& one : parts_.pairs) {
      for (const Extremity* leg : {&one.pair.positive, &one.pair.negative}) {
        const std::vector<Vec3>& points = leg->points;
        if (one.kind == LimbKind::leg && points.size() > 1) {
          ahead += glm::dot(points.back() - points[points.size() - 2], parts_.axis.forward);
        }
      }
    }
    return ahead > 0.0;
  }

  // A collar bone or half of a pelvis is none of the limb's: a first bone that only leads aside, and from
  // which the limb turns away.
  [[nodiscard]] Extremity withoutStub(Extremity row, bool hasShoulder) const {
    constexpr double aside = 0.8;     // cosine
    constexpr double turnsAway = 0.7; // cosine
    constexpr double longest = 0.45;  // of what follows
    if (!hasShoulder || parts_.standingLegs() > 4 || row.path.size() < 4) {
      return row;
    }
    const Vec3 first = row.points[1] - row.points[0];
    const Vec3 next = row.points[2] - row.points[1];
    const double length = glm::length(first);
    const bool leads = std::abs(glm::dot(first, plane_.normal)) > aside * length;
    const bool turns = glm::dot(first, next) < turnsAway * length * glm::length(next);
    if (leads && turns && length < longest * (row.length - length)) {
      row.path.erase(row.path.begin());
      row.points.erase(row.points.begin());
      row.length -= length;
    }
    return row;
  }

  void addLimb(const PlannedLimb& planned, const Placed& placed, std::vector<Limb>& limbs) const {
    const Extremity row = withoutStub(*placed.limb, isArm(placed.place) || isLeg(placed.place));
    std::size_t end = isLeg(placed.place) && placed.pair->stands
                          ? endOfLeg(view_, row, up_, parts_.extremities.floor)
                          : row.points.size() - 1;
    if (isArm(placed.place)) {
      end = std::min<std::size_t>(end, 2);
    }
    std::optional<Limb> limb = limbOf(planned, row, end);
    if (!limb) {
      return;
    }
    const double mirror = std::exp(-4.0 * placed.pair->pair.mirrorError);
    const double names = std::max({row.word(PartWord::leg), row.word(PartWord::arm), row.word(PartWord::wing),
                                   row.word(PartWord::fin), row.word(PartWord::feeler)});
    limb->confidence = 1.0 - (1.0 - 0.75 * mirror) * (1.0 - 0.6 * names);
    const char* const does = placed.pair->stands ? "reaches the ground" : "does not touch the ground";
    limb->reasons = {(names > 0.0 ? "joint names: " : "names say little: found by position (") +
                         nodeNames(scene_, limb->joints) + (names > 0.0 ? "" : ")"),
                     does + std::string(isLeg(placed.place) ? rowWord(placed.place.row, placed.rows) : ""),
                     "mirrors the limb on the other side", sides_.reason};
    limbs.push_back(std::move(*limb));
  }

  // A limb of the first `end` joints of a row, that ends at the next one, the tip, or its vertices.
  [[nodiscard]] std::optional<Limb> limbOf(const PlannedLimb& planned, const Extremity& row,
                                           std::size_t end) const {
    std::vector<NodeIndex> joints;
    LimbEnd limbEnd;
    if (end >= row.path.size() && row.tip.exists()) {
      limbEnd.node = row.tip;
      end = row.path.size();
    } else if (end > 0 && end < row.path.size()) {
      limbEnd.node = nodeOf(row.path[end]);
    } else {
      const std::optional<EstimatedEnd> estimated = estimateEnd(view_, row.path.back());
      if (!estimated) {
        return std::nullopt;
      }
      limbEnd.position = estimated->position;
      end = row.path.size();
    }
    for (std::size_t i = 0; i < end; ++i) {
      joints.push_back(nodeOf(row.path[i]));
    }
    Limb limb = makeLimb(planned.place, std::move(joints), limbEnd, bindPose_.worlds);
    limb.id = planned.id;
    const bool isUseful = isSound(limb) && limb.joints.size() <= mostJoints;
    return isUseful ? std::optional(std::move(limb)) : std::nullopt;
  }

  void addTrunk(const BodyPlan& plan, std::vector<Limb>& limbs) const {
    const Axis& axis = parts_.axis;
    if (plan.legs == 0) {
      addLongRow(plan, limbs);
      return;
    }
    if (axis.spineEnd >= 0 && !axis.spine.empty()) {
      const bool runsBack = std::ranges::find(axis.row, axis.spineEnd) == axis.row.end();
      addRow(plan, biped::spine, axis.spine, axis.spineEnd,
             runsBack ? "from where the front of the body begins to the hips"
                      : "from the hips to where the front of the body begins",
             limbs);
    }
    if (axis.head >= 0 && !axis.neck.empty()) {
      addRow(plan, biped::neck, axis.neck, axis.head, "between the trunk and the head", limbs);
    }
    const PlannedLimb* const tail = plannedLimb(plan, {LimbKind::tail});
    if (axis.tail && tail != nullptr) {
      const std::size_t before = limbs.size();
      addWhole(*tail, *axis.tail, "goes back from the trunk", limbs);
      if (limbs.size() > before && hangsFromTip(view_, axis, *axis.tail)) {
        limbs.back().confidence = std::min(limbs.back().confidence, 0.45);
        limbs.back().reasons.emplace_back("its joints hang from its tip");
      }
    }
  }

  void addRow(const BodyPlan& plan, const LimbPlace& place, const std::vector<int>& row, int end,
              const char* why, std::vector<Limb>& limbs) const {
    const PlannedLimb* const planned = plannedLimb(plan, place);
    if (planned == nullptr) {
      return;
    }
    std::vector<NodeIndex> joints;
    const bool isRoot = isRootOnFloor(view_, parts_, row.front(), up_);
    for (std::size_t i = isRoot && row.size() > 1 ? 1 : 0; i < row.size(); ++i) {
      joints.push_back(nodeOf(row[i]));
    }
    Limb limb = makeLimb(place, std::move(joints), {.node = nodeOf(end)}, bindPose_.worlds);
    limb.id = planned->id;
    limb.confidence = isRoot && row.size() < 2 ? 0.45 : parts_.axis.headIsNamed ? 0.9 : 0.65;
    limb.reasons = {why, nodeNames(scene_, limb.joints)};
    if (isSound(limb)) {
      limbs.push_back(std::move(limb));
    }
  }

  void addWhole(const PlannedLimb& planned, const Extremity& row, const char* why,
                std::vector<Limb>& limbs) const {
    const std::size_t end = row.tip.exists() || row.path.size() < 2 ? row.path.size() : row.path.size() - 1;
    std::optional<Limb> limb = limbOf(planned, row, end);
    if (limb) {
      limb->confidence = row.word(PartWord::tail) > 0.0 ? 0.95 : 0.7;
      limb->reasons = {why, nodeNames(scene_, limb->joints)};
      limbs.push_back(std::move(*limb));
    }
  }

  // A serpent: the longest row is its trunk; anchors before it are left out.
  void addLongRow(const BodyPlan& plan, std::vector<Limb>& limbs) const {
    const Extremity* const longest = longestRow();
    const PlannedLimb* const spine = plannedLimb(plan, biped::spine);
    if (longest == nullptr || spine == nullptr) {
      return;
    }
    Extremity row = *longest;
    while (row.path.size() > 2 && startsAtAnchor(view_, row)) {
      row.path.erase(row.path.begin());
      row.points.erase(row.points.begin());
    }
    endAtHead(row, parts_.axis);
    endBeforeFins(view_, row);
    addWhole(*spine, row, "one row of joints along the body", limbs);
    if (isInFork(view_, row, row.path.size() - 1) && !limbs.empty() && !parts_.axis.headIsNamed &&
        row.word(PartWord::tail) <= 0.0) {
      limbs.back().confidence = std::min(limbs.back().confidence, 0.45);
      limbs.back().reasons.emplace_back("it ends where joints part, which may be fins");
    }
    const Axis& axis = parts_.axis;
    const PlannedLimb* const neck = plannedLimb(plan, biped::neck);
    if (neck == nullptr || row.path.empty() || axis.row.empty() || axis.row.back() == row.path.back()) {
      return;
    }
    std::vector<int> other;
    std::ranges::copy_if(axis.row, std::back_inserter(other), [&](int joint) {
      return std::ranges::find(longest->path, joint) == longest->path.end();
    });
    if (const auto head = std::ranges::find(other, axis.head); axis.headIsNamed && head != other.end()) {
      other.erase(head + 1, other.end());
    }
    const double length =
        other.empty() ? 0.0 : glm::distance(view_.at(other.front()), view_.at(other.back()));
    if (other.size() >= 2 && length > 0.1 * longest->length) {
      const int end = other.back();
      other.pop_back();
      addRow(plan, biped::neck, other, end, "the other way from where the rows meet", limbs);
    }
  }

  [[nodiscard]] double confidence() const {
    double mirror = 0.0;
    double legNames = 0.0;
    for (const KindredPair& one : parts_.pairs) {
      mirror += std::exp(-4.0 * one.pair.mirrorError) / static_cast<double>(parts_.pairs.size());
      legNames = std::max(legNames, one.pair.word(PartWord::leg));
    }
    if (parts_.pairs.empty()) {
      mirror = 0.8;
    }
    const double named = (parts_.axis.headIsNamed ? 0.5 : 0.0) + 0.5 * std::min(1.0, legNames);
    return 1.0 - (1.0 - 0.75 * mirror) * (1.0 - 0.8 * named);
  }

  [[nodiscard]] std::vector<std::string> reasons(const BodyPlan& plan) const {
    std::vector<std::string> reasons;
    const int legs = parts_.standingLegs();
    reasons.push_back(legs > 0 ? fmt::format("stands on {} legs in the bind pose", legs)
                               : "nothing of it stands on the ground in the bind pose");
    if (legs == 0 && longestRow() != nullptr) {
      reasons.push_back(fmt::format("one row of {} joints along the body", longestRow()->path.size()));
    }
    for (const auto& [kind, text] :
         {std::pair(LimbKind::wing, "a pair of wings"), std::pair(LimbKind::arm, "a pair of arms"),
          std::pair(LimbKind::fin, "fins"), std::pair(LimbKind::feeler, "a pair of feelers")}) {
      if (std::ranges::find(parts_.pairs, kind, &KindredPair::kind) != parts_.pairs.end()) {
        reasons.emplace_back(text);
      }
    }
    if (parts_.axis.tail && plannedLimb(plan, {LimbKind::tail}) != nullptr) {
      reasons.emplace_back("a tail");
    }
    reasons.emplace_back(parts_.axis.headIsNamed
                             ? "names say where the head is"
                             : "names do not say where the head is: by the order of the joints");
    return reasons;
  }

  const Scene& scene_;
  const BindPose& bindPose_;
  const BodyView& view_;
  const MirrorPlane& plane_;
  Vec3 up_;
  PlanParts parts_;
  PlanSides sides_;
};

std::optional<PlanReading> readUpright(const Scene& scene, const BindPose& bindPose, const BodyView& view,
                                       const MirrorPlane& plane, const Vec3& up, int leastLegs,
                                       int mostLegs) {
  const PlanReader reader(scene, bindPose, view, plane, up,
                          partsOfBody(scene, bindPose, view, plane, up, std::nullopt));
  for (const BodyPlan& plan : bodyPlans()) {
    const bool isAsked =
        plan.id != "biped" && plan.id != "other" && plan.legs >= leastLegs && plan.legs <= mostLegs;
    if (std::optional<PlanReading> reading = isAsked ? reader.fit(plan) : std::nullopt) {
      return reading;
    }
  }
  return std::nullopt;
}

const Vec3 upwards(0, 1, 0);

} // namespace

std::optional<PlanReading> readPlan(const Scene& scene, const BindPose& bindPose, const BodyView& view) {
  if (view.count() == 0) {
    return std::nullopt;
  }
  const MirrorPlane plane = findMirrorPlane(view);
  constexpr int any = 1000;
  std::optional<PlanReading> level = readUpright(scene, bindPose, view, plane, upwards, 2, any);
  constexpr double named = 0.8;
  if (level && (level->plan->legs > 2 || level->confidence >= named)) {
    return level;
  }
  for (const Vec3& up : leaningUps(plane)) {
    std::optional<PlanReading> reading = readUpright(scene, bindPose, view, plane, up, 4, any);
    const bool isSurer = reading && (!level || reading->plan->legs > 4); // birds and beasts tell little apart
    if (isSurer && !hasGuessedWings(*reading)) {
      return reading->confidence < named ? turnedOver(*std::move(reading), up) : *std::move(reading);
    }
  }
  if (level) {
    return level;
  }
  for (const Vec3& up : otherUps(plane)) {
    if (std::optional<PlanReading> reading = readUpright(scene, bindPose, view, plane, up, 4, any)) {
      return turnedOver(*std::move(reading), up);
    }
  }
  if (std::optional<PlanReading> reading = readUpright(scene, bindPose, view, plane, upwards, 0, 0)) {
    return reading;
  }
  const PlanReader reader(scene, bindPose, view, plane, upwards,
                          partsOfBody(scene, bindPose, view, plane, upwards, std::nullopt));
  return reader.fitWinged(*planNamed(reader.hasNamedTail() ? "bird" : "insect"));
}

PlanReading readAsPlan(const Scene& scene, const BindPose& bindPose, const BodyView& view,
                       const BodyPlan& plan) {
  if (view.count() == 0) {
    PlanReading nothing;
    nothing.plan = &plan;
    return nothing;
  }
  const MirrorPlane plane = findMirrorPlane(view);
  const auto reader = [&](const Vec3& up, std::optional<int> legPairs) {
    return PlanReader(scene, bindPose, view, plane, up,
                      partsOfBody(scene, bindPose, view, plane, up, legPairs));
  };
  if (std::optional<PlanReading> reading = reader(upwards, std::nullopt).fit(plan)) {
    return *std::move(reading);
  }
  for (const Vec3& up : plan.legs > 2 ? leaningUps(plane) : std::vector<Vec3>{}) {
    if (std::optional<PlanReading> reading = reader(up, std::nullopt).fit(plan)) {
      return *std::move(reading);
    }
  }
  for (const Vec3& up : plan.legs > 2 ? otherUps(plane) : std::vector<Vec3>{}) {
    if (std::optional<PlanReading> reading = reader(up, std::nullopt).fit(plan)) {
      return turnedOver(*std::move(reading), up);
    }
  }
  return reader(upwards, plan.legs / 2).as(plan);
}

} // namespace stretch::rig::body
