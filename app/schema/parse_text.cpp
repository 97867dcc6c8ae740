#include "app/schema/parse_text.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "core/base/number.h"

namespace stretch::app {

Result<double> parseNumber(const std::string& text, const std::string& where) {
  if (const std::optional<double> value = stretch::parseNumber(text)) {
    return *value;
  }
  return Error{"'" + text + "' is not a number", where, "give one number, such as 2 or 0.5"};
}

Result<Vec3> parseVector(const std::string& text, const std::string& where) {
  const Error malformed{"'" + text + "' is not a vector", where, "give three numbers, such as 0,-9.81,0"};
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream words(spaced);
  Vec3 vector(0.0);
  std::string word;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> number = words >> word ? stretch::parseNumber(word) : std::nullopt;
    if (!number) {
      return malformed;
    }
    vector[i] = *number;
  }
  return words >> word ? Result<Vec3>(malformed) : Result<Vec3>(vector);
}

Result<Vec2> parseRange(const std::string& text, const std::string& where) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    return Error{"'" + text + "' is not a range", where, "give the first and the last frame, such as 0:12"};
  }
  const Result<double> first = parseNumber(text.substr(0, colon), where);
  const Result<double> last = parseNumber(text.substr(colon + 1), where);
  if (!first || !last) {
    return first ? last.error() : first.error();
  }
  if (*first > *last) {
    return Error{"the first frame comes after the last", where, "give them in order"};
  }
  return Vec2(*first, *last);
}

} // namespace stretch::app
