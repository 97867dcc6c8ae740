#include "app/batch/setting_options.h"

#include "core/gltf/json.h"

namespace stretch::app {

void addSettingOption(CommandLine& line, const SettingFacts& setting, SettingTexts& texts,
                      const std::string& heading) {
  if (setting.kind == SettingKind::flag) {
    line.flag(setting.option, texts.flags[setting.option], optionHelp(setting)).group(heading);
    return;
  }
  line.option(setting.option, texts.values[setting.option], optionHelp(setting))
      .check([setting](const std::string& text) {
        const Result<gltf::Json> value = valueOfText(setting, text);
        return value ? std::string() : withoutPlace(value.error());
      })
      .group(heading);
}

const std::string* textOf(const SettingTexts& texts, const SettingFacts& setting) {
  static const std::string given;
  const auto flag = texts.flags.find(setting.option);
  if (flag != texts.flags.end()) {
    return flag->second ? &given : nullptr;
  }
  const auto value = texts.values.find(setting.option);
  return value == texts.values.end() || value->second.empty() ? nullptr : &value->second;
}

} // namespace stretch::app
