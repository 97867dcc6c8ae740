#include "tests/support/app/report_text.h"

#include <map>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "core/gltf/json/json.h"

namespace stretch::test {

namespace {

using gltf::Json;

/// Of a long report how many values there are at each path, whatever their place in a list, and what numbers
/// add up to.
std::string sumsOf(const Json& flat) {
  std::map<std::string, std::pair<int, double>> sums;
  for (const auto& [path, value] : flat.items()) {
    auto& [count, sum] = sums[std::regex_replace(path, std::regex("/[0-9]+"), "/*")];
    ++count;
    sum += value.is_number() ? value.get<double>() : 0.0;
  }
  std::string text;
  for (const auto& [path, of] : sums) {
    text += fmt::format("  {} {} values, {:.6f}\n", path, of.first, of.second);
  }
  return text;
}

} // namespace

std::string reportText(const std::string& output) {
  const Json report = Json::parse(output, nullptr, false);
  if (report.is_discarded() || !report.is_structured()) {
    return output;
  }
  constexpr std::size_t mostValues = 400;
  const Json flat = report.flatten();
  if (flat.size() > mostValues) {
    return sumsOf(flat);
  }
  std::string text;
  for (const auto& [path, value] : flat.items()) {
    text += "  " + path + " " + value.dump() + "\n";
  }
  return text;
}

} // namespace stretch::test
