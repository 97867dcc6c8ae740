#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document.h"
#include "rig/controllers/adjustment.h"

namespace stretch::app {

// Keys of what controllers are offset by (docs/controllers.md, Keys). `id` names a controller or an
// attribute; frames are those of the clip.

/// Offset of a controller: along the axes of its carrier, world units and a rotation vector, as in
/// rig::OffsetKey.
struct ControllerOffset {
  std::string id;
  Vec3 move{0.0};
  Vec3 turn{0.0};

  friend bool operator==(const ControllerOffset&, const ControllerOffset&) = default;
};

struct AttributeValue {
  std::string id;
  double value = 0.0;

  friend bool operator==(const AttributeValue&, const AttributeValue&) = default;
};

/// Offsets and values of several controllers and attributes at one moment.
struct OffsetPose {
  std::vector<ControllerOffset> offsets;
  std::vector<AttributeValue> values;

  [[nodiscard]] bool empty() const { return offsets.empty() && values.empty(); }
  friend bool operator==(const OffsetPose&, const OffsetPose&) = default;
};

/// Range in which a first key acts: inside a range and nowhere else, or on the whole clip.
struct KeyRange {
  std::optional<Vec2> rangeFrames;
};

/// The adjustment that says what is offset at a frame: the one with a key there, else the one whose range
/// holds it. Null where there is none.
[[nodiscard]] const rig::Adjustment* adjustmentAt(const Document& document, int clip, double frame,
                                                  const std::string& id);

/// The key at a frame; null where there is none.
[[nodiscard]] const rig::OffsetKey* offsetKeyAt(const Document& document, int clip, double frame,
                                                const std::string& id);

/// Returns the offset by the keys at a frame; no offset where nothing is keyed.
[[nodiscard]] ControllerOffset offsetAt(const Document& document, int clip, double frame,
                                        const std::string& id);
/// Returns the value of an attribute, held to its range; its standard value where nothing is keyed.
[[nodiscard]] double valueAt(const Document& document, int clip, double frame, const std::string& id);

/// Ids of everything that is adjusted in a clip, each once.
[[nodiscard]] std::vector<std::string> adjustedIds(const Document& document, int clip);

/// Sets a key of each at the frame: one that is there gets the numbers and keeps its interpolation. Where
/// nothing is adjusted at the frame, `range` says where the key acts, cut where another adjustment of the
/// same controller begins; a range that does not hold the frame is an error. All of them or none.
[[nodiscard]] Result<Document> setOffsets(const Document& document, int clip, double frame,
                                          std::span<const ControllerOffset> offsets,
                                          std::span<const AttributeValue> values, const KeyRange& range);

/// Takes the keys at the frame away; what has no key left is adjusted no more.
[[nodiscard]] Document removeOffsetKeys(const Document& document, int clip, double frame,
                                        std::span<const std::string> ids);

/// Nothing is offset at the frame: its key goes, and where others still offset there, a key without an
/// offset takes its place.
[[nodiscard]] Result<Document> resetOffsets(const Document& document, int clip, double frame,
                                            std::span<const std::string> ids);

/// Nothing is offset from one frame to another, both included: keys between go. What is keyed outside runs
/// out at the ends.
[[nodiscard]] Result<Document> resetOffsetsOver(const Document& document, int clip, const Vec2& frames,
                                                std::span<const std::string> ids);

/// How the curve passes the keys at the frame. A key that becomes free keeps the slope that it has.
[[nodiscard]] Document setKeyInterpolation(const Document& document, int clip, double frame,
                                           std::span<const std::string> ids,
                                           rig::KeyInterpolation interpolation);

/// Gives what adjusts each at the frame another range, or the whole clip. A range that leaves a key out, or
/// that reaches another adjustment of the same controller, is an error.
[[nodiscard]] Result<Document> setOffsetRange(const Document& document, int clip, double frame,
                                              std::span<const std::string> ids, const KeyRange& range);

} // namespace stretch::app
