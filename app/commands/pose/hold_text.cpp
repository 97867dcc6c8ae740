#include "app/commands/pose/hold_text.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/named.h"
#include "rig/motion/solve_holds.h"

namespace stretch::app {

namespace {

// One hold as it is told.
struct ToldHold {
  std::string title; // what is held
  std::string range;
};

double toldFrame(double frame) {
  return std::round(100.0 * frame) / 100.0;
}

std::string toldRange(const Vec2& frames) {
  return fmt::format("{:g} to {:g}", toldFrame(frames.x), toldFrame(frames.y));
}

template <typename Hold, typename Tell>
void addMissing(const std::vector<Hold>& from, const std::vector<Hold>& other, const Tell& tell,
                std::vector<ToldHold>& told) {
  for (const Hold& hold : from) {
    if (std::ranges::find(other, hold) == other.end()) {
      told.push_back(tell(hold));
    }
  }
}

// The holds of one document that the other does not have.
std::vector<ToldHold> holdsOnlyIn(const Document& document, const Document& other) {
  std::vector<ToldHold> told;
  addMissing(
      document.holds.pins, other.holds.pins,
      [&](const rig::Pin& pin) {
        return ToldHold{limbTitle(document, pin.limb), toldRange(pin.time.rangeFrames)};
      },
      told);
  addMissing(
      document.holds.grips, other.holds.grips,
      [&](const rig::Grip& grip) {
        return ToldHold{limbTitle(document, grip.follower) + " with " + limbTitle(document, grip.leader),
                        toldRange(grip.time.rangeFrames)};
      },
      told);
  addMissing(
      document.holds.props, other.holds.props,
      [&](const rig::Prop& prop) {
        std::vector<std::string> hands;
        for (const rig::PropHand& hand : prop.hands) {
          hands.push_back(limbTitle(document, hand.limb));
        }
        const NodeIndex node = rig::propNode(*document.scene, prop.node);
        const std::string thing = node.exists() ? nodeTitle(document, node) : prop.node;
        return ToldHold{thing + " in " + listed(hands),
                        prop.time ? toldRange(prop.time->rangeFrames) : std::string("over the whole clip")};
      },
      told);
  return told;
}

// The ranges of each title, in the order of the titles.
std::vector<std::pair<std::string, std::vector<std::string>>> byTitle(const std::vector<ToldHold>& holds) {
  std::vector<std::pair<std::string, std::vector<std::string>>> titles;
  for (const ToldHold& hold : holds) {
    auto known = std::ranges::find_if(titles, [&](const auto& title) { return title.first == hold.title; });
    if (known == titles.end()) {
      titles.push_back({hold.title, {}});
      known = titles.end() - 1;
    }
    known->second.push_back(hold.range);
  }
  return titles;
}

// Many are told by the first of them: a message is read at a glance.
std::string toldRanges(std::vector<std::string> ranges) {
  constexpr std::size_t most = 3;
  if (ranges.size() > most) {
    const std::size_t more = ranges.size() - (most - 1);
    ranges.resize(most - 1);
    ranges.push_back(fmt::format("{} more", more));
  }
  return listed(ranges);
}

// The trails that new pins outweigh: what is pinned stays, whatever its trail makes of the limb.
std::string outweighed(const Document& before, const Document& after) {
  const auto isNew = [&](const rig::Pin& pin) {
    return std::ranges::none_of(before.holds.pins, [&](const rig::Pin& old) {
      return old.limb == pin.limb && old.clip == pin.clip && old.time.rangeFrames == pin.time.rangeFrames;
    });
  };
  std::vector<std::string> ranges;
  for (const rig::Trail& trail : after.trails) {
    const Vec2 frames(trail.settings.startFrame, trail.settings.endFrame);
    const bool isPinned = std::ranges::any_of(after.holds.pins, [&](const rig::Pin& pin) {
      const Vec2 range = pin.time.rangeFrames;
      return pin.limb == trail.limb && pin.clip == trail.clip && range.x < frames.y && frames.x < range.y &&
             isNew(pin);
    });
    if (isPinned && trail.connected) {
      ranges.push_back(toldRange(frames));
    }
  }
  return ranges.empty() ? "" : ", instead of the trail of " + toldRanges(std::move(ranges));
}

} // namespace

std::string holdChangeText(const Document& before, const Document& after) {
  const std::vector<ToldHold> added = holdsOnlyIn(after, before);
  const std::vector<ToldHold> removed = holdsOnlyIn(before, after);
  const auto oldTitles = byTitle(removed);
  std::string text;
  for (const auto& [title, ranges] : byTitle(added.empty() ? removed : added)) {
    text += (text.empty() ? "" : ", ") + title + " " + toldRanges(ranges);
    const auto old =
        std::ranges::find_if(oldTitles, [&title = title](const auto& one) { return one.first == title; });
    if (!added.empty() && old != oldTitles.end() && old->second != ranges) {
      text += " in the place of " + toldRanges(old->second);
    }
  }
  return text + outweighed(before, after);
}

} // namespace stretch::app
