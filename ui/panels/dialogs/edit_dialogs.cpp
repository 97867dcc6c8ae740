#include <algorithm>

#include "app/commands/pose/step_text.h"
#include "app/edits/pose/selection_set_edits.h"
#include "app/edits/trail/name_edits.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/key_bar.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

/// Typed as it was, the name stays the limbs'.
void rename(PanelContext& context) {
  const RenameState& state = context.ui.trails.rename;
  if (state.typed == state.present) {
    return;
  }
  const app::Document& document = context.character().document();
  if (state.trail == 0) {
    editOnce(context, "Rename the selection set",
             app::renameSelectionSet(document, state.present, state.typed));
  } else if (state.ofGroup) {
    editOnce(context, "Rename the group", app::renameGroup(document, state.trail, state.typed));
  } else {
    editOnce(context, "Rename the trail", app::renameTrail(document, state.trail, state.typed));
  }
}

/// What a row of the history is beside its text.
struct HistoryRow {
  std::size_t index = 0;
  bool isShown = false;
  bool isUndone = false;
  bool isHighlighted = false;
};

/// One state of the document: its text, quieter where it was undone. True when it was clicked.
bool historyRow(PanelContext& context, const std::string& text, const HistoryRow& state) {
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const Control row = takePlace(widgets, "history/" + std::to_string(state.index),
                                {ImGui::GetContentRegionAvail().x, theme.rowHeight()});
  if (row.visible) {
    const ThemeColours& colours = theme.colours;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (state.isHighlighted || row.hovered) {
      list->AddRectFilled(row.box.min, row.box.max,
                          state.isHighlighted ? colours.accentQuiet : colours.raised, theme.corner());
    }
    if (state.isShown) {
      list->AddCircleFilled({row.box.min.x + theme.px(9.0F), row.box.centre().y}, theme.px(3.5F),
                            colours.accent);
    }
    const Rect place{{row.box.min.x + theme.px(20.0F), row.box.min.y}, row.box.max};
    const ImU32 colour = state.isShown ? colours.accent : state.isUndone ? colours.quietText : colours.text;
    drawText(widgets, theme.fonts.body, place, colour, text);
  }
  tooltip(widgets, {text,
                    state.isShown    ? "This is shown."
                    : state.isUndone ? "Brings this and all before it back."
                                     : "Goes back to this.",
                    {}});
  return row.clicked;
}

/// The rows; the one that was clicked or that Enter was pressed on, or -1.
int historyRows(PanelContext& context, const std::vector<std::string>& texts, std::size_t shown,
                bool opening) {
  HistoryState& state = context.ui.dialogs.history;
  if (opening) {
    state.highlighted = static_cast<int>(shown);
  }
  const int before = state.highlighted;
  moveHighlight(state.highlighted, static_cast<int>(texts.size()));
  const bool entered = enterPressed();
  int chosen = entered ? state.highlighted : -1;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const bool isHighlighted = static_cast<int>(i) == state.highlighted;
    if (historyRow(context, i == 0 ? "As it was opened" : texts[i],
                   {i, i == shown, i > shown, isHighlighted})) {
      chosen = static_cast<int>(i);
    }
    if (isHighlighted && (opening || state.highlighted != before)) {
      ImGui::SetScrollHereY(0.5F);
    }
  }
  state.highlighted = chosen >= 0 ? chosen : state.highlighted;
  return chosen;
}

} // namespace

void drawRenameDialog(PanelContext& context) {
  RenameState& state = context.ui.trails.rename;
  const bool opening = state.open && !state.wasOpen;
  state.wasOpen = state.open;
  if (!beginDialog(context,
                   {.id = "rename",
                    .icon = icon::pencil,
                    .title = state.trail == 0 ? "Rename the selection set"
                             : state.ofGroup  ? "Rename the group"
                                              : "Rename the trail",
                    .width = 380.0F},
                   state.open)) {
    return;
  }
  static_cast<void>(editText(widgetsOf(context), "rename/name",
                             state.trail == 0 ? "A name of its own"
                             : state.ofGroup  ? "The limbs' names"
                                              : "The limb's name",
                             state.typed, 0.0F, opening || ImGui::IsWindowAppearing(), true));
  const bool entered = enterPressed();
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
  HistoryState& state = context.ui.dialogs.history;
  const bool opening = state.open && !state.wasOpen;
  state.wasOpen = state.open;
  const std::vector<std::string> texts = context.open.with(
      std::vector<std::string>{}, [](auto& session) { return app::stepTexts(session.history()); });
  // As high as its rows, which scroll where they are many.
  const float rows = std::min(16.0F, static_cast<float>(texts.size()));
  if (!beginDialog(context,
                   {.id = "history",
                    .icon = icon::undo,
                    .title = "History",
                    .width = 460.0F,
                    .height = 82.0F + 27.0F * rows},
                   state.open)) {
    return;
  }
  note(widgetsOf(context), "Up, Down and Enter, or a click, go to a state. Esc closes the list.");
  ImGui::BeginChild("history/list", {0.0F, ImGui::GetContentRegionAvail().y}, false);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  const bool jumped = context.open.with(false, [&](auto& session) {
    const int chosen =
        historyRows(context, texts, session.history().position(), opening || ImGui::IsWindowAppearing());
    if (chosen >= 0) {
      session.goTo(static_cast<std::size_t>(chosen));
    }
    return chosen >= 0;
  });
  if (jumped) {
    context.ui.panelDrag = false;
    if (context.open.character() != nullptr) {
      bringBackPicks(context.ui.time, context.character());
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  endDialog();
}

} // namespace stretch::ui
