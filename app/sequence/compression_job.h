#pragma once

#include <atomic>
#include <future>
#include <memory>

#include "app/sequence/sequence_document.h"

namespace stretch::app {

/// A compression on a thread of its own: started when it is made, stopped when it goes.
class CompressionJob {
public:
  CompressionJob(std::shared_ptr<const MeshSequence> mesh, const skinning::CompressSettings& settings);
  CompressionJob(const CompressionJob&) = delete;
  CompressionJob& operator=(const CompressionJob&) = delete;
  ~CompressionJob(); ///< Waits until the thread has taken notice.

  [[nodiscard]] double share() const { return share_; } ///< Done, 0..1.
  [[nodiscard]] bool isFinished() const;
  /// Asks it to end soon; its result is then an error.
  void cancel() { cancelled_ = true; }
  [[nodiscard]] bool isCancelled() const { return cancelled_; }
  /// Once, after it finished; waits before.
  [[nodiscard]] Result<Compression> take() { return work_.get(); }

private:
  std::atomic<double> share_ = 0.0;
  std::atomic<bool> cancelled_ = false;
  std::future<Result<Compression>> work_;
};

} // namespace stretch::app
