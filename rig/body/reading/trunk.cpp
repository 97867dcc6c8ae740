#include "rig/body/reading/trunk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stretch::rig::body {

namespace {

constexpr double clearName = 0.8;
constexpr std::size_t longestTrunk = 40;

// Where limbs meet the middle of the body.
struct Attachment {
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 legBase{0.0};
  Vec3 armBase{0.0};
  double legLength = 0.0;
  double trunkLength = 0.0;
  std::vector<int> limbBases;
  int legJoint = -1; // nearest common ancestor of the legs
  bool hasBothLegs = false;
  int armJoint = -1;
};

double lengthOf(const LimbPair& pair) {
  return std::max(pair.negative ? pair.negative->length : 0.0, pair.positive ? pair.positive->length : 0.0);
}

void addBases(std::vector<int>& bases, const LimbPair& pair) {
  for (const std::optional<LimbGuess>* limb : {&pair.negative, &pair.positive}) {
    if (*limb) {
      bases.push_back((*limb)->base);
      bases.push_back((*limb)->endDetached ? (*limb)->end : (*limb)->base);
    }
  }
}

Attachment attachmentOf(const BodyView& view, const BipedReading& reading) {
  Attachment attachment;
  if (reading.legs) {
    attachment.legBase = meanBase(view, *reading.legs);
    attachment.legLength = lengthOf(*reading.legs);
    attachment.legJoint = meetingJoint(view, *reading.legs);
    attachment.hasBothLegs = reading.legs->negative && reading.legs->positive;
    attachment.up = attachment.legBase - meanEnd(*reading.legs);
    addBases(attachment.limbBases, *reading.legs);
  }
  if (reading.arms) {
    attachment.armBase = meanBase(view, *reading.arms);
    attachment.armJoint = meetingJoint(view, *reading.arms);
    addBases(attachment.limbBases, *reading.arms);
  }
  if (reading.arms && reading.legs) {
    attachment.up = attachment.armBase - attachment.legBase;
  }
  attachment.trunkLength = reading.arms && reading.legs ? glm::length(attachment.up) : 0.4 * view.size;
  const double length = glm::length(attachment.up);
  attachment.up = length > 0.0 ? attachment.up / length : Vec3(0, 1, 0);
  return attachment;
}

class TrunkReader {
public:
  TrunkReader(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading)
      : view_(view), plane_(plane), reading_(reading), attachment_(attachmentOf(view, reading)) {}

  Trunk read() {
    const int top = topJoint();
    chain_ = chainTo(top >= 0 ? top : attachment_.armJoint);
    if (chain_.empty()) {
      return {};
    }
    findLandmarks();
    Split best;
    double bestScore = std::numeric_limits<double>::lowest();
    const std::size_t firstHips = hips_ > 0 ? hips_ - 1 : 0;
    for (std::size_t hips = firstHips; hips < chain_.size(); ++hips) {
      for (std::size_t tip = hips; tip < chain_.size(); ++tip) {
        for (std::size_t head = tip + 1; head <= chain_.size(); ++head) {
          const double score = scoreOf({hips, tip, head});
          if (score > bestScore) {
            bestScore = score;
            best = {hips, tip, head};
          }
        }
      }
    }
    return trunkOf(best);
  }

private:
  // Indices into the chain; head = size where the chain has none.
  struct Split {
    std::size_t hips = 0;
    std::size_t tip = 0;
    std::size_t head = 0;
  };

  [[nodiscard]] double heightOf(int joint) const { return glm::dot(view_.at(joint), attachment_.up); }

  [[nodiscard]] bool isInLimb(int joint) const {
    return std::ranges::any_of(attachment_.limbBases,
                               [&](int base) { return view_.isAboveOrSelf(base, joint); });
  }

  // Of a trunk that bends aside, what is beyond its arms may stand as far from them as they do from the legs.
  [[nodiscard]] bool isInPlane(const Vec3& place) const {
    const double near = 0.04 * view_.size;
    const double aside = plane_.lateral(attachment_.armBase);
    const double bend = reading_.arms && reading_.legs ? aside - plane_.lateral(attachment_.legBase) : 0.0;
    const double lateral = plane_.lateral(place);
    return std::abs(lateral) < near || (std::abs(bend) > near && std::abs(lateral - aside) < std::abs(bend));
  }

  [[nodiscard]] bool isCentral(int joint) const {
    const NameEvidence& name = view_.name(joint);
    return (name.role(Role::head) >= clearName || isInPlane(view_.at(joint))) && !name.accessory &&
           !name.finger && !name.fin && name.side == Side::none && isSeen(joint) && !isInLimb(joint);
  }

  // A head whose mesh follows the neck is one by its name.
  [[nodiscard]] bool isSeen(int joint) const {
    const int below = view_.parentOf(joint);
    return view_.movesMesh(joint) || (below >= 0 && view_.name(joint).role(Role::head) >= clearName &&
                                      view_.name(below).role(Role::neck) >= clearName);
  }

  // The less the likelier: above the arms, else near them; on a neck; high in the tree, before a hood or a
  // look target.
  [[nodiscard]] std::tuple<double, bool, int> rankOfHead(int joint) const {
    const int arms = attachment_.armJoint;
    const bool isAbove = arms < 0 || view_.isAboveOrSelf(arms, joint);
    const int below = view_.parentOf(joint);
    return {isAbove ? 0.0 : glm::distance(view_.at(joint), attachment_.armBase),
            below < 0 || view_.name(below).role(Role::neck) < clearName,
            view_.depth[static_cast<std::size_t>(joint)]};
  }

  // The joint that is likeliest of those that are named head, else the highest one in the middle.
  [[nodiscard]] int topJoint() const {
    const double lowest = reading_.arms
                              ? glm::dot(attachment_.armBase, attachment_.up) - 0.25 * attachment_.trunkLength
                              : std::numeric_limits<double>::lowest();
    int top = -1;
    for (int joint = 0; joint < view_.count(); ++joint) {
      if (isCentral(joint) && heightOf(joint) > lowest && (top < 0 || isBetterTop(joint, top))) {
        top = joint;
      }
    }
    return top;
  }

  [[nodiscard]] bool isBetterTop(int joint, int top) const {
    const bool named = view_.name(joint).role(Role::head) >= clearName;
    const bool topNamed = view_.name(top).role(Role::head) >= clearName;
    if (named != topNamed) {
      return named;
    }
    if (named) {
      return rankOfHead(joint) < rankOfHead(top);
    }
    return heightOf(joint) > heightOf(top) + 1e-6 * view_.size;
  }

  [[nodiscard]] std::vector<int> chainTo(int top) const {
    std::vector<int> chain;
    for (int joint = top; joint >= 0; joint = view_.parentOf(joint)) {
      chain.push_back(joint);
    }
    chain.resize(std::min(chain.size(), longestTrunk));
    std::ranges::reverse(chain);
    return chain;
  }

  void findLandmarks() {
    hips_ = hipsIndex();
    if (hangsBesideHips()) {
      hips_ += view_.isAboveOrSelf(chain_[hips_], attachment_.legJoint) ? 1 : 0;
      chain_.insert(chain_.begin() + static_cast<std::ptrdiff_t>(hips_), attachment_.legJoint);
    }
    arms_ = armsIndex();
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      namesHead_ = namesHead_ || std::max(role(i, Role::neck), role(i, Role::head)) >= clearName;
      namesNeck_ = namesNeck_ || role(i, Role::neck) >= clearName;
    }
    head_ = headIndex();
  }

  // Where the chain leaves the joint that the legs hang from; where that is far from the thighs (or there is
  // none), the joint nearest to them.
  [[nodiscard]] std::size_t hipsIndex() const {
    if (!reading_.legs) {
      return 0;
    }
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      if (isMeeting(i)) {
        return i;
      }
      const double distance = glm::distance(view_.at(chain_[i]), attachment_.legBase);
      if (distance < glm::distance(view_.at(chain_[nearest]), attachment_.legBase) - 1e-6 * view_.size) {
        nearest = i;
      }
    }
    return nearest;
  }

  // Whether the trunk hangs from a root, or from nothing, and the legs from hips of their own; those of
  // another copy of the skeleton stand where its own do.
  [[nodiscard]] bool hangsBesideHips() const {
    const int hips = attachment_.legJoint;
    return attachment_.hasBothLegs && hips >= 0 && !isMeeting(hips_) &&
           !view_.isAboveOrSelf(hips, chain_.back()) &&
           (std::max(role(hips_, Role::spine), role(hips_, Role::chest)) >= clearName ||
            glm::distance(view_.at(hips), view_.at(chain_[hips_])) > 0.01 * view_.size);
  }

  // Whether legs and trunk hang from a joint of the chain, near the thighs.
  [[nodiscard]] bool isMeeting(std::size_t index) const {
    return attachment_.legJoint >= 0 &&
           chain_[index] == view_.commonAncestor(attachment_.legJoint, chain_.back()) &&
           glm::distance(view_.at(chain_[index]), attachment_.legBase) < 0.35 * attachment_.legLength;
  }

  [[nodiscard]] std::size_t armsIndex() const {
    const int meeting =
        attachment_.armJoint < 0 ? -1 : view_.commonAncestor(attachment_.armJoint, chain_.back());
    const double shoulder = glm::dot(attachment_.armBase, attachment_.up) - 0.04 * view_.size;
    std::size_t below = hips_;
    for (std::size_t i = hips_; i < chain_.size(); ++i) {
      if (chain_[i] == meeting && i > hips_) {
        return i;
      }
      below = heightOf(chain_[i]) < shoulder ? i : below;
    }
    return below;
  }

  // Size of what follows a joint of the chain, side branches (jaw, eyes, hair) included.
  [[nodiscard]] double bulk(std::size_t index) const {
    Vec3 low(std::numeric_limits<double>::max());
    Vec3 high(std::numeric_limits<double>::lowest());
    std::vector<int> joints{chain_[index]};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      for (const Vec3& point : view_.points[static_cast<std::size_t>(joints[i])]) {
        low = glm::min(low, point);
        high = glm::max(high, point);
      }
      for (const int child : view_.childrenOf(joints[i])) {
        if ((index + 1 >= chain_.size() || child != chain_[index + 1]) && !isInLimb(child)) {
          joints.push_back(child);
        }
      }
    }
    return high.x >= low.x ? glm::distance(low, high) : 0.0;
  }

  [[nodiscard]] std::size_t headIndex() const {
    const std::size_t first = arms_ + 1;
    const std::size_t above = chain_.size() - std::min(chain_.size(), first);
    if (above < 2) {
      return first;
    }
    // Where neck and head are numbered on from the spine, the last of the row is the head.
    const auto isSpine = [&](std::size_t index) { return role(index, Role::spine) >= clearName; };
    if (!namesHead_ && isSpine(first) && isSpine(chain_.size() - 1)) {
      return chain_.size() - 1;
    }
    if (view_.hasVertices) {
      // Without a neck the head comes first: it carries far more than what stands on it.
      return bulk(first) > 1.5 * bulk(first + 1) ? first : firstBulky(first + 1);
    }
    const std::size_t last = chain_.size() - 1;
    const bool endsInTip = above >= 3 && boneLength(last) > boneLength(last - 1);
    return endsInTip ? last - 1 : last;
  }

  // The first joint that carries most of the head: a tip or a hat above it may carry more than the head
  // itself.
  [[nodiscard]] std::size_t firstBulky(std::size_t from) const {
    double largest = 0.0;
    for (std::size_t i = from; i < chain_.size(); ++i) {
      largest = std::max(largest, bulk(i));
    }
    std::size_t index = from;
    while (bulk(index) < 0.6 * largest) {
      ++index;
    }
    return index;
  }

  [[nodiscard]] double boneLength(std::size_t index) const {
    return glm::distance(view_.at(chain_[index]), view_.at(chain_[index - 1]));
  }

  [[nodiscard]] double role(std::size_t index, Role which) const {
    return view_.name(chain_[index]).role(which);
  }
  // Where the neck is called spine like the rest, the word says nothing above the arms.
  [[nodiscard]] double spineRole(std::size_t index) const {
    if (index > arms_ && (!namesHead_ || (!namesNeck_ && chain_[arms_] == attachment_.armJoint))) {
      return 0.0;
    }
    return std::max(role(index, Role::spine), role(index, Role::chest));
  }

  [[nodiscard]] double scoreOf(const Split& split) const {
    return hipsScore(split.hips) + spineScore(split) + neckScore(split);
  }

  [[nodiscard]] double hipsScore(std::size_t hips) const {
    if (hips < hips_) {
      // The thighs hang from the first joint of the spine: only names can say so.
      const bool named = role(hips, Role::hips) >= clearName && spineRole(hips_) >= clearName;
      const bool near =
          glm::distance(view_.at(chain_[hips]), attachment_.legBase) < 0.5 * attachment_.legLength;
      return named && near ? 1.0 : -3.0;
    }
    double score = role(hips, Role::hips) - 0.5 * static_cast<double>(hips - hips_);
    for (std::size_t i = hips_ + 1; i <= hips; ++i) {
      score -= spineRole(i) >= clearName ? 1.0 : 0.0;
    }
    return score;
  }

  [[nodiscard]] double spineScore(const Split& split) const {
    double score = split.tip == split.hips ? -0.3 : 0.0;
    for (std::size_t i = split.hips + 1; i <= split.tip; ++i) {
      score += spineRole(i) - role(i, Role::neck) - role(i, Role::head) - 0.5 * role(i, Role::hips);
    }
    const double off = std::abs(static_cast<double>(split.tip) - static_cast<double>(arms_));
    return score + 0.7 - std::min(1.4, 0.7 * off);
  }

  [[nodiscard]] double neckScore(const Split& split) const {
    double score = 0.0;
    for (std::size_t i = split.tip + 1; i < split.head; ++i) {
      score += role(i, Role::neck) - spineRole(i) - role(i, Role::head);
    }
    const bool topIsNeck = split.head + 1 == chain_.size() && split.head > split.tip + 1;
    for (std::size_t i = split.head; i < chain_.size(); ++i) {
      // The last of several neck joints carries the head where no joint is named so.
      score += (topIsNeck ? 1.0 : -1.0) * role(i, Role::neck) - spineRole(i);
      score += i == split.head ? role(i, Role::head) : -role(i, Role::head);
    }
    const double off = std::abs(static_cast<double>(split.head) - static_cast<double>(head_));
    return score + 0.5 - std::min(1.0, 0.3 * off);
  }

  [[nodiscard]] Trunk trunkOf(const Split& split) const {
    Trunk trunk;
    trunk.hips = chain_[split.hips];
    double spineNames = 0.0;
    double neckNames = 0.0;
    for (std::size_t i = split.hips + 1; i <= split.tip; ++i) {
      trunk.spine.push_back(chain_[i]);
      spineNames += spineRole(i);
    }
    for (std::size_t i = split.tip + 1; i < split.head; ++i) {
      trunk.neck.push_back(chain_[i]);
      neckNames += role(i, Role::neck);
    }
    if (split.head < chain_.size()) {
      trunk.head = chain_[split.head];
      neckNames += std::max(role(split.head, Role::head), 0.5 * role(split.head, Role::neck));
    }
    if (trunk.spine.empty()) { // the joint that carries the legs is the spine's as well
      spineNames = std::max(role(split.hips, Role::spine), role(split.hips, Role::chest));
    }
    trunk.spineNameFit = spineNames / std::max(1.0, static_cast<double>(trunk.spine.size()));
    trunk.neckNameFit = neckNames / static_cast<double>(trunk.neck.size() + 1);
    trunk.hasRivalOfNeck = !namesHead_ && hasRivalOfNeck(split);
    return trunk;
  }

  // Whether two joints in a row stand above the spine in the middle, and not on the way up to the head:
  // beside it, as what a back carries, or beyond it, as a ponytail.
  [[nodiscard]] bool hasRivalOfNeck(const Split& split) const {
    const auto end = chain_.begin() + static_cast<std::ptrdiff_t>(std::min(split.head + 1, chain_.size()));
    const auto isRival = [&](int joint) {
      return joint >= 0 && isCentral(joint) && heightOf(joint) > heightOf(chain_[split.tip]) &&
             std::find(chain_.begin(), end, joint) == end;
    };
    for (int joint = 0; joint < view_.count(); ++joint) {
      if (isRival(joint) && isRival(view_.parentOf(joint))) {
        return true;
      }
    }
    return false;
  }

  const BodyView& view_;
  const MirrorPlane& plane_;
  const BipedReading& reading_;
  Attachment attachment_;
  std::vector<int> chain_;
  std::size_t hips_ = 0;   // index into the chain of the joint that the legs hang from
  std::size_t arms_ = 0;   // of the joint that the arms hang from
  std::size_t head_ = 0;   // of the head as its bulk tells
  bool namesHead_ = false; // or the neck
  bool namesNeck_ = false;
};

} // namespace

Trunk readTrunk(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading) {
  return reading.arms || reading.legs ? TrunkReader(view, plane, reading).read() : Trunk{};
}

} // namespace stretch::rig::body
