#include "app/schema/parse_text.h"

#include "core/base/number.h"

namespace stretch::app {

Result<double> parseNumber(const std::string& text, const std::string& where) {
  if (const std::optional<double> value = stretch::parseNumber(text)) {
    return *value;
  }
  return Error{"'" + text + "' is not a number", where, "give one number, such as 2 or 0.5"};
}

Result<Vec3> parseVector(const std::string& text, const std::string& where) {
  Vec3 vector(0.0);
  std::size_t start = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',', start) : text.size();
    if (comma == std::string::npos) {
      return Error{"'" + text + "' is not a vector", where, "give three numbers, such as 0,-9.81,0"};
    }
    const Result<double> number = parseNumber(text.substr(start, comma - start), where);
    if (!number) {
      return number.error();
    }
    vector[i] = *number;
    start = comma + 1;
  }
  return vector;
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
