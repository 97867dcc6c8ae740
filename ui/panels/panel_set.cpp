#include "ui/panels/panels.h"

namespace stretch::ui {

namespace {

void characterLeft(PanelContext& context) {
  drawLimbPanel(context);
  drawRigPanel(context);
}

void characterRight(PanelContext& context) {
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
