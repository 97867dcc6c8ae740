#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/batch/command_line.h"
#include "app/batch/options.h"
#include "app/schema/schema.h"

namespace stretch::app {

/// What was given for the settings of a schema: text by option, empty where nothing was.
struct SettingTexts {
  std::map<std::string, std::string> values;
  std::map<std::string, bool> flags;
};

/// Declares the option of one setting. A value that the setting never takes is a wrong argument: found before
/// any file is opened.
void addSettingOption(CommandLine& line, const SettingFacts& setting, SettingTexts& texts,
                      const std::string& heading);

/// The text of a setting's option; null where it was not given.
[[nodiscard]] const std::string* textOf(const SettingTexts& texts, const SettingFacts& setting);

template <typename Settings>
void addSettingOptions(CommandLine& line, const Schema<Settings>& schema, SettingTexts& texts,
                       const std::string& heading) {
  for (const Setting<Settings>& setting : schema) {
    addSettingOption(line, setting, texts, heading);
  }
}

/// Sets what the option's text says; an error names the option.
template <typename Settings>
[[nodiscard]] Status setFromText(const Setting<Settings>& setting, const std::string& text,
                                 Settings& settings) {
  const auto value = valueOfText(setting, text);
  if (!value) {
    return value.error();
  }
  setting.write(*value, settings);
  return Success{};
}

template <typename Settings>
[[nodiscard]] Status setFromTexts(const Schema<Settings>& schema, const SettingTexts& texts,
                                  Settings& settings) {
  for (const Setting<Settings>& setting : schema) {
    const std::string* const text = textOf(texts, setting);
    if (text == nullptr) {
      continue;
    }
    if (Status set = setFromText(setting, *text, settings); !set) {
      return set;
    }
  }
  return Success{};
}

} // namespace stretch::app
