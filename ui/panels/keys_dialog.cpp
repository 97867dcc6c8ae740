#include <algorithm>

#include "ui/panels/dialog_frame.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

std::string groupOf(const std::string& commandId) {
  return capitalised(commandId.substr(0, commandId.find('.')));
}

void keyCell(PanelContext& context, const CommandInfo& command) {
  KeysOverviewState& keys = context.ui.keys;
  const bool waiting = keys.waitingFor == command.id;
  ButtonSpec cell;
  cell.id = "keys/" + command.id;
  cell.text = waiting ? "press a key" : command.keyText.empty() ? "none" : command.keyText;
  cell.on = waiting;
  cell.width = context.theme.px(136.0F);
  cell.help = {
      "Change the key", "Click, then press the new key. Backspace takes the key away, Esc keeps it.", {}};
  if (button(widgetsOf(context), cell)) {
    keys.waitingFor = waiting ? std::string() : command.id;
    keys.clash.clear();
  }
}

void commandRow(PanelContext& context, const CommandInfo& command) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const float keyWidth = theme.px(136.0F);
  const float width = ImGui::GetContentRegionAvail().x - keyWidth - theme.unit();
  const Control row = takePlace(widgets, "keys/label/" + command.id, {width, theme.rowHeight()}, false);
  if (row.visible) {
    const float split = row.box.min.x + std::floor(width * 0.38F);
    drawText(widgets, theme.fonts.body,
             {{row.box.min.x + theme.unit(), row.box.min.y}, {split, row.box.max.y}}, theme.colours.text,
             command.label);
    drawText(widgets, theme.fonts.label, {{split + theme.unit(), row.box.min.y}, row.box.max},
             theme.colours.quietText, command.help);
  }
  tooltip(widgets, {command.label, command.help, command.keyText});
  ImGui::SameLine(0.0F, theme.unit());
  keyCell(context, command);
}

/// Takes the key that was pressed while one is awaited.
void takeKey(PanelContext& context) {
  KeysOverviewState& keys = context.ui.keys;
  const std::string& pressed = context.status.pressedKey;
  if (keys.waitingFor.empty() || pressed.empty()) {
    return;
  }
  if (pressed != "Escape" && pressed != "Esc") {
    const auto other =
        std::find_if(context.commands.begin(), context.commands.end(),
                     [&](const CommandInfo& c) { return c.keyText == pressed && c.id != keys.waitingFor; });
    keys.clash = other == context.commands.end()
                     ? std::string()
                     : pressed + " was the key of \"" + other->label + "\", which has none now.";
    context.ui.answers.keyChange =
        KeyChange{keys.waitingFor, pressed == "Backspace" ? std::string() : pressed};
  }
  keys.waitingFor.clear();
}

bool matches(const std::string& filter, const CommandInfo& command) {
  return filter.empty() || fuzzyScore(filter, command.label).has_value() || command.keyText == filter;
}

void commandList(PanelContext& context) {
  ImGui::BeginChild("keys/list", {0.0F, ImGui::GetContentRegionAvail().y - context.theme.px(44.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.theme.unit(), context.theme.px(2.0F)));
  std::string group;
  for (const CommandInfo& command : context.commands) {
    if (!matches(context.ui.keys.filter, command)) {
      continue;
    }
    if (groupOf(command.id) != group) {
      group = groupOf(command.id);
      verticalSpace(widgetsOf(context), 10.0F);
      note(widgetsOf(context), group);
    }
    commandRow(context, command);
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

} // namespace

void drawKeysOverview(PanelContext& context) {
  KeysOverviewState& keys = context.ui.keys;
  const bool awaiting = !keys.waitingFor.empty();
  DialogSpec spec{
      .id = "keys", .icon = icon::keyboard, .title = "All keys", .width = 860.0F, .height = 600.0F};
  spec.closable = !awaiting; // Esc ends the waiting first
  takeKey(context);
  if (!beginDialog(context, spec, keys.open)) {
    keys.waitingFor.clear();
    return;
  }
  textField(widgetsOf(context), "keys/filter", "Search by name, or type a key", keys.filter);
  if (!keys.clash.empty()) {
    notice(widgetsOf(context), NoticeKind::warning, keys.clash);
  }
  commandList(context);
  const int clicked =
      dialogButtons(context, "keys",
                    {{.id = "",
                      .text = "Defaults",
                      .help = {"Default keys", "Gives every command its first key again.", {}}},
                     {.id = "", .text = "Close"}});
  context.ui.answers.resetKeys = context.ui.answers.resetKeys || clicked == 0;
  if (clicked == 1) {
    keys.open = false;
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
