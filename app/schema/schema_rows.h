#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "app/schema/schema.h"
#include "core/base/check.h"
#include "core/gltf/json/json.h"
#include "core/math/types.h"
#include "rig/trail/trail.h"

namespace stretch::app {

// For the sources that hold a schema: how a member of each type becomes a value and back.

template <typename Value>
[[nodiscard]] constexpr SettingKind kindOf() {
  if constexpr (std::is_same_v<Value, bool>) {
    return SettingKind::flag;
  } else if constexpr (std::is_enum_v<Value>) {
    return SettingKind::choice;
  } else if constexpr (std::is_integral_v<Value>) {
    return SettingKind::whole;
  } else if constexpr (std::is_floating_point_v<Value>) {
    return SettingKind::number;
  } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
    return SettingKind::optionalNumber;
  } else if constexpr (std::is_same_v<Value, rig::Ease>) {
    return SettingKind::ease;
  } else if constexpr (std::is_same_v<Value, std::array<bool, 3>>) {
    return SettingKind::axes;
  } else if constexpr (std::is_same_v<Value, std::string>) {
    return SettingKind::text;
  } else {
    static_assert(std::is_same_v<Value, Vec3>, "a setting of this type needs a kind");
    return SettingKind::vector;
  }
}

template <typename Value>
[[nodiscard]] gltf::Json valueOf(const Value& value, const std::vector<SettingChoice>& choices) {
  if constexpr (std::is_enum_v<Value>) {
    check(static_cast<std::size_t>(value) < choices.size(), "every value of the enumeration has a name");
    return choices[static_cast<std::size_t>(value)].name;
  } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
    return value ? gltf::Json(*value) : gltf::Json(nullptr);
  } else if constexpr (std::is_same_v<Value, rig::Ease>) {
    return gltf::Json::array({value.percent, value.value});
  } else if constexpr (std::is_same_v<Value, std::array<bool, 3>>) {
    std::string axes;
    for (std::size_t i = 0; i < 3; ++i) {
      axes += value[i] ? std::string(1, "xyz"[i]) : "";
    }
    return axes;
  } else if constexpr (std::is_same_v<Value, Vec3>) {
    return gltf::Json::array({value.x, value.y, value.z});
  } else {
    return value;
  }
}

template <typename Value>
void take(const gltf::Json& json, const std::vector<SettingChoice>& choices, Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    const auto name = json.get<std::string>();
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&](const SettingChoice& choice) { return choice.name == name; });
    value = static_cast<Value>(found - choices.begin());
  } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
    value = json.is_null() ? std::optional<double>() : std::optional<double>(json.get<double>());
  } else if constexpr (std::is_same_v<Value, rig::Ease>) {
    value = {json[0].get<double>(), json[1].get<double>()};
  } else if constexpr (std::is_same_v<Value, std::array<bool, 3>>) {
    for (std::size_t i = 0; i < 3; ++i) {
      value[i] = json.get<std::string>().find("xyz"[i]) != std::string::npos;
    }
  } else if constexpr (std::is_same_v<Value, Vec3>) {
    value = Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
  } else if constexpr (std::is_same_v<Value, std::string>) {
    value = json.get<std::string>();
  } else {
    value = static_cast<Value>(json.get<std::conditional_t<std::is_same_v<Value, bool>, bool, double>>());
  }
}

/// "--ease-in"; "--no-pull" for a flag that is on by default.
[[nodiscard]] std::string optionOf(const std::string& name, bool onByDefault);

/// One line of a schema. `access` leads to the member: `&Settings::scale`, or, where it lies deeper,
/// `[](auto& s) -> auto& { return s.body.mass; }`.
template <typename Settings, typename Access>
[[nodiscard]] Setting<Settings> setting(SettingFacts facts, Access access) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Access, Settings&>>;
  const std::vector<SettingChoice> choices = facts.choices;
  const Settings defaults{};
  const gltf::Json standard = valueOf<Value>(std::invoke(access, defaults), choices);
  facts.kind = kindOf<Value>();
  facts.standard = standard.dump();
  facts.option = optionOf(facts.name, standard.is_boolean() && standard.get<bool>());
  return {std::move(facts),
          [access, choices](const Settings& s) { return valueOf<Value>(std::invoke(access, s), choices); },
          [access, choices](const gltf::Json& v, Settings& s) {
            take<Value>(v, choices, std::invoke(access, s));
          }};
}

/// Parts of a table, one after the other.
template <typename Settings>
[[nodiscard]] Schema<Settings> joined(const std::vector<Schema<Settings>>& parts) {
  Schema<Settings> schema;
  for (const Schema<Settings>& part : parts) {
    schema.insert(schema.end(), part.begin(), part.end());
  }
  return schema;
}

/// The settings of a part of `Settings`, to which `access` leads, as settings of the whole.
template <typename Settings, typename Part, typename Access>
[[nodiscard]] Schema<Settings> partOf(const Schema<Part>& part, Access access) {
  Schema<Settings> schema;
  for (const Setting<Part>& one : part) {
    schema.push_back({static_cast<const SettingFacts&>(one),
                      [one, access](const Settings& s) { return one.read(access(s)); },
                      [one, access](const gltf::Json& v, Settings& s) { one.write(v, access(s)); }});
  }
  return schema;
}

} // namespace stretch::app
