#pragma once

#include <string>

#include "app/schema/locator_json.h"
#include "core/gltf/json/json.h"

namespace stretch::test {

/// The locators of a person of 1.8 units who faces +Z with the arms sideways, as a file has them; without
/// orientations.
[[nodiscard]] inline gltf::Json locatorText() {
  gltf::Json json{{"plan", "biped"}, {"locators", gltf::Json::array()}};
  const auto add = [&](const std::string& name, double x, double y, double z) {
    json["locators"].push_back({{"name", name}, {"position", {x, y, z}}});
  };
  add("hips", 0.0, 0.95, 0.0);
  add("spine", 0.0, 1.05, 0.0);
  add("chest", 0.0, 1.2, 0.0);
  add("upperChest", 0.0, 1.35, 0.0);
  add("neck", 0.0, 1.5, 0.0);
  add("head", 0.0, 1.6, 0.0);
  for (const auto& [side, sign] : {std::pair{"left", 1.0}, std::pair{"right", -1.0}}) {
    const std::string name(side);
    add(name + "Shoulder", sign * 0.03, 1.45, 0.0);
    add(name + "UpperArm", sign * 0.17, 1.45, 0.0);
    add(name + "LowerArm", sign * 0.45, 1.45, 0.0);
    add(name + "Hand", sign * 0.7, 1.45, 0.0);
    add(name + "UpperLeg", sign * 0.09, 0.9, 0.0);
    add(name + "LowerLeg", sign * 0.09, 0.5, 0.0);
    add(name + "Foot", sign * 0.09, 0.08, -0.02);
    add(name + "Toes", sign * 0.09, 0.02, 0.12);
  }
  return json;
}

} // namespace stretch::test
