#include "app/commands/modal.h"

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

} // namespace stretch::app
