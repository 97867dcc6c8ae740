#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <utility>

#include "app/editing.h"
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

/// What is shown of a sequence.
enum class SequenceLook {
  material,  ///< The materials of its source.
  compare,   ///< Red for the original, green for the skinned result.
  error,     ///< How far the result is from the original, vertex by vertex, as colour.
  thickness, ///< The shape diameter as colour.
  segments,  ///< A colour for each bone, mixed by the weights.
  cylinders  ///< The segments as cylinders, as the elastic model sees them.
};

/// What is looked at: not part of the document.
struct SequenceView {
  double frame = 0.0; ///< Playhead.
  bool showOriginal = true;
  bool showSkinned = true; ///< Where there is a result.
  SequenceLook look = SequenceLook::material;
};

/// An open mesh sequence: the door for its edits, what is looked at, and the compression that is being made.
class SequenceSession : public Editing<SequenceDocument> {
public:
  explicit SequenceSession(SequenceDocument document) : Editing(std::move(document)) {}

  [[nodiscard]] SequenceView& view() { return view_; }
  [[nodiscard]] const SequenceView& view() const { return view_; }

  /// Compresses with the document's settings, beside the caller; refused while a compression is being made.
  Status startCompression();
  /// Asks it to end soon.
  void cancelCompression();
  [[nodiscard]] bool isCompressing() const { return job_ != nullptr; }
  [[nodiscard]] double compressedShare() const { return job_ == nullptr ? 0.0 : job_->share(); } ///< 0..1.

  /// Takes up what a finished compression made, as an edit; not while something is dragged. Empty while
  /// there is none to take; an error when it failed, not when it was cancelled.
  [[nodiscard]] std::optional<Status> takeCompression();

private:
  SequenceView view_;
  std::unique_ptr<CompressionJob> job_; ///< Null: nothing is being made.
};

/// Whether there is what the look shows: the error needs a result, the thickness a surface that encloses
/// something, segments and cylinders a centre line or a result.
[[nodiscard]] bool canShow(const SequenceDocument& document, SequenceLook look);

/// The last frame, >= 0.
[[nodiscard]] double lastFrame(const SequenceSession& session);
/// The frame that is shown: sequences are not interpolated.
[[nodiscard]] std::size_t shownFrame(const SequenceSession& session);

} // namespace stretch::app
