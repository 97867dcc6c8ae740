#pragma once

#include <cstddef>

#include "app/document.h"
#include "app/things/place.h"
#include "rig/hold/hold.h"

namespace stretch::app {

/// Pins, grips and props through the door (app/things/place.h). A hold names hands, feet and nodes that the
/// character has; no hand is led by itself, through others or not.
[[nodiscard]] Result<Document> placeHolds(const Document& document, const rig::Holds& wanted,
                                          Entry entry = Entry::request);

/// One hold of a document: its place in the list of its kind.
struct HoldPlace {
  rig::HoldKind kind = rig::HoldKind::pin;
  std::size_t index = 0;

  friend bool operator==(const HoldPlace&, const HoldPlace&) = default;
};

/// Takes one hold away. What is not there is left alone.
[[nodiscard]] Document removeHold(const Document& document, const HoldPlace& place);

/// The hold at this place with another value; errors as those of placeHolds.
[[nodiscard]] Result<Document> changeHold(const Document& document, const HoldPlace& place,
                                          const rig::Holds& value);

/// The holds of one clip, in their order.
[[nodiscard]] rig::Holds holdsOfClip(const rig::Holds& holds, int clip);

} // namespace stretch::app
