#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <utility>

#include "core/base/result.h"
#include "skinning/fit/alternate.h"

namespace stretch::app {

/// Work on a thread of its own: started when it is made, stopped when it goes.
template <typename Made>
class Job {
public:
  /// `work` tells how far it is, and ends soon with an error once it is told not to go on.
  explicit Job(std::function<Result<Made>(const skinning::Proceed&)> work)
      : work_(std::async(std::launch::async, [this, work = std::move(work)] {
          return work([this](double share) {
            share_ = share;
            return !cancelled_;
          });
        })) {}
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job() { ///< Waits until the thread has taken notice.
    cancel();
    if (work_.valid()) {
      work_.wait();
    }
  }

  [[nodiscard]] double share() const { return share_; } ///< Done, 0..1.
  [[nodiscard]] bool isFinished() const {
    return work_.valid() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  /// Asks it to end soon; its result is then an error.
  void cancel() { cancelled_ = true; }
  [[nodiscard]] bool isCancelled() const { return cancelled_; }
  /// Once, after it finished; waits before.
  [[nodiscard]] Result<Made> take() { return work_.get(); }

private:
  std::atomic<double> share_ = 0.0;
  std::atomic<bool> cancelled_ = false;
  std::future<Result<Made>> work_; // The last: its thread uses the others.
};

} // namespace stretch::app
