#include "ui/panels/trails/trail_sections.h"

#include <algorithm>
#include <functional>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/pose/prop_file_edits.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/rows/shown_holds.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

/// Two numbers of frames beside each other: a range, or the blends beside it.
struct FramePair {
  const char* id = "";
  const char* label = "";
  const char* text = "";
  double maximum = 0.0;
  Vec2 value{0.0};
};

void pairRow(PanelContext& context, const std::string& id, const FramePair& pair,
             const std::function<void(const EditPhase&, const Vec2&)>& set) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help{pair.label, pair.text, {}};
  labelledRow(widgets, pair.label, help);
  for (int side = 0; side < 2; ++side) {
    SliderSpec spec{.id = id + "/" + pair.id + (side == 0 ? "-first" : "-last"),
                    .maximum = pair.maximum,
                    .step = 1.0,
                    .decimals = frameDecimals(pair.value[side]),
                    .showsFill = false,
                    .width = columnWidth(2)};
    spec.help = dragHelp(help);
    double number = pair.value[side];
    const EditPhase phase = slider(widgets, spec, number);
    Vec2 changed = pair.value;
    changed[side] = number;
    set(phase, changed);
    if (side == 0) {
      ImGui::SameLine();
    }
  }
}

void holdRows(PanelContext& context, const std::string& id, const ShownHold& hold) {
  const WidgetContext widgets = widgetsOf(context);
  const double last = app::lastFrame(context.character().document(), context.character().view().clip);
  pairRow(context, id,
          {"range", "Range", "First and last frame over which it is held.", last, hold.time.rangeFrames},
          [&](const EditPhase& phase, const Vec2& wanted) {
            // Neither end takes the other along: a number may be typed whose first digit lies beyond it.
            const Vec2& now = hold.time.rangeFrames;
            const Vec2 range(std::min(wanted.x, now.y), std::max(wanted.y, now.x));
            editHold(context, phase, "Change the range of a hold", hold.place,
                     [&](rig::HoldTime& time, double&) { time.rangeFrames = range; });
          });
  pairRow(context, id,
          {"blend", "Blend", "Frames in which it comes before the range, and goes after it.", 30.0,
           hold.time.blendFrames},
          [&](const EditPhase& phase, const Vec2& wanted) {
            editHold(context, phase, "Change the blend of a hold", hold.place,
                     [&](rig::HoldTime& time, double&) { time.blendFrames = wanted; });
          });
  const Help help{"Stretch", "1: the limb stretches to stay. 0: it keeps its length and falls short.", {}};
  labelledRow(widgets, "Stretch", help);
  SliderSpec spec{.id = id + "/stretch", .defaultValue = 1.0, .help = dragHelp(help)};
  double stretch = hold.stretch;
  const EditPhase phase = slider(widgets, spec, stretch);
  editHold(context, phase, "Change how far a held limb stretches", hold.place,
           [&](rig::HoldTime&, double& switched) { switched = stretch; });
}

void deleteButton(PanelContext& context, const std::string& id, const ShownHold& hold) {
  const bool clicked =
      button(widgetsOf(context), {.id = id + "/delete",
                                  .icon = icon::trash,
                                  .text = "Take it away",
                                  .help = {"Take it away", hold.title + ": no longer held.", {}},
                                  .emphasis = Emphasis::quiet,
                                  .width = ImGui::GetContentRegionAvail().x});
  if (clicked) {
    editOnce(context, "Take a hold away", app::takeHoldAway(context.character().document(), hold.place));
  }
}

void makeButtons(PanelContext& context) {
  const float half = columnWidth(2);
  commandButton(context, {.command = command::holdPin, .width = half});
  ImGui::SameLine();
  commandButton(context, {.command = command::holdPinFeet, .width = ImGui::GetContentRegionAvail().x});
  commandButton(context, {.command = command::holdMatch, .text = "Match other hand", .width = half});
  ImGui::SameLine();
  commandButton(
      context,
      {.command = command::holdProp, .text = "Hold a prop", .width = ImGui::GetContentRegionAvail().x});
}

} // namespace

void holdSection(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  std::vector<std::string>& closed = context.ui.closedSections;
  if (!section(widgets, "holds/section", "Pins, grips, props", closed)) {
    return;
  }
  makeButtons(context);
  const app::Session& session = context.character();
  int number = 0;
  for (const ShownHold& hold : shownHolds(session.document(), session.view().clip)) {
    const std::string id = "holds/" + std::to_string(number++);
    const std::string title = fmt::format("{}, {} to {}", hold.title, shortNumber(hold.time.rangeFrames.x, 1),
                                          shortNumber(hold.time.rangeFrames.y, 1));
    if (section(widgets, id, title, closed)) {
      holdRows(context, id, hold);
      deleteButton(context, id, hold);
    }
  }
}

} // namespace stretch::ui
