#include "app/schema/trail_description.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/number.h"
#include "core/gltf/json.h"

namespace stretch::app {

namespace {

using gltf::Json;
using rig::TrailSettings;

TrailSetting number(std::string name, std::string option, double minimum, double maximum, std::string unit,
                    std::string help, double TrailSettings::*member) {
  return {std::move(name),
          std::move(option),
          SettingKind::number,
          minimum,
          maximum,
          {},
          std::move(unit),
          std::move(help),
          [member](const TrailSettings& s) { return Json(s.*member); },
          [member](const Json& v, TrailSettings& s) { s.*member = v.get<double>(); }};
}

TrailSetting flag(std::string name, std::string option, std::string help, bool TrailSettings::*member) {
  return {std::move(name),
          std::move(option),
          SettingKind::flag,
          0.0,
          1.0,
          {},
          "",
          std::move(help),
          [member](const TrailSettings& s) { return Json(s.*member); },
          [member](const Json& v, TrailSettings& s) { s.*member = v.get<bool>(); }};
}

template <typename Enum>
TrailSetting choice(std::string name, std::string option, std::vector<std::string> choices, std::string help,
                    Enum TrailSettings::*member) {
  return {std::move(name),
          std::move(option),
          SettingKind::choice,
          0.0,
          0.0,
          choices,
          "",
          std::move(help),
          [member, choices](const TrailSettings& s) {
            return Json(choices[static_cast<std::size_t>(s.*member)]);
          },
          [member, choices](const Json& v, TrailSettings& s) {
            const auto found = std::find(choices.begin(), choices.end(), v.get<std::string>());
            s.*member = static_cast<Enum>(found - choices.begin());
          }};
}

TrailSetting ease(std::string name, std::string option, std::string help, rig::Ease TrailSettings::*member) {
  return {std::move(name),
          std::move(option),
          SettingKind::ease,
          0.0,
          1.0,
          {},
          "fraction,value",
          std::move(help),
          [member](const TrailSettings& s) {
            return Json::array({(s.*member).percent, (s.*member).value});
          },
          [member](const Json& v, TrailSettings& s) {
            s.*member = {v[0].get<double>(), v[1].get<double>()};
          }};
}

TrailSetting axesSetting() {
  return {"axes",
          "--axes",
          SettingKind::axes,
          0.0,
          0.0,
          {},
          "",
          "Active axes of the trail's space, any of x, y, z.",
          [](const TrailSettings& s) {
            std::string axes;
            for (std::size_t i = 0; i < 3; ++i) {
              axes += s.axes[i] ? std::string(1, "xyz"[i]) : "";
            }
            return Json(axes);
          },
          [](const Json& v, TrailSettings& s) {
            const auto axes = v.get<std::string>();
            for (std::size_t i = 0; i < 3; ++i) {
              s.axes[i] = axes.find("xyz"[i]) != std::string::npos;
            }
          }};
}

TrailSetting releaseSetting() {
  return {
      "release",
      "--release",
      SettingKind::optionalNumber,
      0.0,
      100000.0,
      {},
      "frames",
      "Frames after the tip over which the limb comes back to the original motion; default: to the next key.",
      [](const TrailSettings& s) { return s.releaseFrames ? Json(*s.releaseFrames) : Json(nullptr); },
      [](const Json& v, TrailSettings& s) {
        s.releaseFrames = v.is_null() ? std::optional<double>() : std::optional<double>(v.get<double>());
      }};
}

std::vector<TrailSetting> trailTable() {
  using S = TrailSettings;
  return {
      number("scale", "--scale", 0.0, 100.0, "",
             "How long the limb becomes at the tip, in lengths of itself.", &S::scale),
      axesSetting(),
      choice("pivot", "--pivot", {"start", "end"}, "The end of the range that stays where it is.", &S::pivot),
      choice("space", "--space", {"world", "root", "base", "view"}, "Where the path is exaggerated.",
             &S::space),
      choice("reference", "--reference", {"pose", "rest"}, "The length that the scale multiplies.",
             &S::reference),
      choice("bend", "--bend", {"keep", "straighten"},
             "Keep the limb's bend, or straighten it before it stretches.", &S::bend),
      choice("remap", "--remap", {"spline", "linear"}, "Shape of the transition along the path.", &S::remap),
      ease("ease_in", "--ease-in", "Ease-in: fraction of the path and value there, P,V.", &S::easeIn),
      ease("ease_out", "--ease-out", "Ease-out: fraction of the path from its end and value there, P,V.",
           &S::easeOut),
      releaseSetting(),
      number("overshoot", "--overshoot", 0.0, 1.0, "of the tip's offset",
             "How far the release swings past the original.", &S::overshoot),
      number("blend", "--blend", 0.0, 2.0, "", "0 original, 1 half-way, 2 exaggerated.", &S::blend),
      number("switch", "--switch", 0.0, 1.0, "", "How much of the wanted length the limb takes on.",
             &S::stretchSwitch),
      number("volume", "--volume", 0.0, 1.0, "", "Volume preservation: 0 keeps the thickness, 1 the volume.",
             &S::volume),
      flag("pull", "", "Pull the tip to the wanted length where its line does not reach it.", &S::pull),
      flag("stay_in_world", "--stay-in-world", "The limb's end is not carried along by inner trails.",
           &S::stayInWorld),
      flag("turn_end", "--turn-end", "The hand or foot turns with the limb.", &S::turnEnd),
  };
}

bool isNumberWithin(const Json& value, double minimum, double maximum) {
  return value.is_number() && value.get<double>() >= minimum && value.get<double>() <= maximum;
}

bool isAxes(const Json& value) {
  return value.is_string() && value.get<std::string>().find_first_not_of("xyz") == std::string::npos;
}

bool isEase(const Json& value) {
  return value.is_array() && value.size() == 2 && isNumberWithin(value[0], 0.0, 0.999) &&
         isNumberWithin(value[1], 0.0, 1.0);
}

bool isValid(const TrailSetting& setting, const Json& value) {
  switch (setting.kind) {
  case SettingKind::number:
    return isNumberWithin(value, setting.minimum, setting.maximum);
  case SettingKind::optionalNumber:
    return value.is_null() || isNumberWithin(value, setting.minimum, setting.maximum);
  case SettingKind::flag:
    return value.is_boolean();
  case SettingKind::choice:
    return value.is_string() && std::find(setting.choices.begin(), setting.choices.end(),
                                          value.get<std::string>()) != setting.choices.end();
  case SettingKind::axes:
    return isAxes(value);
  case SettingKind::ease:
    return isEase(value);
  }
  return false;
}

std::string expectation(const TrailSetting& setting) {
  switch (setting.kind) {
  case SettingKind::number:
  case SettingKind::optionalNumber:
    return fmt::format("a number from {:g} to {:g}", setting.minimum, setting.maximum);
  case SettingKind::flag:
    return "true or false";
  case SettingKind::axes:
    return "any of x, y, z";
  case SettingKind::ease:
    return "a fraction below 1 and a value from 0 to 1";
  case SettingKind::choice:
    break;
  }
  std::string list;
  for (const std::string& one : setting.choices) {
    list += (list.empty() ? "" : ", ") + one;
  }
  return "one of " + list;
}

} // namespace

const std::vector<TrailSetting>& trailSettings() {
  static const std::vector<TrailSetting> table = trailTable();
  return table;
}

Status setTrailSetting(const TrailSetting& setting, const Json& value, TrailSettings& settings) {
  if (!isValid(setting, value)) {
    return Error{fmt::format("{} is not a value of it", value.dump()), setting.name,
                 "give " + expectation(setting)};
  }
  setting.write(value, settings);
  return Success{};
}

Result<double> parseNumber(const std::string& text, const std::string& where) {
  if (const std::optional<double> value = stretch::parseNumber(text)) {
    return *value;
  }
  return Error{"'" + text + "' is no number", where, "give one number, such as 2 or 0.5"};
}

Result<Json> parseSettingText(const TrailSetting& setting, const std::string& text) {
  switch (setting.kind) {
  case SettingKind::number:
  case SettingKind::optionalNumber: {
    const Result<double> value = parseNumber(text, setting.option);
    return value ? Result<Json>(Json(*value)) : Result<Json>(value.error());
  }
  case SettingKind::flag:
    return Json(text != "false");
  case SettingKind::choice:
  case SettingKind::axes:
    return Json(text);
  case SettingKind::ease:
    break;
  }
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

} // namespace stretch::app
