#pragma once

#include <functional>
#include <string>
#include <vector>

namespace stretch::bench {

/// Something of this program beside a floor (the least that could do it) or a peer (another program).
struct Comparison {
  std::string item;
  std::string than;   ///< The floor or the peer.
  double ours = 0.0;  ///< Milliseconds of processor time, or megabytes.
  double other = 0.0; ///< The same of the other; 0: it is not on this machine.
  double goal = 0.0;  ///< ours / other, at most.
  std::string limit;  ///< What limits it.
  [[nodiscard]] double ratio() const { return other > 0.0 ? ours / other : 0.0; }
};

using Work = std::function<void()>;

/// Medians of both, measured in turn so that a busy machine troubles both alike: milliseconds of all threads.
struct Pair {
  double ours = 0.0;
  double other = 0.0;
};
[[nodiscard]] Pair measureInTurn(int repetitions, const Work& ours, const Work& other);

/// The processor time and the memory of a program that is run to its end.
struct RunCost {
  bool ran = false;          ///< It was there and answered 0.
  double milliseconds = 0.0; ///< Processor time, its own and the system's for it.
  double megabytes = 0.0;    ///< Its peak.
};
/// What it prints is dropped.
[[nodiscard]] RunCost runProgram(const std::vector<std::string>& command);

void print(const std::vector<Comparison>& comparisons, bool asJson);

} // namespace stretch::bench
