#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/control.h"

namespace stretch::ui {

/// Draws a label in the left column and puts the cursor at the value's column, which takes the rest of the
/// width. The label has the help as its tooltip.
void labelledRow(const WidgetContext& context, const std::string& label, const Help& help = {});

/// A line of quiet text in the value column's style: "Clip   punch".
void valueRow(const WidgetContext& context, const std::string& label, const std::string& value,
              const Help& help = {});

/// A heading that folds what follows. `closedSections` keeps the ids of folded ones. True when its content is
/// to be drawn.
bool section(const WidgetContext& context, const std::string& id, const std::string& title,
             std::vector<std::string>& closedSections);

/// A panel's title row; `reserved` pixels at its right end stay free for buttons.
void panelTitle(const WidgetContext& context, const char* iconText, const std::string& title,
                float reserved = 0.0F);

/// The lines of a text that is wrapped between words at a width in pixels of the font's own size, the rest of
/// it in the last of `most`.
[[nodiscard]] std::vector<std::string_view> wrapped(const ImFont* font, std::string_view text, float width,
                                                    std::size_t most = std::string_view::npos);

/// Wrapped quiet text in the label font.
void note(const WidgetContext& context, const std::string& text);

enum class NoticeKind { info, success, warning, error };
/// Wrapped text with a coloured edge: something the user should know.
void notice(const WidgetContext& context, NoticeKind kind, const std::string& text);

/// Draws the notice on two lines, cut where it is long and told by its tooltip, or the `whole` of it; with
/// `more` at its end. True when it was clicked.
[[nodiscard]] bool noticeLines(const WidgetContext& context, const std::string& id, NoticeKind kind,
                               const std::string& text, const std::string& more, bool whole);

/// Draws what a panel says while it has nothing to show: an icon, a title, and what to do.
void emptyState(const WidgetContext& context, const char* iconText, const std::string& title,
                const std::string& text);

/// A key drawn as a key cap; returns its width.
float keyCap(const WidgetContext& context, const ImVec2& corner, const std::string& text);

void verticalSpace(const WidgetContext& context, float designPixels);
void separator(const WidgetContext& context);

} // namespace stretch::ui
