#pragma once

#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <string>

// The switch of the faults that tests/mutation plants in a copy of the product: included before every file of
// that copy, never by the product itself. MUTANT=n turns the fault n on; MUTANT_TRACE=FILE notes there each
// fault whose place was passed.
namespace stretch::mutation {

inline int chosenMutant() {
  const char* chosen = std::getenv("MUTANT");
  return chosen == nullptr ? -1 : std::atoi(chosen);
}

inline int traceFile() {
  const char* path = std::getenv("MUTANT_TRACE");
  return path == nullptr ? -1 : ::open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
}

inline const int chosen = chosenMutant();
inline const int trace = traceFile();
inline std::array<std::atomic<bool>, 8192> passed = {};

// Written at once, so that a process that is killed has told what it passed.
inline void note(int mutant) {
  std::atomic<bool>& before = passed[static_cast<std::size_t>(mutant)];
  if (!before.load(std::memory_order_relaxed) && !before.exchange(true)) {
    const std::string line = std::to_string(mutant) + "\n";
    [[maybe_unused]] const auto written = ::write(trace, line.data(), line.size());
  }
}

} // namespace stretch::mutation

namespace stretch {

// Whether the fault of that number is the one that is on. Not constexpr: a table that could be calculated by
// the compiler is made when the program starts, so that its faults are tried as well; where a constant is
// asked for, the planted code does not compile.
inline bool mutant(int number) {
  if (mutation::trace >= 0) [[unlikely]] {
    mutation::note(number);
  }
  return mutation::chosen == number;
}

} // namespace stretch
