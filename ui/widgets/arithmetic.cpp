#include "ui/widgets/arithmetic.h"

#include <cmath>
#include <string>

#include "core/base/number.h"

namespace stretch::ui {

namespace {

constexpr int deepest = 32; ///< Brackets within brackets.

/// A sum as it is read, from left to right.
class Sum {
public:
  explicit Sum(std::string_view text) : text_(text) {}

  std::optional<double> whole() {
    const std::optional<double> value = sum(0);
    return rest_ == text_.size() ? value : std::nullopt;
  }

private:
  [[nodiscard]] char next() const { return rest_ < text_.size() ? text_[rest_] : '\0'; }

  std::optional<double> sum(int depth) {
    std::optional<double> value = product(depth);
    while (value && (next() == '+' || next() == '-')) {
      const bool adds = text_[rest_++] == '+';
      const std::optional<double> other = product(depth);
      value = other ? std::optional(adds ? *value + *other : *value - *other) : std::nullopt;
    }
    return value;
  }

  std::optional<double> product(int depth) {
    std::optional<double> value = factor(depth);
    while (value && (next() == '*' || next() == '/')) {
      const bool multiplies = text_[rest_++] == '*';
      const std::optional<double> other = factor(depth);
      value = other ? std::optional(multiplies ? *value * *other : *value / *other) : std::nullopt;
    }
    return value;
  }

  std::optional<double> factor(int depth) {
    if (depth > deepest) {
      return std::nullopt;
    }
    if (next() == '-' || next() == '+') {
      const bool negative = text_[rest_++] == '-';
      const std::optional<double> value = factor(depth + 1);
      return value ? std::optional(negative ? -*value : *value) : std::nullopt;
    }
    if (next() == '(') {
      ++rest_;
      const std::optional<double> value = sum(depth + 1);
      return value && next() == ')' && ++rest_ > 0 ? value : std::nullopt;
    }
    const std::size_t end = std::min(text_.find_first_not_of("0123456789.", rest_), text_.size());
    const std::string_view digits = text_.substr(rest_, end - rest_);
    rest_ = end;
    return stretch::parseNumber(digits);
  }

  std::string_view text_;
  std::size_t rest_ = 0;
};

std::string cleaned(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (c == ',') {
      plain += '.';
    } else if (c != ' ' && c != '%' && c != 'x') {
      plain += c;
    }
  }
  return plain;
}

} // namespace

std::optional<double> typedNumber(std::string_view text, double current) {
  const std::string plain = cleaned(text);
  const bool goesOn = plain.size() > 2 && plain[1] == '=';
  const std::optional<double> value = Sum(goesOn ? std::string_view(plain).substr(2) : plain).whole();
  if (!value) {
    return std::nullopt;
  }
  double result = *value;
  if (goesOn) {
    switch (plain[0]) {
    case '+':
      result = current + *value;
      break;
    case '-':
      result = current - *value;
      break;
    case '*':
      result = current * *value;
      break;
    case '/':
      result = current / *value;
      break;
    default:
      return std::nullopt;
    }
  }
  return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

} // namespace stretch::ui
