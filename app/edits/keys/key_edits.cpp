#include "app/edits/keys/key_edits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/core.h>

#include "app/edits/keys/following_keys.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

// A key on its way through an edit.
struct HeldKey {
  RowKey key;
  unsigned picked = 0;  ///< Components; 0: not picked.
  double before = -1e9; ///< Its frame before the edit; far away for a new one.
};

// The row as keys that know whether they are picked.
struct HeldRow {
  KeyedRow row; ///< Without keys.
  std::vector<HeldKey> keys;
};

HeldRow heldRow(const Document& document, int clip, const PickedRow& picked, RowDetail detail) {
  HeldRow held;
  KeyedRow row = readRow(document, clip, picked.row, detail);
  for (const RowKey& key : row.keys) {
    held.keys.push_back({key, 0U, key.frame});
  }
  row.keys.clear();
  held.row = std::move(row);
  for (const PickedKey& key : picked.keys) {
    if (key.key >= 0 && at(key.key) < held.keys.size()) {
      held.keys[at(key.key)].picked = key.components;
    }
  }
  return held;
}

// What lies a rounding off a whole frame means it.
double settledFrame(double frame) {
  const double whole = std::round(frame);
  return std::abs(frame - whole) < 1e-4 ? whole : frame;
}

// Keys that an edit brought to one place, or that a track cannot tell apart: of these the first is written.
bool areOne(const HeldKey& kept, const HeldKey& key, double framesPerSecond) {
  const auto seconds = [&](const HeldKey& one) {
    return static_cast<float>(one.key.frame / framesPerSecond);
  };
  const bool wereApart = !sameFrame(kept.before, key.before);
  return kept.key.part == key.key.part &&
         ((wereApart && key.key.frame - kept.key.frame < frameTolerance) || !(seconds(key) > seconds(kept)));
}

// In order, and of keys in one place the picked one.
void settle(std::vector<HeldKey>& keys, double framesPerSecond) {
  std::stable_sort(keys.begin(), keys.end(), [](const HeldKey& a, const HeldKey& b) {
    return a.key.frame < b.key.frame || (a.key.frame == b.key.frame && a.picked > b.picked);
  });
  // Keys that stood as near to each other before, such as the two of a step, leave each other alone.
  const auto covers = [](const HeldKey& other, const HeldKey& key) {
    return other.picked != 0 && sameFrame(other.key.frame, key.key.frame) &&
           !sameFrame(other.before, key.before);
  };
  std::vector<HeldKey> kept;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool covered = keys[i].picked == 0 && ((i > 0 && covers(keys[i - 1], keys[i])) ||
                                                 (i + 1 < keys.size() && covers(keys[i + 1], keys[i])));
    if (!covered && !kept.empty() && areOne(kept.back(), keys[i], framesPerSecond)) {
      kept.back().picked |= keys[i].picked;
    } else if (!covered) {
      kept.push_back(keys[i]);
    }
  }
  keys = std::move(kept);
}

Result<EditedKeys> written(EditedKeys so, int clip, HeldRow held) {
  settle(held.keys, clipOf(so.document, clip).framesPerSecond);
  PickedRow picked{held.row.row, {}};
  for (const HeldKey& key : held.keys) {
    if (key.picked != 0) {
      picked.keys.push_back({static_cast<int>(held.row.keys.size()), key.picked});
    }
    held.row.keys.push_back(key.key);
  }
  Result<Document> changed = writeRow(so.document, clip, held.row);
  if (!changed) {
    return changed.error();
  }
  so.document = std::move(*changed);
  if (!picked.keys.empty()) {
    so.picked.push_back(std::move(picked));
  }
  return so;
}

// Each row of the selection through one change.
using RowChange = std::function<Status(HeldRow&)>;
Result<EditedKeys> changeRows(const Document& document, int clip, const KeySelection& selection,
                              RowDetail detail, const RowChange& change) {
  EditedKeys edited{document, {}};
  for (const PickedRow& picked : selection) {
    HeldRow held = heldRow(document, clip, picked, detail);
    if (const Status done = change(held); !done) {
      return done.error();
    }
    Result<EditedKeys> next = written(std::move(edited), clip, std::move(held));
    if (!next) {
      return next.error();
    }
    edited = std::move(*next);
  }
  return edited;
}

template <typename Change>
void forPicked(HeldRow& held, Change&& change) {
  for (HeldKey& key : held.keys) {
    if (key.picked != 0) {
      change(key);
    }
  }
}

// The one change of values that all kinds of edits make.
void setValues(HeldKey& key, std::size_t components, const std::function<double(std::size_t, double)>& to) {
  for (std::size_t i = 0; i < components; ++i) {
    if ((key.picked >> i & 1U) != 0) {
      const double value = to(i, key.key.values[i]);
      key.key.valuesChanged = key.key.valuesChanged || value != key.key.values[i];
      key.key.values[i] = value;
    }
  }
}

// The frames that the picked keys may all be moved by, around 0.
RowPart freedomOf(const Document& document, int clip, const KeySelection& selection) {
  RowPart freedom{-1e9, 1e9};
  for (const PickedRow& picked : selection) {
    HeldRow held = heldRow(document, clip, picked, RowDetail::times);
    forPicked(held, [&](const HeldKey& key) {
      const RowPart& part = held.row.parts[at(key.key.part)];
      freedom.firstFrame = std::max(freedom.firstFrame, part.firstFrame - key.key.frame);
      freedom.lastFrame = std::min(freedom.lastFrame, part.lastFrame - key.key.frame);
    });
  }
  return freedom;
}

Error noKeys() {
  return {"no key is picked", "", "click a key in the graph, or draw a box around some"};
}

double finite(double number) {
  return std::isfinite(number) ? number : 0.0;
}

} // namespace

Result<EditedKeys> moveKeys(const Document& document, int clip, const KeySelection& selection,
                            const KeyMove& move) {
  if (selection.empty()) {
    return noKeys();
  }
  const RowPart freedom = freedomOf(document, clip, selection);
  const double frames =
      std::clamp(finite(move.frames), std::min(0.0, freedom.firstFrame), std::max(0.0, freedom.lastFrame));
  const double value = finite(move.value);
  return changeRows(document, clip, selection, value == 0.0 ? RowDetail::times : RowDetail::values,
                    [&](HeldRow& held) -> Status {
                      forPicked(held, [&](HeldKey& key) {
                        if (frames != 0.0) {
                          const double there = settledFrame(key.key.frame + frames);
                          key.key.frame = move.wholeFrames ? std::round(there) : there;
                        }
                        if (value != 0.0) {
                          setValues(key, held.row.components,
                                    [&](std::size_t, double old) { return old + value; });
                        }
                      });
                      return Success{};
                    });
}

namespace {

// Time is scaled for all components of a key, values only for those that are picked. Turned round in time,
// what came to the key leaves it.
void scaleSlopes(const HeldRow& held, const KeyScale& scale, HeldKey& key) {
  const double slower = scale.time == 0.0 ? 1.0 : finite(scale.time);
  for (std::size_t i = 0; i < held.row.components; ++i) {
    const bool isPicked = (key.picked >> i & 1U) != 0;
    const double steeper = (isPicked ? finite(scale.value) : 1.0) / slower;
    key.key.inSlopes[i] *= steeper;
    key.key.outSlopes[i] *= steeper;
  }
  if (slower < 0.0) {
    std::swap(key.key.inSlopes, key.key.outSlopes);
  }
  if (slower != 1.0 || scale.value != 1.0) {
    key.key.slopesChanged = held.row.interpolation == Interpolation::cubicSpline;
  }
}

} // namespace

Result<EditedKeys> scaleKeys(const Document& document, int clip, const KeySelection& selection,
                             const KeyScale& scale) {
  if (selection.empty()) {
    return noKeys();
  }
  const bool values = scale.value != 1.0;
  return changeRows(
      document, clip, selection, values || scale.time != 1.0 ? RowDetail::values : RowDetail::times,
      [&](HeldRow& held) -> Status {
        forPicked(held, [&](HeldKey& key) {
          const RowPart& part = held.row.parts[at(key.key.part)];
          const double there =
              settledFrame(scale.aboutFrame + (key.key.frame - scale.aboutFrame) * finite(scale.time));
          key.key.frame =
              scale.time == 1.0 ? key.key.frame : std::clamp(there, part.firstFrame, part.lastFrame);
          setValues(key, held.row.components, [&](std::size_t, double old) {
            return values ? scale.aboutValue + (old - scale.aboutValue) * finite(scale.value) : old;
          });
          scaleSlopes(held, scale, key);
        });
        return Success{};
      });
}

Result<EditedKeys> snapKeys(const Document& document, int clip, const KeySelection& selection) {
  if (selection.empty()) {
    return noKeys();
  }
  return changeRows(document, clip, selection, RowDetail::times, [](HeldRow& held) -> Status {
    // The second key of a jump goes with the first, by as little behind it as single precision tells.
    constexpr double precision = 2.5e-7;
    double before = -1e9;
    double there = before;
    forPicked(held, [&](HeldKey& key) {
      const RowPart& part = held.row.parts[at(key.key.part)];
      const double frame = key.key.frame;
      const double behind = there + std::max(frame - before, precision * std::max(1.0, there));
      const double whole = sameFrame(frame, before) ? behind : std::round(frame);
      const bool fits = whole >= part.firstFrame && whole <= part.lastFrame;
      key.key.frame = fits && (whole == behind || std::abs(whole - frame) > 1e-4) ? whole : frame;
      before = frame;
      there = key.key.frame;
    });
    return Success{};
  });
}

Result<EditedKeys> removeKeys(const Document& document, int clip, const KeySelection& selection) {
  if (selection.empty()) {
    return noKeys();
  }
  return changeRows(document, clip, selection, RowDetail::times, [](HeldRow& held) -> Status {
    std::erase_if(held.keys, [](const HeldKey& key) { return key.picked != 0; });
    return Success{};
  });
}

CopiedKeys copyKeys(const Document& document, int clip, const KeySelection& selection) {
  CopiedKeys copied{{}, clipOf(document, clip).framesPerSecond};
  double first = 1e9;
  for (const PickedRow& picked : selection) {
    HeldRow held = heldRow(document, clip, picked, RowDetail::values);
    CopiedKeys::Row row{picked.row, {}, {}};
    forPicked(held, [&](HeldKey& key) {
      key.key.origin = -1;
      key.key.valuesChanged = key.key.slopesChanged = true;
      first = std::min(first, key.key.frame);
      row.keys.push_back(key.key);
      row.components.push_back(key.picked);
    });
    copied.rows.push_back(std::move(row));
  }
  for (CopiedKeys::Row& row : copied.rows) {
    for (RowKey& key : row.keys) {
      key.frame -= first;
    }
  }
  return copied;
}

Result<EditedKeys> setKeyValue(const Document& document, int clip, const KeySelection& selection,
                               double value) {
  if (selection.empty()) {
    return noKeys();
  }
  return changeRows(document, clip, selection, RowDetail::values, [&](HeldRow& held) -> Status {
    forPicked(held, [&](HeldKey& key) {
      setValues(key, held.row.components, [&](std::size_t, double) { return finite(value); });
    });
    return Success{};
  });
}

namespace {

int partAt(const KeyedRow& row, double frame) {
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    if (isWithinFrames(row.parts[i].firstFrame, row.parts[i].lastFrame, frame)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

bool hasKeyAt(const HeldRow& held, double frame) {
  return std::ranges::any_of(held.keys, [&](const HeldKey& key) { return sameFrame(key.key.frame, frame); });
}

// A key on the curve: the curve stays as it is where its track can say so.
RowKey keyOnCurve(const Document& document, int clip, const HeldRow& held, double frame) {
  constexpr double step = 1e-3;
  RowKey key;
  key.frame = frame;
  key.onCurve = true;
  const auto before = std::find_if(held.keys.rbegin(), held.keys.rend(),
                                   [&](const HeldKey& other) { return other.key.frame < frame; });
  const KeyValues near = before == held.keys.rend() ? KeyValues{} : before->key.values;
  key.values = valuesAt(document, clip, held.row.row, frame, near);
  const KeyValues earlier = valuesAt(document, clip, held.row.row, frame - step, key.values);
  const KeyValues later = valuesAt(document, clip, held.row.row, frame + step, key.values);
  const bool inside = before != held.keys.rend() && frame < held.keys.back().key.frame;
  for (std::size_t i = 0; i < mostComponents; ++i) {
    key.inSlopes[i] = key.outSlopes[i] = inside ? (later[i] - earlier[i]) / (2.0 * step) : 0.0;
  }
  const bool onOffsets = held.row.row.isOffset();
  const bool holds =
      before != held.keys.rend() && before->key.kind == rig::KeyInterpolation::stepped && onOffsets;
  key.kind = holds ? rig::KeyInterpolation::stepped : rig::KeyInterpolation::free;
  return key;
}

bool sameValues(const KeyRow& a, const KeyRow& b) {
  return a.isOffset() == b.isOffset() && (a.isOffset() || a.channel == b.channel);
}

} // namespace

Result<EditedKeys> insertKeys(const Document& document, int clip, std::span<const KeyRow> rows,
                              double frame) {
  EditedKeys edited{document, {}};
  bool any = false;
  for (const KeyRow& row : rows) {
    HeldRow held = heldRow(document, clip, {row, {}}, RowDetail::values);
    const int part = partAt(held.row, frame);
    if (part < 0 || !(frame >= 0.0)) {
      continue;
    }
    any = true;
    if (hasKeyAt(held, frame)) {
      continue;
    }
    HeldKey key{keyOnCurve(document, clip, held, frame), ~0U};
    key.key.part = part;
    held.keys.push_back(key);
    Result<EditedKeys> next = written(std::move(edited), clip, std::move(held));
    if (!next) {
      return next.error();
    }
    edited = std::move(*next);
  }
  if (!any) {
    return Error{"no key can stand there", fmt::format("frame {:g}", frame),
                 "offset keys are set by moving their controller, or choose a frame of their range"};
  }
  return edited;
}

namespace {

// A copied key at its frame, of a row of the document whose keys are in order: components that were not
// picked are as they are there.
RowKey besidePresent(const Document& document, int clip, const HeldRow& present, RowKey key,
                     unsigned components) {
  const unsigned all = (1U << present.row.components) - 1U;
  if ((components & all) == all) {
    return key;
  }
  const auto there = std::ranges::find_if(
      present.keys, [&](const HeldKey& other) { return sameFrame(other.key.frame, key.frame); });
  const RowKey own =
      there == present.keys.end() ? keyOnCurve(document, clip, present, key.frame) : there->key;
  for (std::size_t i = 0; i < present.row.components; ++i) {
    if ((components >> i & 1U) == 0) {
      key.values[i] = own.values[i];
      key.inSlopes[i] = own.inSlopes[i];
      key.outSlopes[i] = own.outSlopes[i];
    }
  }
  key.following = (key.following & components) | (own.following & ~components);
  return key;
}

// Where a copied key comes to stand, in frames that are `factor` times as many in a second.
RowKey keyInTime(RowKey key, double firstFrame, double factor) {
  key.frame = settledFrame(key.frame * factor + firstFrame);
  for (std::size_t i = 0; i < mostComponents; ++i) {
    key.inSlopes[i] /= factor;
    key.outSlopes[i] /= factor;
  }
  return key;
}

} // namespace

Result<EditedKeys> pasteKeys(const Document& document, int clip, const CopiedKeys& copied, double frame,
                             const std::optional<KeyRow>& target) {
  EditedKeys edited{document, {}};
  const double factor = clipOf(document, clip).framesPerSecond / copied.framesPerSecond;
  for (const CopiedKeys::Row& from : copied.rows) {
    const bool toTarget = target && copied.rows.size() == 1 && sameValues(*target, from.row);
    const HeldRow present = heldRow(document, clip, {toTarget ? *target : from.row, {}}, RowDetail::values);
    HeldRow held = present;
    bool any = false;
    for (std::size_t i = 0; i < from.keys.size(); ++i) {
      RowKey key = keyInTime(from.keys[i], frame, factor);
      key.part = partAt(held.row, key.frame);
      if (key.part >= 0) {
        held.keys.push_back(
            {besidePresent(document, clip, present, key, from.components[i]), from.components[i]});
        any = true;
      }
    }
    Result<EditedKeys> next =
        any ? written(std::move(edited), clip, std::move(held)) : Result<EditedKeys>(std::move(edited));
    if (!next) {
      return next.error();
    }
    edited = std::move(*next);
  }
  if (edited.picked.empty()) {
    return Error{"nothing that was copied fits there", fmt::format("frame {:g}", frame),
                 "copy keys of this character, and paste inside the range of their controller"};
  }
  return edited;
}

namespace {

// The slope that a kind asks for at a key, from its neighbours.
double slopeOf(const HeldRow& held, std::size_t key, std::size_t component, rig::KeyInterpolation kind,
               bool after) {
  const auto point = [&](std::size_t i) {
    return Vec2(held.keys[i].key.frame, held.keys[i].key.values[component]);
  };
  const bool hasBefore = key > 0;
  const bool hasAfter = key + 1 < held.keys.size();
  if (kind == rig::KeyInterpolation::linear && (after ? hasAfter : hasBefore)) {
    const Vec2 piece = after ? point(key + 1) - point(key) : point(key) - point(key - 1);
    return piece.y / piece.x;
  }
  const auto rowKey = [&](bool exists, std::size_t i) { return exists ? &held.keys[i].key : nullptr; };
  return kind == rig::KeyInterpolation::automatic
             ? followingSlope(rowKey(hasBefore, key - 1), held.keys[key].key, rowKey(hasAfter, key + 1),
                              component)
             : 0.0;
}

void setSlopesByKind(HeldRow& held, rig::KeyInterpolation kind) {
  for (std::size_t i = 0; i < held.keys.size(); ++i) {
    HeldKey& key = held.keys[i];
    const bool follows = kind == rig::KeyInterpolation::automatic;
    key.key.following = follows ? key.key.following | key.picked : key.key.following & ~key.picked;
    if (key.picked == 0 || kind == rig::KeyInterpolation::free) {
      continue;
    }
    for (std::size_t c = 0; c < held.row.components; ++c) {
      if ((key.picked >> c & 1U) != 0) {
        key.key.inSlopes[c] = slopeOf(held, i, c, kind, false);
        key.key.outSlopes[c] = slopeOf(held, i, c, kind, true);
      }
    }
    key.key.slopesChanged = true;
  }
}

Status setTrackKind(HeldRow& held, rig::KeyInterpolation kind) {
  const bool all =
      std::all_of(held.keys.begin(), held.keys.end(), [](const HeldKey& key) { return key.picked != 0; });
  const bool steps = held.row.interpolation == Interpolation::step;
  const bool toSteps = kind == rig::KeyInterpolation::stepped;
  if ((steps || toSteps) && steps != toSteps && !all) {
    return Error{"a track of the clip steps as a whole", "", "pick all of its keys"};
  }
  if (toSteps ||
      (kind == rig::KeyInterpolation::linear && (all || held.row.interpolation == Interpolation::linear))) {
    held.row.interpolation = toSteps ? Interpolation::step : Interpolation::linear;
    return Success{};
  }
  held.row.interpolation = Interpolation::cubicSpline;
  setSlopesByKind(held, kind);
  return Success{};
}

} // namespace

Result<EditedKeys> setKeyKind(const Document& document, int clip, const KeySelection& selection,
                              rig::KeyInterpolation kind) {
  if (selection.empty()) {
    return noKeys();
  }
  return changeRows(document, clip, selection, RowDetail::values, [&](HeldRow& held) -> Status {
    if (!held.row.row.isOffset()) {
      return setTrackKind(held, kind);
    }
    forPicked(held, [&](HeldKey& key) {
      key.key.slopesChanged = kind == rig::KeyInterpolation::free && key.key.kind != kind;
      key.key.kind = kind;
    });
    return Success{};
  });
}

Result<EditedKeys> setKeySlope(const Document& document, int clip, const KeyRow& row, const PickedKey& key,
                               TangentSide side, double slope) {
  return changeRows(document, clip, {{row, {key}}}, RowDetail::values, [&](HeldRow& held) -> Status {
    forPicked(held, [&](HeldKey& picked) {
      const bool both = side == TangentSide::both || row.isOffset();
      for (std::size_t i = 0; i < held.row.components; ++i) {
        if ((picked.picked >> i & 1U) == 0) {
          continue;
        }
        picked.key.inSlopes[i] = both || side == TangentSide::in ? finite(slope) : picked.key.inSlopes[i];
        picked.key.outSlopes[i] = both || side == TangentSide::out ? finite(slope) : picked.key.outSlopes[i];
      }
      picked.key.kind = rig::KeyInterpolation::free;
      picked.key.following &= ~picked.picked;
      picked.key.slopesChanged = true;
    });
    if (!row.isOffset()) {
      held.row.interpolation = Interpolation::cubicSpline;
    }
    return Success{};
  });
}

} // namespace stretch::app
