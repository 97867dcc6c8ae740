#include "ui/panels/rows/shown_holds.h"

#include <fmt/core.h>

#include "app/commands/table/frames.h"
#include "rig/motion/solve_holds.h"

namespace stretch::ui {

namespace {

constexpr int holdKinds = 3;

/// Range and stretch of a hold, whatever it is.
void changeTime(const app::Document& document, const app::HoldPlace& place, const HoldChange& change,
                rig::Holds& value) {
  switch (place.kind) {
  case rig::HoldKind::pin:
    value.pins.push_back(document.holds.pins[place.index]);
    change(value.pins.back().time, value.pins.back().stretch);
    break;
  case rig::HoldKind::grip:
    value.grips.push_back(document.holds.grips[place.index]);
    change(value.grips.back().time, value.grips.back().stretch);
    break;
  case rig::HoldKind::prop: {
    value.props.push_back(document.holds.props[place.index]);
    rig::Prop& prop = value.props.back();
    rig::HoldTime time = prop.time.value_or(rig::HoldTime{{0.0, app::lastFrame(document, prop.clip)}, {}});
    const rig::HoldTime before = time;
    change(time, prop.stretch);
    prop.time = prop.time || time != before ? std::optional(time) : std::nullopt;
    break;
  }
  }
}

std::string propTitle(const app::Document& document, const rig::Prop& prop) {
  std::string hands;
  for (const rig::PropHand& hand : prop.hands) {
    hands += (hands.empty() ? "" : " and ") + limbHeading(document, hand.limb);
  }
  const NodeIndex node = rig::propNode(*document.scene, prop.node);
  return fmt::format("{} in {}", node.exists() ? nodeName(*document.scene, node) : prop.node, hands);
}

} // namespace

void editHold(PanelContext& context, const EditPhase& phase, const std::string& label,
              const app::HoldPlace& place, const HoldChange& change) {
  editThrough(context, phase, label, [&](const app::Document& start) -> Result<app::Document> {
    rig::Holds value;
    changeTime(start, place, change, value);
    return app::changeHold(start, place, value);
  });
}

std::vector<ShownHold> shownHolds(const app::Document& document, int clip) {
  std::vector<ShownHold> shown;
  const rig::Holds& holds = document.holds;
  for (std::size_t i = 0; i < holds.pins.size(); ++i) {
    const rig::Pin& pin = holds.pins[i];
    if (pin.clip == clip) {
      shown.push_back({{rig::HoldKind::pin, i},
                       pin.limb,
                       limbHeading(document, pin.limb) + " pinned",
                       pin.time,
                       pin.stretch});
    }
  }
  for (std::size_t i = 0; i < holds.grips.size(); ++i) {
    const rig::Grip& grip = holds.grips[i];
    if (grip.clip == clip) {
      shown.push_back(
          {{rig::HoldKind::grip, i},
           grip.follower,
           limbHeading(document, grip.follower) + " follows " + limbHeading(document, grip.leader),
           grip.time,
           grip.stretch});
    }
  }
  for (std::size_t i = 0; i < holds.props.size(); ++i) {
    const rig::Prop& prop = holds.props[i];
    if (prop.clip == clip) {
      const rig::HoldTime whole{{0.0, app::lastFrame(document, clip)}, {}};
      shown.push_back({{rig::HoldKind::prop, i},
                       prop.hands.front().limb,
                       propTitle(document, prop),
                       prop.time.value_or(whole),
                       prop.stretch});
    }
  }
  return shown;
}

int barOfHold(const app::HoldPlace& place) {
  return -1 - static_cast<int>(place.index) * holdKinds - static_cast<int>(place.kind);
}

std::optional<app::HoldPlace> holdOfBar(int bar) {
  if (bar >= 0) {
    return std::nullopt;
  }
  const int number = -1 - bar;
  return app::HoldPlace{static_cast<rig::HoldKind>(number % holdKinds),
                        static_cast<std::size_t>(number / holdKinds)};
}

} // namespace stretch::ui
