#pragma once

#include <functional>
#include <string>
#include <vector>

namespace stretch::bench {

/// What doing a thing once takes: medians over the repetitions, milliseconds. CPU time is that of all threads
/// of the process: on a busy machine it says more than the wall's.
struct Timing {
  double cpuMilliseconds = 0.0;
  double wallMilliseconds = 0.0;
};

/// Does it `repetitions` times (at least once), quick work many times in a row, after some that do not count.
[[nodiscard]] Timing measure(int repetitions, const std::function<void()>& work);

/// What a run was asked for.
struct Options {
  int repetitions = 50;
  std::string only; ///< Rows whose text holds this; empty: all.
};

/// Rows that are compared with the first of them.
class Table {
public:
  Table(std::string title, Options options) : title_(std::move(title)), options_(std::move(options)) {}

  /// Measures, where the row is asked for.
  void add(const std::string& what, const std::function<void()>& work);
  /// The same, with this many repetitions.
  void add(const std::string& what, int repetitions, const std::function<void()>& work);

  [[nodiscard]] const Options& options() const { return options_; }

  /// Title and rows: CPU and wall time, and the CPU time as a multiple of the first row's. Nothing without
  /// rows.
  void print() const;

private:
  struct Row {
    std::string what;
    Timing timing;
  };
  std::string title_;
  Options options_;
  std::vector<Row> rows_;
};

} // namespace stretch::bench
