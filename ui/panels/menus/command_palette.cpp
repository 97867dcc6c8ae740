#include <algorithm>

#include <fmt/format.h>

#include "app/commands/keys/clips.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/rows/clip_name.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// A command, or a clip or a style that is chosen by its name.
struct Entry {
  CommandInfo shown;
  int clip = -1;  ///< To be viewed; -1: none.
  int style = -1; ///< Into TrailPanels::styles, to be looked at on the clip; -1: none.
};

struct Match {
  Entry entry;
  int score = 0;
};

/// The commands, and where something was typed the clips and the styles; or the clips alone.
std::vector<Entry> entriesOf(const PanelContext& context) {
  const PaletteState& palette = context.ui.dialogs.palette;
  std::vector<Entry> entries;
  for (const CommandInfo& command : context.commands) {
    if (!palette.clipsOnly) {
      entries.push_back({command});
    }
  }
  if (!hasViewedClip(context) || (palette.typed.empty() && !palette.clipsOnly)) {
    return entries;
  }
  const std::vector<Clip>& clips = *context.character().document().clips;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const int clip = static_cast<int>(i);
    const std::string name = clipName(clips[i].name, i);
    const std::string help = fmt::format("{:.2f} s", clips[i].endSeconds);
    entries.push_back(
        {{"clip-" + std::to_string(i), palette.clipsOnly ? name : "Clip: " + name, help, ""}, clip});
  }
  const std::vector<rig::Style>& styles = context.ui.trails.styles;
  for (std::size_t i = 0; i < (palette.clipsOnly ? 0 : styles.size()); ++i) {
    entries.push_back({{"style-" + styles[i].name, "Style: " + styles[i].name,
                        "Shows the clip exaggerated in this style, to be kept or not.", ""},
                       -1,
                       static_cast<int>(i)});
  }
  return entries;
}

/// Entries that answer what was typed, the best first and those that are off last; a match in the help
/// counts less than one in the label.
std::vector<Match> matchesOf(const PanelContext& context) {
  const std::string& typed = context.ui.dialogs.palette.typed;
  std::vector<Match> matches;
  for (Entry& entry : entriesOf(context)) {
    if (typed.empty()) {
      matches.push_back({std::move(entry)}); // In the order of the menus.
      continue;
    }
    const CommandInfo& command = entry.shown;
    const std::optional<int> label = wordScore(typed, command.label);
    const bool both = !label && typed.size() >= 3; // words of the label and words of the help
    const std::optional<int> help =
        both ? wordScore(typed, command.label + " " + command.help, false) : std::nullopt;
    if (label || help) {
      constexpr int farBehind = 200;
      matches.push_back({std::move(entry), label ? *label : *help - farBehind});
    }
  }
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    const bool isOn = a.entry.shown.enabled;
    return isOn == b.entry.shown.enabled ? a.score > b.score : isOn;
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

void runAndClose(PanelContext& context, const Entry& entry) {
  if (entry.clip >= 0) {
    app::showClip(context.character(), entry.clip);
  } else if (entry.style >= 0) {
    context.ui.trails.clipStyle.style = entry.style;
    request(context, command::clipExaggerate);
  } else {
    request(context, entry.shown.id);
  }
  context.ui.dialogs.palette.open = false;
  ImGui::CloseCurrentPopup();
}

void results(PanelContext& context, bool opening) {
  PaletteState& palette = context.ui.dialogs.palette;
  const std::vector<Match> matches = matchesOf(context);
  moveHighlight(palette.highlighted, static_cast<int>(matches.size()));
  const bool entered = enterPressed();
  ImGui::BeginChild("palette/list", {0.0F, ImGui::GetContentRegionAvail().y});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const CommandInfo& command = matches[i].entry.shown;
    const bool highlighted = static_cast<int>(i) == palette.highlighted;
    if (commandRow(context, command, highlighted) || (highlighted && entered && command.enabled)) {
      runAndClose(context, matches[i].entry);
    }
    if (highlighted &&
        (opening || keyPressed(ImGuiKey_DownArrow, true) || keyPressed(ImGuiKey_UpArrow, true))) {
      ImGui::SetScrollHereY(0.5F);
    }
  }
  ImGui::PopStyleVar();
  if (matches.empty()) {
    const bool clipsOnly = palette.clipsOnly;
    emptyState(widgetsOf(context), icon::search,
               clipsOnly ? "No clip is called that" : "No command, clip or style is called that",
               clipsOnly ? "Try a part of its name." : R"(Try another word: "trail", "view", "save".)");
  }
  ImGui::EndChild();
}

} // namespace

void drawCommandPalette(PanelContext& context) {
  PaletteState& palette = context.ui.dialogs.palette;
  const bool opening = palette.open && !palette.wasOpen;
  palette.wasOpen = palette.open;
  if (opening) {
    palette.highlighted = palette.clipsOnly ? context.character().view().clip : 0;
  }
  if (!beginDialog(context,
                   {.id = "palette",
                    .icon = icon::search,
                    .title = palette.clipsOnly ? "Clips" : "Commands",
                    .width = 620.0F,
                    .height = 420.0F},
                   palette.open)) {
    return;
  }
  const bool appears = opening || ImGui::IsWindowAppearing();
  const char* const hint = palette.clipsOnly ? "Search a clip" : "What do you want to do?";
  if (textField(widgetsOf(context), "palette/typed", hint, palette.typed, 0.0F, appears)) {
    palette.highlighted = 0;
  }
  results(context, appears);
  endDialog();
}

} // namespace stretch::ui
