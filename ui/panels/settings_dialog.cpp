#include "ui/panels/dialog_frame.h"
#include "ui/panels/panel_support.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

void themeRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  UiState& ui = context.ui;
  labelledRow(widgets, "Theme", {"Theme", "Colours of the whole program.", {}});
  const std::vector<Choice> choices{
      {"Dark", {"Dark theme", "Calm and dark: the character is the brightest thing.", {}}},
      {"Light", {"Light theme", "For bright rooms.", {}}},
      {"Contrast", {"High contrast", "Black and white with bright edges.", {}}}};
  if (const int chosen = segmented(widgets, "settings/theme", choices, static_cast<int>(ui.theme));
      chosen >= 0) {
    ui.theme = static_cast<ThemeKind>(chosen);
    ui.answers.themeChanged = true;
  }
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
}

void navigationRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  labelledRow(widgets, "Navigation", {"Navigation", "How the mouse turns the view.", {}});
  const std::vector<Choice> choices{
      {"Maya", {"Maya", "Alt with the left, middle and right button: orbit, pan, zoom.", {}}},
      {"Blender", {"Blender", "Middle button orbits, Shift+middle pans, the wheel zooms.", {}}}};
  if (const int chosen =
          segmented(widgets, "settings/navigation", choices, static_cast<int>(context.ui.navigation));
      chosen >= 0) {
    context.ui.navigation = static_cast<NavigationStyle>(chosen);
    context.ui.answers.navigation = context.ui.navigation;
  }
}

} // namespace

void drawSettingsDialog(PanelContext& context) {
  UiState& ui = context.ui;
  if (!beginDialog(context, {.id = "settings", .icon = icon::cog, .title = "Settings", .width = 520.0F},
                   ui.settingsOpen)) {
    return;
  }
  const WidgetContext widgets = widgetsOf(context);
  themeRow(context);
  interfaceScaleRow(context);
  navigationRow(context);
  labelledRow(widgets, "Timeline", {"Timeline", "What the mouse does in the timeline.", {}});
  if (toggle(widgets, "settings/snap", "Snap to whole frames", ui.timeline.snapToFrames,
             {"Snap to whole frames", "Playhead and ranges stop at whole frames.", {}})) {
    ui.timeline.snapToFrames = !ui.timeline.snapToFrames;
  }
  const int clicked = dialogButtons(context, "settings",
                                    {{.id = "",
                                      .icon = icon::keyboard,
                                      .text = "Keys",
                                      .help = {"All keys", "Shows and changes every key.", {}}},
                                     {.id = "", .text = "Close"}});
  if (clicked >= 0) {
    ui.settingsOpen = false;
    ui.keys.open = clicked == 0;
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
