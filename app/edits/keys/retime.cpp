#include "app/edits/keys/retime.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "app/edits/keys/key_edits.h"
#include "app/named.h"
#include "app/things/place.h"
#include "app/things/time_map.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

constexpr double roundedFrames = 1e-4; ///< A retimed frame that comes so near to a whole one is on it.

void mapKey(const TimeMap& map, bool hasSlopes, RowKey& key) {
  const double frame = key.frame;
  const bool comesIn = map.isInside(frame) && frame > map.first + frameTolerance;
  const bool goesOut = map.isInside(frame) && frame < map.last - frameTolerance;
  for (std::size_t i = 0; i < mostComponents && hasSlopes; ++i) {
    key.inSlopes[i] /= comesIn ? map.factor : 1.0;
    key.outSlopes[i] /= goesOut ? map.factor : 1.0;
  }
  key.slopesChanged = key.slopesChanged || (hasSlopes && (comesIn || goesOut));
  key.frame = map(frame);
}

// Rows that have keys on both sides of a frame get one there.
Result<Document> withKeysAt(const Document& document, int clip, const std::vector<KeyRow>& rows,
                            double frame) {
  std::vector<KeyRow> spanning;
  for (const KeyRow& row : rows) {
    const std::vector<double> frames = keyFramesOf(document, clip, row);
    if (!frames.empty() && frames.front() < frame && frames.back() > frame) {
      spanning.push_back(row);
    }
  }
  if (spanning.empty()) {
    return document;
  }
  Result<EditedKeys> inserted = insertKeys(document, clip, spanning, frame);
  return inserted ? Result<Document>(std::move(inserted->document)) : Result<Document>(inserted.error());
}

Result<Document> withRow(const Document& document, int clip, const KeyRow& which, const TimeMap& map) {
  KeyedRow row = readRow(document, clip, which);
  // What a slower range comes to cover falls on its end, where the first key stays: the one from its old end,
  // or of a row that only moves later the one that it was held at.
  for (RowKey& key : row.keys) {
    mapKey(map, row.interpolation == Interpolation::cubicSpline, key);
  }
  return writeRow(document, clip, row);
}

bool isOfLimb(const rig::ControllerList& list, const std::string& limb, const std::string& id) {
  const rig::Controller* const controller = list.controller(id);
  const rig::Attribute* const attribute = list.attribute(id);
  return limb.empty() || (controller != nullptr && controller->limb == limb) ||
         (attribute != nullptr && attribute->limb == limb);
}

// Of one limb only what its controllers are given.
void mapThings(const TimeMap& map, int clip, const std::string& limb, Document& document) {
  const rig::ControllerList controllers = controllersOf(document);
  eachList(document, [&](auto& list) {
    using T = typename std::remove_cvref_t<decltype(list)>::value_type;
    list = mappedList(list, map, [&](const T& thing) {
      return thing.clip == clip &&
             (limb.empty() || (isThing<T, rig::Adjustment> && isOfLimb(controllers, limb, subjectOf(thing))));
    });
  });
}

std::vector<KeyRow> rowsOf(const Document& document, int clip, const std::string& limbId) {
  std::vector<KeyRow> rows = keyedRows(document, clip);
  const rig::Limb* const limb = findLimb(document, limbId);
  std::set<NodeIndex> nodes;
  if (limb != nullptr) {
    nodes.insert(limb->joints.begin(), limb->joints.end());
    nodes.insert(limb->endNode);
  }
  std::erase_if(rows, [&](const KeyRow& row) {
    return row.isOffset() || (limb != nullptr && nodes.count(row.node) == 0);
  });
  return rows;
}

Status checkRetime(const Document& document, const Retime& wanted) {
  constexpr double longest = 1e6; // frames
  const double frames = wanted.lastFrame - wanted.firstFrame;
  const bool sound = std::isfinite(frames + wanted.newFrames) && wanted.firstFrame >= 0.0 &&
                     frames >= frameTolerance && wanted.newFrames >= frameTolerance &&
                     wanted.newFrames <= longest;
  if (!sound) {
    return Error{"the range has no length, or none that it could get", "",
                 "choose a range of frames and a new length above 0"};
  }
  if (!wanted.limb.empty() && findLimb(document, wanted.limb) == nullptr) {
    return Error{"there is no such limb", wanted.limb, "select a limb, or retime the whole body"};
  }
  return Success{};
}

} // namespace

Result<Document> retimed(const Document& document, int clip, const Retime& wanted) {
  if (const Status sound = checkRetime(document, wanted); !sound) {
    return sound.error();
  }
  const double length = wanted.lastFrame - wanted.firstFrame;
  const TimeMap map{wanted.firstFrame, wanted.lastFrame,  wanted.newFrames / length,
                    wanted.firstFrame, wanted.movesAfter, roundedFrames};
  const std::vector<KeyRow> rows = rowsOf(document, clip, wanted.limb);
  Result<Document> changed = withKeysAt(document, clip, rows, wanted.firstFrame);
  changed = changed ? withKeysAt(*changed, clip, rows, wanted.lastFrame) : changed;
  for (const KeyRow& row : rows) {
    changed = changed ? withRow(*changed, clip, row, map) : changed;
  }
  if (!changed) {
    return changed;
  }
  mapThings(map, clip, wanted.limb, *changed);
  const Status sound = checkThings(*changed, clip);
  // What was odd before, as a trail of a limb that the body has no more, does not stand in the way.
  return sound || !checkThings(document, clip) ? changed : Result<Document>(sound.error());
}

} // namespace stretch::app
