#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/rows/clip_name.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/fuzzy.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

std::string clipHeading(const ClipPick& pick, std::size_t clip) {
  return clipName(pick.clips[clip].name, clip);
}

/// Those that the filter leaves, in the order of the file.
std::vector<std::size_t> listedClips(const ClipPick& pick) {
  std::vector<std::size_t> listed;
  for (std::size_t clip = 0; clip < pick.clips.size(); ++clip) {
    if (pick.filter.empty() || fuzzyScore(pick.filter, clipHeading(pick, clip))) {
      listed.push_back(clip);
    }
  }
  return listed;
}

/// A clip's name and length; true when it was clicked.
bool clipRow(PanelContext& context, std::size_t clip, bool isHighlighted) {
  const ClipPick& pick = context.ui.dialogs.clipPick;
  const Theme& theme = context.theme;
  const WidgetContext widgets = widgetsOf(context);
  const std::string name = clipHeading(pick, clip);
  const Control row =
      takePlace(widgets, "clips/" + name, {ImGui::GetContentRegionAvail().x, theme.rowHeight()});
  if (row.visible) {
    const ThemeColours& colours = theme.colours;
    if (isHighlighted || row.hovered) {
      ImGui::GetWindowDrawList()->AddRectFilled(
          row.box.min, row.box.max, isHighlighted ? colours.accentQuiet : colours.raised, theme.corner());
    }
    const float split = row.box.max.x - theme.px(72.0F);
    drawText(widgets, theme.fonts.body,
             {{row.box.min.x + theme.unit(), row.box.min.y}, {split, row.box.max.y}},
             isHighlighted ? colours.accent : colours.text, name);
    drawText(widgets, theme.fonts.label,
             {{split, row.box.min.y}, {row.box.max.x - theme.unit(), row.box.max.y}}, colours.quietText,
             fmt::format("{:.2f} s", pick.clips[clip].seconds), 1.0F);
  }
  tooltip(widgets, {name, "Imports this clip.", {}});
  return row.clicked;
}

/// The clip that was clicked, if any.
std::optional<std::size_t> clipRows(PanelContext& context, const std::vector<std::size_t>& listed,
                                    bool moved) {
  std::optional<std::size_t> clicked;
  ImGui::BeginChild("clips/list", {0.0F, ImGui::GetContentRegionAvail().y - context.theme.px(62.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.theme.px(1.0F)));
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const bool isHighlighted = static_cast<int>(i) == context.ui.dialogs.clipPick.highlighted;
    ImGui::PushID(static_cast<int>(listed[i]));
    if (clipRow(context, listed[i], isHighlighted)) {
      clicked = listed[i];
    }
    ImGui::PopID();
    if (isHighlighted && moved) {
      ImGui::SetScrollHereY(0.5F);
    }
  }
  if (listed.empty()) {
    note(widgetsOf(context), "No clip is called that.");
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  return clicked;
}

} // namespace

void drawClipDialog(PanelContext& context) {
  ClipPick& pick = context.ui.dialogs.clipPick;
  bool open = !pick.file.empty() && context.open.character() != nullptr;
  const bool opening = open && !pick.wasOpen;
  pick.wasOpen = open;
  const float rows = std::clamp(static_cast<float>(pick.clips.size()), 3.0F, 12.0F);
  if (!beginDialog(context,
                   {.id = "clips",
                    .icon = icon::film,
                    .title = "Which clip of " + pick.file.filename().string() + "?",
                    .width = 460.0F,
                    .height = 170.0F + 29.0F * rows},
                   open)) {
    pick.file = open ? pick.file : std::filesystem::path();
    return;
  }
  static_cast<void>(editText(widgetsOf(context), "clips/filter", "Search a clip", pick.filter, 0.0F,
                             opening || ImGui::IsWindowAppearing(), true));
  const std::vector<std::size_t> listed = listedClips(pick);
  const int before = pick.highlighted;
  moveHighlight(pick.highlighted, static_cast<int>(listed.size()));
  const std::optional<std::size_t> row = clipRows(context, listed, pick.highlighted != before);
  const bool entered = enterPressed();
  const int clicked = dialogButtons(context, "clips",
                                    {{.id = "", .text = "Cancel"},
                                     {.id = "", .text = "All"},
                                     {.id = "", .text = "Import", .enabled = !listed.empty()}});
  std::optional<int> chosen;
  if (row) {
    chosen = static_cast<int>(*row);
  } else if ((entered || clicked == 2) && !listed.empty()) {
    chosen = static_cast<int>(listed[static_cast<std::size_t>(pick.highlighted)]);
  } else if (clicked == 1) {
    chosen = -1;
  }
  if (chosen) {
    context.ui.answers.clip = ClipAnswer{pick.file, *chosen};
  }
  if (chosen || clicked == 0 || !open) {
    pick = {};
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
