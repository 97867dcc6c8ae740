#include "app/recipe/recipe_parts.h"

#include <string_view>

namespace stretch::app {

namespace {

using gltf::Json;

constexpr std::string_view fractionEnding = "_of_clip";

bool isFraction(const Json& json) {
  return json.is_number() && json.get<double>() >= 0.0 && json.get<double>() <= 1.0;
}

// One number, or two in order.
Result<Json> framesOf(const std::string& key, const Json& fractions, double lastFrame) {
  if (isFraction(fractions)) {
    return Json(fractions.get<double>() * lastFrame);
  }
  const bool isPart = fractions.is_array() && fractions.size() == 2 && isFraction(fractions[0]) &&
                      isFraction(fractions[1]) && fractions[0].get<double>() < fractions[1].get<double>();
  if (!isPart) {
    return Error{fractions.dump() + " is not a part of a clip", key,
                 "give two fractions in order, such as [0.2, 0.5]"};
  }
  return Json::array({fractions[0].get<double>() * lastFrame, fractions[1].get<double>() * lastFrame});
}

} // namespace

Result<Json> withFrames(const Json& entry, double lastFrame) {
  if (!entry.is_structured()) {
    return entry;
  }
  Json resolved = entry.is_array() ? Json::array() : Json::object();
  for (const auto& [key, value] : entry.items()) {
    const bool isFractions = entry.is_object() && key.ends_with(fractionEnding);
    const std::string plain = isFractions ? key.substr(0, key.size() - fractionEnding.size()) : key;
    Result<Json> inFrames = isFractions ? framesOf(key, value, lastFrame) : withFrames(value, lastFrame);
    if (!inFrames) {
      return inFrames;
    }
    if (entry.is_array()) {
      resolved.push_back(std::move(*inFrames));
    } else if (isFractions || !entry.contains(key + std::string(fractionEnding))) {
      resolved[plain] = std::move(*inFrames);
    }
  }
  return resolved;
}

} // namespace stretch::app
