#include "ui/panels/context/typed_control.h"

#include <fmt/format.h>

#include "core/gltf/json/json.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/layout.h"

namespace stretch::ui {

namespace {

using gltf::Json;

/// "0, -9.81, 0"; nothing for null.
std::string textOfValue(const Json& value) {
  if (value.is_array()) {
    std::string text;
    for (const Json& number : value) {
      text += (text.empty() ? "" : ", ") + fmt::format("{}", number.get<double>());
    }
    return text;
  }
  return value.is_number() ? fmt::format("{}", value.get<double>()) : std::string();
}

/// The value that the text stands for, and whether it is one that the setting takes.
std::pair<Json, bool> valueOfTyped(const app::SettingFacts& setting, const std::string& text,
                                   const Json& standard) {
  if (text.empty()) {
    return {standard, true};
  }
  const Result<Json> typed = app::valueOfText(setting, text);
  return typed ? std::pair(*typed, true) : std::pair(standard, false);
}

} // namespace

RowEdit typedControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                     const Json& value, const std::string& hint) {
  const Json standard = Json::parse(setting.standard);
  std::string& text = context.ui.typedTexts[id];
  // The text stays as it is typed while it says what the setting holds; after undo it is made anew.
  if (valueOfTyped(setting, text, standard).first != value) {
    text = value == standard ? std::string() : textOfValue(value);
  }
  const std::string shown = hint.empty() ? textOfValue(standard) + unitSuffix(setting) : hint;
  const EditPhase phase = editText(widgetsOf(context), id, shown, text);
  const auto [typed, isTaken] = valueOfTyped(setting, text, standard);
  if (!isTaken) {
    notice(widgetsOf(context), NoticeKind::error, "Give " + app::takenValues(setting) + ".");
  }
  return {phase, typed};
}

} // namespace stretch::ui
