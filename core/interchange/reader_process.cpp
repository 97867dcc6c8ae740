#include "core/interchange/reader_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h> // environ

#include "core/base/descriptor.h"
#include "core/gltf/json/json.h"
#include "core/interchange/foreign_file.h"

namespace stretch::interchange {

namespace {

using gltf::Json;

constexpr const char* hiddenVerb = "read-foreign-file";
constexpr std::uintmax_t bytesOfOne = 64;            // As docs/trust.md says of every file.
constexpr std::uintmax_t bytesOfAny = 400ULL << 20U; // Half of what it says: to touch memory is what costs
                                                     // time.
constexpr rlim_t processorSeconds = 60;
constexpr int longestSilence = 120'000; // Milliseconds: one that waits, and uses no processor, is ended too.

// This program once more, with the hidden verb; its standard output goes to the pipe. -1: could not be
// started.
pid_t startReader(const std::filesystem::path& file, int output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  std::string program = "stretch-engine";
  std::string verb = hiddenVerb;
  std::string name = file.string();
  const std::array<char*, 4> arguments{program.data(), verb.data(), name.data(), nullptr};
  pid_t child = -1;
  const int failed = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? child : -1;
}

enum class Ending { whole, tooLate, tooMuch };

// All that the reader writes, up to `most` bytes.
Ending readAll(int input, std::uintmax_t most, Bytes& all) {
  std::array<std::uint8_t, 1U << 16U> part{};
  for (;;) {
    pollfd waited{input, POLLIN, 0};
    const int ready = poll(&waited, 1, longestSilence);
    if (ready == 0) {
      return Ending::tooLate;
    }
    const ssize_t got = ready < 0 ? -1 : read(input, part.data(), part.size());
    if (got == 0 || (got < 0 && errno != EINTR)) {
      return Ending::whole;
    }
    if (got > 0 && all.size() + static_cast<std::size_t>(got) > most) {
      return Ending::tooMuch;
    }
    all.insert(all.end(), part.begin(), part.begin() + std::max<ssize_t>(got, 0));
  }
}

Error tooExpensive(const std::string& format) {
  return {"asks for more memory or time than its size allows", "",
          "the " + format + " may be damaged: export it again, or as .glb"};
}

// The error of a reader that answered nothing: it was ended by a limit, or by a fault of the library.
Error noAnswer(int status, const std::string& format) {
  const bool byLimit = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
  return byLimit ? tooExpensive(format)
                 : Error{"brought the reader of " + format + " files down, and nothing else", "",
                         "the file may be damaged: export it again, or as .glb"};
}

Result<Converted> parsedAnswer(const Bytes& all, int status, const std::string& format) {
  const auto end = std::find(all.begin(), all.end(), std::uint8_t{'\n'});
  const Json head =
      end == all.end() ? Json(Json::value_t::discarded) : Json::parse(all.begin(), end, nullptr, false);
  if (!head.is_object()) {
    return noAnswer(status, format);
  }
  if (head.contains("what")) {
    return Error{head.value("what", ""), head.value("where", ""), head.value("remedy", "")};
  }
  Converted converted;
  converted.glb.assign(end + 1, all.end());
  converted.warnings = head.value("warnings", std::vector<std::string>());
  return head.value("bytes", std::size_t{0}) == converted.glb.size() ? Result<Converted>(std::move(converted))
                                                                     : noAnswer(status, format);
}

void limit(int what, rlim_t most) {
  rlimit limits{};
  getrlimit(static_cast<__rlimit_resource>(what), &limits);
  limits.rlim_cur = std::min(most, limits.rlim_max);
  limits.rlim_max = limits.rlim_cur;
  setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

// A sanitizer reserves more addresses than any machine has memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limitsAddresses = false;
#else
constexpr bool limitsAddresses = true;
#endif

// What the program itself occupies comes on top.
void limitThisProcess(std::uintmax_t fileBytes) {
  std::uintmax_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const std::uintmax_t own = pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
  if (limitsAddresses) {
    limit(RLIMIT_AS, own + bytesOfAny + bytesOfOne * fileBytes);
  }
  limit(RLIMIT_CPU, processorSeconds);
  limit(RLIMIT_CORE, 0);
}

Result<Converted> convertedWithinMemory(const char* file) {
  try {
    return converted(file);
  } catch (const std::bad_alloc&) {
    return tooExpensive("file");
  } catch (const std::exception& problem) {
    return Error{fmt::format("cannot be read ({})", problem.what()), "", "export it again, or as .glb"};
  }
}

} // namespace

Result<Converted> convertedInProcess(const std::filesystem::path& file, Format format,
                                     std::uintmax_t fileBytes) {
  std::array<int, 2> ends{-1, -1};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Error{fmt::format("cannot be read: no pipe ({})", std::strerror(errno)), "",
                 "close other programs"};
  }
  const Descriptor input(ends[0]);
  Descriptor output(ends[1]);
  const pid_t child = startReader(file, output.number());
  output.close();
  if (child < 0) {
    return Error{"cannot be read: the program could not start itself again", "", "close other programs"};
  }
  Bytes all;
  const Ending ending = readAll(input.number(), bytesOfAny + bytesOfOne * fileBytes, all);
  if (ending != Ending::whole) {
    kill(child, SIGKILL);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return ending == Ending::whole ? parsedAnswer(all, status, nameOf(format))
                                 : Result<Converted>(tooExpensive(nameOf(format)));
}

std::optional<int> runAsReader(int argumentCount, const char* const* arguments) {
  if (argumentCount != 3 || std::string_view(arguments[1]) != hiddenVerb) {
    return std::nullopt;
  }
  std::error_code ignored;
  const std::uintmax_t bytes = std::filesystem::file_size(arguments[2], ignored);
  prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody waits for the answer when the program is gone
  limitThisProcess(ignored ? 0 : bytes);
  const Result<Converted> made = convertedWithinMemory(arguments[2]);
  const Json head =
      made
          ? Json{{"warnings", made->warnings}, {"bytes", made->glb.size()}}
          : Json{{"what", made.error().what}, {"where", made.error().where}, {"remedy", made.error().remedy}};
  const std::string line = head.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  std::fwrite(line.data(), 1, line.size(), stdout);
  if (made) {
    std::fwrite(made->glb.data(), 1, made->glb.size(), stdout);
  }
  return std::fflush(stdout) == 0 ? 0 : 1;
}

} // namespace stretch::interchange
