#pragma once

#include <cstdio>
#include <string>

namespace stretch::test {

/// While it lives, what goes to a standard stream of the process is kept instead.
class CapturedStream {
public:
  /// `stream`: stdout or stderr.
  explicit CapturedStream(std::FILE* stream);
  ~CapturedStream();
  CapturedStream(const CapturedStream&) = delete;
  CapturedStream& operator=(const CapturedStream&) = delete;

  /// Everything so far.
  [[nodiscard]] std::string text() const;

private:
  std::FILE* stream_;
  int kept_ = -1; ///< The real stream.
  int file_ = -1;
};

} // namespace stretch::test
