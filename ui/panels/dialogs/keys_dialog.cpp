#include <algorithm>
#include <iterator>
#include <string_view>

#include "ui/panels/context/dialog_frame.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// Not what the command would do now.
const std::string& nameOf(const CommandInfo& command) {
  return command.name.empty() ? command.label : command.name;
}

/// Headings by the first part of a command's id, in the order of the list.
struct KeyGroup {
  std::string_view prefix;
  const char* title;
};
constexpr KeyGroup keyGroups[] = {{"file", "File"},
                                  {"recipe", "Recipes"},
                                  {"edit", "Edit"},
                                  {"limb", "Limbs"},
                                  {"rig", "Limbs"},
                                  {"range", "Range"},
                                  {"trail", "Trails"},
                                  {"sphere", "Control spheres"},
                                  {"weight", "Weight"},
                                  {"time", "Time"},
                                  {"play", "Time"},
                                  {"clip", "Clips"},
                                  {"view", "View"},
                                  {"sequence", "Mesh sequences"},
                                  {"help", "Help and settings"},
                                  {"keys", "Help and settings"}};

std::string groupOf(const std::string& commandId) {
  const std::string_view prefix = std::string_view(commandId).substr(0, commandId.find('.'));
  const auto* const found = std::ranges::find(keyGroups, prefix, &KeyGroup::prefix);
  return found == std::end(keyGroups) ? capitalised(std::string(prefix)) : found->title;
}

bool answersFilter(const std::string& filter, const CommandInfo& command) {
  return filter.empty() || fuzzyScore(filter, nameOf(command)).has_value() || command.keyText == filter;
}

/// Commands that answer the filter under their heading, which each stands once.
struct GroupedCommands {
  std::string title;
  std::vector<const CommandInfo*> commands;
};

std::vector<GroupedCommands> groupedCommands(const PanelContext& context) {
  std::vector<GroupedCommands> groups;
  for (const KeyGroup& group : keyGroups) {
    if (groups.empty() || groups.back().title != group.title) {
      groups.push_back({group.title, {}});
    }
  }
  for (const CommandInfo& command : context.commands) {
    const std::string title = groupOf(command.id);
    auto group = std::ranges::find(groups, title, &GroupedCommands::title);
    if (group == groups.end()) {
      group = groups.insert(groups.end(), {title, {}});
    }
    if (answersFilter(context.ui.dialogs.keys.filter, command)) {
      group->commands.push_back(&command);
    }
  }
  return groups;
}

void keyCell(PanelContext& context, const CommandInfo& command) {
  KeysOverviewState& keys = context.ui.dialogs.keys;
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

/// Label, what it does on as many lines as it takes, and the key.
void commandRow(PanelContext& context, const CommandInfo& command) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const float keyWidth = theme.px(136.0F);
  const float width = ImGui::GetContentRegionAvail().x - keyWidth - theme.unit();
  const float split = std::floor(width * 0.36F);
  ImFont* const font = theme.fonts.label != nullptr ? theme.fonts.label : ImGui::GetFont();
  const float wrap = width - split - 2.0F * theme.unit();
  const ImVec2 help = font->CalcTextSizeA(font->FontSize, FLT_MAX, wrap, command.help.c_str());
  const float height = std::max(theme.rowHeight(), help.y + theme.px(8.0F));
  const Control row = takePlace(widgets, "keys/label/" + command.id, {width, height}, false);
  if (row.visible) {
    const float line = row.box.min.y + theme.rowHeight();
    drawText(widgets, theme.fonts.body,
             {{row.box.min.x + theme.unit(), row.box.min.y}, {row.box.min.x + split, line}},
             theme.colours.text, nameOf(command));
    const ImVec2 at(row.box.min.x + split + theme.unit(),
                    row.box.min.y + std::floor((theme.rowHeight() - font->FontSize) * 0.5F));
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, theme.colours.quietText,
                                        command.help.c_str(), nullptr, wrap);
  }
  tooltip(widgets, {nameOf(command), command.help, command.keyText});
  ImGui::SameLine(0.0F, theme.unit());
  keyCell(context, command);
}

/// Takes the key that was pressed while one is awaited.
void takeKey(PanelContext& context) {
  KeysOverviewState& keys = context.ui.dialogs.keys;
  const std::string& pressed = context.status.pressedKey;
  if (keys.waitingFor.empty() || pressed.empty()) {
    return;
  }
  if (pressed != "Escape" && pressed != "Esc") {
    context.ui.answers.keyChange =
        KeyChange{keys.waitingFor, pressed == "Backspace" ? std::string() : pressed};
  }
  keys.waitingFor.clear();
}

void commandList(PanelContext& context) {
  ImGui::BeginChild("keys/list", {0.0F, ImGui::GetContentRegionAvail().y - context.theme.px(44.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.theme.unit(), context.theme.px(2.0F)));
  for (const GroupedCommands& group : groupedCommands(context)) {
    if (group.commands.empty()) {
      continue;
    }
    verticalSpace(widgetsOf(context), 10.0F);
    ImGui::PushFont(context.theme.fonts.strong);
    ImGui::TextUnformatted(group.title.c_str());
    ImGui::PopFont();
    for (const CommandInfo* command : group.commands) {
      commandRow(context, *command);
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

} // namespace

void drawKeysOverview(PanelContext& context) {
  KeysOverviewState& keys = context.ui.dialogs.keys;
  const bool awaiting = !keys.waitingFor.empty();
  DialogSpec spec{
      .id = "keys", .icon = icon::keyboard, .title = "All keys", .width = 940.0F, .height = 600.0F};
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
