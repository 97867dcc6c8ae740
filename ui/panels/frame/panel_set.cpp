#include "app/commands/table/selection.h"
#include "ui/panels/body/controller_panel.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/trails/trail_sections.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

void characterLeft(PanelContext& context) {
  drawSkinPanel(context);
  drawLimbPanel(context);
  drawRigPanel(context);
}

void characterRight(PanelContext& context) {
  if (hasViewedClip(context) && app::hasControllers(context.character())) {
    drawControllerSettings(context);
    verticalSpace(widgetsOf(context), 8.0F);
    separator(widgetsOf(context));
    drawTrailsPanel(context);
    holdSection(context);
    return;
  }
  drawTrailsPanel(context);
  drawTrailSettingsPanel(context);
}

} // namespace

PanelSet panelSetOf(const PanelContext& context) {
  if (context.open.sequence() != nullptr) {
    return {drawSequenceFacts, drawSequencePanel, drawSequenceTimeline, drawSequenceBar};
  }
  return {characterLeft, characterRight, drawBottomPanel, drawViewportBar};
}

} // namespace stretch::ui
