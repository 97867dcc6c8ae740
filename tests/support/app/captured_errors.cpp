#include "tests/support/app/captured_errors.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace stretch::test {

CapturedErrors::CapturedErrors() : kept_(dup(STDERR_FILENO)) {
  std::string pattern = (std::filesystem::temp_directory_path() / "stretch-told-XXXXXX").string();
  std::fflush(stderr);

  file_ = mkstemp(pattern.data());
  if (kept_ < 0 || file_ < 0 || dup2(file_, STDERR_FILENO) < 0) {
    throw std::runtime_error("cannot keep what goes to standard error");
  }
  unlink(pattern.c_str());
}

CapturedErrors::~CapturedErrors() {
  std::fflush(stderr);
  dup2(kept_, STDERR_FILENO);
  close(kept_);
  close(file_);
}

std::string CapturedErrors::text() const {
  std::fflush(stderr);
  std::string text;
  std::array<char, 4096> part{};
  ssize_t count = 0;
  while ((count = pread(file_, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return text;
}

} // namespace stretch::test
