#include "tests/support/app/other_value.h"

namespace stretch::test {

using app::SettingKind;
using gltf::Json;

Json otherValue(const app::SettingFacts& setting) {
  const Json standard = Json::parse(setting.standard);
  switch (setting.kind) {
  case SettingKind::number:
  case SettingKind::whole:
    return standard.get<double>() == setting.maximum ? setting.minimum : setting.maximum;
  case SettingKind::optionalNumber:
    return 7.5;
  case SettingKind::flag:
    return !standard.get<bool>();
  case SettingKind::choice:
    return standard == setting.choices.back().name ? setting.choices.front().name
                                                   : setting.choices.back().name;
  case SettingKind::axes:
    return "y";
  case SettingKind::ease:
    return Json::array({0.25, setting.name == "ease_in" ? 0.25 : 0.75}); // on its side of the half
  case SettingKind::vector:
    return Json::array({1.0, -2.5, 0.0});
  case SettingKind::text:
    return "side"; // a camera that every character has
  }
  return nullptr;
}

} // namespace stretch::test
