#pragma once

#include <array>
#include <string>
#include <vector>

#include "ui/widgets/control.h"

namespace stretch::ui {

enum class Emphasis {
  normal,  ///< A raised face.
  primary, ///< The next thing to do: filled with the accent.
  quiet,   ///< No face until the mouse is over it.
  danger   ///< Takes something away.
};

struct ButtonSpec {
  std::string id;
  const char* icon = ""; ///< Left out where the icon font is missing.
  std::string text = {}; ///< May be empty when there is an icon.
  Help help = {};
  Emphasis emphasis = Emphasis::normal;
  bool on = false; ///< A switch that is on.
  bool enabled = true;
  bool focused = false;      ///< Enter stands for it: it has an edge around it.
  float width = 0.0F;        ///< Screen pixels; 0: as wide as its content.
  const char* fallback = ""; ///< Stands for an icon without text where the icon font is missing.
};

/// True when it was clicked.
bool button(const WidgetContext& context, const ButtonSpec& spec);

/// A switch with its label to the right; true when it was clicked (the caller flips the value).
bool toggle(const WidgetContext& context, const std::string& id, const std::string& label, bool on,
            const Help& help, bool enabled = true);

struct Choice {
  std::string text;
  Help help = {};
  bool enabled = true;
  bool marked = false;   ///< With a dot at its end, in lists.
  std::string note = {}; ///< Quiet text at its end, in lists.
};

/// Choices side by side, one of which is on, as wide as the available width. The index that was clicked, or
/// -1.
int segmented(const WidgetContext& context, const std::string& id, const std::vector<Choice>& choices,
              int selected);

/// Three buttons X, Y, Z in the colours of the axes. The index that was clicked, or -1; Shift means "only
/// this axis" and is the caller's to read.
int axisButtons(const WidgetContext& context, const std::string& id, const std::array<bool, 3>& axes,
                const Help& help);

/// Colour of an axis (0 x, 1 y, 2 z), readable on the panel.
[[nodiscard]] ImU32 axisColour(const Theme& theme, int axis);

} // namespace stretch::ui
