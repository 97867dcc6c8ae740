#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/panels/panel_support.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

// Rows of the trail settings: one control each for a number, a choice, a flag, a point of the remap. Each
// edits the same setting of every trail that commands act on. Help texts come from the table that describes
// the settings.

/// Help of a setting by its name in recipes ("ease_in").
[[nodiscard]] Help settingHelp(const std::string& setting, const std::string& title);

/// The help with what the mouse does on a slider.
[[nodiscard]] Help dragHelp(Help help);

struct NumberRow {
  std::string setting; ///< Name in recipes; the widget is "trail/" or "weight/" + it.
  std::string label;
  std::string undoLabel;
  double minimum = 0.0;
  double maximum = 1.0;
  double defaultValue = 0.0;
  double hardMaximum = 0.0; ///< Of typing; `maximum` where it is smaller.
  const char* prefix = "";
  const char* suffix = "";
  int decimals = 2;
  double factor = 1.0; ///< Shown value = value x factor.
  double step = 0.01;
};
/// Label and slider of a number; answers what the hand does and changes `value`.
[[nodiscard]] EditPhase numberControl(PanelContext& context, const std::string& id, const NumberRow& row,
                                      const Help& help, double& value);
void numberRow(PanelContext& context, const NumberRow& row, const rig::TrailSettings& settings,
               double rig::TrailSettings::*member);

struct ChoiceRow {
  std::string setting;
  std::string label;
  std::string undoLabel;
  std::vector<std::string> choices; ///< In the order of the enumeration.
  SettingsChange also = {};         ///< What else changes with it.
};
void choiceRow(PanelContext& context, const ChoiceRow& row, int selected,
               const std::function<void(rig::TrailSettings&, int)>& set);

template <typename Enum>
void choiceRow(PanelContext& context, const ChoiceRow& row, const rig::TrailSettings& settings,
               Enum rig::TrailSettings::*member) {
  choiceRow(context, row, static_cast<int>(settings.*member),
            [member](rig::TrailSettings& s, int chosen) { s.*member = static_cast<Enum>(chosen); });
}

struct FlagRow {
  std::string setting;
  std::string label;
  std::string undoLabel;
};
void flagRow(PanelContext& context, const FlagRow& row, const rig::TrailSettings& settings,
             bool rig::TrailSettings::*member);

struct EaseRow {
  std::string setting;
  std::string label;
  std::string id;
};
/// Percent and value of one ease point; `values` is the range of the value.
void easeRow(PanelContext& context, const EaseRow& row, const Vec2& point, const Vec2& values,
             const std::function<void(const Vec2&, rig::TrailSettings&)>& set);

/// "Up to here and not past it": an axis-aligned plane that the limb's end does not pass.
void stopRows(PanelContext& context, const rig::Trail& trail);

} // namespace stretch::ui
