#include "app/commands/pose/library_posing.h"

#include <algorithm>

#include "app/commands/pose/posing.h"
#include "app/commands/pose/seen_posing.h"
#include "app/named.h"

namespace stretch::app {

namespace {

/// The controllers of a pose that are chosen, with what they hold; the whole pose where none is.
SeenPose onChosen(const Session& session, SeenPose pose) {
  const std::vector<std::string> ids = withAttributes(session, chosenControllers(session));
  if (ids.empty()) {
    return pose;
  }
  const auto isOther = [&](const auto& part) { return std::ranges::find(ids, part.id) == ids.end(); };
  std::erase_if(pose.controllers, isOther);
  std::erase_if(pose.values, isOther);
  return pose;
}

bool hasAny(const Session& session, const SeenPose& pose) {
  const rig::ControllerList list = controllersOf(session.document());
  return std::ranges::any_of(pose.controllers, [&](const SeenController& seen) {
    return findController(session.document(), list, seen.id).ok();
  });
}

} // namespace

Result<PoseBlend> blendInto(Session& session, const SeenPose& pose) {
  const SeenPose wanted = onChosen(session, pose);
  if (!hasAny(session, wanted)) {
    const bool isWhole = chosenControllers(session).empty();
    return isWhole ? Error{"this character has none of the pose's controllers", "", "take another pose"}
                   : Error{"the pose has none of the selected controllers", "",
                           "select others, or none for the whole character"};
  }
  Result<PosedAsSeen> posed = posedAsSeen(session, wanted);
  if (!posed) {
    return posed.error();
  }
  if (posed->offsets.empty()) {
    return Error{"the character stands so already", "", "move the playhead, or take another pose"};
  }
  PoseBlend blend{{}, std::move(posed->offsets), std::move(posed->missed)};
  for (const ControllerOffset& offset : blend.to.offsets) {
    blend.from.offsets.push_back(shownOffset(session, offset.id));
  }
  for (const AttributeValue& value : blend.to.values) {
    blend.from.values.push_back({value.id, shownValue(session, value.id)});
  }
  return blend;
}

OffsetPose blended(const PoseBlend& blend, double amount) {
  OffsetPose pose = blend.to;
  for (std::size_t i = 0; i < pose.offsets.size(); ++i) {
    const ControllerOffset& from = blend.from.offsets[i];
    pose.offsets[i].move = from.move + amount * (pose.offsets[i].move - from.move);
    pose.offsets[i].turn = from.turn + amount * (pose.offsets[i].turn - from.turn);
  }
  for (std::size_t i = 0; i < pose.values.size(); ++i) {
    const double from = blend.from.values[i].value;
    pose.values[i].value = from + amount * (pose.values[i].value - from);
  }
  return pose;
}

} // namespace stretch::app
