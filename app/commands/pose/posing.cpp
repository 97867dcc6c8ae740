#include "app/commands/pose/posing.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/core.h>

#include "app/commands/table/frames.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/pose_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

/// "the left hand and left elbow", "4 controllers".
std::string titlesOf(const Document& document, std::span<const std::string> ids) {
  constexpr std::size_t mostNamed = 3;
  if (ids.size() > mostNamed) {
    return fmt::format("{} controllers", ids.size());
  }
  std::vector<std::string> titles;
  for (const std::string& id : ids) {
    titles.push_back(controllerTitle(document, id));
  }
  return "the " + listed(titles);
}

/// Remembers what is shown and keyed nowhere; what cannot be done is refused as for a key.
Status poseWithoutKey(Session& session, const OffsetPose& pose) {
  ViewState& view = session.view();
  const Result<Document> possible =
      setOffsets(session.document(), view.clip, view.frame, pose.offsets, pose.values, {});
  if (!possible) {
    return possible.error();
  }
  if (!isPosedWithoutKey(view)) {
    view.unkeyed = {view.clip, view.frame, {}, {}};
  }
  for (const ControllerOffset& offset : pose.offsets) {
    view.unkeyed.offsets[offset.id] = offset;
  }
  for (const AttributeValue& value : pose.values) {
    view.unkeyed.values[value.id] = value.value;
  }
  return Success{};
}

/// Of the adjustments of one controller that have a range: the one at the playhead, else the nearest that
/// would grow up to it. Null where there is none.
const rig::Adjustment* rangeToEnd(const Document& document, const ViewState& view, const std::string& id,
                                  bool start) {
  const rig::Adjustment* nearest = nullptr;
  double distance = 0.0;
  for (const rig::Adjustment& adjustment : document.adjustments) {
    if (adjustment.controller != id || adjustment.clip != view.clip || !adjustment.rangeFrames) {
      continue;
    }
    const Vec2 range = *adjustment.rangeFrames;
    const double away = start ? range.x - view.frame : view.frame - range.y;
    const bool possible = start ? view.frame < range.y : view.frame > range.x;
    if (possible && (nearest == nullptr || std::max(away, 0.0) < distance)) {
      nearest = &adjustment;
      distance = std::max(away, 0.0);
    }
  }
  return nearest;
}

} // namespace

void forgetUnkeyed(ViewState& view, const OffsetPose& pose) {
  for (const ControllerOffset& offset : pose.offsets) {
    view.unkeyed.offsets.erase(offset.id);
  }
  for (const AttributeValue& value : pose.values) {
    view.unkeyed.values.erase(value.id);
  }
}

KeyRange keyRange(const Session& session) {
  const ViewState& view = session.view();
  const bool holdsPlayhead = view.frame >= view.rangeStart && view.frame <= view.rangeEnd;
  if (view.wholeClip || !isRangeSet(view) || view.rangeEnd <= view.rangeStart || !holdsPlayhead) {
    return {};
  }
  const double last = lastFrame(session.document(), view.clip);
  return {Vec2(std::clamp(view.rangeStart, 0.0, last), std::clamp(view.rangeEnd, 0.0, last))};
}

KeyRange seenPoseRange(const Session& session) {
  const ViewState& view = session.view();
  const KeyRange range = keyRange(session);
  const std::vector<double> frames = keyFrames(session.document(), view.clip, {});
  if (range.rangeFrames || view.wholeClip || frames.empty()) {
    return range;
  }
  constexpr double leastSeconds = 1.0 / 6.0; // a clip may have a key on every frame
  const double least = leastSeconds * clipOf(session.document(), view.clip).framesPerSecond - frameTolerance;
  const auto after = std::ranges::lower_bound(frames, view.frame + least);
  const auto before = std::ranges::upper_bound(frames, view.frame - least);
  const Vec2 between(before == frames.begin() ? 0.0 : *(before - 1),
                     after == frames.end() ? endInFrames(clipOf(session.document(), view.clip)) : *after);
  return between.y - between.x > frameTolerance ? KeyRange{between} : KeyRange{};
}

ControllerOffset shownOffset(const Session& session, const std::string& id) {
  const ViewState& view = session.view();
  const auto unkeyed = view.unkeyed.offsets.find(id);
  return isPosedWithoutKey(view) && unkeyed != view.unkeyed.offsets.end()
             ? unkeyed->second
             : offsetAt(session.document(), view.clip, view.frame, id);
}

double shownValue(const Session& session, const std::string& id) {
  const ViewState& view = session.view();
  const auto unkeyed = view.unkeyed.values.find(id);
  return isPosedWithoutKey(view) && unkeyed != view.unkeyed.values.end()
             ? unkeyed->second
             : valueAt(session.document(), view.clip, view.frame, id);
}

std::vector<rig::Controller> selectedControllers(const Session& session) {
  const rig::ControllerList list = controllersOf(session.document());
  std::vector<rig::Controller> controllers;
  for (const std::string& id : session.view().selection.controllers()) {
    if (Result<rig::Controller> found = findController(session.document(), list, id)) {
      controllers.push_back(std::move(found).value());
    }
  }
  return controllers;
}

std::vector<rig::Attribute> attributesOf(const Session& session,
                                         std::span<const rig::Controller> controllers) {
  std::vector<rig::Attribute> attributes = controllersOf(session.document()).attributes;
  std::erase_if(attributes, [&](const rig::Attribute& attribute) {
    return std::ranges::find(controllers, attribute.limb, &rig::Controller::limb) == controllers.end();
  });
  return attributes;
}

std::vector<std::string> withAttributes(const Session& session, std::span<const std::string> controllers) {
  const rig::ControllerList list = controllersOf(session.document());
  std::vector<std::string> ids;
  for (const std::string& id : controllers) {
    const Result<rig::Controller> controller = findController(session.document(), list, id);
    if (!controller) {
      continue;
    }
    ids.push_back(id);
    for (const rig::Attribute& attribute : attributesHeldBy(list, *controller)) {
      ids.push_back(attribute.id);
    }
  }
  return ids;
}

std::vector<std::string> posedIds(const Session& session) {
  return withAttributes(session, session.view().selection.controllers());
}

std::vector<std::string> chosenControllers(const Session& session) {
  const Selection& selection = session.view().selection;
  if (selection.limbs().empty()) {
    return selection.controllers();
  }
  std::vector<std::string> ids;
  for (const rig::Controller& controller : controllersOf(session.document()).controllers) {
    if (isSelected(session, controller.limb)) {
      ids.push_back(controller.id);
    }
  }
  return ids;
}

std::string chosenText(const Session& session) {
  const std::vector<std::string> ids = chosenControllers(session);
  return ids.empty() ? "the whole character" : titlesOf(session.document(), ids);
}

OffsetPose shownPose(const Session& session, std::span<const std::string> ids) {
  const rig::ControllerList list = controllersOf(session.document());
  OffsetPose shown;
  for (const std::string& id : ids) {
    if (list.attribute(id) != nullptr) {
      shown.values.push_back({id, shownValue(session, id)});
    } else {
      shown.offsets.push_back(shownOffset(session, id));
    }
  }
  return shown;
}

std::vector<double> offsetKeyFrames(const Session& session) {
  const std::vector<std::string> ids = posedIds(session);
  std::set<double> frames;
  for (const rig::Adjustment& adjustment : session.document().adjustments) {
    if (adjustment.clip == session.view().clip &&
        std::ranges::find(ids, adjustment.controller) != ids.end()) {
      for (const rig::OffsetKey& key : adjustment.keys) {
        frames.insert(key.frame);
      }
    }
  }
  return {frames.begin(), frames.end()};
}

Status endOffsetsHere(Session& session, bool start) {
  const ViewState& view = session.view();
  Document document = session.document();
  for (const std::string& id : posedIds(session)) {
    const rig::Adjustment* const meant = rangeToEnd(document, view, id, start);
    if (meant == nullptr) {
      continue;
    }
    const Vec2 range =
        start ? Vec2(view.frame, meant->rangeFrames->y) : Vec2(meant->rangeFrames->x, view.frame);
    Result<Document> changed =
        setOffsetRange(document, view.clip, meant->keys.front().frame, {&id, 1}, {range});
    if (!changed) {
      return changed.error();
    }
    document = std::move(changed).value();
  }
  return finish(session, std::move(document), "Change the range");
}

std::optional<rig::KeyInterpolation> interpolationHere(const Session& session) {
  const ViewState& view = session.view();
  std::optional<rig::KeyInterpolation> here;
  for (const std::string& id : posedIds(session)) {
    const rig::OffsetKey* const key = offsetKeyAt(session.document(), view.clip, view.frame, id);
    if (key != nullptr && here && *here != key->interpolation) {
      return std::nullopt;
    }
    here = key == nullptr ? here : key->interpolation;
  }
  return here;
}

bool canTween(const Session& session) {
  return !tweened(session, 0.5).empty();
}

OffsetPose tweened(const Session& session, double between) {
  const ViewState& view = session.view();
  return tweenedPose(session.document(), view.clip, view.frame, posedIds(session), between);
}

bool isWholeClip(const Session& session) {
  const ViewState& view = session.view();
  for (const std::string& id : posedIds(session)) {
    if (const rig::Adjustment* const present = adjustmentAt(session.document(), view.clip, view.frame, id)) {
      return !present->rangeFrames;
    }
  }
  return !keyRange(session).rangeFrames;
}

bool endsAtOnce(const Session& session, bool first) {
  const Document& document = session.document();
  const ViewState& view = session.view();
  const rig::ControllerList list = controllersOf(document);
  const double clipEnd = first ? 0.0 : lastFrame(document, view.clip);
  const std::vector<std::string> ids = posedIds(session);
  return !sameFrame(view.frame, clipEnd) && std::ranges::any_of(ids, [&](const std::string& id) {
    const rig::Adjustment* const present = adjustmentAt(document, view.clip, view.frame, id);
    const rig::OffsetKey* const key = offsetKeyAt(document, view.clip, view.frame, id);
    if (present == nullptr || key == nullptr || !present->rangeFrames ||
        !sameFrame(first ? present->rangeFrames->x : present->rangeFrames->y, view.frame)) {
      return false;
    }
    const rig::Attribute* const attribute = list.attribute(id);
    return attribute != nullptr ? key->value != attribute->standard
                                : key->move != Vec3(0.0) || key->turn != Vec3(0.0);
  });
}

std::string heldPoseText(const Session& session) {
  const ViewState& view = session.view();
  const std::vector<rig::Adjustment>& all = session.document().adjustments;
  const auto isHere = [&](const rig::Adjustment& adjustment) {
    return adjustment.clip == view.clip &&
           std::ranges::any_of(adjustment.keys,
                               [&](const rig::OffsetKey& key) { return sameFrame(key.frame, view.frame); });
  };
  const auto ranged = std::ranges::find_if(
      all, [&](const rig::Adjustment& adjustment) { return isHere(adjustment) && adjustment.rangeFrames; });
  const auto held = std::ranges::find_if(all, [&](const rig::Adjustment& adjustment) {
    return isHere(adjustment) && !adjustment.rangeFrames && adjustment.keys.size() == 1;
  });
  if (!view.autoKey || keyRange(session).rangeFrames || (ranged == all.end() && held == all.end())) {
    return {};
  }
  return ranged != all.end()
             ? fmt::format(
                   "The pose comes in from frame {:g} and is gone at {:g}; a range set before says otherwise",
                   ranged->rangeFrames->x, ranged->rangeFrames->y)
             : "The pose is held over the whole clip: a second key, or a range set before, ends it";
}

namespace {

Status keyPoseIn(Session& session, const OffsetPose& pose, const std::string& label, const Document& document,
                 const KeyRange& range) {
  ViewState& view = session.view();
  Status done = finish(session, setOffsets(document, view.clip, view.frame, pose.offsets, pose.values, range),
                       label.c_str());
  if (done) {
    forgetUnkeyed(view, pose);
  }
  return done;
}

Status previewIn(Session& session, const OffsetPose& pose, const Document& document, const KeyRange& range) {
  const ViewState& view = session.view();
  Result<Document> keyed = setOffsets(document, view.clip, view.frame, pose.offsets, pose.values, range);
  if (!keyed) {
    return keyed.error();
  }
  session.preview(std::move(keyed).value());
  return Success{};
}

// As far as a range goes that is to hold another one too, between those of the same controller beside it.
Vec2 widened(const Document& document, const rig::Adjustment& present, const Vec2& wanted) {
  const Vec2 range = *present.rangeFrames;
  Vec2 wide(std::min(range.x, wanted.x), std::max(range.y, wanted.y));
  for (const rig::Adjustment& other : document.adjustments) {
    if (other.controller != present.controller || other.clip != present.clip || !other.rangeFrames) {
      continue;
    }
    wide.y = other.rangeFrames->x >= range.y ? std::min(wide.y, other.rangeFrames->x) : wide.y;
    wide.x = other.rangeFrames->y <= range.x ? std::max(wide.x, other.rangeFrames->y) : wide.x;
  }
  return wide;
}

// The document with time for the pose to come in and go where an earlier one ends at the playhead or shortly
// after.
Document withRoom(const Session& session, Document document, const OffsetPose& pose, const KeyRange& wanted) {
  const ViewState& view = session.view();
  std::vector<std::string> ids;
  std::ranges::transform(pose.offsets, std::back_inserter(ids), &ControllerOffset::id);
  std::ranges::transform(pose.values, std::back_inserter(ids), &AttributeValue::id);
  for (const std::string& id : ids) {
    const rig::Adjustment* const present = adjustmentAt(document, view.clip, view.frame, id);
    if (!wanted.rangeFrames || keyRange(session).rangeFrames || present == nullptr || !present->rangeFrames) {
      continue;
    }
    const KeyRange wide{widened(document, *present, *wanted.rangeFrames)};
    Result<Document> roomy = setOffsetRange(document, view.clip, view.frame, {&id, 1}, wide);
    if (roomy) {
      document = std::move(roomy).value();
    }
  }
  return document;
}

} // namespace

Status keyPose(Session& session, const OffsetPose& pose, const std::string& label) {
  return keyPoseIn(session, pose, label, session.document(), keyRange(session));
}

Status keyUnkeyedPose(Session& session) {
  if (!isPosedWithoutKey(session.view())) {
    return Success{};
  }
  if (session.isDragging()) {
    session.cancel(); // what is only tried takes no key, and a file is saved without it
  }
  const UnkeyedPose& unkeyed = session.view().unkeyed;
  OffsetPose pose;
  std::vector<std::string> ids;
  for (const auto& [id, offset] : unkeyed.offsets) {
    pose.offsets.push_back(offset);
    ids.push_back(id);
  }
  for (const auto& [id, value] : unkeyed.values) {
    pose.values.push_back({id, value});
    ids.push_back(id);
  }
  return keyPose(session, pose, poseLabel(session.document(), "Key", ids));
}

Status poseAll(Session& session, const OffsetPose& pose, const std::string& label) {
  return session.view().autoKey ? keyPose(session, pose, label) : poseWithoutKey(session, pose);
}

Status poseAsSeen(Session& session, const OffsetPose& pose, const std::string& label) {
  if (!session.view().autoKey) {
    return poseWithoutKey(session, pose);
  }
  const KeyRange range = seenPoseRange(session);
  return keyPoseIn(session, pose, label, withRoom(session, session.document(), pose, range), range);
}

Status previewPose(Session& session, const OffsetPose& pose) {
  return session.view().autoKey ? previewIn(session, pose, session.atBegin(), keyRange(session))
                                : poseWithoutKey(session, pose);
}

Status previewAsSeen(Session& session, const OffsetPose& pose) {
  const KeyRange range = seenPoseRange(session);
  return previewIn(session, pose, withRoom(session, session.atBegin(), pose, range), range);
}

std::string poseLabel(const Document& document, const std::string& verb, std::span<const std::string> ids) {
  return verb + " " + titlesOf(document, ids);
}

} // namespace stretch::app
