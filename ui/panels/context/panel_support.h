#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "rig/motion/motion.h"
#include "ui/panels/context/panel_context.h"
#include "ui/panels/state/ui_state.h"
#include "ui/widgets/button.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

// Parts that the panels share. None of this knows a particular panel.

[[nodiscard]] inline WidgetContext widgetsOf(const PanelContext& context) {
  return {context.theme, context.items};
}

/// A button that asks for a command; off while the command is missing or disabled. Text and help are the
/// command's, the text can be replaced by a shorter one; " " shows the icon alone.
struct CommandButton {
  const char* command = "";
  const char* icon = "";
  const char* text = "";
  Emphasis emphasis = Emphasis::normal;
  float width = 0.0F;
  const char* fallback = "";
};
void commandButton(PanelContext& context, const CommandButton& spec);

/// One of a row of quiet buttons with an icon alone; `fallback` where there is no icon font. The next item
/// follows on the same line.
void iconButton(PanelContext& context, const char* command, const char* icon, const char* fallback);

/// The key that a command has, as shown; empty without one.
[[nodiscard]] std::string keyOf(const PanelContext& context, std::string_view commandId);

/// Carries one frame of a value's gesture into the session: the first change begins a drag, each change
/// previews `change(document at begin)`, the end commits. While another part of the program is dragging
/// nothing happens.
using DocumentChange = std::function<Result<app::Document>(const app::Document&)>;
void editThrough(PanelContext& context, const EditPhase& phase, const std::string& label,
                 const DocumentChange& change);

/// Change of a mesh sequence.
using SequenceChange = std::function<void(app::SequenceDocument&)>;
void editSequence(PanelContext& context, const EditPhase& phase, const std::string& label,
                  const SequenceChange& change);

/// One finished edit; an error is told in a toast.
void editOnce(PanelContext& context, const std::string& label, const Result<app::Document>& changed);

/// Change of the settings of every trail that commands act on.
using SettingsChange = std::function<void(rig::TrailSettings&)>;
void editSettings(PanelContext& context, const EditPhase& phase, const std::string& label,
                  const SettingsChange& change);

/// Edits the ends of the range, of those whose range is the selected one's.
void editRange(PanelContext& context, const EditPhase& phase, const SettingsChange& change);

/// "left arm" -> "Left arm".
[[nodiscard]] std::string capitalised(std::string text);
/// A limb's name as a heading: "Left arm", or the chain's id.
[[nodiscard]] std::string limbHeading(const app::Document& document, const std::string& limbId);

/// Returns a trail's name as a heading.
[[nodiscard]] std::string trailHeading(const app::Document& document, const rig::Trail& trail);

/// The name of a node, or "#index" where it has none.
[[nodiscard]] std::string nodeName(const Scene& scene, NodeIndex node);

/// Whether there is a character to work on: a file with a scene.
[[nodiscard]] bool hasCharacter(const PanelContext& context);
/// Whether the viewed clip exists.
[[nodiscard]] bool hasViewedClip(const PanelContext& context);

/// "24", "12.5": no decimals where none are needed.
[[nodiscard]] std::string shortNumber(double value, int decimals = 2);

/// Decimals of a field that shows a frame: none on a frame, two between frames.
[[nodiscard]] int frameDecimals(double frame);

/// How long the limb is at the trail's tip: straight distance from its base to its end, world units.
struct TipLengths {
  double before = 0.0; ///< In the source clip.
  double after = 0.0;  ///< Value of the character as it moves where the trail is active, else of the
                       ///< exaggerated path.
};
[[nodiscard]] TipLengths tipLengths(app::Session& session, const rig::SolvedTrail& solved);

/// "0.52 -> 1.04 (x2.00)" with units fit for the size.
[[nodiscard]] std::string lengthsText(const TipLengths& lengths);

/// Tells the user something for a few seconds; what is told already stays longer instead of standing there
/// twice.
void tell(UiState& ui, ToastKind kind, const std::string& text);
/// Takes back what was told to inform: something else has the user's eye now. What went wrong stays.
void hideNews(UiState& ui);

/// The error in one line that calls a limb what people call it: "Left arm", never "left-arm".
[[nodiscard]] std::string errorLine(const app::OpenDocument& open, Error error);

/// An error as a toast; nothing for success.
void tellProblem(UiState& ui, const app::OpenDocument& open, const Status& status);
void tellProblem(PanelContext& context, const Status& status);

} // namespace stretch::ui
