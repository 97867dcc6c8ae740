#pragma once

#include <string>

namespace stretch::test {

/// While it lives, what goes to standard error is kept instead.
class CapturedErrors {
public:
  CapturedErrors();
  ~CapturedErrors();
  CapturedErrors(const CapturedErrors&) = delete;
  CapturedErrors& operator=(const CapturedErrors&) = delete;

  /// Everything so far.
  [[nodiscard]] std::string text() const;

private:
  int kept_ = -1; ///< The real standard error.
  int file_ = -1;
};

} // namespace stretch::test
