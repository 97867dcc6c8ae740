#include "app/edits/pose/hold_edits.h"

#include <algorithm>
#include <iterator>

namespace stretch::app {

namespace {

template <typename Hold>
std::vector<Hold> heldInClip(const std::vector<Hold>& all, int clip) {
  std::vector<Hold> some;
  std::ranges::copy_if(all, std::back_inserter(some), [&](const Hold& hold) { return hold.clip == clip; });
  return some;
}

template <typename Hold>
void removeAt(std::vector<Hold>& list, std::size_t index) {
  if (index < list.size()) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
  }
}

// The hold that was added last goes to the place of the one that it stands for.
template <typename Hold>
void bringTo(std::vector<Hold>& list, std::size_t index) {
  if (index < list.size()) {
    std::rotate(list.begin() + static_cast<std::ptrdiff_t>(index), list.end() - 1, list.end());
  }
}

} // namespace

Result<Document> placeHolds(const Document& document, const rig::Holds& wanted, Entry entry) {
  return documentOf(place(document, {{}, {}, wanted, {}}, entry));
}

Document removeHold(const Document& document, const HoldPlace& place) {
  Document changed = document;
  switch (place.kind) {
  case rig::HoldKind::pin:
    removeAt(changed.holds.pins, place.index);
    break;
  case rig::HoldKind::grip:
    removeAt(changed.holds.grips, place.index);
    break;
  case rig::HoldKind::prop:
    removeAt(changed.holds.props, place.index);
    break;
  }
  return changed;
}

Result<Document> changeHold(const Document& document, const HoldPlace& place, const rig::Holds& value) {
  Result<Document> changed =
      documentOf(app::place(removeHold(document, place), {{}, {}, value, {}}, Entry::hand, document));
  if (changed) {
    bringTo(changed->holds.pins, place.kind == rig::HoldKind::pin ? place.index : changed->holds.pins.size());
    bringTo(changed->holds.grips,
            place.kind == rig::HoldKind::grip ? place.index : changed->holds.grips.size());
    bringTo(changed->holds.props,
            place.kind == rig::HoldKind::prop ? place.index : changed->holds.props.size());
  }
  return changed;
}

rig::Holds holdsOfClip(const rig::Holds& holds, int clip) {
  return {heldInClip(holds.pins, clip), heldInClip(holds.grips, clip), heldInClip(holds.props, clip)};
}

} // namespace stretch::app
