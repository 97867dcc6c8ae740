#include "app/sequence/sequence_session.h"

#include <algorithm>
#include <chrono>
#include <cmath>

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

Status SequenceSession::startCompression() {
  if (isCompressing()) {
    return Error{"a compression is being made", "", "wait for it or cancel it"};
  }
  job_ = std::make_unique<CompressionJob>(document().mesh, document().settings);
  return Success{};
}

void SequenceSession::cancelCompression() {
  if (job_ != nullptr) {
    job_->cancel();
  }
}

std::optional<Status> SequenceSession::takeCompression() {
  if (job_ == nullptr || !job_->isFinished() || isDragging()) {
    return std::nullopt;
  }
  const bool cancelled = job_->isCancelled();
  Result<Compression> made = job_->take();
  job_.reset();
  if (cancelled) {
    return std::nullopt;
  }
  if (!made) {
    return Status(made.error());
  }
  SequenceDocument changed = document();
  changed.result = std::make_shared<const Compression>(std::move(made).value());
  changed.clip = exported(changed);
  edit(std::move(changed), "Compress");
  view_.showSkinned = true;
  return Status(Success{});
}

bool canShow(const SequenceDocument& document, SequenceLook look) {
  const bool hasResult = document.result != nullptr;
  const bool hasThickness = !document.analysis->vertexDiameters.empty();
  const bool hasSegments = hasResult || !document.analysis->joints.empty();
  switch (look) {
  case SequenceLook::error:
    return hasResult;
  case SequenceLook::thickness:
    return hasThickness;
  case SequenceLook::segments:
    return hasSegments;
  case SequenceLook::cylinders:
    return hasSegments && hasThickness;
  case SequenceLook::material:
  case SequenceLook::compare:
    break;
  }
  return true;
}

double lastFrame(const SequenceSession& session) {
  return static_cast<double>(session.document().mesh->frameCount() - 1);
}

std::size_t shownFrame(const SequenceSession& session) {
  return static_cast<std::size_t>(std::clamp(std::round(session.view().frame), 0.0, lastFrame(session)));
}

} // namespace stretch::app
