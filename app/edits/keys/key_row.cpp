#include "app/edits/keys/key_row.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "app/edits/keys/following_keys.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/keys/track_row.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/named.h"
#include "core/anim/frames.h"
#include "core/anim/track_names.h"
#include "rig/controllers/offset_curve.h"

namespace stretch::app {

namespace {

constexpr double shownDegrees = 180.0 / pi;

const Track* trackOf(const Document& document, int clip, const KeyRow& row) {
  const Clip& shown = clipOf(document, clip);
  const int index = findTrack(shown, row.node, row.channel);
  return index < 0 ? nullptr : &*shown.tracks[at(index)];
}

int channelWidth(Channel channel) {
  return channel == Channel::rotation ? 4 : 3;
}

// Where the adjustments of the row stand in the document, in their order.
std::vector<std::size_t> adjustmentsOf(const Document& document, int clip, const KeyRow& row) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < document.adjustments.size(); ++i) {
    const rig::Adjustment& adjustment = document.adjustments[i];
    if (adjustment.clip == clip && adjustment.controller == row.controller) {
      places.push_back(i);
    }
  }
  return places;
}

RowPart partOf(const Document& document, const rig::Adjustment& adjustment) {
  const Clip& clip = clipOf(document, adjustment.clip);
  const double last = std::max(0.0, wholeFrameAtLeast(endInFrames(clip)));
  const Vec2 range = adjustment.rangeFrames.value_or(Vec2(0.0, last));
  return {range.x, range.y};
}

KeyValues shownOffset(const Vec3& move, const Vec3& turn, double value, bool isAttribute) {
  if (isAttribute) {
    return {value};
  }
  const Vec3 angles = turn * shownDegrees;
  return {move.x, move.y, move.z, angles.x, angles.y, angles.z};
}

// The offset keys of a row with the part that each belongs to, ascending by frame.
struct PlacedKey {
  const rig::OffsetKey* key = nullptr;
  int part = 0;
};
std::vector<PlacedKey> placedKeys(const Document& document, const std::vector<std::size_t>& places) {
  std::vector<PlacedKey> keys;
  for (std::size_t part = 0; part < places.size(); ++part) {
    for (const rig::OffsetKey& key : document.adjustments[places[part]].keys) {
      keys.push_back({&key, static_cast<int>(part)});
    }
  }
  std::stable_sort(keys.begin(), keys.end(),
                   [](const PlacedKey& a, const PlacedKey& b) { return a.key->frame < b.key->frame; });
  return keys;
}

struct OffsetLook {
  bool isAttribute = false;
  double standard = 0.0;
};
OffsetLook lookOf(const Document& document, const KeyRow& row) {
  const rig::ControllerList list = controllersOf(document);
  const rig::Attribute* const attribute = list.attribute(row.controller);
  return {attribute != nullptr, attribute != nullptr ? attribute->standard : 0.0};
}

KeyValues offsetValues(const rig::OffsetCurve& curve, double seconds, bool isAttribute) {
  const rig::Offset offset = curve.at(seconds);
  return shownOffset(offset.move, offset.turn, offset.value, isAttribute);
}

// How the curve comes to a key and goes on from it, for each frame.
void addOffsetSlopes(const rig::OffsetCurve& curve, double framesPerSecond, bool isAttribute, RowKey& key) {
  constexpr double step = 1e-3;
  const auto sample = [&](double frame) { return offsetValues(curve, frame / framesPerSecond, isAttribute); };
  const KeyValues before = sample(key.frame - step);
  const KeyValues here = sample(key.frame);
  const KeyValues after = sample(key.frame + step);
  for (std::size_t i = 0; i < mostComponents; ++i) {
    key.inSlopes[i] = (here[i] - before[i]) / step;
    key.outSlopes[i] = (after[i] - here[i]) / step;
  }
  if (key.kind == rig::KeyInterpolation::free) {
    key.inSlopes = key.outSlopes;
  }
}

KeyedRow readOffsets(const Document& document, int clip, const KeyRow& row, RowDetail detail) {
  const OffsetLook look = lookOf(document, row);
  const std::vector<std::size_t> places = adjustmentsOf(document, clip, row);
  const double rate = clipOf(document, clip).framesPerSecond;
  KeyedRow read;
  read.row = row;
  read.components = look.isAttribute ? 1 : mostComponents;
  read.interpolation = Interpolation::cubicSpline;
  std::vector<rig::OffsetCurve> curves;
  for (const std::size_t place : places) {
    read.parts.push_back(partOf(document, document.adjustments[place]));
    curves.emplace_back(document.adjustments[place], look.standard, rate);
  }
  for (const PlacedKey& placed : placedKeys(document, places)) {
    RowKey key;
    key.frame = placed.key->frame;
    key.values = shownOffset(placed.key->move, placed.key->turn, placed.key->value, look.isAttribute);
    key.kind = placed.key->interpolation;
    key.origin = static_cast<int>(read.keys.size());
    key.part = placed.part;
    key.valuesChanged = key.slopesChanged = false;
    if (detail == RowDetail::values) {
      addOffsetSlopes(curves[at(placed.part)], rate, look.isAttribute, key);
    }
    read.keys.push_back(key);
  }
  return read;
}

rig::OffsetKey offsetKey(const RowKey& key, const rig::OffsetKey* before, bool isAttribute) {
  rig::OffsetKey written = before != nullptr ? *before : rig::OffsetKey{};
  written.frame = key.frame;
  written.interpolation = key.kind;
  if (key.valuesChanged && isAttribute) {
    written.value = key.values[0];
  } else if (key.valuesChanged) {
    written.move = {key.values[0], key.values[1], key.values[2]};
    written.turn = Vec3(key.values[3], key.values[4], key.values[5]) / shownDegrees;
  }
  if (key.kind == rig::KeyInterpolation::free && key.slopesChanged) {
    const KeyValues& slopes = key.outSlopes;
    written.valueSlope = isAttribute ? slopes[0] : 0.0;
    written.moveSlope = isAttribute ? Vec3(0.0) : Vec3(slopes[0], slopes[1], slopes[2]);
    written.turnSlope = isAttribute ? Vec3(0.0) : Vec3(slopes[3], slopes[4], slopes[5]) / shownDegrees;
  }
  return written;
}

Result<Document> writeOffsets(const Document& document, int clip, const KeyedRow& row) {
  const OffsetLook look = lookOf(document, row.row);
  const std::vector<std::size_t> places = adjustmentsOf(document, clip, row.row);
  const std::vector<PlacedKey> before = placedKeys(document, places);
  Document changed = document;
  for (const std::size_t place : places) {
    changed.adjustments[place].keys.clear();
  }
  for (const RowKey& key : row.keys) {
    std::vector<rig::OffsetKey>& keys = changed.adjustments[places[at(key.part)]].keys;
    const bool taken = !keys.empty() && key.frame - keys.back().frame < frameTolerance;
    if (!taken) {
      keys.push_back(
          offsetKey(key, key.origin >= 0 ? before[at(key.origin)].key : nullptr, look.isAttribute));
    }
  }
  std::vector<rig::Adjustment> kept;
  for (const std::size_t place : places) {
    if (!changed.adjustments[place].keys.empty()) {
      kept.push_back(changed.adjustments[place]);
    }
  }
  const Result<Document> sound = placeAdjustments(document, kept);
  if (!sound) {
    return sound.error();
  }
  std::erase_if(changed.adjustments, [](const rig::Adjustment& one) { return one.keys.empty(); });
  return changed;
}

Status checkTrack(const Document& document, const Track& track) {
  constexpr double farthest = 1000.0; // heights of the character, or times the size
  constexpr double longestSeconds = 1e5;
  const double most = track.channel == Channel::translation ? farthest * document.body.height : farthest;
  const auto sound = [&](float value) { return std::isfinite(value); };
  const bool isCubic = track.interpolation == Interpolation::cubicSpline;
  const auto width = static_cast<std::size_t>(track.width);
  bool near = std::all_of(track.values.begin(), track.values.end(), sound);
  for (std::size_t key = 0; key < track.times.size(); ++key) {
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t at = (isCubic ? 3 * key + 1 : key) * width + i;
      near = near && std::abs(static_cast<double>(track.values[at])) <= most;
    }
  }
  if (!near || !sound(track.times.back()) || static_cast<double>(track.times.back()) > longestSeconds) {
    return Error{"a key is out of proportion", nodeTitle(document, track.node),
                 "keep it within a thousand heights of the character and a day"};
  }
  return Success{};
}

Result<Document> writeOwn(const Document& document, int clip, const KeyedRow& row) {
  const Track* const known = trackOf(document, clip, row.row);
  Track before;
  before.node = row.row.node;
  before.channel = row.row.channel;
  before.width = channelWidth(row.row.channel);
  before.interpolation = row.interpolation;
  const Track& from = known != nullptr ? *known : before;
  const WrittenTrack written = writeFollowing(from, row, clipOf(document, clip).framesPerSecond);
  if (written.track.times.empty()) {
    return Error{"a track of the clip keeps one key", rowTitle(document, row.row),
                 "leave one of its keys where it is"};
  }
  if (const Status sound = checkTrack(document, written.track); !sound) {
    return sound.error();
  }
  Document changed =
      known != nullptr && written.track == *known ? document : setTracks(document, clip, {written.track});
  rememberFollowing(clip, written, row, changed);
  return changed;
}

Track restTrack(const Scene& scene, const KeyRow& row) {
  Track rest;
  rest.node = row.node;
  rest.channel = row.channel;
  rest.width = channelWidth(row.channel);
  rest.times = {0.0F};
  const Transform& local = scene.nodes[at(row.node)].rest;
  const Vec3& value = row.channel == Channel::scale ? local.scale : local.translation;
  const Quat& turn = local.rotation;
  const std::vector<double> numbers = row.channel == Channel::rotation
                                          ? std::vector<double>{turn.x, turn.y, turn.z, turn.w}
                                          : std::vector<double>{value.x, value.y, value.z};
  for (const double number : numbers) {
    rest.values.push_back(static_cast<float>(number));
  }
  return rest;
}

std::vector<KeyValues> sampleOffsets(const Document& document, int clip, const KeyRow& row,
                                     std::span<const double> frames) {
  const OffsetLook look = lookOf(document, row);
  const double rate = clipOf(document, clip).framesPerSecond;
  std::vector<rig::OffsetCurve> curves;
  for (const std::size_t place : adjustmentsOf(document, clip, row)) {
    curves.emplace_back(document.adjustments[place], look.standard, rate);
  }
  std::vector<KeyValues> values;
  for (const double frame : frames) {
    const auto covering = std::find_if(curves.begin(), curves.end(), [&](const rig::OffsetCurve& curve) {
      return curve.covers(frame / rate);
    });
    values.push_back(covering != curves.end()
                         ? offsetValues(*covering, frame / rate, look.isAttribute)
                         : shownOffset(Vec3(0.0), Vec3(0.0), look.standard, look.isAttribute));
  }
  return values;
}

} // namespace

std::vector<KeyRow> keyedRows(const Document& document, int clip) {
  std::vector<KeyRow> rows;
  for (const CopyOnWrite<Track>& track : clipOf(document, clip).tracks) {
    if (track->channel != Channel::weights) {
      rows.push_back({track->node, track->channel, {}});
    }
  }
  for (const rig::Adjustment& adjustment : document.adjustments) {
    const KeyRow row{NodeIndex::none, Channel::translation, adjustment.controller};
    if (adjustment.clip == clip && std::find(rows.begin(), rows.end(), row) == rows.end()) {
      rows.push_back(row);
    }
  }
  return rows;
}

KeyedRow readRow(const Document& document, int clip, const KeyRow& row, RowDetail detail) {
  if (row.isOffset()) {
    return readOffsets(document, clip, row, detail);
  }
  const Track* const track = trackOf(document, clip, row);
  if (track == nullptr) {
    KeyedRow empty;
    empty.row = row;
    empty.parts = {{0.0, 1e7}};
    return empty;
  }
  KeyedRow read = readTrack(*track, clipOf(document, clip).framesPerSecond, detail);
  markFollowing(document, clip, *track, read);
  return read;
}

std::vector<double> keyFramesOf(const Document& document, int clip, const KeyRow& row) {
  std::vector<double> frames;
  if (row.isOffset()) {
    for (const PlacedKey& key : placedKeys(document, adjustmentsOf(document, clip, row))) {
      frames.push_back(key.key->frame);
    }
  } else if (const Track* const track = trackOf(document, clip, row)) {
    const double rate = clipOf(document, clip).framesPerSecond;
    for (const float seconds : track->times) {
      frames.push_back(static_cast<double>(seconds) * rate);
    }
  }
  return frames;
}

KeyValues valuesAt(const Document& document, int clip, const KeyRow& row, double frame,
                   const KeyValues& near) {
  return sampleRow(document, clip, row, {&frame, 1}, near).front();
}

std::vector<KeyValues> sampleRow(const Document& document, int clip, const KeyRow& row,
                                 std::span<const double> frames, const KeyValues& near) {
  if (row.isOffset()) {
    return sampleOffsets(document, clip, row, frames);
  }
  const double rate = clipOf(document, clip).framesPerSecond;
  const Track* const known = trackOf(document, clip, row);
  const Track resting = known == nullptr ? restTrack(*document.scene, row) : Track{};
  const Track& track = known == nullptr ? resting : *known;
  std::vector<KeyValues> values;
  for (const double frame : frames) {
    values.push_back(trackValues(track, frame / rate, values.empty() ? near : values.back()));
  }
  return values;
}

Result<Document> writeRow(const Document& document, int clip, const KeyedRow& row) {
  return row.row.isOffset() ? writeOffsets(document, clip, row) : writeOwn(document, clip, row);
}

std::string rowTitle(const Document& document, const KeyRow& row) {
  if (!row.isOffset()) {
    return fmt::format("{} {}", nodeTitle(document, row.node), nameOf(row.channel));
  }
  std::string title = row.controller;
  std::replace(title.begin(), title.end(), '-', ' ');
  std::replace(title.begin(), title.end(), '.', ' ');
  return title;
}

} // namespace stretch::app
