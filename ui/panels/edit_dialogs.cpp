#include "app/commands/selection.h"
#include "app/edits/name_edits.h"
#include "ui/panels/dialog_frame.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void rename(PanelContext& context) {
  const RenameState& state = context.ui.rename;
  editOnce(context, "Rename the trail",
           app::renameTrail(context.character().document(), state.trail, state.typed));
}

/// One state of the document: its label, quieter where it was undone. True when it was clicked.
bool historyRow(PanelContext& context, const std::string& label, std::size_t index, std::size_t shown) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const Control row = takePlace(widgets, "history/" + std::to_string(index),
                                {ImGui::GetContentRegionAvail().x, theme.rowHeight()});
  if (row.visible) {
    const ThemeColours& colours = theme.colours;
    if (index == shown || row.hovered) {
      ImGui::GetWindowDrawList()->AddRectFilled(
          row.box.min, row.box.max, index == shown ? colours.accentQuiet : colours.raised, theme.corner());
    }
    const Rect text{{row.box.min.x + theme.unit(), row.box.min.y}, row.box.max};
    const ImU32 colour = index == shown  ? colours.accent
                         : index > shown ? faded(colours.text, 0.45F)
                                         : colours.text;
    drawText(widgets, theme.fonts.body, text, colour, label);
  }
  tooltip(widgets, {label, index > shown ? "Brings this and all before it back." : "Goes back to this.", {}});
  if (index == shown && ImGui::IsWindowAppearing()) {
    ImGui::SetScrollHereY(0.5F);
  }
  return row.clicked;
}

} // namespace

void drawRenameDialog(PanelContext& context) {
  RenameState& state = context.ui.rename;
  const bool opening = state.open && !state.wasOpen;
  state.wasOpen = state.open;
  if (!beginDialog(context,
                   {.id = "rename", .icon = icon::pencil, .title = "Rename the trail", .width = 380.0F},
                   state.open)) {
    return;
  }
  static_cast<void>(editText(widgetsOf(context), "rename/name", "The limb's name", state.typed, 0.0F,
                             opening || ImGui::IsWindowAppearing(), true));
  const bool entered = keyPressed(ImGuiKey_Enter) || keyPressed(ImGuiKey_KeyPadEnter);
  const int clicked =
      dialogButtons(context, "rename", {{.id = "", .text = "Cancel"}, {.id = "", .text = "Rename"}});
  if (entered || clicked == 1) {
    rename(context);
  }
  if (entered || clicked >= 0) {
    state.open = false;
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

void drawHistoryDialog(PanelContext& context) {
  bool& open = context.ui.historyOpen;
  if (!beginDialog(
          context,
          {.id = "history", .icon = icon::undo, .title = "History", .width = 420.0F, .height = 420.0F},
          open)) {
    return;
  }
  ImGui::BeginChild("history/list", {0.0F, ImGui::GetContentRegionAvail().y});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  const bool jumped = context.open.with(false, [&](auto& session) {
    const std::vector<std::string> labels = session.history().labels();
    const std::size_t shown = session.history().position();
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (historyRow(context, i == 0 ? "As it was opened" : labels[i], i, shown)) {
        session.goTo(i);
        return true;
      }
    }
    return false;
  });
  if (jumped) {
    context.ui.panelDrag = false;
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  endDialog();
}

} // namespace stretch::ui
