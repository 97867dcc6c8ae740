#include "app/sequence/sequence_session.h"

#include <algorithm>
#include <cmath>

namespace stretch::app {

double lastFrame(const SequenceSession& session) {
  return static_cast<double>(session.document.mesh->frameCount() - 1);
}

std::size_t shownFrame(const SequenceSession& session) {
  return static_cast<std::size_t>(std::clamp(std::round(session.view.frame), 0.0, lastFrame(session)));
}

Status startCompression(SequenceSession& session) {
  if (session.job != nullptr) {
    return Error{"a compression is being made", "", "wait for it or cancel it"};
  }
  session.job = std::make_unique<CompressionJob>(session.document.mesh, session.document.settings);
  return Success{};
}

std::optional<Status> takeCompression(SequenceSession& session) {
  if (session.job == nullptr || !session.job->isFinished()) {
    return std::nullopt;
  }
  const bool cancelled = session.job->isCancelled();
  Result<Compression> made = session.job->take();
  session.job.reset();
  if (!made) {
    return cancelled ? std::nullopt : std::optional(Status(made.error()));
  }
  session.document.result = std::make_shared<const Compression>(std::move(made).value());
  session.view.showSkinned = true;
  return Status(Success{});
}

} // namespace stretch::app
