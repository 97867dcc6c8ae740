#include <algorithm>

#include "ui/panels/context/dialog_frame.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

struct Match {
  const CommandInfo* command;
  int score;
};

/// Commands that answer what was typed, the best first and those that are off last; a match in the help
/// counts less than one in the label.
std::vector<Match> matchesOf(const PanelContext& context) {
  const std::string& typed = context.ui.dialogs.palette.typed;
  std::vector<Match> matches;
  for (const CommandInfo& command : context.commands) {
    if (typed.empty()) {
      matches.push_back({&command, 0}); // In the order of the menus.
      continue;
    }
    const std::optional<int> label = wordScore(typed, command.label);
    const bool both = !label && typed.size() >= 3; // words of the label and words of the help
    const std::optional<int> help =
        both ? wordScore(typed, command.label + " " + command.help, false) : std::nullopt;
    if (label || help) {
      constexpr int farBehind = 200;
      matches.push_back({&command, label ? *label : *help - farBehind});
    }
  }
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    return a.command->enabled == b.command->enabled ? a.score > b.score : a.command->enabled;
  });
  return matches;
}

/// Draws one command; true when it was clicked.
bool commandRow(PanelContext& context, const CommandInfo& command, bool highlighted) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const Control row = takePlace(widgets, "palette/" + command.id,
                                {ImGui::GetContentRegionAvail().x, theme.px(32.0F)}, command.enabled);
  const std::string key = keyOf(context, command.id);
  if (row.visible) {
    const ThemeColours& colours = theme.colours;
    if (highlighted || row.hovered) {
      ImGui::GetWindowDrawList()->AddRectFilled(
          row.box.min, row.box.max, highlighted ? colours.accentQuiet : colours.raised, theme.corner());
    }
    const float opacity = command.enabled ? 1.0F : 0.5F;
    const float left = row.box.min.x + theme.unit();
    const float labelWidth = std::min(textSize(theme.fonts.body, command.label).x, row.box.width() * 0.6F);
    drawText(widgets, theme.fonts.body, {{left, row.box.min.y}, {left + labelWidth, row.box.max.y}},
             faded(colours.text, opacity), command.label);
    const float keyWidth = key.empty() ? 0.0F : textSize(theme.fonts.label, key).x + theme.px(26.0F);
    drawText(widgets, theme.fonts.label,
             {{left + labelWidth + theme.px(14.0F), row.box.min.y},
              {row.box.max.x - keyWidth - theme.unit(), row.box.max.y}},
             colours.quietText, command.enabled ? command.help : capitalised(command.reason));
    if (!key.empty()) {
      keyCap(widgets, {row.box.max.x - keyWidth + theme.unit(), row.box.min.y + theme.px(7.0F)}, key);
    }
  }
  return row.clicked;
}

void runAndClose(PanelContext& context, const CommandInfo& command) {
  request(context, command.id);
  context.ui.dialogs.palette.open = false;
  ImGui::CloseCurrentPopup();
}

void results(PanelContext& context) {
  PaletteState& palette = context.ui.dialogs.palette;
  const std::vector<Match> matches = matchesOf(context);
  moveHighlight(palette.highlighted, static_cast<int>(matches.size()));
  const bool entered = enterPressed();
  ImGui::BeginChild("palette/list", {0.0F, ImGui::GetContentRegionAvail().y});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const CommandInfo& command = *matches[i].command;
    const bool highlighted = static_cast<int>(i) == palette.highlighted;
    if (commandRow(context, command, highlighted) || (highlighted && entered && command.enabled)) {
      runAndClose(context, command);
    }
    if (highlighted && (keyPressed(ImGuiKey_DownArrow, true) || keyPressed(ImGuiKey_UpArrow, true))) {
      ImGui::SetScrollHereY(0.5F);
    }
  }
  ImGui::PopStyleVar();
  if (matches.empty()) {
    emptyState(widgetsOf(context), icon::search, "No command is called that",
               R"(Try another word: "trail", "view", "save".)");
  }
  ImGui::EndChild();
}

} // namespace

void drawCommandPalette(PanelContext& context) {
  PaletteState& palette = context.ui.dialogs.palette;
  const bool opening = palette.open && !palette.wasOpen;
  palette.wasOpen = palette.open;
  if (opening) {
    palette.highlighted = 0;
  }
  if (!beginDialog(
          context,
          {.id = "palette", .icon = icon::search, .title = "Commands", .width = 620.0F, .height = 420.0F},
          palette.open)) {
    return;
  }
  if (textField(widgetsOf(context), "palette/typed", "What do you want to do?", palette.typed, 0.0F,
                opening || ImGui::IsWindowAppearing())) {
    palette.highlighted = 0;
  }
  results(context);
  endDialog();
}

} // namespace stretch::ui
