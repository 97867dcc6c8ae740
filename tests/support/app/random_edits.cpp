#include "tests/support/app/random_edits.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/edits/keys/key_edits.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/keys/retime.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/pose/offset_edits.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/mirror_edits.h"
#include "app/edits/trail/name_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/edits/trail/style_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"

namespace stretch::test {

namespace {

using namespace app;

Document orUnchanged(const Document& document, const Result<Document>& edited) {
  return edited ? *edited : document;
}

Document newTrail(const Document& document, Dice& dice) {
  NewTrail wanted;
  const auto limb = static_cast<std::size_t>(dice.below(static_cast<int>(document.body.limbs.size())));
  wanted.limb = document.body.limbs[limb].id;
  wanted.clip = 0;
  wanted.settings.startFrame = dice.below(10);
  wanted.settings.endFrame = wanted.settings.startFrame + 1 + dice.below(10);
  wanted.settings.scale = 0.5 + 0.5 * dice.below(6);
  const Result<CreatedTrail> created = createTrail(document, wanted);
  return created ? created->document : document;
}

Document randomWeight(const Document& document, Dice& dice) {
  const auto index = static_cast<std::size_t>(dice.below(static_cast<int>(document.body.limbs.size())));
  const std::string& limb = document.body.limbs[index].id;
  if (dice.below(3) == 0) {
    return removeWeight(document, limb, 0);
  }
  WeightedLimb entry{limb, 0, dice.below(4) > 0, {}};
  entry.settings.stiffness = 0.25 * (1 + dice.below(8));
  return orUnchanged(document, setWeight(document, entry));
}

/// One of the edits of offset keys.
Document randomPose(const Document& document, const std::string& controller, Dice& dice) {
  const double frame = dice.below(20);
  const std::vector<std::string> ids{controller, "left-arm.stretch"};
  const KeyRange range =
      dice.below(2) == 0 ? KeyRange{} : KeyRange{Vec2(dice.below(10), 10 + dice.below(10))};
  switch (dice.below(6)) {
  case 0:
    return removeOffsetKeys(document, 0, frame, ids);
  case 1:
    return orUnchanged(document, resetOffsets(document, 0, frame, ids));
  case 2:
    return orUnchanged(document, resetOffsetsOver(document, 0, {frame, frame + 5.0}, ids));
  case 3:
    return setKeyInterpolation(document, 0, frame, ids,
                               dice.below(2) == 0 ? rig::KeyInterpolation::free
                                                  : rig::KeyInterpolation::stepped);
  case 4:
    return orUnchanged(document, setOffsetRange(document, 0, frame, ids, range));
  default:
    break;
  }
  const std::vector<ControllerOffset> offsets{{controller, {0.0, 0.01 * dice.below(10), 0.0}, {}}};
  const std::vector<AttributeValue> values{{"left-arm.stretch", 0.1 * dice.below(10)}};
  return orUnchanged(document, setOffsets(document, 0, frame, offsets, values, range));
}

Document randomAdjustment(const Document& document, Dice& dice) {
  const std::vector<std::string> controllers{"hips", "left-hand", "right-elbow", "spine-top"};
  rig::Adjustment adjustment;
  adjustment.controller = controllers[static_cast<std::size_t>(dice.below(4))];
  if (dice.below(4) == 0) {
    return removeAdjustments(document, adjustment.controller, 0);
  }
  if (dice.below(2) == 0) {
    return randomPose(document, adjustment.controller, dice);
  }
  rig::OffsetKey key;
  key.frame = dice.below(20);
  key.move = {0.01 * dice.below(10), 0.02, 0.0};
  adjustment.keys = {key};
  return orUnchanged(document, placeAdjustments(document, {&adjustment, 1}));
}

// Keys of the clip and of controllers, by whatever edit.
Document randomKeys(const Document& document, Dice& dice) {
  const std::vector<KeyRow> rows = keyedRows(document, 0);
  if (rows.empty()) {
    return document;
  }
  const KeyRow& row = rows[static_cast<std::size_t>(dice.below(static_cast<int>(rows.size())))];
  const double from = dice.below(20);
  const KeySelection picked = keysBetween(document, 0, {&row, 1}, from, from + dice.below(12));
  const auto edited = [&](const Result<EditedKeys>& result) { return result ? result->document : document; };
  switch (dice.below(9)) {
  case 0:
    return edited(moveKeys(document, 0, picked, {0.5 * dice.below(8) - 2.0, 3.0 * dice.below(3)}));
  case 1:
    return edited(scaleKeys(document, 0, picked, {from, 0.25 * (1 + dice.below(6)), 0.0, 1.5}));
  case 2:
    return edited(insertKeys(document, 0, {&row, 1}, 0.5 * dice.below(40)));
  case 3:
    return edited(removeKeys(document, 0, picked));
  case 4:
    return edited(pasteKeys(document, 0, copyKeys(document, 0, picked), dice.below(20), {}));
  case 5:
    return edited(setKeyKind(document, 0, picked, static_cast<rig::KeyInterpolation>(dice.below(5))));
  case 6:
    return edited(snapKeys(document, 0, picked));
  case 7:
    return orUnchanged(document,
                       retimed(document, 0, {from, from + 3.0, 1.0 + dice.below(6), dice.below(2) == 0, {}}));
  default:
    return restoreAllTracks(document);
  }
}

Document randomHold(const Document& document, Dice& dice) {
  if (dice.below(3) == 0) {
    return removeHold(document, {dice.below(2) == 0 ? rig::HoldKind::pin : rig::HoldKind::grip, 0});
  }
  const double start = dice.below(10);
  rig::HoldTime time{{start, start + 1 + dice.below(8)}, {dice.below(3), dice.below(3)}};
  rig::Holds wanted;
  if (dice.below(2) == 0) {
    rig::Pin pin{dice.below(2) == 0 ? "left-arm" : "right-leg", 0, time, start, {}, true, 1.0};
    wanted.pins.push_back(pin);
  } else {
    const bool leftLeads = dice.below(2) == 0;
    wanted.grips.push_back({leftLeads ? "right-arm" : "left-arm", leftLeads ? "left-arm" : "right-arm", 0,
                            time, dice.below(2) == 0 ? std::optional(start) : std::nullopt, 1.0});
  }
  return orUnchanged(document, placeHolds(document, wanted));
}

// A thing in one hand or in both, and who holds it.
Document randomProp(const Document& document, Dice& dice) {
  if (document.scene->nodes.empty() || dice.below(3) == 0) {
    return removeHold(document, {rig::HoldKind::prop, 0});
  }
  rig::Prop prop;
  prop.node = "#" + std::to_string(dice.below(static_cast<int>(document.scene->nodes.size())));
  prop.boundFrame = dice.below(2) == 0 ? std::optional<double>(dice.below(10)) : std::nullopt;
  rig::OffsetKey firm;
  firm.value = 1.0;
  prop.hands = {{dice.below(2) == 0 ? "left-arm" : "right-arm", {firm}}};
  prop.move = {0.0, 0.01 * dice.below(10), 0.0};
  rig::Holds wanted;
  wanted.props = {prop};
  return orUnchanged(document, placeHolds(document, wanted));
}

// Names, groups, styles, the other side, the rate that frames are counted in.
Document randomOrder(const Document& document, const rig::Trail& trail, Dice& dice) {
  std::vector<int> ids;
  for (const rig::Trail& other : document.trails) {
    ids.push_back(other.id);
  }
  switch (dice.below(6)) {
  case 0:
    return orUnchanged(document, renameTrail(document, trail.id, dice.below(2) == 0 ? "a blow" : ""));
  case 1:
    return orUnchanged(document, groupTrails(document, ids));
  case 2:
    return orUnchanged(document, renameGroup(document, trail.id, "all"));
  case 3:
    return orUnchanged(
        document,
        applyStyle(document, ids, rig::builtInStyles().at(static_cast<std::size_t>(dice.below(11)))));
  case 4: {
    const Result<CreatedTrail> mirrored = mirrorTrail(document, trail);
    return mirrored ? mirrored->document : document;
  }
  default:
    return workAtRate(document, 0, dice.below(2) == 0 ? 24.0 : ownRate(document, 0));
  }
}

} // namespace

Document randomEdit(const Document& document, Dice& dice) {
  if (dice.below(6) == 0) {
    return randomKeys(document, dice);
  }
  if (dice.below(10) == 0) {
    return dice.below(3) == 0 ? randomProp(document, dice) : randomHold(document, dice);
  }
  if (dice.below(6) == 0) {
    return randomAdjustment(document, dice);
  }
  if (dice.below(8) == 0) {
    return randomWeight(document, dice);
  }
  if (document.trails.empty() || dice.below(5) == 0) {
    return newTrail(document, dice);
  }
  const auto index = static_cast<std::size_t>(dice.below(static_cast<int>(document.trails.size())));
  const rig::Trail& trail = document.trails[index];
  if (dice.below(8) == 0) {
    return randomOrder(document, trail, dice);
  }
  rig::TrailSettings settings = trail.settings;
  switch (dice.below(12)) {
  case 0:
    settings.scale = 0.1 * dice.below(40);
    settings.axes[1] = dice.below(2) == 0;
    return orUnchanged(document, setTrailSettings(document, trail.id, settings));
  case 1:
    return orUnchanged(document, setFollow(document, trail.id, dice.below(2) == 0));
  case 2:
    return orUnchanged(document, setConnected(document, trail.id, dice.below(2) == 0));
  case 3:
    return orUnchanged(document, applyTrail(document, trail.id));
  case 4:
    return orUnchanged(document, setBlend(document, trail.id, dice.below(3)));
  case 5:
    return orUnchanged(
        document,
        setSphereOffset(document, trail.id, {settings.startFrame, Vec3(0.01 * dice.below(9), 0.0, 0.02)}));
  case 6:
    return setLooping(document, 0, dice.below(2) == 0);
  case 7:
    settings.startFrame = dice.below(std::max(1, static_cast<int>(settings.endFrame)));
    settings.pivot = dice.below(2) == 0 ? rig::Pivot::start : rig::Pivot::end;
    return orUnchanged(document, setTrailSettings(document, trail.id, settings));
  case 8:
    settings.space = dice.below(2) == 0 ? rig::TrailSpace::world : rig::TrailSpace::base;
    settings.releaseFrames = dice.below(5);
    return orUnchanged(document, setTrailSettings(document, trail.id, settings));
  case 9:
    return orUnchanged(document, setSphereTangent(document, trail.id, settings.endFrame,
                                                  Vec3(0.0, 0.01 * dice.below(9), 0.0)));
  case 10:
    return takeApart(document, std::vector<int>{trail.id});
  default:
    return orUnchanged(document, deleteTrail(document, trail.id));
  }
}

} // namespace stretch::test
