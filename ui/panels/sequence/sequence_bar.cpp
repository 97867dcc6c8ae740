#include "app/commands/table/command_ids.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/context/view_schema.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"

namespace stretch::ui {

namespace {

/// A mark in the mesh's colour before the switch that shows it.
void swatch(const PanelContext& context, ImU32 colour) {
  const Theme& theme = context.theme;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float side = theme.px(12.0F);
  const float top = corner.y + 0.5F * (theme.rowHeight() - side);
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + side, top + side}, colour,
                                            theme.px(2.0F));
  ImGui::Dummy({side, theme.rowHeight()});
  ImGui::SameLine(0.0F, theme.px(4.0F));
}

void meshSwitch(PanelContext& context, const char* id, const char* text, ImU32 colour) {
  const bool coloured = context.sequence().view().look == app::SequenceLook::compare;
  swatch(context, coloured ? colour : faded(context.theme.colours.quietText, 0.5F));
  commandButton(context, {.command = id, .text = text, .emphasis = Emphasis::quiet});
  ImGui::SameLine(0.0F, context.theme.unit());
}

void lookChoice(PanelContext& context) {
  app::SequenceSession& session = context.sequence();
  std::vector<Choice> choices;
  for (const app::SettingChoice& choice : sequenceViewSchema().front().choices) {
    const std::string label = capitalised(choice.name);
    const auto look = static_cast<app::SequenceLook>(choices.size());
    choices.push_back({label, {label, choice.help, {}}, app::canShow(session.document(), look)});
  }
  const float free = ImGui::GetContentRegionAvail().x;
  const float sideBySide = context.theme.px(380.0F);
  const float width = std::min(free, free < sideBySide ? context.theme.px(112.0F) : sideBySide);
  ImGui::SameLine(0.0F, free - width);
  const int now = static_cast<int>(session.view().look);
  const WidgetContext widgets = widgetsOf(context);
  ImGui::BeginChild("sequence/look-box", {width, context.theme.rowHeight()});
  const int chosen = width < sideBySide ? dropdown(widgets, "sequence/look", choices, now,
                                                   {"Look", sequenceViewSchema().front().help, {}})
                                        : segmented(widgets, "sequence/look", choices, now);
  ImGui::EndChild();
  if (chosen >= 0) {
    session.view().look = static_cast<app::SequenceLook>(chosen);
  }
}

} // namespace

void drawSequenceBar(PanelContext& context) {
  meshSwitch(context, command::sequenceOriginal, "Original", originalMeshColour);
  meshSwitch(context, command::sequenceSkinned, "Skinned", skinnedMeshColour);
  iconButton(context, command::viewSkeleton, icon::skeleton, "Sk");
  iconButton(context, command::viewWire, icon::wire, "Wi");
  iconButton(context, command::viewGrid, icon::grid, "Gr");
  lookChoice(context);
}

} // namespace stretch::ui
