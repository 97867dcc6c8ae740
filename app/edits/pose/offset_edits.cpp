#include "app/edits/pose/offset_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "core/anim/frames.h"
#include "rig/controllers/offset_curve.h"

namespace stretch::app {

namespace {

constexpr double endlessFrames = std::numeric_limits<double>::infinity();

/// Of what is adjusted: the standard value of an attribute, 0 of a controller.
double standardOf(const rig::ControllerList& list, const std::string& id) {
  const rig::Attribute* const attribute = list.attribute(id);
  return attribute == nullptr ? 0.0 : attribute->standard;
}

Vec2 framesOf(const rig::Adjustment& adjustment) {
  return adjustment.rangeFrames.value_or(Vec2(-endlessFrames, endlessFrames));
}

bool holdsFrame(const rig::Adjustment& adjustment, double frame) {
  const Vec2 frames = framesOf(adjustment);
  return isWithinFrames(frames.x, frames.y, frame);
}

template <typename Keys>
auto keyIn(Keys& keys, double frame) {
  return std::ranges::find_if(keys, [&](const rig::OffsetKey& key) { return sameFrame(key.frame, frame); });
}

rig::Offset offsetIn(const Document& document, const rig::Adjustment& adjustment, double frame,
                     double standard) {
  const double rate = clipOf(document, adjustment.clip).framesPerSecond;
  return rig::OffsetCurve(adjustment, standard, rate).at(frame / rate);
}

rig::OffsetKey keyOfOffset(double frame, const rig::Offset& offset) {
  rig::OffsetKey key;
  key.frame = frame;
  key.move = offset.move;
  key.turn = offset.turn;
  key.value = offset.value;
  return key;
}

/// Sets the numbers of the key at its frame, or puts it in.
void putKey(rig::Adjustment& adjustment, const rig::OffsetKey& key) {
  const auto present = keyIn(adjustment.keys, key.frame);
  if (present != adjustment.keys.end()) {
    present->move = key.move;
    present->turn = key.turn;
    present->value = key.value;
    return;
  }
  const auto after =
      std::ranges::find_if(adjustment.keys, [&](const auto& other) { return other.frame > key.frame; });
  adjustment.keys.insert(after, key);
}

/// The frames around one in which nothing of the same is adjusted; infinite where nothing is beside it.
Vec2 roomAround(const Document& document, int clip, double frame, const std::string& id) {
  Vec2 room(-endlessFrames, endlessFrames);
  for (const rig::Adjustment& other : document.adjustments) {
    if (other.controller == id && other.clip == clip) {
      const Vec2 taken = framesOf(other);
      room.x = taken.y < frame ? std::max(room.x, taken.y) : room.x;
      room.y = taken.x > frame ? std::min(room.y, taken.x) : room.y;
    }
  }
  return room;
}

/// A first key. On the whole clip it is held up to what else adjusts the same, and to the ends of the clip.
Result<rig::Adjustment> firstKey(const Document& document, int clip, const rig::OffsetKey& key,
                                 const std::string& id, const KeyRange& range) {
  const Vec2 room = roomAround(document, clip, key.frame, id);
  rig::Adjustment adjustment{id, clip, range.rangeFrames, {key}};
  if (range.rangeFrames) {
    if (!holdsFrame(adjustment, key.frame)) {
      return Error{fmt::format("frame {:g} lies outside of the range {:g} to {:g}", key.frame,
                               range.rangeFrames->x, range.rangeFrames->y),
                   id, "move the playhead into the range, or forget the range"};
    }
    adjustment.rangeFrames =
        Vec2(std::max(range.rangeFrames->x, room.x), std::min(range.rangeFrames->y, room.y));
    return adjustment;
  }
  if (room == Vec2(-endlessFrames, endlessFrames)) {
    return adjustment;
  }
  const Vec2 ends(0.0, std::max(key.frame, lastFrame(clipOf(document, clip))));
  adjustment.rangeFrames = Vec2(std::max(room.x, ends.x), std::min(room.y, ends.y));
  for (const double end : {ends.x, ends.y}) {
    if (room.x < end && end < room.y) {
      rig::OffsetKey held = key;
      held.frame = end;
      putKey(adjustment, held);
    }
  }
  return adjustment;
}

/// What adjusts each of `ids` at the frame, changed; without keys it is gone.
template <typename Change>
Document changedAt(const Document& document, int clip, double frame, std::span<const std::string> ids,
                   Change&& change) {
  Document changed = document;
  for (const std::string& id : ids) {
    const rig::Adjustment* const found = adjustmentAt(document, clip, frame, id);
    if (found != nullptr) {
      change(changed.adjustments[static_cast<std::size_t>(found - document.adjustments.data())]);
    }
  }
  std::erase_if(changed.adjustments, [](const rig::Adjustment& one) { return one.keys.empty(); });
  return changed;
}

/// Its slope is that of the curve around it, as far as the range goes.
void makeFree(const Document& document, const rig::Adjustment& adjustment, rig::OffsetKey& key) {
  constexpr double step = 1e-3; // frames
  const Vec2 range = framesOf(adjustment);
  const double from = std::max(range.x, key.frame - step);
  const double to = std::min(range.y, key.frame + step);
  const rig::Offset before = offsetIn(document, adjustment, from, key.value);
  const rig::Offset after = offsetIn(document, adjustment, to, key.value);
  key.moveSlope = (after.move - before.move) / (to - from);
  key.turnSlope = (after.turn - before.turn) / (to - from);
  key.valueSlope = (after.value - before.value) / (to - from);
}

bool isAtRest(const rig::Offset& offset, double standard) {
  return offset.move == Vec3(0.0) && offset.turn == Vec3(0.0) && offset.value == standard;
}

} // namespace

const rig::Adjustment* adjustmentAt(const Document& document, int clip, double frame, const std::string& id) {
  const rig::Adjustment* found = nullptr;
  for (const rig::Adjustment& adjustment : document.adjustments) {
    if (adjustment.controller != id || adjustment.clip != clip || !holdsFrame(adjustment, frame)) {
      continue;
    }
    if (keyIn(adjustment.keys, frame) != adjustment.keys.end()) {
      return &adjustment;
    }
    found = found == nullptr ? &adjustment : found;
  }
  return found;
}

const rig::OffsetKey* offsetKeyAt(const Document& document, int clip, double frame, const std::string& id) {
  const rig::Adjustment* const adjustment = adjustmentAt(document, clip, frame, id);
  if (adjustment == nullptr) {
    return nullptr;
  }
  const auto key = keyIn(adjustment->keys, frame);
  return key == adjustment->keys.end() ? nullptr : &*key;
}

ControllerOffset offsetAt(const Document& document, int clip, double frame, const std::string& id) {
  const rig::Adjustment* const adjustment = adjustmentAt(document, clip, frame, id);
  if (adjustment == nullptr) {
    return {id, Vec3(0.0), Vec3(0.0)};
  }
  const rig::Offset offset = offsetIn(document, *adjustment, frame, 0.0);
  return {id, offset.move, offset.turn};
}

double valueAt(const Document& document, int clip, double frame, const std::string& id) {
  const rig::ControllerList list = controllersOf(document);
  const rig::Attribute* const attribute = list.attribute(id);
  const rig::Adjustment* const adjustment = adjustmentAt(document, clip, frame, id);
  if (attribute == nullptr || adjustment == nullptr) {
    return standardOf(list, id);
  }
  const rig::Offset offset = offsetIn(document, *adjustment, frame, attribute->standard);
  return std::clamp(offset.value, attribute->minimum, attribute->maximum);
}

std::vector<std::string> adjustedIds(const Document& document, int clip) {
  std::vector<std::string> ids;
  for (const rig::Adjustment& adjustment : document.adjustments) {
    if (adjustment.clip == clip && std::ranges::find(ids, adjustment.controller) == ids.end()) {
      ids.push_back(adjustment.controller);
    }
  }
  return ids;
}

Result<Document> setOffsets(const Document& document, int clip, double frame,
                            std::span<const ControllerOffset> offsets, std::span<const AttributeValue> values,
                            const KeyRange& range) {
  std::vector<rig::Adjustment> wanted;
  const auto add = [&](const std::string& id, const rig::Offset& offset) -> Status {
    const rig::OffsetKey key = keyOfOffset(frame, offset);
    if (const rig::Adjustment* const present = adjustmentAt(document, clip, frame, id)) {
      wanted.push_back(*present);
      putKey(wanted.back(), key);
      return Success{};
    }
    Result<rig::Adjustment> first = firstKey(document, clip, key, id, range);
    if (!first) {
      return first.error();
    }
    wanted.push_back(std::move(first).value());
    return Success{};
  };
  if (document.clips == nullptr || clip < 0 || static_cast<std::size_t>(clip) >= document.clips->size()) {
    return Error{"the file has no such clip", fmt::format("clip {}", clip), "open a file with an animation"};
  }
  for (const ControllerOffset& offset : offsets) {
    if (const Status added = add(offset.id, {offset.move, offset.turn, 0.0}); !added) {
      return added.error();
    }
  }
  for (const AttributeValue& value : values) {
    if (const Status added = add(value.id, {Vec3(0.0), Vec3(0.0), value.value}); !added) {
      return added.error();
    }
  }
  return placeAdjustments(document, wanted);
}

Document removeOffsetKeys(const Document& document, int clip, double frame,
                          std::span<const std::string> ids) {
  return changedAt(document, clip, frame, ids, [&](rig::Adjustment& adjustment) {
    std::erase_if(adjustment.keys, [&](const rig::OffsetKey& key) { return sameFrame(key.frame, frame); });
  });
}

Result<Document> resetOffsets(const Document& document, int clip, double frame,
                              std::span<const std::string> ids) {
  const rig::ControllerList list = controllersOf(document);
  return changedAt(removeOffsetKeys(document, clip, frame, ids), clip, frame, ids,
                   [&](rig::Adjustment& adjustment) {
                     const double standard = standardOf(list, adjustment.controller);
                     if (!isAtRest(offsetIn(document, adjustment, frame, standard), standard)) {
                       putKey(adjustment, keyOfOffset(frame, {Vec3(0.0), Vec3(0.0), standard}));
                     }
                   });
}

Result<Document> resetOffsetsOver(const Document& document, int clip, const Vec2& frames,
                                  std::span<const std::string> ids) {
  const rig::ControllerList list = controllersOf(document);
  Document changed = document;
  for (rig::Adjustment& adjustment : changed.adjustments) {
    const bool meant = adjustment.clip == clip && std::ranges::find(ids, adjustment.controller) != ids.end();
    const Vec2 range = framesOf(adjustment);
    if (!meant || range.y < frames.x || range.x > frames.y) {
      continue;
    }
    std::erase_if(adjustment.keys,
                  [&](const rig::OffsetKey& key) { return isWithinFrames(frames.x, frames.y, key.frame); });
    const double standard = standardOf(list, adjustment.controller);
    for (const double end : {frames.x, frames.y}) {
      if (!adjustment.keys.empty() && range.x < end && end < range.y) {
        rig::OffsetKey rest = keyOfOffset(end, {Vec3(0.0), Vec3(0.0), standard});
        rest.interpolation = rig::KeyInterpolation::flat;
        putKey(adjustment, rest);
      }
    }
  }
  std::erase_if(changed.adjustments, [](const rig::Adjustment& one) { return one.keys.empty(); });
  return changed;
}

Document setKeyInterpolation(const Document& document, int clip, double frame,
                             std::span<const std::string> ids, rig::KeyInterpolation interpolation) {
  return changedAt(document, clip, frame, ids, [&](rig::Adjustment& adjustment) {
    const auto key = keyIn(adjustment.keys, frame);
    if (key == adjustment.keys.end() || key->interpolation == interpolation) {
      return;
    }
    if (interpolation == rig::KeyInterpolation::free) {
      makeFree(document, adjustment, *key);
    }
    key->interpolation = interpolation;
  });
}

Result<Document> setOffsetRange(const Document& document, int clip, double frame,
                                std::span<const std::string> ids, const KeyRange& range) {
  std::vector<rig::Adjustment> wanted;
  Document changed = document;
  for (const std::string& id : ids) {
    const rig::Adjustment* const present = adjustmentAt(document, clip, frame, id);
    if (present == nullptr) {
      continue;
    }
    wanted.push_back(*present);
    wanted.back().rangeFrames = range.rangeFrames;
    std::erase(changed.adjustments, *present);
    const Vec2 frames = framesOf(wanted.back());
    const bool meets = std::ranges::any_of(changed.adjustments, [&](const rig::Adjustment& other) {
      const Vec2 taken = framesOf(other);
      return other.controller == id && other.clip == clip && frames.x < taken.y && taken.x < frames.y;
    });
    if (meets) {
      return Error{"another adjustment stands in the way", id, "reset it, or choose a shorter range"};
    }
  }
  return placeAdjustments(changed, wanted);
}

} // namespace stretch::app
