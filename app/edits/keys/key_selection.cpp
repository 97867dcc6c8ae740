#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "app/edits/keys/key_edits.h"
#include "core/anim/frames.h"

namespace stretch::app {

std::size_t keyCount(const KeySelection& selection) {
  std::size_t count = 0;
  for (const PickedRow& row : selection) {
    count += row.keys.size();
  }
  return count;
}

KeySelection keysBetween(const Document& document, int clip, std::span<const KeyRow> rows, double firstFrame,
                         double lastFrame) {
  KeySelection selection;
  for (const KeyRow& row : rows) {
    const std::vector<double> frames = keyFramesOf(document, clip, row);
    PickedRow picked{row, {}};
    const auto first = std::lower_bound(frames.begin(), frames.end(), firstFrame - frameTolerance);
    for (auto frame = first; frame != frames.end() && *frame <= lastFrame + frameTolerance; ++frame) {
      picked.keys.push_back({static_cast<int>(frame - frames.begin())});
    }
    if (!picked.keys.empty()) {
      selection.push_back(std::move(picked));
    }
  }
  return selection;
}

KeySelection allKeys(const Document& document, int clip, std::span<const KeyRow> rows) {
  return keysBetween(document, clip, rows, -1e9, 1e9);
}

KeySelection keysOffFrames(const Document& document, int clip) {
  KeySelection off;
  for (PickedRow& picked : allKeys(document, clip, keyedRows(document, clip))) {
    const std::vector<double> frames = keyFramesOf(document, clip, picked.row);
    std::erase_if(picked.keys, [&](const PickedKey& key) {
      return sameFrame(frames[at(key.key)], std::round(frames[at(key.key)]));
    });
    if (!picked.keys.empty()) {
      off.push_back(std::move(picked));
    }
  }
  return off;
}

KeySelection joined(const KeySelection& a, const KeySelection& b) {
  KeySelection both = a;
  for (const PickedRow& more : b) {
    const auto known =
        std::find_if(both.begin(), both.end(), [&](const PickedRow& row) { return row.row == more.row; });
    if (known == both.end()) {
      both.push_back(more);
      continue;
    }
    for (const PickedKey& key : more.keys) {
      const auto place =
          std::lower_bound(known->keys.begin(), known->keys.end(), key,
                           [](const PickedKey& x, const PickedKey& y) { return x.key < y.key; });
      if (place != known->keys.end() && place->key == key.key) {
        place->components |= key.components;
      } else {
        known->keys.insert(place, key);
      }
    }
  }
  return both;
}

KeySelection stillThere(const Document& document, int clip, const KeySelection& selection) {
  KeySelection there;
  for (const PickedRow& picked : selection) {
    const auto count = static_cast<int>(keyFramesOf(document, clip, picked.row).size());
    PickedRow kept{picked.row, {}};
    std::copy_if(picked.keys.begin(), picked.keys.end(), std::back_inserter(kept.keys),
                 [&](const PickedKey& key) { return key.key < count; });
    if (!kept.keys.empty()) {
      there.push_back(std::move(kept));
    }
  }
  return there;
}

std::string selectionTitle(const Document& document, const KeySelection& selection) {
  const std::size_t keys = keyCount(selection);
  const std::string count = keys == 1 ? "a key" : fmt::format("{} keys", keys);
  return selection.size() == 1 ? fmt::format("{} of {}", count, rowTitle(document, selection.front().row))
                               : fmt::format("{} of {} rows", count, selection.size());
}

} // namespace stretch::app
