#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

// Each panel draws into the window (or child window) that its caller has begun, and fills its width.

/// Once at the start of each frame's panels: forgets the last frame's items, commits a drag whose widget is
/// gone.
void beginPanels(PanelContext& context);

void drawMenuBar(PanelContext& context);     ///< Inside BeginMainMenuBar/EndMainMenuBar or a menu bar of a
                                             ///< window.
void drawSkinPanel(PanelContext& context);   ///< Left, top: locators that are set, whose weights are shown;
                                             ///< else nothing.
void drawRigPanel(PanelContext& context);    ///< Left: the file, its clip, the limbs that were found.
void drawLimbPanel(PanelContext& context);   ///< Left: the limb diagram.
void drawTrailsPanel(PanelContext& context); ///< Right, top: list of trails and what can be done with them.
void drawTrailSettingsPanel(PanelContext& context); ///< Right.
void drawBottomPanel(PanelContext& context);   ///< Bottom, everything: tabs, play controls and what the tab
                                               ///< shows. Or:
void drawTimelinePanel(PanelContext& context); ///< Play controls, ruler, range, keys of the selection,
                                               ///< trails.
void drawGraphPanel(PanelContext& context); ///< Curves of the selected limb, or the dope sheet where its tab
                                            ///< is on.
void drawDopeSheet(PanelContext& context);  ///< Keys of every limb.
// The same places while a mesh sequence is open.
void drawSequenceFacts(PanelContext& context);    ///< Left: what it holds, length against curvature.
void drawSequencePanel(PanelContext& context);    ///< Right: the compression, its result, the elastic model.
void drawSequenceTimeline(PanelContext& context); ///< Bottom: play controls, frames, those that fits use.
void drawSequenceBar(PanelContext& context);      ///< Over the viewport: what of the sequence is shown.

/// The panels of one kind of document, by the places that the shell gives them.
struct PanelSet {
  using Draw = void (*)(PanelContext&);
  Draw left = nullptr;
  Draw right = nullptr;
  Draw bottom = nullptr;
  Draw viewportBar = nullptr;
};
/// Those of a mesh sequence while one is open, else those of a character.
[[nodiscard]] PanelSet panelSetOf(const PanelContext& context);

void drawStatusBar(PanelContext& context);   ///< One row of Theme::rowHeight().
void drawViewportBar(PanelContext& context); ///< Over the viewport's top edge: switches of the overlays.

/// Every dialog and popup that is open (file browser, palette, keys, settings, questions): once a
/// frame, after the panels, outside any window.
void drawDialogs(PanelContext& context);

/// The card of the tour's step, while it runs, in the lower left of the picture: once a frame.
void drawTour(PanelContext& context, const Rect& picture);

/// Room for messages.
struct MessageRoom {
  Rect picture;
  std::optional<Rect> figure;    ///< The character: messages keep beside it where there is room.
  std::vector<Rect> kept;        ///< Covered by no message while there is another place.
  std::vector<Rect> spared;      ///< Left free as well, where there is room for that.
  std::vector<Rect> labels = {}; ///< And these, where there is room for both.
};

/// Draws what was told, for its seconds: once a frame, at the upper edge of the picture, so that it covers no
/// bar, ruler or timeline, on `under`, the picture's own list, so that menus and tooltips lie over it. A menu
/// takes news away; while a dialog is open only what went wrong is shown, over everything, beside the dialog
/// where there is room. `place` is the one that was found in the frame before, which messages leave only for
/// what is kept or spared. Returns the messages that were drawn.
std::vector<DrawnToast> drawMessages(PanelContext& context, const MessageRoom& room, std::size_t& place,
                                     ImDrawList& under);

} // namespace stretch::ui
