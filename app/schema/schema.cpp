#include "app/schema/schema.h"

#include <cctype>
#include <cmath>

#include <fmt/core.h>

#include "app/schema/parse_text.h"
#include "app/schema/schema_json.h"
#include "app/schema/schema_rows.h"

namespace stretch::app {

namespace {

using gltf::Json;

bool isNumberWithin(const Json& value, double minimum, double maximum) {
  return value.is_number() && value.get<double>() >= minimum && value.get<double>() <= maximum;
}

bool isWhole(const Json& value) {
  return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
}

bool isChoice(const SettingFacts& setting, const Json& value) {
  return std::any_of(setting.choices.begin(), setting.choices.end(), [&](const SettingChoice& choice) {
    return value.is_string() && value.get_ref<const std::string&>() == choice.name;
  });
}

bool isEase(const Json& value) {
  return value.is_array() && value.size() == 2 && isNumberWithin(value[0], 0.0, 0.999) &&
         isNumberWithin(value[1], 0.0, 1.0);
}

// Each letter once.
bool isAxes(const Json& value) {
  const std::string axes = value.is_string() ? value.get<std::string>() : "-";
  return std::ranges::all_of(axes, [&](char axis) {
    return std::string("xyz").find(axis) != std::string::npos && std::ranges::count(axes, axis) == 1;
  });
}

bool isVectorWithin(const SettingFacts& setting, const Json& value) {
  return value.is_array() && value.size() == 3 && std::all_of(value.begin(), value.end(), [&](const Json& v) {
           return isNumberWithin(v, setting.minimum, setting.maximum);
         });
}

bool isValid(const SettingFacts& setting, const Json& value) {
  switch (setting.kind) {
  case SettingKind::number:
    return isNumberWithin(value, setting.minimum, setting.maximum);
  case SettingKind::whole:
    return isNumberWithin(value, setting.minimum, setting.maximum) && isWhole(value);
  case SettingKind::optionalNumber:
    return value.is_null() || isNumberWithin(value, setting.minimum, setting.maximum);
  case SettingKind::flag:
    return value.is_boolean();
  case SettingKind::choice:
    return isChoice(setting, value);
  case SettingKind::axes:
    return isAxes(value);
  case SettingKind::ease:
    return isEase(value);
  case SettingKind::vector:
    return isVectorWithin(setting, value);
  case SettingKind::text:
    return value.is_string();
  }
  return false;
}

std::string choiceList(const SettingFacts& setting) {
  std::string list;
  for (const SettingChoice& choice : setting.choices) {
    list += (list.empty() ? "" : ", ") + choice.name;
  }
  return list;
}

std::string unitAfter(const SettingFacts& setting) {
  return setting.unit.empty() ? "" : " " + setting.unit;
}

// Text that only has to be split: the numbers are checked afterwards.
Result<Json> easeOfText(const SettingFacts& setting, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    return Error{"'" + text + "' has no comma", setting.option,
                 "give a fraction and a value, such as 0.6,0.1"};
  }
  const Result<double> percent = parseNumber(text.substr(0, comma), setting.option);
  const Result<double> value = parseNumber(text.substr(comma + 1), setting.option);
  if (!percent || !value) {
    return percent ? value.error() : percent.error();
  }
  return Json::array({*percent, *value});
}

Result<Json> splitText(const SettingFacts& setting, const std::string& text) {
  switch (setting.kind) {
  case SettingKind::number:
  case SettingKind::whole:
  case SettingKind::optionalNumber: {
    const bool hasUnit = setting.unit == "%" && text.ends_with('%');
    const Result<double> value = parseNumber(text.substr(0, text.size() - (hasUnit ? 1 : 0)), setting.option);
    return value ? Result<Json>(Json(*value)) : Result<Json>(value.error());
  }
  case SettingKind::flag: // an option that is there says the opposite of the default
    return Json(setting.standard != "true");
  case SettingKind::choice:
  case SettingKind::axes:
  case SettingKind::text:
    return Json(text);
  case SettingKind::vector: {
    const Result<Vec3> vector = parseVector(text, setting.option);
    return vector ? Result<Json>(vectorToJson(*vector)) : Result<Json>(vector.error());
  }
  case SettingKind::ease:
    break;
  }
  return easeOfText(setting, text);
}

} // namespace

std::string takenValues(const SettingFacts& setting) {
  const std::string range =
      fmt::format("from {:g} to {:g}", setting.minimum, setting.maximum) + unitAfter(setting);
  switch (setting.kind) {
  case SettingKind::number:
  case SettingKind::optionalNumber:
    return "a number " + range;
  case SettingKind::whole:
    return "a whole number " + range;
  case SettingKind::flag:
    return "true or false";
  case SettingKind::axes:
    return "any of x, y, z";
  case SettingKind::ease:
    return "a fraction below 1 and a value from 0 to 1";
  case SettingKind::vector:
    return "three numbers " + range;
  case SettingKind::text:
    return "a name";
  case SettingKind::choice:
    break;
  }
  return "one of " + choiceList(setting);
}

Status checkValue(const SettingFacts& setting, const Json& value) {
  if (isValid(setting, value)) {
    return Success{};
  }
  const std::string given = value.is_number() ? fmt::format("{:g}", value.get<double>())
                                              : value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return Error{given + " is not possible", setting.name, "give " + takenValues(setting)};
}

Result<Json> valueOfText(const SettingFacts& setting, const std::string& text) {
  Result<Json> value = splitText(setting, text);
  if (!value) {
    return value;
  }
  if (const Status valid = checkValue(setting, *value); !valid) {
    return Error{"'" + text + "' is not possible", setting.option, valid.error().remedy};
  }
  return value;
}

std::string optionHelp(const SettingFacts& setting) {
  const bool switchesOff = setting.kind == SettingKind::flag && setting.standard == "true";
  std::string help = (switchesOff ? "Switches this off: " : "") + setting.help;
  if (!setting.choices.empty()) {
    help += " (" + choiceList(setting) + ")";
  }
  if (!setting.unit.empty()) {
    help += " [" + setting.unit + "]";
  }
  const bool tellsDefault =
      setting.kind != SettingKind::flag && setting.standard != "null" && setting.standard != "\"\"";
  std::string standard = setting.standard;
  std::erase_if(standard, [](char letter) { return letter == '"' || letter == '[' || letter == ']'; });
  return tellsDefault ? help + " Default: " + standard : help;
}

std::string labelOf(const SettingFacts& setting) {
  std::string label = setting.row.label.empty() ? setting.name : setting.row.label;
  std::replace(label.begin(), label.end(), '_', ' ');
  if (!label.empty()) {
    label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
  }
  return label;
}

std::string optionOf(const std::string& name, bool onByDefault) {
  std::string option = (onByDefault ? "--no-" : "--") + name;
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

} // namespace stretch::app
