#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "core/base/descriptor.h"
#include "core/base/file.h"

namespace stretch::app {

/// Outcome of a command.
struct CommandAnswer {
  int exitCode = 0;
  std::string output; ///< On standard output.
  std::string told;   ///< On standard error.
};

/// A process that runs one command after another and stays warm between them: a copy of this one, so that a
/// command that brings it down costs no other. It ends with this one, and when it is destroyed.
class Worker {
public:
  /// Runs a command; called in the process of the worker alone.
  using Run = std::function<int(const std::string& command)>;

  /// Starts the process; isAlive tells whether it could be. This process must not have threads yet.
  explicit Worker(const Run& run);
  Worker(Worker&&) noexcept = default;
  Worker& operator=(Worker&&) = delete;
  ~Worker();

  [[nodiscard]] bool isAlive() const { return process_ > 0; }
  [[nodiscard]] bool isBusy() const { return isBusy_; }
  [[nodiscard]] int readyDescriptor() const { return answers_.number(); }

  void give(const std::string& command);
  /// Takes what the process has written. An answer once it is whole; where the process ended before, one that
  /// says so, and the worker is not alive any more.
  [[nodiscard]] std::optional<CommandAnswer> take();

private:
  struct ProcessId {
    pid_t number = -1;
    ProcessId() = default;
    ProcessId(ProcessId&& other) noexcept : number(std::exchange(other.number, -1)) {}
    ProcessId& operator=(ProcessId&&) = delete;
    ProcessId& operator=(pid_t other) {
      number = other;
      return *this;
    }
    operator pid_t() const { return number; } // NOLINT(google-explicit-constructor)
  };

  [[nodiscard]] CommandAnswer ended();

  ProcessId process_;
  Descriptor commands_;
  Descriptor answers_;
  bool isBusy_ = false;
  Bytes received_;
};

} // namespace stretch::app
