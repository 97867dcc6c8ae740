#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/edits/pose/hold_edits.h"
#include "ui/panels/context/panel_context.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

// Pins, grips and props of the viewed clip, as their section and the timeline show and edit them.

struct ShownHold {
  app::HoldPlace place;
  std::string limb;  ///< That is held; of a prop the first that holds it.
  std::string title; ///< "Left hand follows right hand".
  rig::HoldTime time;
  double stretch = 1.0;
};

[[nodiscard]] std::vector<ShownHold> shownHolds(const app::Document& document, int clip);

using HoldChange = std::function<void(rig::HoldTime&, double& stretch)>;

/// Range, blend and stretch of a hold, whatever it is, edited from press to release.
void editHold(PanelContext& context, const EditPhase& phase, const std::string& label,
              const app::HoldPlace& place, const HoldChange& change);

/// The bar of a hold on the timeline, whose id is below 0; nothing for the bar of a trail.
[[nodiscard]] int barOfHold(const app::HoldPlace& place);
[[nodiscard]] std::optional<app::HoldPlace> holdOfBar(int bar);

} // namespace stretch::ui
