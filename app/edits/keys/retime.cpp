#include "app/edits/keys/retime.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "app/edits/keys/key_edits.h"
#include "app/edits/pose/adjustment_edits.h"

namespace stretch::app {

namespace {

// Where a frame comes to stand.
struct TimeMap {
  double first = 0.0;
  double last = 0.0;
  double factor = 1.0;
  bool movesAfter = true;

  [[nodiscard]] double newLast() const { return first + (last - first) * factor; }
  [[nodiscard]] bool isInside(double frame) const {
    return frame >= first - keyTolerance && frame <= last + keyTolerance;
  }
  [[nodiscard]] double operator()(double frame) const {
    if (frame <= first) {
      return frame;
    }
    const double there = isInside(frame) ? first + (frame - first) * factor
                         : movesAfter    ? frame + newLast() - last
                                         : frame;
    const double whole = std::round(there);
    return std::abs(there - whole) < 1e-4 ? whole : there;
  }
  // Keys after the range that the range now reaches.
  [[nodiscard]] bool givesWay(double frame) const {
    return !movesAfter && frame > last + keyTolerance && frame <= newLast() + keyTolerance;
  }
};

void mapKey(const TimeMap& map, bool hasSlopes, RowKey& key) {
  const double frame = key.frame;
  const bool comesIn = map.isInside(frame) && frame > map.first + keyTolerance;
  const bool goesOut = map.isInside(frame) && frame < map.last - keyTolerance;
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
  std::erase_if(row.keys, [&](const RowKey& key) { return map.givesWay(key.frame); });
  for (RowKey& key : row.keys) {
    mapKey(map, row.interpolation == Interpolation::cubicSpline, key);
  }
  return writeRow(document, clip, row);
}

Vec2 mapped(const TimeMap& map, const Vec2& range) {
  return {map(range.x), map(range.y)};
}

void mapOffsetKeys(const TimeMap& map, std::vector<rig::OffsetKey>& keys) {
  std::erase_if(keys, [&](const rig::OffsetKey& key) { return map.givesWay(key.frame); });
  for (rig::OffsetKey& key : keys) {
    const double slower = map.isInside(key.frame) ? map.factor : 1.0;
    key.frame = map(key.frame);
    key.moveSlope /= slower;
    key.turnSlope /= slower;
    key.valueSlope /= slower;
  }
}

void mapAdjustment(const TimeMap& map, rig::Adjustment& adjustment) {
  mapOffsetKeys(map, adjustment.keys);
  if (adjustment.rangeFrames) {
    adjustment.rangeFrames = mapped(map, *adjustment.rangeFrames);
  }
}

void mapTrail(const TimeMap& map, rig::Trail& trail) {
  rig::TrailSettings& settings = trail.settings;
  if (settings.releaseFrames) {
    settings.releaseFrames = map(settings.endFrame + *settings.releaseFrames) - map(settings.endFrame);
  }
  settings.startFrame = map(settings.startFrame);
  settings.endFrame = map(settings.endFrame);
  for (rig::SphereOffset& sphere : settings.spheres) {
    if (sphere.tangent) {
      *sphere.tangent /= map.isInside(sphere.frame) ? map.factor : 1.0;
    }
    sphere.frame = map(sphere.frame);
  }
  for (double& frame : trail.controlFrames) {
    frame = map(frame);
  }
}

void mapProp(const TimeMap& map, rig::Prop& prop) {
  if (prop.time) {
    prop.time->rangeFrames = mapped(map, prop.time->rangeFrames);
  }
  if (prop.boundFrame) {
    prop.boundFrame = map(*prop.boundFrame);
  }
  for (rig::PropHand& hand : prop.hands) {
    const rig::OffsetKey last = hand.keys.back();
    mapOffsetKeys(map, hand.keys);
    if (hand.keys.empty()) {
      hand.keys.push_back(last); // A hand that holds keeps one key.
    }
  }
}

void mapHolds(const TimeMap& map, int clip, rig::Holds& holds) {
  for (rig::Pin& pin : holds.pins) {
    if (pin.clip == clip) {
      pin.time.rangeFrames = mapped(map, pin.time.rangeFrames);
      pin.atFrame = map(pin.atFrame);
    }
  }
  for (rig::Grip& grip : holds.grips) {
    if (grip.clip == clip) {
      grip.time.rangeFrames = mapped(map, grip.time.rangeFrames);
      grip.relationFrame = grip.relationFrame ? std::optional(map(*grip.relationFrame)) : std::nullopt;
    }
  }
  for (rig::Prop& prop : holds.props) {
    if (prop.clip == clip) {
      mapProp(map, prop);
    }
  }
}

bool isOfLimb(const rig::ControllerList& list, const std::string& limb, const std::string& id) {
  const rig::Controller* const controller = list.controller(id);
  const rig::Attribute* const attribute = list.attribute(id);
  return limb.empty() || (controller != nullptr && controller->limb == limb) ||
         (attribute != nullptr && attribute->limb == limb);
}

void mapWhatStandsOnTime(const TimeMap& map, int clip, const std::string& limb, Document& document) {
  const rig::ControllerList list = controllersOf(document);
  for (rig::Adjustment& adjustment : document.adjustments) {
    if (adjustment.clip == clip && isOfLimb(list, limb, adjustment.controller)) {
      mapAdjustment(map, adjustment);
    }
  }
  std::erase_if(document.adjustments, [](const rig::Adjustment& one) { return one.keys.empty(); });
  if (limb.empty()) {
    mapHolds(map, clip, document.holds);
  }
  for (rig::Trail& trail : document.trails) {
    if (limb.empty() && trail.clip == clip) {
      mapTrail(map, trail);
    }
  }
  for (WeightedLimb& weight : document.weights) {
    if (limb.empty() && weight.clip == clip && weight.settings.rangeFrames) {
      weight.settings.rangeFrames = mapped(map, *weight.settings.rangeFrames);
    }
  }
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
                     frames >= keyTolerance && wanted.newFrames >= keyTolerance &&
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
  const TimeMap map{wanted.firstFrame, wanted.lastFrame, wanted.newFrames / length, wanted.movesAfter};
  const std::vector<KeyRow> rows = rowsOf(document, clip, wanted.limb);
  Result<Document> changed = withKeysAt(document, clip, rows, wanted.firstFrame);
  changed = changed ? withKeysAt(*changed, clip, rows, wanted.lastFrame) : changed;
  for (const KeyRow& row : rows) {
    changed = changed ? withRow(*changed, clip, row, map) : changed;
  }
  if (changed) {
    mapWhatStandsOnTime(map, clip, wanted.limb, *changed);
  }
  return changed;
}

} // namespace stretch::app
