#include "rig/body/reading/limb_guess.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "rig/body/reading/limb_score.h"

namespace stretch::rig::body {

namespace {

constexpr int deepest = 6;         // joints from base to middle and from middle to end, twist joints included
constexpr int deepestOfEqual = 18; // where most are of equal bones in line
constexpr std::size_t mostBelow = 160;     // joints looked at below one joint
constexpr std::size_t mostGuesses = 60000; // of one region: a file with more is no character
constexpr int mostForDetached = 800;       // joints of a tree in which ends are looked for elsewhere
constexpr double shortestBone = 0.02;      // of the body's size

// Joints up to `deepest` levels below, nearest first; none below a foot that hangs elsewhere in the file.
// Below the first of many equal bones those in line count for none.
std::vector<int> descendants(const BodyView& view, int from, bool isOfEqual) {
  std::vector<int> found{from};
  std::vector<int> levels{0};
  const int top = view.depth[static_cast<std::size_t>(from)];
  for (std::size_t i = 0; i < found.size() && found.size() < mostBelow; ++i) {
    const auto here = static_cast<std::size_t>(found[i]);
    if (levels[i] < deepest && view.depth[here] - top < deepestOfEqual &&
        (i == 0 || !view.isDetached[here])) {
      const auto& children = view.childrenOf(found[i]);
      found.insert(found.end(), children.begin(), children.end());
      const bool goesOn = isOfEqual && children.size() == 1 && continuesEqualBone(view, found[i]);
      levels.resize(found.size(), levels[i] + (goesOn ? 0 : 1));
    }
  }
  found.erase(found.begin());
  return found;
}

class Guesser {
public:
  Guesser(const BodyView& view, const MirrorPlane& plane, Region region)
      : view_(view), plane_(plane), region_(region) {
    for (int joint = 0; joint < view.count(); ++joint) {
      ends_.push_back(estimateEnd(view, joint));
      if (region == Region::leg && ends_.back()) {
        ends_.back()->position = withoutFoot(view.at(joint), ends_.back()->position);
      }
    }
  }

  std::vector<LimbGuess> all() {
    for (int base = 0; base < view_.count() && guesses_.size() < mostGuesses; ++base) {
      if (canBend(base) && !continuesBone(base)) {
        guessFrom(base);
      }
    }
    return std::move(guesses_);
  }

private:
  // A foot in the last bone's mesh pulls its far end forward: the ankle of a standing leg is straight below.
  [[nodiscard]] Vec3 withoutFoot(const Vec3& joint, const Vec3& end) const {
    const Vec3 offset = end - joint;
    const Vec3 forward = glm::cross(plane_.normal, Vec3(0, 1, 0));
    const bool hangs = -offset.y > 0.6 * glm::length(offset);
    return hangs ? end - forward * glm::dot(offset, forward) : end;
  }

  [[nodiscard]] bool canBend(int candidate) const {
    const NameEvidence& name = view_.name(candidate);
    const bool isFin = name.fin && region_ == Region::leg; // arms of a penguin are flippers
    return view_.movesMesh(candidate) && !name.finger && !name.accessory && !isFin;
  }

  // Whether a bone of a joint leads on as the one that leads to it, as that of a joint on a bone does.
  [[nodiscard]] bool goesStraightOn(int above, int joint) const {
    constexpr double inLine = 0.995; // cosine
    const Vec3 first = view_.at(joint) - view_.at(above);
    return glm::length(first) > 1e-6 * view_.size &&
           std::ranges::any_of(view_.childrenOf(joint), [&](int child) {
             const Vec3 next = view_.at(child) - view_.at(joint);
             return glm::dot(first, next) > inLine * glm::length(first) * glm::length(next);
           });
  }

  // The second half of an upper arm or thigh: a joint below one of the same name but for its number, or an
  // upper arm in line with one. The limb starts at the first. A thigh in line with a hip is none: both words
  // name it. The hinges of a robot's hip are called alike: a bone between two of them is of the leg.
  [[nodiscard]] bool continuesBone(int joint) const {
    const int above = view_.parentOf(joint);
    const Role role = region_ == Region::arm ? Role::upperArm : Role::thigh;
    const auto word = [](const std::string& key) { return key.substr(0, key.find('#')); };
    if (above < 0 || !view_.movesMesh(above) || view_.name(joint).role(role) < 0.8 ||
        view_.name(above).role(role) < 0.8 || view_.name(above).side != view_.name(joint).side) {
      return false;
    }
    constexpr double aside = 0.7; // cosine: a bone that leads to the leg is none of it
    const Vec3 bone = view_.at(joint) - view_.at(above);
    const bool isHinge = view_.name(above).role(role) == view_.name(joint).role(role) &&
                         isBone(view_.at(above), view_.at(joint)) &&
                         std::abs(glm::dot(bone, plane_.normal)) < aside * glm::length(bone);
    return word(view_.name(above).key) == word(view_.name(joint).key) ||
           (region_ == Region::arm ? goesStraightOn(above, joint) : isHinge);
  }

  [[nodiscard]] bool isBone(const Vec3& from, const Vec3& to) const {
    return glm::distance(from, to) > shortestBone * view_.size;
  }

  [[nodiscard]] const std::optional<EstimatedEnd>& endOf(int joint) const {
    return ends_[static_cast<std::size_t>(joint)];
  }

  // A joint from which a leg goes on straight, as far as it came down to it, whatever it is called.
  [[nodiscard]] bool isKnee(int base, int end) const {
    constexpr double asFar = 0.6;
    constexpr double straight = 0.85; // cosine
    const std::optional<EstimatedEnd>& last = endOf(end);
    const Vec3 bone = view_.at(end) - view_.at(base);
    const Vec3 beyond = last ? last->position - view_.at(end) : Vec3(0.0);
    return region_ == Region::leg && view_.childrenOf(end).empty() &&
           glm::length(beyond) > asFar * glm::length(bone) &&
           glm::dot(beyond, bone) > straight * glm::length(beyond) * glm::length(bone);
  }

  // An arm that is one bone: the hand hangs from it and is called so.
  [[nodiscard]] bool isEndOfOneBone(int base, int end) const {
    const Role above = region_ == Region::arm ? Role::upperArm : Role::thigh;
    return !isKnee(base, end) && view_.name(end).role(endRole()) >= 0.8 &&
           view_.name(base).role(above) >= 0.4 && isBone(view_.at(base), view_.at(end));
  }

  void guessFrom(int base) {
    const bool isOfEqual = !continuesEqualBone(view_, base);
    const std::vector<int> below = descendants(view_, base, isOfEqual);
    for (const int middle : below) {
      const bool isOwn = !view_.isDetached[static_cast<std::size_t>(middle)];
      if (isOwn && canBend(middle) && isBone(view_.at(base), view_.at(middle))) {
        guessFrom(base, middle, isOfEqual);
      }
    }
    for (const int end : view_.childrenOf(base)) {
      if (isEndOfOneBone(base, end)) {
        keep({.base = base, .end = end, .endPosition = view_.at(end)});
      }
    }
    // What lies over the one bone in the same place, as a sleeve does, is no next joint; a collar bone is no
    // arm.
    const bool alone =
        std::ranges::none_of(
            below, [&](int joint) { return canBend(joint) && isBone(view_.at(base), view_.at(joint)); }) &&
        view_.name(base).role(Role::clavicle) <= view_.name(base).role(Role::upperArm);
    const std::optional<EstimatedEnd> end = alone ? endOf(base) : std::nullopt;
    if (end) {
      keep({.base = base, .endPosition = end->position});
    }
  }

  void guessFrom(int base, int middle, bool isOfEqual) {
    const std::vector<int> below = descendants(view_, middle, isOfEqual);
    for (const int end : below) {
      if (isBone(view_.at(middle), view_.at(end))) {
        keep({.base = base,
              .middle = middle,
              .end = end,
              .endDetached = view_.isDetached[static_cast<std::size_t>(end)],
              .endPosition = view_.at(end)});
      }
    }
    if (const std::optional<EstimatedEnd>& end = endOf(middle)) {
      keep({.base = base, .middle = middle, .endPosition = end->position});
    }
    const bool isLast = std::ranges::all_of(below, [&](int joint) { return view_.name(joint).twist; });
    const bool hasNoEnd =
        std::ranges::none_of(below, [&](int joint) { return view_.name(joint).role(endRole()) > 0.0; });
    if (view_.count() <= mostForDetached && (isLast || (hasNoEnd && region_ == Region::arm))) {
      guessDetached(base, middle);
    }
  }

  [[nodiscard]] Role endRole() const { return region_ == Region::arm ? Role::wrist : Role::ankle; }

  // An end joint that hangs from elsewhere: named as one of the same side, or standing where the mesh of the
  // last bone ends.
  void guessDetached(int base, int middle) {
    const std::optional<EstimatedEnd>& end = endOf(middle);
    const double upper = glm::distance(view_.at(base), view_.at(middle));
    for (int joint = 0; joint < view_.count(); ++joint) {
      const bool named =
          view_.name(joint).role(endRole()) >= 0.8 && view_.name(joint).side == view_.name(middle).side;
      const int above = view_.parentOf(joint);
      const bool isApart = above < 0 || view_.points[static_cast<std::size_t>(above)].empty(); // a hip is not
      const bool near = end && glm::distance(end->position, view_.at(joint)) < 0.35 * upper &&
                        view_.movesMesh(joint) && isApart;
      const bool sameSide = plane_.lateral(view_.at(joint)) * plane_.lateral(view_.at(middle)) > 0.0;
      if ((named || near) && sameSide && isBone(view_.at(middle), view_.at(joint)) &&
          !view_.isAboveOrSelf(base, joint) && !view_.isAboveOrSelf(joint, base)) {
        keep({.base = base,
              .middle = middle,
              .end = joint,
              .endDetached = true,
              .endPosition = view_.at(joint)});
      }
    }
  }

  // A posed limb may reach across the body: where its base stands beside the middle, that tells.
  [[nodiscard]] double sideOf(const Vec3& base, const Vec3& middle) const {
    const double atBase = plane_.lateral(base);
    return std::abs(atBase) > 0.02 * view_.size ? atBase : plane_.lateral(middle);
  }

  void keep(LimbGuess guess) {
    const Vec3 base = view_.at(guess.base);
    const Vec3 middle = guess.middle >= 0 ? view_.at(guess.middle) : guess.endPosition;
    guess.length = glm::distance(base, middle) + glm::distance(middle, guess.endPosition);
    guess.lateral = sideOf(base, middle);
    const bool isInPlane = std::abs(guess.lateral) < 0.005 * view_.size;
    if (guess.length <= 0.0 || (isInPlane && namedSide(view_, guess) == Side::none)) {
      return;
    }
    guess.nameFit = nameFit(view_, guess, region_);
    guess.shapePenalty = shapePenalty(view_, plane_, guess, region_);
    guesses_.push_back(guess);
  }

  const BodyView& view_;
  const MirrorPlane& plane_;
  Region region_;
  std::vector<std::optional<EstimatedEnd>> ends_; // one for each candidate
  std::vector<LimbGuess> guesses_;
};

} // namespace

std::vector<LimbGuess> guessLimbs(const BodyView& view, const MirrorPlane& plane, Region region,
                                  std::size_t most) {
  std::vector<LimbGuess> guesses = Guesser(view, plane, region).all();
  std::ranges::stable_sort(guesses, std::ranges::greater{}, &LimbGuess::score);
  std::size_t negative = 0;
  std::size_t positive = 0;
  std::erase_if(guesses,
                [&](const LimbGuess& guess) { return ++(guess.lateral < 0.0 ? negative : positive) > most; });
  return guesses;
}

Side namedSide(const BodyView& view, const LimbGuess& guess) {
  int votes = 0;
  for (const int joint : {guess.base, guess.middle, guess.end}) {
    if (joint >= 0) {
      const Side side = view.name(joint).side;
      votes += side == Side::left ? 1 : side == Side::right ? -1 : 0;
    }
  }
  return votes > 0 ? Side::left : votes < 0 ? Side::right : Side::none;
}

} // namespace stretch::rig::body
