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

/// A row of the table; rows of one table are compared with its first.
struct Row {
  std::string what;
  Timing timing;
};

/// Prints a title and the rows: CPU and wall time, and the CPU time as a multiple of the first row's.
void printTable(const std::string& title, const std::vector<Row>& rows);

} // namespace stretch::bench
