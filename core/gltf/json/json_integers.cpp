#include "core/gltf/json/json_integers.h"

#include <cmath>
#include <limits>

#include "core/gltf/json/json.h"

namespace stretch::gltf {

namespace {

constexpr int wrongType = 302; // in the library's list of exceptions

} // namespace

int integerOf(const Json& value) {
  constexpr double largest = std::numeric_limits<int>::max();
  const double number = value.is_number() ? value.get<double>() : 0.5;
  if (std::abs(number) > largest || number != std::floor(number)) {
    throw Json::type_error::create(wrongType, "type must be an integer of 32 bits", &value);
  }
  return static_cast<int>(number);
}

std::vector<int> integersOf(const Json& list) {
  if (!list.is_array()) {
    throw Json::type_error::create(wrongType, "type must be a list", &list);
  }
  std::vector<int> numbers;
  numbers.reserve(list.size());
  for (const Json& value : list) {
    numbers.push_back(integerOf(value));
  }
  return numbers;
}

} // namespace stretch::gltf
