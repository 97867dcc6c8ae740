#pragma once

#include <array>
#include <compare>
#include <span>
#include <string>
#include <vector>

#include "app/document.h"

namespace stretch::app {

// Two kinds of keys are edited in one way: those of the clip itself, and offset keys of controllers and
// attributes. Both are read as a row of keys with shown values, changed there, and written back.

/// Values that are keyed as one: a joint's translation, rotation or scale in the clip, or a controller or an
/// attribute in its adjustments.
struct KeyRow {
  NodeIndex node;                         ///< Node of the clip's own keys; none: offset keys.
  Channel channel = Channel::translation; ///< Channel of the clip's own keys.
  std::string controller = {};            ///< Owner of offset keys: Controller::id or Attribute::id.

  [[nodiscard]] bool isOffset() const { return !node.exists(); }

  friend auto operator<=>(const KeyRow&, const KeyRow&) = default;
};

inline constexpr std::size_t mostComponents = 6;
using KeyValues = std::array<double, mostComponents>;

/// One key of a row. Values as they are shown: degrees for angles, else as they are.
struct RowKey {
  double frame = 0.0;
  KeyValues values{};
  KeyValues inSlopes{}; ///< For each frame.
  KeyValues outSlopes{};
  rig::KeyInterpolation kind = rig::KeyInterpolation::automatic;
  int origin = -1;        ///< Place in the row that it was read from; -1: a new one.
  int part = 0;           ///< Which of KeyedRow::parts it belongs to.
  unsigned following = 0; ///< For the clip's own keys: components whose slopes follow the neighbours (auto).
  bool onCurve = false;   ///< A new key that leaves the curve as it is: slopes beside it do not follow it.
  bool valuesChanged = true; ///< Else the key keeps its values as they are stored, to the last bit,
  bool slopesChanged = true; ///< and its slopes.
};

/// A stretch of time in which keys of a row may stand.
struct RowPart {
  double firstFrame = 0.0;
  double lastFrame = 0.0;
};

struct KeyedRow {
  KeyRow row;
  std::size_t components = 3;                          ///< Number of the values that count.
  Interpolation interpolation = Interpolation::linear; ///< Interpolation of the clip's own keys, as it is to
                                                       ///< be.
  std::vector<RowPart> parts;
  std::vector<RowKey> keys; ///< Ascending by frame.
};

enum class RowDetail { times, values }; ///< Times alone are read faster; such keys can be moved in time.

/// The rows of a clip that have keys: its own, tracks of morph weights left out, and offset keys.
[[nodiscard]] std::vector<KeyRow> keyedRows(const Document& document, int clip);

/// Without keys where nothing is keyed there.
[[nodiscard]] KeyedRow readRow(const Document& document, int clip, const KeyRow& row,
                               RowDetail detail = RowDetail::values);

/// Frames of the keys of a row, in order, in the numbering of readRow.
[[nodiscard]] std::vector<double> keyFramesOf(const Document& document, int clip, const KeyRow& row);

/// Returns a row's values at a frame, as values are shown; angles nearest to `near`.
[[nodiscard]] KeyValues valuesAt(const Document& document, int clip, const KeyRow& row, double frame,
                                 const KeyValues& near);
/// Returns a row's values at several frames, each near the one before it.
[[nodiscard]] std::vector<KeyValues> sampleRow(const Document& document, int clip, const KeyRow& row,
                                               std::span<const double> frames, const KeyValues& near);

/// The row in place of what the document has. Keys of one frame: the first counts. Refused where a row of the
/// clip itself would lose its last key, and where a number is out of proportion.
[[nodiscard]] Result<Document> writeRow(const Document& document, int clip, const KeyedRow& row);

/// "left hand", "Arm.L rotation": what a row is called.
[[nodiscard]] std::string rowTitle(const Document& document, const KeyRow& row);

} // namespace stretch::app
