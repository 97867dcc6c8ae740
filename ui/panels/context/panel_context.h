#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/commands/table/command_ids.h"
#include "app/open_document.h"
#include "ui/panels/state/ui_state.h"
#include "ui/widgets/item_registry.h"
#include "ui/widgets/theme.h"

namespace stretch::ui {

namespace command = app::command;

/// A command as menus, palette, tooltips and the keys overview show it; made by the shell each frame.
struct CommandInfo {
  std::string id; ///< command::trailApply.
  std::string label;
  std::string help;
  std::string keyText; ///< The real key, as the user's layout names it; empty without one.
  bool enabled = true;
  bool checked = false;    ///< A switch that is on.
  std::string reason = {}; ///< Says what to do first while it is off.
  std::string name = {};   ///< The label as it is always, whatever the command would do now.
};

/// Everything a panel may see and touch. Panels draw, read what is open, make edits through it (begin,
/// preview, commit) and ask for commands by id; the shell runs those after the frame's panels, in order.
struct PanelContext {
  app::OpenDocument& open;
  UiState& ui;
  const Theme& theme;
  const std::vector<CommandInfo>& commands;
  std::vector<std::string>& requestedCommands;
  ItemRegistry& items;
  const EditorStatus& status;

  /// For panels that are drawn while a document of their kind is open.
  [[nodiscard]] app::Session& character() const { return *open.character(); }
  [[nodiscard]] app::SequenceSession& sequence() const { return *open.sequence(); }
};

/// Null for an id that no command has.
[[nodiscard]] const CommandInfo* findCommand(const PanelContext& context, std::string_view id);
void request(PanelContext& context, std::string_view commandId);

} // namespace stretch::ui
