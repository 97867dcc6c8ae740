#include <array>
#include <cmath>

#include "core/gltf/json/json.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/context/view_schema.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// What the row above does, in its column: nobody has to wait for a tooltip here.
void explain(PanelContext& context, const std::string& text) {
  const float column = context.theme.px(104.0F); // Where labelledRow puts values in a panel of this width.
  ImGui::Indent(column);
  note(widgetsOf(context), text);
  ImGui::Unindent(column);
}

/// The help of a setting; of one with choices that of the chosen one.
std::string explanationOf(const app::Setting<UiState>& setting, const UiState& ui) {
  const auto value = setting.read(ui);
  for (const app::SettingChoice& choice : setting.choices) {
    if (value == choice.name) {
      return choice.help;
    }
  }
  return setting.help;
}

void interfaceScaleRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  UiState& ui = context.ui;
  constexpr std::array<float, 5> sizes{0.85F, 1.0F, 1.25F, 1.5F, 2.0F};
  std::vector<Choice> choices;
  int selected = -1;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::string percent = shortNumber(static_cast<double>(sizes[i]) * 100.0, 0) + "%";
    choices.push_back({percent, {"Size " + percent, "On top of the screen's own scale.", {}}});
    selected = std::abs(sizes[i] - ui.scale) < 0.01F ? static_cast<int>(i) : selected;
  }
  labelledRow(widgets, "Size", {"Size of text and controls", "On top of the screen's own scale.", {}});
  if (const int chosen = segmented(widgets, "settings/scale", choices, selected); chosen >= 0) {
    ui.scale = sizes[static_cast<std::size_t>(chosen)];
    ui.answers.themeChanged = true;
  }
  explain(context, "On top of the screen's own scale: together " +
                       shortNumber(static_cast<double>(context.theme.scale) * 100.0, 0) + " %.");
}

const app::Setting<UiState>& windowSetting(const std::string& name) {
  return *app::findSetting(windowSchema(), name);
}

void themeRow(PanelContext& context) {
  if (viewRow(context, "settings/", windowSetting("theme"), context.ui)) {
    context.ui.answers.themeChanged = true;
  }
  explain(context, explanationOf(windowSetting("theme"), context.ui));
}

void navigationRow(PanelContext& context) {
  if (viewRow(context, "settings/", windowSetting("navigation"), context.ui)) {
    context.ui.answers.navigation = context.ui.navigation;
  }
  explain(context, explanationOf(windowSetting("navigation"), context.ui));
}

} // namespace

void drawSettingsDialog(PanelContext& context) {
  UiState& ui = context.ui;
  if (!beginDialog(context, {.id = "settings", .icon = icon::cog, .title = "Settings", .width = 520.0F},
                   ui.dialogs.settingsOpen)) {
    return;
  }
  themeRow(context);
  interfaceScaleRow(context);
  navigationRow(context);
  for (const char* name : {"form", "key_frames", "touch"}) {
    viewRow(context, "settings/", windowSetting(name), context.ui);
    explain(context, explanationOf(windowSetting(name), context.ui));
  }
  for (const char* name : {"snap", "exaggerate_at_tip", "every_frame", "on_twos"}) {
    viewRow(context, "settings/", windowSetting(name), context.ui);
    explain(context, windowSetting(name).help);
  }
  const int clicked = dialogButtons(context, "settings",
                                    {{.id = "",
                                      .icon = icon::keyboard,
                                      .text = "Keys",
                                      .help = {"All keys", "Shows and changes every key.", {}}},
                                     {.id = "", .text = "Close"}});
  if (clicked >= 0) {
    ui.dialogs.settingsOpen = false;
    ui.dialogs.keys.open = clicked == 0;
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
