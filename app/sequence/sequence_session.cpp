#include "app/sequence/sequence_session.h"

#include <algorithm>
#include <cmath>

namespace stretch::app {

namespace {

constexpr double compressedShareOfWork = 0.95;

Result<CompressedClip> makeCompressedClip(const MeshSequence& mesh,
                                          const skinning::CompressSettings& settings,
                                          const skinning::EncodeSettings& encoding,
                                          const skinning::Proceed& proceed) {
  auto compression =
      makeCompression(mesh, settings, [&](double share) { return proceed(compressedShareOfWork * share); });
  if (!compression) {
    return compression.error();
  }
  CompressedClip made;
  made.result = std::make_shared<const Compression>(std::move(compression).value());
  auto clip = makeClip(made.result, encoding, [&](double share) {
    return proceed(compressedShareOfWork + (1.0 - compressedShareOfWork) * share);
  });
  if (!clip) {
    return clip.error();
  }
  made.clip = std::make_shared<const ExportedClip>(std::move(clip).value());
  return made;
}

} // namespace

Status SequenceSession::startCompression() {
  if (isCompressing()) {
    return Error{"a compression is being made", "", "wait for it or cancel it"};
  }
  compression_ = std::make_unique<Job<CompressedClip>>(
      [mesh = document().mesh, settings = document().settings,
       encoding = document().encoding](const skinning::Proceed& proceed) {
        return makeCompressedClip(*mesh, settings, encoding, proceed);
      });
  return Success{};
}

std::optional<Status> SequenceSession::takeCompression() {
  if (compression_ == nullptr || !compression_->isFinished() || isDragging()) {
    return std::nullopt;
  }
  const bool cancelled = compression_->isCancelled();
  Result<CompressedClip> made = compression_->take();
  compression_.reset();
  if (cancelled) {
    return std::nullopt;
  }
  if (!made) {
    return Status(made.error());
  }
  SequenceDocument changed = document();
  changed.result = made->result;
  clip_ = made->clip;
  edit(std::move(changed), "Compress");
  view_.showSkinned = true;
  return Status(Success{});
}

std::shared_ptr<const ExportedClip> SequenceSession::clip() const {
  return clip_ != nullptr && isWanted(*clip_) ? clip_ : nullptr;
}

void SequenceSession::keepClip() {
  if (encoding_ != nullptr && encoding_->isFinished()) {
    const bool cancelled = encoding_->isCancelled();
    Result<ExportedClip> made = encoding_->take();
    encoding_.reset();
    if (made && !cancelled) {
      clip_ = std::make_shared<const ExportedClip>(std::move(made).value());
    }
  }
  if (document().result == nullptr || clip() != nullptr || isExporting() || isDragging()) {
    return;
  }
  if (encoding_ != nullptr) {
    if (!isWanted(encodes_)) {
      encoding_->cancel();
    }
    return;
  }
  if (isWanted(unwanted_)) {
    return;
  }
  encodes_ = {document().encoding, document().result, {}};
  unwanted_ = {};
  encoding_ = std::make_unique<Job<ExportedClip>>(
      [result = encodes_.result, settings = encodes_.settings](const skinning::Proceed& proceed) {
        return makeClip(result, settings, proceed);
      });
}

Status SequenceSession::startExport(const std::filesystem::path& path) {
  if (document().result == nullptr) {
    return Error{"nothing was compressed yet", path.string(), "compress the sequence first"};
  }
  if (isExporting()) {
    return Error{"another file is being written", path.string(), "wait for it or cancel it"};
  }
  if (encoding_ != nullptr) {
    encoding_->cancel(); // What is written is encoded with it.
  }
  exported_ = document();
  export_ = std::make_unique<Job<WrittenClip>>(
      [document = exported_, known = clip(), path](const skinning::Proceed& proceed) {
        return writeClip(document, known, path, proceed);
      });
  return Success{};
}

std::optional<Result<WrittenClip>> SequenceSession::takeExport() {
  if (export_ == nullptr || !export_->isFinished()) {
    return std::nullopt;
  }
  const bool cancelled = export_->isCancelled();
  Result<WrittenClip> written = export_->take();
  export_.reset();
  if (written) {
    clip_ = written->clip;
    if (sameDocument(exported_, history().current())) {
      markSaved();
    }
  }
  // One that had written its file when it was cancelled is told all the same.
  return cancelled && !written ? std::nullopt : std::optional(std::move(written));
}

void SequenceSession::cancelWork() {
  if (compression_ != nullptr) {
    compression_->cancel();
  }
  if (export_ != nullptr) {
    export_->cancel();
  }
  if (encoding_ != nullptr) {
    unwanted_ = {encodes_.settings, encodes_.result, {}};
    encoding_->cancel();
  }
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
