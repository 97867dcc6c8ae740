#include "app/commands/table/modal.h"

namespace stretch::app {

double TypedNumber::value() const {
  double sign = 1.0;
  double whole = 0.0;
  double fraction = 0.0;
  double place = 0.0; // 0: left of the separator.
  for (const char c : text) {
    if (c == '-') {
      sign = -1.0;
    } else if (c == '.') {
      place = 0.1;
    } else if (place > 0.0) {
      fraction += place * static_cast<double>(c - '0');
      place *= 0.1;
    } else {
      whole = 10.0 * whole + static_cast<double>(c - '0');
    }
  }
  return sign * (whole + fraction);
}

bool typeNumber(TypedNumber& number, const Chord& chord) {
  constexpr std::size_t longest = 9;
  std::string& text = number.text;
  const std::optional<int> digit = digitOf(chord.key);
  if (digit && text.size() < longest) {
    text.push_back(static_cast<char>('0' + *digit));
  } else if (isDecimalSeparator(chord.key)) {
    if (text.find('.') == std::string::npos) {
      text.push_back('.');
    }
  } else if (chord.key == Key::minus || chord.key == Key::numpadSubtract) {
    text = !text.empty() && text.front() == '-' ? text.substr(1) : "-" + text;
  } else if (chord.key == Key::backspace) {
    text = text.empty() ? text : text.substr(0, text.size() - 1);
  } else {
    return digit.has_value();
  }
  return true;
}

std::optional<int> axisOf(char letter) {
  return letter >= 'x' && letter <= 'z' ? std::optional(letter - 'x') : std::nullopt;
}

std::optional<ModalOutcome> endBy(const Chord& chord) {
  const bool keeps = chord.key == Key::enter || chord.key == Key::numpadEnter;
  return keeps                      ? std::optional(ModalOutcome::keep)
         : chord.key == Key::escape ? std::optional(ModalOutcome::restore)
                                    : std::nullopt;
}

Vec3 nudgeOf(const Chord& chord, const Mat3& viewAxes, double stepUnits) {
  const double step = stepUnits * (chord.shift ? 10.0 : chord.ctrl ? 0.1 : 1.0);
  switch (chord.key) {
  case Key::right:
    return step * viewAxes[0];
  case Key::left:
    return -step * viewAxes[0];
  case Key::up:
    return step * viewAxes[1];
  case Key::down:
    return -step * viewAxes[1];
  case Key::pageDown:
    return step * viewAxes[2];
  case Key::pageUp:
    return -step * viewAxes[2];
  default:
    return Vec3(0.0);
  }
}

} // namespace stretch::app
