#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/edits/keys/key_row.h"

namespace stretch::app {

// Edits of keys, the same for those of the clip itself and for offset keys. Each answers the changed document
// and which keys are picked in it: the same keys, wherever they stand now.

/// A key that is picked, and which of its values: bit i for component i.
struct PickedKey {
  int key = 0; ///< Place in its row.
  unsigned components = ~0U;
  friend bool operator==(const PickedKey&, const PickedKey&) = default;
};
struct PickedRow {
  KeyRow row;
  std::vector<PickedKey> keys; ///< Ascending.
  friend bool operator==(const PickedRow&, const PickedRow&) = default;
};
using KeySelection = std::vector<PickedRow>;

struct EditedKeys {
  Document document;
  KeySelection picked;
};

[[nodiscard]] std::size_t keyCount(const KeySelection& selection);
/// Every key of the rows.
[[nodiscard]] KeySelection allKeys(const Document& document, int clip, std::span<const KeyRow> rows);
/// The keys of the rows from one frame to another, both included.
[[nodiscard]] KeySelection keysBetween(const Document& document, int clip, std::span<const KeyRow> rows,
                                       double firstFrame, double lastFrame);
/// Every key of the clip that stands between frames.
[[nodiscard]] KeySelection keysOffFrames(const Document& document, int clip);
/// Both together.
[[nodiscard]] KeySelection joined(const KeySelection& a, const KeySelection& b);
/// Without what the document does not have any more.
[[nodiscard]] KeySelection stillThere(const Document& document, int clip, const KeySelection& selection);
/// "3 keys of left arm rotation", "12 keys of 4 rows".
[[nodiscard]] std::string selectionTitle(const Document& document, const KeySelection& selection);

/// The selection moves as one piece: no key leaves the time that its row has. A key that another is moved
/// onto gives way. `value` is in shown units.
struct KeyMove {
  double frames = 0.0;
  double value = 0.0;
  bool wholeFrames = false; ///< Keys come to stand on whole frames.
};
[[nodiscard]] Result<EditedKeys> moveKeys(const Document& document, int clip, const KeySelection& selection,
                                          const KeyMove& move);

/// Factors about a frame and a value. A time factor below 0 turns the keys round.
struct KeyScale {
  double aboutFrame = 0.0;
  double time = 1.0;
  double aboutValue = 0.0;
  double value = 1.0;
};
[[nodiscard]] Result<EditedKeys> scaleKeys(const Document& document, int clip, const KeySelection& selection,
                                           const KeyScale& scale);

/// Picked keys come to stand on whole frames.
[[nodiscard]] Result<EditedKeys> snapKeys(const Document& document, int clip, const KeySelection& selection);

/// A key on each of the rows, where the curve is at the frame; rows that have one there keep it. A joint
/// without keys gets its first one.
[[nodiscard]] Result<EditedKeys> insertKeys(const Document& document, int clip, std::span<const KeyRow> rows,
                                            double frame);

[[nodiscard]] Result<EditedKeys> removeKeys(const Document& document, int clip,
                                            const KeySelection& selection);

/// Keys that Copy takes, with their values and slopes, times counted from the first of all in frames of the
/// clip that they are of.
struct CopiedKeys {
  struct Row {
    KeyRow row;
    std::vector<RowKey> keys;
    std::vector<unsigned> components; ///< Those that were picked of each key: bit i for component i.
  };
  std::vector<Row> rows;
  double framesPerSecond = 0.0;
};
[[nodiscard]] CopiedKeys copyKeys(const Document& document, int clip, const KeySelection& selection);
/// The first key comes to stand at the frame, the others as far from it in time as they were; keys that stand
/// in the way give way, but for components that were not picked, which stay as the row has them there. One
/// copied row goes to `target` where that is given and holds the same kind of values. Rows that take no keys
/// are left out; an error where none does.
[[nodiscard]] Result<EditedKeys> pasteKeys(const Document& document, int clip, const CopiedKeys& copied,
                                           double frame, const std::optional<KeyRow>& target);

/// How the curves pass the picked keys. On a LINEAR track a curved kind makes the whole track CUBICSPLINE,
/// with the other keys as straight as they were. A track steps as a whole: "stepped", and any other kind on
/// one that steps, is refused unless all of its keys are picked.
[[nodiscard]] Result<EditedKeys> setKeyKind(const Document& document, int clip, const KeySelection& selection,
                                            rig::KeyInterpolation kind);

/// Which sides of a key a tangent is set on.
enum class TangentSide { both, in, out };
/// The slope of one component, shown units for each frame: the key is free then. An offset key has the same
/// slope on both sides.
[[nodiscard]] Result<EditedKeys> setKeySlope(const Document& document, int clip, const KeyRow& row,
                                             const PickedKey& key, TangentSide side, double slope);

/// The picked values of the picked keys, as typed.
[[nodiscard]] Result<EditedKeys> setKeyValue(const Document& document, int clip,
                                             const KeySelection& selection, double value);

} // namespace stretch::app
