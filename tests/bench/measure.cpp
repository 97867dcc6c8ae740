#include "tests/bench/measure.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include <fmt/core.h>

namespace stretch::bench {

namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The mean of `batch` times in a row.
Timing timeBatch(int batch, const std::function<void()>& work) {
  using Wall = std::chrono::steady_clock;
  const Wall::time_point wallStart = Wall::now();
  const std::clock_t cpuStart = std::clock();
  for (int i = 0; i < batch; ++i) {
    work();
  }
  const double cpu = 1e3 * static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC;
  const double wall = std::chrono::duration<double, std::milli>(Wall::now() - wallStart).count();
  return {cpu / batch, wall / batch};
}

/// How often quick work is done in a row, so that the clocks can tell it: for about a millisecond.
int batchSize(const std::function<void()>& work) {
  constexpr int most = 1024;
  int batch = 1;
  while (batch < most && timeBatch(batch, work).cpuMilliseconds * batch < 1.0) {
    batch *= 2;
  }
  return batch;
}

} // namespace

Timing measure(int repetitions, const std::function<void()>& work) {
  const int batch = batchSize(work);
  std::vector<double> cpu;
  std::vector<double> wall;
  for (int i = 0; i < std::max(repetitions, 1); ++i) {
    const Timing once = timeBatch(batch, work);
    cpu.push_back(once.cpuMilliseconds);
    wall.push_back(once.wallMilliseconds);
  }
  return {median(std::move(cpu)), median(std::move(wall))};
}

void Table::add(const std::string& what, const std::function<void()>& work) {
  add(what, options_.repetitions, work);
}

void Table::add(const std::string& what, int repetitions, const std::function<void()>& work) {
  if (what.find(options_.only) != std::string::npos) {
    rows_.push_back({what, measure(repetitions, work)});
  }
}

void Table::print() const {
  if (rows_.empty()) {
    return;
  }
  fmt::print("{}\n  {:<44}{:>12}{:>12}{:>10}\n", title_, "", "CPU ms", "wall ms", "ratio");
  const double unit = rows_.front().timing.cpuMilliseconds;
  for (const Row& row : rows_) {
    const double ratio = unit > 0.0 ? row.timing.cpuMilliseconds / unit : 0.0;
    fmt::print("  {:<44}{:>12.3f}{:>12.3f}{:>10.2f}\n", row.what, row.timing.cpuMilliseconds,
               row.timing.wallMilliseconds, ratio);
  }
}

} // namespace stretch::bench
