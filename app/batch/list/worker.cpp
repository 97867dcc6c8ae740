#include "app/batch/list/worker.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iostream>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace stretch::app {

namespace {

/// Goes before the two texts of an answer.
struct AnswerHead {
  std::int64_t exitCode = 0;
  std::uint64_t output = 0;
  std::uint64_t told = 0;
};

bool writeWhole(int to, const void* bytes, std::size_t count) {
  const auto* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = write(to, at, count);
    if (written < 0 && errno != EINTR) {
      return false;
    }
    at += std::max<ssize_t>(written, 0);
    count -= static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  return true;
}

bool readWhole(int from, void* bytes, std::size_t count) {
  auto* at = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = read(from, at, count);
    if (got == 0 || (got < 0 && errno != EINTR)) {
      return false;
    }
    at += std::max<ssize_t>(got, 0);
    count -= static_cast<std::size_t>(std::max<ssize_t>(got, 0));
  }
  return true;
}

// A file in memory in the place of standard output or error.
void captureStream(int stream) {
  const Descriptor memory(memfd_create("answer", 0));
  dup2(memory.number(), stream);
}

std::string takeCaptured(int stream) {
  std::string text(static_cast<std::size_t>(std::max<off_t>(lseek(stream, 0, SEEK_END), 0)), '\0');
  lseek(stream, 0, SEEK_SET);
  readWhole(stream, text.data(), text.size());
  lseek(stream, 0, SEEK_SET);
  return ftruncate(stream, 0) == 0 ? text : std::string();
}

[[noreturn]] void serve(int commands, int answers, const Worker::Run& run) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  dup2(nothing.number(), STDIN_FILENO);
  captureStream(STDOUT_FILENO);
  captureStream(STDERR_FILENO);
  std::string command;
  for (std::uint64_t length = 0; readWhole(commands, &length, sizeof(length));) {
    command.resize(length);
    if (!readWhole(commands, command.data(), command.size())) {
      break;
    }
    AnswerHead head;
    head.exitCode = run(command);
    std::cout.flush();
    std::fflush(nullptr);
    const std::string output = takeCaptured(STDOUT_FILENO);
    const std::string told = takeCaptured(STDERR_FILENO);
    head.output = output.size();
    head.told = told.size();
    if (!writeWhole(answers, &head, sizeof(head)) || !writeWhole(answers, output.data(), output.size()) ||
        !writeWhole(answers, told.data(), told.size())) {
      break;
    }
  }
  _exit(0);
}

} // namespace

Worker::Worker(const Run& run) {
  std::array<int, 2> in{-1, -1};
  std::array<int, 2> out{-1, -1};
  if (pipe2(in.data(), O_CLOEXEC) != 0) {
    return;
  }
  const Descriptor commandsEnd(in[0]);
  commands_ = Descriptor(in[1]);
  if (pipe2(out.data(), O_CLOEXEC) != 0) {
    return;
  }
  answers_ = Descriptor(out[0]);
  const Descriptor answersEnd(out[1]);
  std::cout.flush();
  std::fflush(nullptr);
  process_ = fork();
  if (process_ == 0) {
    commands_.close();
    answers_.close();
    serve(commandsEnd.number(), answersEnd.number(), run);
  }
}

Worker::~Worker() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
}

void Worker::give(const std::string& command) {
  const std::uint64_t length = command.size();
  isBusy_ = true;
  received_.clear();
  // One that is dead is found when its answer is taken.
  (void)(writeWhole(commands_.number(), &length, sizeof(length)) &&
         writeWhole(commands_.number(), command.data(), command.size()));
}

CommandAnswer Worker::ended() {
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  isBusy_ = false;
  return {1,
          {},
          WIFSIGNALED(status) ? fmt::format("the command was ended by signal {}", WTERMSIG(status))
                              : "the command ended the program"};
}

std::optional<CommandAnswer> Worker::take() {
  std::array<std::uint8_t, 1U << 16U> part{};
  const ssize_t got = read(answers_.number(), part.data(), part.size());
  if (got < 0 && errno == EINTR) {
    return std::nullopt;
  }
  if (got <= 0) {
    return ended();
  }
  received_.insert(received_.end(), part.begin(), part.begin() + got);
  AnswerHead head;
  if (received_.size() < sizeof(head)) {
    return std::nullopt;
  }
  std::memcpy(&head, received_.data(), sizeof(head));
  if (received_.size() < sizeof(head) + head.output + head.told) {
    return std::nullopt;
  }
  const auto* const texts = reinterpret_cast<const char*>(received_.data()) + sizeof(head);
  isBusy_ = false;
  return CommandAnswer{
      static_cast<int>(head.exitCode), {texts, head.output}, {texts + head.output, head.told}};
}

} // namespace stretch::app
