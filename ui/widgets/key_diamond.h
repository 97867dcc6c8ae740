#pragma once

#include <string>

#include "ui/widgets/control.h"

namespace stretch::ui {

/// Place of keys, seen from the playhead.
enum class KeyMark {
  none,
  elsewhere, ///< At other frames: half filled.
  here       ///< Filled.
};

/// The mark of a key as a button, as wide as a row is high. True when it was clicked.
bool keyDiamond(const WidgetContext& context, const std::string& id, KeyMark mark, const Help& help);

/// The mark alone, around a point.
void addKeyMark(const Theme& theme, ImDrawList& list, const ImVec2& centre, float radius, KeyMark mark,
                ImU32 colour, ImU32 inside);

} // namespace stretch::ui
