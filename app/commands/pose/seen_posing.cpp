#include "app/commands/pose/seen_posing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/pose/held_controllers.h"
#include "app/commands/pose/posing.h"
#include "app/commands/table/selection.h"
#include "app/edits/pose/pose_edits.h"
#include "app/evaluate/cache.h"
#include "app/named.h"
#include "core/anim/frames.h"
#include "core/math/rotation.h"

namespace stretch::app {

namespace {

constexpr double thereRadians = 1e-4;
constexpr double missedRadians = 2e-2;

/// What carries comes before what is carried.
int rankOf(rig::ControllerKind kind) {
  using rig::ControllerKind;
  return kind == ControllerKind::body   ? 0
         : kind == ControllerKind::hips ? 1
         : kind == ControllerKind::spineLow || kind == ControllerKind::spineMiddle ||
                 kind == ControllerKind::spineTop
             ? 2
             : 3;
}
constexpr int lastRank = 3;

/// How far a controller is from its goal, world space; zero where it cannot move or turn so.
struct Miss {
  Vec3 move{0.0};
  Vec3 turn{0.0}; ///< Rotation vector.
};

Vec3 vectorOfTurn(const Quat& turn) {
  const Quat shorter = turn.w < 0.0 ? -turn : turn;
  const Vec3 sine(shorter.x, shorter.y, shorter.z);
  const double length = glm::length(sine);
  return length > 0.0 ? sine * (2.0 * std::atan2(length, shorter.w) / length) : Vec3(0.0);
}

Miss missOf(const rig::PlacedController& placed, const SeenController& goal) {
  Miss miss;
  if (placed.moves) {
    miss.move = goal.placeWorld - placed.placeWorld;
  }
  if (placed.turns) {
    miss.turn = vectorOfTurn(goal.turnWorld * glm::inverse(placed.orientationWorld));
  }
  // The distance of a pole says nothing: only how it stands about its joint.
  if (placed.jointWorld && angleBetween(placed.placeWorld - *placed.jointWorld,
                                        goal.placeWorld - *placed.jointWorld) < thereRadians) {
    miss.move = Vec3(0.0);
  }
  return miss;
}

class Poser {
public:
  Poser(Session& session, const SeenPose& pose)
      : session_(session), view_(session.view()), pose_(pose), posed_(session.document()),
        range_(seenPoseRange(session)), thereUnits_(1e-6 * session.document().body.height) {
    for (const rig::PlacedController& placed : placedNow()) {
      if (placed.kind == rig::ControllerKind::hips) {
        standing_ = {placed.placeWorld.x, 0.0, placed.placeWorld.z};
      }
    }
  }

  Result<PosedAsSeen> run() {
    if (const Status valued = takeValues(); !valued) {
      return valued.error();
    }
    constexpr int mostPasses = 8; // A finger's joints stand on one another.
    for (int rank = 0; rank <= lastRank; ++rank) {
      for (int pass = 0; pass < mostPasses; ++pass) {
        const std::optional<Status> corrected = correct(rank);
        if (!corrected) {
          break;
        }
        if (!*corrected) {
          return corrected->error();
        }
      }
    }
    PosedAsSeen result;
    for (const auto& [id, offset] : offsets_) {
      if (isOther(offset)) {
        result.offsets.offsets.push_back(offset);
      }
    }
    result.offsets.values = values_;
    result.missed = missed();
    return result;
  }

private:
  [[nodiscard]] double seconds() const { return view_.frame / clipOf(posed_, view_.clip).framesPerSecond; }
  const std::vector<rig::PlacedController>& placedNow() {
    return cache_.controllers(posed_, view_.clip, seconds());
  }
  std::vector<SeenController> goals(const std::vector<rig::PlacedController>& placed) {
    const FrameState& shown = cache_.frame(posed_, view_.clip, seconds());
    return goalsOn({posed_, view_.clip, view_.frame, placed, shown}, pose_, standing_);
  }

  /// Attributes come first: how long a limb gets decides where its end is.
  Status takeValues() {
    const rig::ControllerList list = controllersOf(posed_);
    for (const AttributeValue& value : pose_.values) {
      if (list.attribute(value.id) != nullptr && shownValue(session_, value.id) != value.value) {
        values_.push_back(value);
      }
    }
    return values_.empty() ? Status(Success{}) : pose();
  }

  /// Nothing where all of this rank are there.
  std::optional<Status> correct(int rank) {
    const std::vector<rig::PlacedController> placed = placedNow();
    bool any = false;
    for (const SeenController& goal : goals(placed)) {
      const auto now = std::ranges::find(placed, goal.id, &rig::PlacedController::id);
      const Miss miss = missOf(*now, goal);
      if (rankOf(now->kind) == rank &&
          (glm::length(miss.move) > thereUnits_ || glm::length(miss.turn) > thereRadians)) {
        add(*now, miss);
        any = true;
      }
    }
    return any ? std::optional(pose()) : std::nullopt;
  }

  void add(const rig::PlacedController& placed, const Miss& miss) {
    ControllerOffset& offset =
        offsets_.try_emplace(placed.id, shownOffset(session_, placed.id)).first->second;
    const Mat3 toCarrier = glm::transpose(placed.carrierAxesWorld);
    if (miss.move != Vec3(0.0)) {
      offset.move += placed.slack + toCarrier * miss.move;
    }
    offset.turn = turnedFurther(offset.turn, toCarrier * miss.turn);
  }

  /// What was off only until the pose had come to what carries it needs no key.
  [[nodiscard]] bool isOther(const ControllerOffset& offset) const {
    constexpr double rounding = 1e-12;
    const ControllerOffset shown = shownOffset(session_, offset.id);
    return glm::length(offset.move - shown.move) > rounding * posed_.body.height ||
           glm::length(offset.turn - shown.turn) > rounding;
  }

  Status pose() {
    std::vector<ControllerOffset> all;
    for (const auto& [id, offset] : offsets_) {
      all.push_back(offset);
    }
    Result<Document> posed = setOffsets(session_.document(), view_.clip, view_.frame, all, values_, range_);
    if (!posed) {
      return posed.error();
    }
    posed_ = std::move(posed).value();
    return Success{};
  }

  std::vector<std::string> missed() {
    constexpr double missedHeights = 2e-3;
    const std::vector<rig::PlacedController> placed = placedNow();
    std::vector<std::string> ids;
    for (const SeenController& goal : goals(placed)) {
      const auto now = std::ranges::find(placed, goal.id, &rig::PlacedController::id);
      const Miss miss = missOf(*now, goal);
      if (!now->jointWorld && (glm::length(miss.move) > missedHeights * posed_.body.height ||
                               glm::length(miss.turn) > missedRadians)) {
        ids.push_back(goal.id);
      }
    }
    return ids;
  }

  Session& session_;
  const ViewState& view_;
  const SeenPose& pose_;
  Document posed_;
  KeyRange range_; // looked for once: a clip may have millions of keys
  double thereUnits_;
  Vec3 standing_{0.0};
  EvaluationCache cache_;
  std::map<std::string, ControllerOffset> offsets_;
  std::vector<AttributeValue> values_;
};

} // namespace

SeenPose seenAtPlayhead(Session& session, std::span<const std::string> ids) {
  const ViewState& view = session.view();
  SeenPose pose = seenPose({session.document(), view.clip, view.frame, session.controllersAt(view.frame),
                            session.frameAt(view.frame)},
                           ids);
  const rig::ControllerList list = controllersOf(session.document());
  for (const SeenController& seen : pose.controllers) {
    const rig::Controller* const controller = list.controller(seen.id);
    for (const rig::Attribute& attribute :
         controller != nullptr ? attributesHeldBy(list, *controller) : std::vector<rig::Attribute>{}) {
      pose.values.push_back({attribute.id, shownValue(session, attribute.id)});
    }
  }
  return pose;
}

std::string missedText(const Document& document, const std::vector<std::string>& missed) {
  if (missed.empty()) {
    return {};
  }
  std::vector<std::string> titles;
  std::ranges::transform(missed, std::back_inserter(titles),
                         [&](const std::string& id) { return controllerTitle(document, id); });
  return fmt::format("the {} {} held elsewhere", listed(titles), missed.size() == 1 ? "is" : "are");
}

Result<PosedAsSeen> posedAsSeen(Session& session, const SeenPose& pose) {
  return Poser(session, pose).run();
}

} // namespace stretch::app
