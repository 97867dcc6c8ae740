#pragma once

#include <string>
#include <vector>

#include "ui/widgets/button.h"

namespace stretch::ui {

/// A field that opens a list of choices. The index that was chosen in this frame, or -1. Width 0: the
/// available width. A list with a `filter` has a field that narrows it, which keeps its text there.
int dropdown(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
             int selected, const Help& help, float width = 0.0F, const char* none = "",
             std::string* filter = nullptr);

/// A one-line text field with a hint while it is empty; the gesture ends when the field is left.
EditPhase editText(const WidgetContext& context, const std::string& id, const std::string& hint,
                   std::string& text, float width = 0.0F, bool focusNow = false, bool selectAll = false);
/// A one-line text field with a hint while it is empty; true when the text changed.
bool textField(const WidgetContext& context, const std::string& id, const std::string& hint,
               std::string& text, float width = 0.0F, bool focusNow = false);

} // namespace stretch::ui
