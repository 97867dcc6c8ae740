#include "tests/support/app/captured_stream.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace stretch::test {

CapturedStream::CapturedStream(std::FILE* stream) : stream_(stream), kept_(dup(fileno(stream))) {
  std::string pattern = (std::filesystem::temp_directory_path() / "stretch-told-XXXXXX").string();
  std::fflush(stream_);
  file_ = mkstemp(pattern.data());
  if (kept_ < 0 || file_ < 0 || dup2(file_, fileno(stream_)) < 0) {
    throw std::runtime_error("cannot keep what goes to a standard stream");
  }
  unlink(pattern.c_str());
}

CapturedStream::~CapturedStream() {
  std::fflush(stream_);
  dup2(kept_, fileno(stream_));
  close(kept_);
  close(file_);
}

std::string CapturedStream::text() const {
  std::fflush(stream_);
  std::string text;
  std::array<char, 4096> part{};
  ssize_t count = 0;
  while ((count = pread(file_, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return text;
}

} // namespace stretch::test
