#include "app/commands/command_ids.h"
#include "ui/panels/panel_support.h"
#include "ui/panels/panels.h"
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
  const bool coloured = context.sequence().view().colours == app::SequenceColours::plain;
  swatch(context, coloured ? colour : faded(context.theme.colours.quietText, 0.5F));
  commandButton(context, {.command = id, .text = text, .emphasis = Emphasis::quiet});
  ImGui::SameLine(0.0F, context.theme.unit());
}

void coloursChoice(PanelContext& context) {
  app::SequenceSession& session = context.sequence();
  const bool hasThickness = !session.document().analysis->vertexDiameters.empty();
  const std::vector<Choice> choices{
      {"Plain", {"Plain", "The original in red, the skinned result in green.", {}}},
      {"Error",
       {"Error", "How far each vertex of the result is from the original.", {}},
       session.document().result != nullptr},
      {"Thickness",
       {"Thickness", "The shape diameter: how thick the body is under each vertex.", {}},
       hasThickness}};
  const float width = context.theme.px(228.0F);
  const float free = ImGui::GetContentRegionAvail().x;
  if (free > width) {
    ImGui::SameLine(0.0F, free - width);
  }
  ImGui::BeginChild("sequence/colours-box", {std::min(width, free), context.theme.rowHeight()});
  const int chosen =
      segmented(widgetsOf(context), "sequence/colours", choices, static_cast<int>(session.view().colours));
  ImGui::EndChild();
  if (chosen >= 0) {
    session.view().colours = static_cast<app::SequenceColours>(chosen);
  }
}

} // namespace

void drawSequenceBar(PanelContext& context) {
  meshSwitch(context, command::sequenceOriginal, "Original", originalMeshColour);
  meshSwitch(context, command::sequenceSkinned, "Skinned", skinnedMeshColour);
  iconButton(context, command::viewSkeleton, icon::skeleton, "Sk");
  iconButton(context, command::viewWire, icon::wire, "Wi");
  iconButton(context, command::viewGrid, icon::grid, "Gr");
  coloursChoice(context);
}

} // namespace stretch::ui
