#include "app/sequence/compression_job.h"

#include <chrono>

namespace stretch::app {

CompressionJob::CompressionJob(std::shared_ptr<const MeshSequence> mesh,
                               const skinning::CompressSettings& settings) {
  work_ = std::async(std::launch::async, [this, mesh = std::move(mesh), settings] {
    return makeCompression(*mesh, settings, [this](double share) {
      share_ = share;
      return !cancelled_;
    });
  });
}

CompressionJob::~CompressionJob() {
  cancel();
  if (work_.valid()) {
    work_.wait();
  }
}

bool CompressionJob::isFinished() const {
  return work_.valid() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace stretch::app
