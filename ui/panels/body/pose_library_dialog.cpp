#include <algorithm>
#include <cmath>

#include "app/commands/pose/posing.h"
#include "app/commands/table/command_ids.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/widgets/control.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

constexpr int columns = 3;

/// A pose: its picture over its name. True when it was clicked.
bool poseCard(PanelContext& context, std::size_t place, float width) {
  const PoseLibraryState& state = context.ui.body.library;
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const std::string& name = state.poses[place].name;
  const float pad = theme.px(4.0F);
  const float nameHeight = theme.px(20.0F);
  const Control card =
      takePlace(widgets, "pose-library/pose-" + std::to_string(place), {width, width + nameHeight});
  if (card.visible) {
    const bool isChosen = static_cast<int>(place) == state.chosen;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(card.box.min, card.box.max,
                        isChosen       ? theme.colours.accentQuiet
                        : card.hovered ? theme.colours.hovered
                                       : theme.colours.raised,
                        theme.corner());
    drawThumbnail(
        theme, place < state.pictures.size() ? state.pictures[place] : nullptr,
        {{card.box.min.x + pad, card.box.min.y + pad}, {card.box.max.x - pad, card.box.max.y - nameHeight}});
    drawText(widgets, theme.fonts.label,
             {{card.box.min.x + pad, card.box.max.y - nameHeight}, {card.box.max.x - pad, card.box.max.y}},
             theme.colours.text, name, 0.5F);
    if (isChosen) {
      list->AddRect(card.box.min, card.box.max, theme.colours.accent, theme.corner(), 0, theme.px(2.0F));
    }
  }
  tooltip(widgets, {name, "Shows the character in this pose.", {}});
  return card.clicked;
}

void choose(PoseLibraryState& state, int place) {
  state.chosen = place;
  state.typedName = state.poses[static_cast<std::size_t>(place)].name;
  state.changed = true;
  state.deleteAsked = false;
}

/// The poses, row by row; the arrows go through them.
void poseGrid(PanelContext& context) {
  PoseLibraryState& state = context.ui.body.library;
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  const float row = columnWidth(columns) + context.theme.px(20.0F) + gap;
  constexpr float mostRows = 2.3F; // A third one that is cut says that there are more.
  const std::size_t needed = (state.poses.size() + columns - 1) / columns;
  const float rows = std::min(static_cast<float>(needed), mostRows);
  if (!ImGui::GetIO().WantTextInput) {
    const int before = state.chosen;
    const int step = keyPressed(ImGuiKey_RightArrow, true)  ? 1
                     : keyPressed(ImGuiKey_LeftArrow, true) ? -1
                     : keyPressed(ImGuiKey_DownArrow, true) ? columns
                     : keyPressed(ImGuiKey_UpArrow, true)   ? -columns
                                                            : 0;
    const int next = std::clamp(before + step, 0, static_cast<int>(state.poses.size()) - 1);
    if (step != 0 && next != before) {
      choose(state, next);
      state.scrolls = true;
    }
  }
  ImGui::BeginChild("pose-library/poses", {0.0F, rows * row});
  const float width = columnWidth(columns);
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    if (i % columns != 0) {
      ImGui::SameLine();
    }
    if (poseCard(context, i, width)) {
      choose(state, static_cast<int>(i));
    }
    if (state.scrolls && static_cast<int>(i) == state.chosen) {
      ImGui::SetScrollHereY();
      state.scrolls = false;
    }
  }
  ImGui::EndChild();
}

/// Page up and down for the amount, Space for the other side.
void takeAmountKeys(PoseLibraryState& state) {
  constexpr double step = 0.1;
  if (ImGui::GetIO().WantTextInput) {
    return;
  }
  const double change = keyPressed(ImGuiKey_PageUp, true)     ? step
                        : keyPressed(ImGuiKey_PageDown, true) ? -step
                                                              : 0.0;
  const double amount = std::clamp(std::round((state.amount + change) / step) * step, 0.0, 1.0);
  if (change != 0.0 && amount != state.amount) {
    state.amount = amount;
    state.changed = true;
  }
  if (keyPressed(ImGuiKey_Space)) {
    state.mirrored = !state.mirrored;
    state.changed = true;
  }
}

void chosenRows(PanelContext& context) {
  PoseLibraryState& state = context.ui.body.library;
  takeAmountKeys(state);
  const WidgetContext widgets = widgetsOf(context);
  labelledRow(widgets, "Name", {"Name", "Of the pose in the library.", {}});
  state.renamed =
      editText(widgets, "pose-library/name", "A name of its own", state.typedName, 0.0F, false, true).ended ||
      state.renamed;
  const Help amountHelp{
      "Amount",
      "How far the character is brought into the pose. Drag, click and type, or press Page up and down.",
      {}};
  labelledRow(widgets, "Amount", amountHelp);
  const SliderSpec amount{.id = "pose-library/amount",
                          .minimum = 0.0,
                          .maximum = 1.0,
                          .step = 0.05,
                          .decimals = 0,
                          .suffix = " %",
                          .displayFactor = 100.0,
                          .defaultValue = 1.0,
                          .hardMinimum = 0.0,
                          .hardMaximum = 1.0,
                          .help = amountHelp};
  state.changed = slider(widgets, amount, state.amount).changed || state.changed;
  const Help mirroredHelp{"Mirrored", "Exchanges left and right, as Space does.", {}};
  labelledRow(widgets, "Mirrored", mirroredHelp);
  if (toggle(widgets, "pose-library/mirrored", state.mirrored ? "On" : "Off", state.mirrored, mirroredHelp)) {
    state.mirrored = !state.mirrored;
    state.changed = true;
  }
}

/// Which controllers the pose is for, and what it does not reach.
std::string remarkOf(const PanelContext& context) {
  const PoseLibraryState& state = context.ui.body.library;
  const app::Session& session = context.character();
  const bool isPart = !app::chosenControllers(session).empty();
  const std::string whom = "Put on " + app::chosenText(session) + (isPart ? " alone." : ".");
  return state.remark.empty() ? whom : whom + " " + capitalised(state.remark) + ".";
}

} // namespace

void drawPoseLibraryDialog(PanelContext& context) {
  PoseLibraryState& state = context.ui.body.library;
  if (!state.open || context.open.character() == nullptr) {
    return;
  }
  if (!beginDialog(context,
                   {.id = "pose-library",
                    .icon = icon::person,
                    .title = "Pose library",
                    .width = 360.0F,
                    .across = 1.0F,
                    .darkens = false},
                   state.open)) {
    return;
  }
  if (state.poses.empty()) {
    note(widgetsOf(context), "No poses yet. Pose the character, then press Keep this pose.");
  } else {
    poseGrid(context);
  }
  const float width = columnWidth(2);
  commandButton(context, {.command = command::poseKeep, .text = "Keep this pose", .width = width});
  ImGui::SameLine();
  commandButton(context, {.command = command::poseForget,
                          .text = state.deleteAsked ? "Delete for good" : "Delete",
                          .width = width});
  if (!state.refused.empty()) {
    notice(widgetsOf(context), NoticeKind::warning, state.refused);
  }
  const bool isChosen = state.chosen >= 0;
  if (isChosen) {
    chosenRows(context);
    note(widgetsOf(context), remarkOf(context));
  }
  const bool entered = enterPressed() && !ImGui::GetIO().WantTextInput;
  const int clicked = dialogButtons(context, "pose-library",
                                    {{.id = "", .text = isChosen ? "Cancel" : "Close"},
                                     {.id = "", .text = "Pose", .enabled = isChosen && state.reaches}});
  state.accepted = state.accepted || ((entered || clicked == 1) && isChosen && state.reaches);
  state.open = state.open && clicked != 0 && !state.accepted;
  if (!state.open) {
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
