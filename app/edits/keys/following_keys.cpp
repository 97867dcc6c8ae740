#include "app/edits/keys/following_keys.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/math/monotone_curve.h"

namespace stretch::app {

namespace {

template <typename Following>
auto followingOf(Following& all, int clip, const Track& track) {
  return std::find_if(all.begin(), all.end(), [&](const FollowingKeys& one) {
    return one.clip == clip && one.node == track.node && one.channel == track.channel;
  });
}

// Time and value of a key, as they are stored; none for a key that there is not.
struct KeyStand {
  float seconds = 0.0F;
  std::vector<float> value;
  friend bool operator==(const KeyStand&, const KeyStand&) = default;
};

std::optional<KeyStand> standOf(const Track& track, std::ptrdiff_t key) {
  if (key < 0 || static_cast<std::size_t>(key) >= track.times.size()) {
    return std::nullopt;
  }
  const bool cubic = track.interpolation == Interpolation::cubicSpline;
  const auto first = track.values.begin() + (cubic ? 3 * key + 1 : key) * track.width;
  return KeyStand{track.times[static_cast<std::size_t>(key)], {first, first + track.width}};
}

// The next key on one side that was not put onto the curve.
std::ptrdiff_t neighbour(const WrittenTrack& written, const KeyedRow& row, std::ptrdiff_t key,
                         std::ptrdiff_t step) {
  const auto count = static_cast<std::ptrdiff_t>(written.rowKeys.size());
  std::ptrdiff_t there = key + step;
  while (there >= 0 && there < count && row.keys[written.rowKeys[static_cast<std::size_t>(there)]].onCurve) {
    there += step;
  }
  return there;
}

// Whether the key and its neighbours stand where they stood.
bool standsAsBefore(const Track& before, const WrittenTrack& written, const KeyedRow& row,
                    std::ptrdiff_t key) {
  const int origin = row.keys[written.rowKeys[static_cast<std::size_t>(key)]].origin;
  return origin >= 0 && standOf(before, origin) == standOf(written.track, key) &&
         standOf(before, origin - 1) == standOf(written.track, neighbour(written, row, key, -1)) &&
         standOf(before, origin + 1) == standOf(written.track, neighbour(written, row, key, 1));
}

void followNeighbours(KeyedRow& row, std::size_t place, unsigned components) {
  RowKey& key = row.keys[place];
  const RowKey* const before = place > 0 ? &row.keys[place - 1] : nullptr;
  const RowKey* const after = place + 1 < row.keys.size() ? &row.keys[place + 1] : nullptr;
  for (std::size_t i = 0; i < row.components; ++i) {
    if ((components >> i & 1U) != 0) {
      key.inSlopes[i] = key.outSlopes[i] = followingSlope(before, key, after, i);
      key.slopesChanged = true;
    }
  }
}

} // namespace

double followingSlope(const RowKey* before, const RowKey& key, const RowKey* after, std::size_t component) {
  const auto point = [&](const RowKey& one) { return Vec2(one.frame, one.values[component]); };
  return before != nullptr && after != nullptr ? monotoneSlope(point(*before), point(key), point(*after))
                                               : 0.0;
}

void markFollowing(const Document& document, int clip, const Track& track, KeyedRow& row) {
  const auto following = followingOf(document.followingKeys, clip, track);
  if (following == document.followingKeys.end()) {
    return;
  }
  for (const FollowingKeys::Key& key : following->keys) {
    const auto there = std::lower_bound(track.times.begin(), track.times.end(), key.seconds);
    if (there != track.times.end() && *there == key.seconds) {
      row.keys[static_cast<std::size_t>(there - track.times.begin())].following = key.components;
    }
  }
}

WrittenTrack writeFollowing(const Track& before, const KeyedRow& row, double framesPerSecond) {
  WrittenTrack written = writeTrack(before, row, framesPerSecond);
  const bool follows =
      row.interpolation == Interpolation::cubicSpline &&
      std::any_of(row.keys.begin(), row.keys.end(), [](const RowKey& key) { return key.following != 0; });
  if (!follows) {
    return written;
  }
  KeyedRow now = readTrack(written.track, framesPerSecond, RowDetail::values);
  for (std::size_t i = 0; i < now.keys.size(); ++i) {
    if (!standsAsBefore(before, written, row, static_cast<std::ptrdiff_t>(i))) {
      followNeighbours(now, i, row.keys[written.rowKeys[i]].following);
    }
  }
  written.track = writeTrack(written.track, now, framesPerSecond).track;
  return written;
}

void rememberFollowing(int clip, const WrittenTrack& written, const KeyedRow& row, Document& document) {
  FollowingKeys following{clip, written.track.node, written.track.channel, {}};
  const bool cubic = written.track.interpolation == Interpolation::cubicSpline;
  for (std::size_t i = 0; i < written.rowKeys.size() && cubic; ++i) {
    const unsigned components = row.keys[written.rowKeys[i]].following & ((1U << row.components) - 1U);
    if (components != 0) {
      following.keys.push_back({written.track.times[i], components});
    }
  }
  std::vector<FollowingKeys>& all = document.followingKeys;
  const auto known = followingOf(all, clip, written.track);
  if (following.keys.empty()) {
    all.erase(known, known == all.end() ? known : known + 1);
  } else if (known == all.end()) {
    all.push_back(std::move(following));
  } else {
    *known = std::move(following);
  }
}

} // namespace stretch::app
