#include "tests/bench/speed/comparison.h"

#include <algorithm>

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/gltf/json/json.h"
#include "tests/bench/measure.h"

namespace stretch::bench {

namespace {

double milliseconds(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::string shownRatio(const Comparison& one) {
  return one.other > 0.0 ? fmt::format("{:.3g}", one.ratio()) : "-";
}

void printTable(const std::vector<Comparison>& comparisons) {
  fmt::print("{:<64}{:<38}{:>10}{:>10}{:>8}{:>8}  {}\n", "item", "beside", "ours", "other", "ratio", "goal",
             "what limits it");
  for (const Comparison& one : comparisons) {
    const std::string other = one.other > 0.0 ? fmt::format("{:.3f}", one.other) : "-";
    fmt::print("{:<64}{:<38}{:>10.3f}{:>10}{:>8}{:>8.3g}  {}\n", one.item, one.than, one.ours, other,
               shownRatio(one), one.goal, one.limit);
  }
}

} // namespace

Pair measureInTurn(int repetitions, const Work& ours, const Work& other) {
  std::vector<double> first;
  std::vector<double> second;
  for (int i = 0; i < std::max(1, repetitions); ++i) {
    first.push_back(measure(1, ours).cpuMilliseconds);
    second.push_back(measure(1, other).cpuMilliseconds);
  }
  return {median(std::move(first)), median(std::move(second))};
}

RunCost runProgram(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str())); // what posix_spawnp asks for
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  }
  pid_t process = 0;
  const int failed = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  RunCost cost;
  int status = 0;
  rusage usage{};
  if (failed == 0 && wait4(process, &status, 0, &usage) == process) {
    cost.ran = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    cost.milliseconds = milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
    cost.megabytes = static_cast<double>(usage.ru_maxrss) * 1024.0 * 1e-6;
  }
  return cost;
}

void print(const std::vector<Comparison>& comparisons, bool asJson) {
  if (!asJson) {
    printTable(comparisons);
    return;
  }
  gltf::Json rows = gltf::Json::array();
  for (const Comparison& one : comparisons) {
    gltf::Json row{{"item", one.item},
                   {"beside", one.than},
                   {"ours", one.ours},
                   {"goal", one.goal},
                   {"limit", one.limit}};
    if (one.other > 0.0) {
      row["other"] = one.other;
      row["ratio"] = one.ratio();
    }
    rows.push_back(std::move(row));
  }
  fmt::print("{}\n", rows.dump(2));
}

} // namespace stretch::bench
