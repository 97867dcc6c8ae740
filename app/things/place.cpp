#include "app/things/place.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "app/named.h"
#include "app/things/checks.h"

namespace stretch::app {

namespace {

template <typename T>
Error meeting(const T& wanted, const T& other) {
  if constexpr (isThing<T, rig::Trail>) {
    return {fmt::format("two trails of one limb may not overlap in time: there is one from {:g} to {:g}",
                        other.settings.startFrame, other.settings.endFrame),
            wanted.limb, "change the range, or edit that trail"};
  } else if constexpr (isThing<T, rig::Adjustment>) {
    return {"two adjustments of one controller overlap in time", wanted.controller,
            "give each a range of its own, or join their keys"};
  } else if constexpr (isThing<T, WeightedLimb>) {
    return {"the limb is named twice", wanted.limb, "name it once"};
  } else {
    return {"is held twice at the same time", subjectOf(wanted), "give each a range of its own"};
  }
}

// The limb of those in the list that is the same chain of joints by another name and acts at the same time:
// each would move what the other has moved. Empty where none does.
template <typename T>
std::string sameJointsIn(const Document& document, const T& thing, std::span<const T> list) {
  if constexpr (isThing<T, rig::Trail> || isThing<T, WeightedLimb>) {
    const rig::Limb* const limb = findLimb(document, thing.limb);
    for (T other : list) {
      std::string name = std::exchange(other.limb, thing.limb);
      const rig::Limb* const chain = findLimb(document, name);
      if (name != thing.limb && meets(other, thing) && limb != nullptr && chain != nullptr &&
          chain->joints == limb->joints) {
        return name;
      }
    }
  }
  return {};
}

template <typename T>
Status checkJoints(const Ground& ground, const T& thing, std::span<const T> beside,
                   const std::vector<T>& present) {
  std::string other = sameJointsIn<T>(ground.document, thing, beside);
  other = other.empty() ? sameJointsIn<T>(ground.document, thing, present) : other;
  return other.empty() || ground.entry == Entry::file
             ? Status(Success{})
             : Status(Error{"has the joints of " + other + ", which acts at the same time", subjectOf(thing),
                            "name the chain once, or give each a range of its own"});
}

// Where the wanted thing goes among those that it does not meet: a limb's weight to the place of the one that
// it replaces.
template <typename T>
void putIn(std::vector<T>& list, T thing) {
  const auto isMet = [&](const T& old) { return meets(old, thing); };
  const auto first = std::ranges::find_if(list, isMet);
  if (isThing<T, WeightedLimb> && first != list.end()) {
    *first = std::move(thing);
    return;
  }
  std::erase_if(list, isMet);
  list.push_back(std::move(thing));
}

template <typename T>
std::string gaveWayText(const T& old) {
  const Vec2 span = spanOf(old);
  const std::string frames =
      std::isfinite(span.x) ? fmt::format("from {:g} to {:g}", span.x, span.y) : "over the whole clip";
  const bool many = isThing<T, rig::Adjustment>;
  return fmt::format("{}: the {} {} that {} there {} way to the new one{}", subjectOf(old), kindTitle<T>(),
                     frames, many ? "were" : "was", many ? "give" : "gives", many ? "s" : "");
}

template <typename T>
Status placeAll(const Ground& ground, const std::vector<T>& wanted, Placed& placed) {
  std::vector<T>& list = listOf<T>(placed.document);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    T thing = wanted[i];
    if (Status fits = checkAlone(ground, thing); !fits) {
      return fits;
    }
    if (Status own = checkJoints<T>(ground, thing, std::span(wanted).first(i), list); !own) {
      return own;
    }
    const auto isMet = [&](const T& other) { return meets(other, thing); };
    const auto end = wanted.begin() + static_cast<std::ptrdiff_t>(i);
    if (const auto twice = std::find_if(wanted.begin(), end, isMet); twice != end) {
      return meeting(thing, *twice);
    }
    const auto met = std::ranges::find_if(list, isMet);
    if (met != list.end() && ground.entry != Entry::request) {
      return meeting(thing, *met);
    }
    if constexpr (isThing<T, rig::Trail>) {
      thing.id = thing.id > 0 ? thing.id : placed.document.nextTrailId;
      placed.document.nextTrailId = std::max(placed.document.nextTrailId, thing.id + 1);
      placed.trailIds.push_back(thing.id);
    }
    putIn(list, std::move(thing));
  }
  return Success{};
}

} // namespace

Result<Placed> place(const Document& document, const Things& wanted, Entry entry, const Document& before) {
  Placed placed{document, {}};
  Ground ground{document, before, entry, {}};
  if (!wanted.adjustments.empty()) {
    ground.controllers = controllersOf(document);
  }
  Status status = Success{};
  eachList(wanted, [&](const auto& list) { status = status ? placeAll(ground, list, placed) : status; });
  if (status && !wanted.holds.grips.empty()) {
    status = checkCircles(placed.document.holds);
  }
  return status ? Result<Placed>(std::move(placed)) : Result<Placed>(status.error());
}

Result<Placed> place(const Document& document, const Things& wanted, Entry entry) {
  return place(document, wanted, entry, document);
}

std::vector<std::string> gaveWay(const Document& before, const Document& after) {
  std::vector<std::string> lines;
  eachList(before, [&](const auto& list) {
    using T = typename std::remove_cvref_t<decltype(list)>::value_type;
    const std::vector<T>& now = listOf<T>(after);
    for (const T& old : list) {
      const bool isMet = std::ranges::any_of(now, [&](const T& thing) { return meets(thing, old); });
      if (!isThing<T, WeightedLimb> && isMet && std::ranges::find(now, old) == now.end()) {
        lines.push_back(gaveWayText(old));
      }
    }
  });
  return lines;
}

Result<Document> documentOf(Result<Placed> placed) {
  return placed ? Result<Document>(std::move(placed->document)) : Result<Document>(placed.error());
}

Status checkThings(const Document& document, int clip) {
  Things things;
  Document without = document;
  eachList(without, [&](auto& list) {
    using T = typename std::remove_cvref_t<decltype(list)>::value_type;
    for (const T& thing : list) {
      if (thing.clip == clip) {
        listOf<T>(things).push_back(thing);
      }
    }
    list.clear();
  });
  const Result<Placed> placed = place(without, things, Entry::file);
  return placed ? Status(Success{}) : Status(placed.error());
}

} // namespace stretch::app
