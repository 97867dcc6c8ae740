#include "skinning/elastic/moduli.h"

#include <string>

#include "core/gltf/json/json.h"
#include "core/gltf/source/json_text.h"

namespace stretch::skinning {
namespace {

using gltf::Json;

constexpr const char* remedy = "write {\"young\": E, \"segments\": [{\"from\": 0, \"to\": 4, \"young\": E}]}";

Error problem(std::string what, std::string where) {
  return {std::move(what), std::move(where), remedy};
}

std::optional<double> positive(const Json& value) {
  const bool usable = value.is_number() && value.get<double>() > 0.0 && value.get<double>() < 1e30;
  return usable ? std::optional(value.get<double>()) : std::nullopt;
}

std::optional<std::size_t> segmentNumber(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  const bool usable =
      found != entry.end() && found->is_number_unsigned() && found->get<std::uint64_t>() < 1000000;
  return usable ? std::optional(found->get<std::size_t>()) : std::nullopt;
}

Result<SegmentModuli::Range> parseRange(const Json& entry, const std::string& where) {
  if (!entry.is_object()) {
    return problem("a range of segments is an object", where);
  }
  for (const auto& [key, value] : entry.items()) {
    if (key != "from" && key != "to" && key != "young") {
      return problem("unknown key '" + key + "'", where);
    }
  }
  const auto first = segmentNumber(entry, "from");
  const auto last = segmentNumber(entry, "to");
  const auto young = entry.contains("young") ? positive(entry["young"]) : std::nullopt;
  if (!first || !last || !young || *last < *first) {
    return problem("a range needs from <= to, counted from 0, and a positive modulus", where);
  }
  return SegmentModuli::Range{*first, *last, *young};
}

} // namespace

double SegmentModuli::at(std::size_t segment, double fallback) const {
  double modulus = youngModulus.value_or(fallback);
  for (const Range& range : ranges) {
    modulus = segment >= range.first && segment <= range.last ? range.youngModulus : modulus;
  }
  return modulus;
}

Result<SegmentModuli> parseModuli(std::string_view text) {
  const Json json = gltf::parseAnyJson(text);
  if (!json.is_object()) {
    return problem("the moduli are no JSON object", "moduli");
  }
  SegmentModuli moduli;
  for (const auto& [key, value] : json.items()) {
    if (key == "young") {
      moduli.youngModulus = positive(value);
      if (!moduli.youngModulus) {
        return problem("the modulus is no positive number", "moduli.young");
      }
    } else if (key == "segments" && value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        const auto range = parseRange(value[i], "moduli.segments[" + std::to_string(i) + "]");
        if (!range) {
          return range.error();
        }
        moduli.ranges.push_back(*range);
      }
    } else {
      return problem("unknown key '" + key + "'", "moduli");
    }
  }
  return moduli;
}

std::string moduliText(const SegmentModuli& moduli) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (moduli.youngModulus) {
    json["young"] = *moduli.youngModulus;
  }
  if (!moduli.ranges.empty()) {
    json["segments"] = nlohmann::ordered_json::array();
  }
  for (const SegmentModuli::Range& range : moduli.ranges) {
    json["segments"].push_back({{"from", range.first}, {"to", range.last}, {"young", range.youngModulus}});
  }
  return json.dump(2) + "\n";
}

} // namespace stretch::skinning
